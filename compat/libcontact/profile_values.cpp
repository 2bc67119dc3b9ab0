#include "compat/contact/wheel_rail/placement.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

// Profiles as they are used. In CONTACT's order: rails from the gauge to the field side, wheels in reverse, so
// that their s is the negative of ours. In mm, whatever the units.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

/// What is asked for.
struct Request {
  int task;
  bool of_wheel;
  int sampling;                   ///< up to 0 the points; 1 by steps, else as many parts of each interval
  double step;                    ///< [mm], along a surface of its u or v
  double place;                   ///< x or theta of a cross-section; the u, v or y that stays
  std::optional<double> from, to; ///< of what runs along a surface, v from 1 as CONTACT counts it
};

/// s of the samples, in our order.
std::vector<double> samples(const ProfileCurve& curve, const Request& r) {
  constexpr double least_step = 1e-7;
  constexpr int most_parts = 100;
  std::vector<double> s;
  const std::size_t points = curve.points().size();
  const double step = r.step * mm;
  if (r.sampling == 1 && step >= least_step) {
    const auto count = static_cast<std::size_t>((curve.end() - curve.start()) / step) + 1;
    for (std::size_t k = 0; k < count; ++k) // from CONTACT's beginning
      s.push_back(r.of_wheel ? curve.end() - static_cast<double>(k) * step
                             : curve.start() + static_cast<double>(k) * step);
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
  found.reserve(2 * points.size());
  for (const auto& p : points) found.push_back(p.value.y / mm);
  for (const auto& p : points) found.push_back(p.value.z / mm);
  return found;
}

/// In the axes of the track, as the last calculation had it.
std::vector<double> in_track(const ContactProblem& p, std::vector<CurvePoint> points, const Request& r) {
  const Placement& placed = p.solved_wheel().placement;
  const double side = p.was_left() ? -1 : 1; // of the profiles' y, which is to the field side
  for (auto& point : points) {
    const auto at = (r.of_wheel ? placed.wheel : placed.rail).outer({0, side * point.value.y, point.value.z});
    point.value = {at.y, at.z};
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
  const double sign = p.wheel().digits.is_left() ? -1 : 1, unit = p.units.per_length();
  const double top = -found.top.z, height = top + track.gauge_height;
  const double side = gauge_side_at(rail.moved(-track.cant, 0, 0), height, found.top.y);
  const RailPosition& off = p.wheel().rail_position;
  return {
      found.point.y * unit,  -found.point.z * unit, (sign * (track.gauge_width / 2 - found.point.y) + off.dy) * unit,
      (off.dz - top) * unit, side * unit,           height * unit};
}

/// Where a surface is interrupted, as CONTACT has it.
constexpr double nowhere = 999;

/// The point on a surface at u and CONTACT's v, which begins with 1 and of wheels on the other side.
std::array<double, 3> surface_point(const ProfileSurface& s, bool of_wheel, double u, double v) {
  const auto last = static_cast<double>(s.last_v());
  const auto found = s.at(u, of_wheel ? last + 1 - v : v - 1);
  return found ? std::array{u, found->value.y, found->value.z} : std::array{u, nowhere, nowhere};
}

/// The upper side of a rail, or the lower one of a wheel, at y.
std::array<double, 3> point_over(const ProfileSurface& s, bool of_wheel, double u, double y) {
  std::optional<double> outer;
  for (const double v : s.v_at_y(u, y)) {
    const auto point = s.at(u, v);
    if (point && (!outer || (of_wheel ? point->value.z > *outer : point->value.z < *outer))) outer = point->value.z;
  }
  return {u, y, outer.value_or(nowhere)};
}

/// Tasks 6, 7, 8: all x, all y and then all z, or their number alone.
std::vector<double> surface_values(const ProfileSurface& s, const Request& r, bool number_only) {
  constexpr double least_step = 1e-4, most_points = 1e6;
  const bool across = r.task == 6;
  const double from = r.from.value_or(across ? 1 : s.first_u());
  const double to = r.to.value_or(across ? static_cast<double>(s.last_v()) + 1 : s.last_u());
  if (!(r.step >= least_step) || !(to >= from) || (to - from) / r.step > most_points)
    throw Refusal(CNTC_err_other,
                  "the step must be at least 1e-4, and the range ascend, with a million points at most");
  const auto count = static_cast<std::size_t>((to - from) / r.step) + 1;
  if (number_only) return {static_cast<double>(count)};
  std::vector<double> found(3 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const double at = from + static_cast<double>(k) * r.step;
    const auto point = across        ? surface_point(s, r.of_wheel, r.place, at)
                       : r.task == 7 ? surface_point(s, r.of_wheel, at, r.place)
                                     : point_over(s, r.of_wheel, at, r.place);
    for (std::size_t i = 0; i < point.size(); ++i) found[i * count + k] = point[i];
  }
  return found;
}

/// The profile, or the cross-section of one that varies: of a rail in the track's axes at x from the wheelset.
ProfileCurve curve_of(const ContactProblem& p, const ProfileShape& shape, const Request& r) {
  if (!shape.varies()) return *shape.curve;
  const bool in_track = r.task == 2 && !r.of_wheel;
  const double u = r.of_wheel ? r.place : r.place * mm + (in_track ? p.wheel().position.s : 0);
  auto section = cross_section(*shape.surface, r.of_wheel ? ProfileRole::wheel : ProfileRole::rail, u);
  if (!section) throw Refusal(CNTC_err_profil, "the profile is interrupted there");
  return std::move(*section);
}

std::vector<double> profile_values(ContactProblem& p, const Request& r, bool number_only) {
  const ProfileRecord& record = r.of_wheel ? p.wheel().wheel : p.wheel().rail;
  const bool is_there = record.curve || is_variable(record);
  if (r.task == -1) return {is_there ? 0.0 : double(CNTC_err_profil), is_there ? 0.0 : 1.0};
  const ProfileShape shape = p.profile(r.of_wheel);
  if (r.task > 5 && !shape.varies()) throw Refusal(CNTC_err_profil, "the profile does not vary");
  if (r.task == 9) throw Refusal(CNTC_err_other, "files for MATLAB's tools are not written");
  if (r.task > 5) return surface_values(shape.surface->in_units(r.of_wheel ? 1 : per_m, per_m, per_m), r, number_only);
  if (r.task == 3 && r.of_wheel) throw Refusal(CNTC_err_profil, "wheels have no gauge point");
  const ProfileCurve curve = curve_of(p, shape, r);
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
    found.push_back(r.task == 4 ? sense * s[k] / mm : std::atan2(sense * points[k].first.z, sense * points[k].first.y));
  return found;
}

} // namespace

extern "C" {

int cntc_getprofilevalues(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                          double* values) {
  return answered(wheel_call(__func__, ire), into(results(lenarr, values)), [&](ContactProblem& p) {
    const auto choices = integers("iparam", nints, iparam);
    const auto numbers = reals("rparam", nreals, rparam);
    const auto number = [&](std::size_t k) {
      return k < numbers.size() ? std::optional(numbers[k]) : std::optional<double>();
    };
    const Request request = {.task = integer("itask", itask),
                             .of_wheel = !choices.empty() && choices[0] > 0,
                             .sampling = choices.size() > 1 ? choices[1] : 0,
                             .step = number(0).value_or(1),
                             .place = number(1).value_or(0),
                             .from = number(2),
                             .to = number(3)};
    if (request.task < -1 || request.task > 9) throw Refusal(CNTC_err_other, "itask must be in -1 to 9");
    const auto place = room("values", lenarr, values);
    fill(place, profile_values(p, request, place.size() == 1));
  });
}

int cntc_getprofilevalues_new(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                              double* values) {
  return cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, values);
}

} // extern "C"
} // namespace microslip::libcontact
