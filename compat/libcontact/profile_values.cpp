#include "compat/contact/wheel_rail/placement.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

#include <algorithm>
#include <cmath>

// Profiles as they are used. In CONTACT's order: rails from the gauge to the field side, wheels the other way round, so
// that their s is the negative of ours. In mm, whatever the units.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

/// What is asked for.
struct Request {
  int task;
  bool of_wheel;
  int sampling; ///< up to 0 the points; 1 by steps, else as many parts of each interval
  double step;  ///< [mm]
};

/// s of the samples [mm], in our order.
std::vector<double> samples(const ProfileCurve& curve, const Request& r) {
  constexpr double least_step = 1e-4;
  constexpr int most_parts = 100;
  std::vector<double> s;
  const std::size_t points = curve.points().size();
  if (r.sampling == 1 && r.step >= least_step) {
    const auto count = static_cast<std::size_t>((curve.end() - curve.start()) / r.step) + 1;
    for (std::size_t k = 0; k < count; ++k) // from CONTACT's beginning
      s.push_back(r.of_wheel ? curve.end() - static_cast<double>(k) * r.step
                             : curve.start() + static_cast<double>(k) * r.step);
    if (r.of_wheel) std::reverse(s.begin(), s.end());
    return s;
  }
  const int parts = r.sampling < 2 ? 1 : r.sampling;
  if (parts > most_parts) throw Refusal(CNTC_err_other, "isampl must not be above 100");
  for (std::size_t k = 0; k + 1 < points; ++k)
    for (int j = 0; j < parts; ++j) s.push_back(curve.s_of(k) + (curve.s_of(k + 1) - curve.s_of(k)) * j / parts);
  s.push_back(curve.s_of(points - 1));
  return s;
}

/// The curve, or its derivative, at the samples in CONTACT's order.
std::vector<CurvePoint> curve_points(const ProfileCurve& curve, const Request& r) {
  std::vector<CurvePoint> found;
  for (const double s : samples(curve, r)) found.push_back(curve.at(s));
  if (r.of_wheel) std::reverse(found.begin(), found.end());
  return found;
}

/// All y and then all z.
std::vector<double> coordinates(const std::vector<CurvePoint>& points) {
  std::vector<double> found;
  for (const auto& p : points) found.push_back(p.value.y);
  for (const auto& p : points) found.push_back(p.value.z);
  return found;
}

/// In the axes of the track, as the last calculation had it.
std::vector<double> in_track(const ContactProblem& p, std::vector<CurvePoint> points, const Request& r) {
  const Placement& placed = p.solved_wheel().placement;
  const double sign = p.was_left() ? -1 : 1;
  for (auto& point : points) {
    const auto at = (r.of_wheel ? placed.wheel : placed.rail).outer({0, point.value.y, point.value.z});
    point.value = {sign * at.y, at.z};
  }
  return coordinates(points);
}

/// y of the gauge side at a height, between points; its end if it does not reach there.
double gauge_side_at(const ProfileCurve& rail, double z, double y_of_top) {
  const auto& points = rail.points();
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    const auto &below = points[k - 1], &above = points[k];
    if (above.y > y_of_top || !(below.z >= z && above.z < z)) continue;
    return below.y + (z - below.z) / (above.z - below.z) * (above.y - below.y);
  }
  return points.front().y;
}

/// The furthest point to the gauge side, the offset of the profile, and the point at gauge height.
std::vector<double> gauge(const ContactProblem& p, const ProfileCurve& rail) {
  const TrackDimensions& track = p.wheel().track;
  if (!track.by_gauge()) throw Refusal(CNTC_err_profil, "the rail is not placed by the gauge");
  const GaugePoint found = gauge_of(rail, track);
  const double sign = p.wheel().digits.is_left() ? -1 : 1, unit = 1 / p.units.length;
  const double top = -found.top.z, height = top + track.gauge_height;
  const double side = gauge_side_at(rail.moved(-track.cant, 0, 0), height, found.top.y);
  const RailPosition& off = p.wheel().rail_position;
  return {
      found.point.y * unit,  -found.point.z * unit, (sign * (track.gauge_width / 2 - found.point.y) + off.dy) * unit,
      (off.dz - top) * unit, side * unit,           height * unit};
}

std::vector<double> profile_values(const ContactProblem& p, const Request& r) {
  const ProfileRecord& record = r.of_wheel ? p.wheel().wheel : p.wheel().rail;
  const bool is_there = record.curve || is_variable(record);
  if (r.task == -1) return {is_there ? 0.0 : double(CNTC_err_profil), is_there ? 0.0 : 1.0};
  if (!is_there) throw Refusal(CNTC_err_profil, "there is no such profile");
  if (!record.curve || r.task > 5) throw Refusal(CNTC_err_profil, "values of variable profiles are not supported");
  const ProfileCurve& curve = *record.curve;
  if (r.task == 3 && r.of_wheel) throw Refusal(CNTC_err_profil, "wheels have no gauge point");
  if (r.task == 3) return gauge(p, curve);
  auto s = samples(curve, r);
  if (r.task == 0) return {static_cast<double>(s.size())};
  const auto points = curve_points(curve, r);
  if (r.task == 1) return coordinates(points);
  if (r.task == 2) return in_track(p, points, r);
  if (r.of_wheel) std::reverse(s.begin(), s.end());
  const double sense = r.of_wheel ? -1 : 1;
  std::vector<double> found;
  for (std::size_t k = 0; k < s.size(); ++k)
    found.push_back(r.task == 4 ? sense * s[k] : std::atan2(sense * points[k].first.z, sense * points[k].first.y));
  return found;
}

} // namespace
} // namespace microslip::libcontact

using namespace microslip::libcontact;

extern "C" {

int cntc_getprofilevalues(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                          double* values) {
  return guarded({"cntc_getprofilevalues", ire, &whole_wheel, Module::wheel, Scope::whole}, [&](ContactProblem& p) {
    const auto choices = integers("iparam", nints, iparam);
    const auto numbers = reals("rparam", nreals, rparam);
    const Request request = {integer("itask", itask), !choices.empty() && choices[0] > 0,
                             choices.size() > 1 ? choices[1] : 0, numbers.empty() ? 1 : numbers[0]};
    if (request.task < -1 || request.task > 9) throw Refusal(CNTC_err_other, "itask must be in -1 to 9");
    fill(room("values", lenarr, values), profile_values(p, request));
  });
}

int cntc_getprofilevalues_new(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                              double* values) {
  return cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, values);
}

} // extern "C"

LIBCONTACT_UNDERSCORED(cntc_getprofilevalues)
LIBCONTACT_UNDERSCORED(cntc_getprofilevalues_new)
