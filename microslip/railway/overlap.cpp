#include "microslip/railway/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr std::size_t stations = 600, table_points = 1000;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

OverlapSearch::OverlapSearch(const Profile& rail, const Profile& wheel, const Frame<double>& nominal)
    : rail_(&rail), wheel_(&wheel), nominal_(nominal) {
  for (std::size_t k = 0; k <= stations; ++k) {
    station_.push_back(wheel.length() * static_cast<double>(k) / stations);
    at_.push_back(wheel.at(station_.back()));
  }
  // The rail as seen from above: of several points over one y the highest.
  constexpr std::size_t fine = 4000;
  std::vector<Vec3<double>> points;
  double low = infinity, high = -infinity;
  for (std::size_t k = 0; k <= fine; ++k) {
    const double s = rail.length() * static_cast<double>(k) / fine;
    const ProfilePoint p = rail.at(s).value;
    const Vec3<double> place = nominal.outer({0, p.y, p.z});
    points.push_back({s, place.y, place.z});
    low = std::min(low, place.y), high = std::max(high, place.y);
  }
  table_start_ = low, table_step_ = (high - low) / table_points;
  rail_at_.assign(table_points + 1, 0);
  std::vector<double> height(table_points + 1, -infinity);
  for (std::size_t k = 0; k < fine; ++k) {
    const auto [a, b] = std::pair{points[k], points[k + 1]};
    const double from = std::min(a.y, b.y), to = std::max(a.y, b.y);
    for (std::size_t i = static_cast<std::size_t>(std::max(0.0, std::ceil((from - low) / table_step_)));
         i <= table_points && low + static_cast<double>(i) * table_step_ <= to; ++i) {
      const double y = low + static_cast<double>(i) * table_step_, t = b.y == a.y ? 0 : (y - a.y) / (b.y - a.y);
      const double z = a.z + t * (b.z - a.z);
      if (z > height[i]) height[i] = z, rail_at_[i] = a.x + t * (b.x - a.x);
    }
  }
}

double OverlapSearch::near_rail_s(double y) const {
  const double position = std::clamp((y - table_start_) / table_step_, 0.0, static_cast<double>(table_points));
  return rail_at_[static_cast<std::size_t>(position + 0.5)];
}

/// On the locus the normal (y' sin tau, z', -y' cos tau) of the wheel's surface has no component along the track:
/// R11 sin tau - R13 cos tau = -R12 z'/y'.
LocusPoint OverlapSearch::point(const WheelPlacement<double>& placement, double wheel_s, const CurvePoint& p,
                                double rail_s) const {
  LocusPoint out{.wheel_s = wheel_s, .rail_s = rail_s, .place = {}, .gap = infinity, .valid = false};
  const Rotation<double>& r = placement.wheel.frame.axes;
  const double alpha = std::hypot(r.ex.x, r.ez.x), ratio = -r.ey.x * p.first.z / (alpha * p.first.y);
  if (!(p.first.y > 0) || !(std::abs(ratio) <= 1)) return out;
  const double tau = std::asin(ratio) + std::atan2(r.ez.x, r.ex.x);
  out.place = placement.wheel_point(tau, p.value.y, p.value.z);
  const Frame<double>& rail = placement.rail.frame;
  if (std::isnan(rail_s)) out.rail_s = near_rail_s(out.place.y - rail.origin.y + nominal_.origin.y);
  for (int k = 0; k < 4; ++k) {
    const CurvePoint q = rail_->at(out.rail_s);
    const Vec3<double> place = rail.outer({0, q.value.y, q.value.z});
    const Vec3<double> slope = rail.axes * Vec3<double>{0, q.first.y, q.first.z};
    const double step = (out.place.y - place.y) / std::max(slope.y, 0.02);
    out.rail_s += std::clamp(step, -2e-3, 2e-3);
    out.gap = out.place.z - place.z - slope.z * step;
  }
  const CurvePoint q = rail_->at(out.rail_s);
  const Vec3<double> place = rail.outer({0, q.value.y, q.value.z});
  out.gap = out.place.z - place.z;
  out.valid = std::abs(place.y - out.place.y) < 1e-6 && out.rail_s >= 0 && out.rail_s <= rail_->length();
  if (!out.valid) out.gap = infinity;
  return out;
}

LocusPoint OverlapSearch::locus(const WheelPlacement<double>& placement, double wheel_s, double rail_s) const {
  return point(placement, wheel_s, wheel_->at(wheel_s), rail_s);
}

LocusPoint OverlapSearch::at_station(const WheelPlacement<double>& placement, std::size_t k) const {
  return point(placement, station_[k], at_[k], unknown);
}

LocusPoint OverlapSearch::locus_near(const WheelPlacement<double>& placement, double wheel_s) const {
  return point(placement, wheel_s, wheel_->at(wheel_s), unknown);
}

double OverlapSearch::clearance(const WheelPlacement<double>& placement) const {
  double least = infinity;
  for (std::size_t k = 0; k < station_.size(); ++k) least = std::min(least, at_station(placement, k).gap);
  return least;
}

void OverlapSearch::find(const WheelPlacement<double>& placement, std::vector<Overlap>& overlaps) const {
  overlaps.clear();
  LocusPoint before;
  for (std::size_t k = 0; k < station_.size(); ++k) {
    const LocusPoint here = at_station(placement, k);
    const bool overlaps_here = here.valid && here.gap < 0, overlapped = before.valid && before.gap < 0;
    if (overlaps_here != overlapped) {
      // Where the gap is zero, by bisection and secants between two stations.
      LocusPoint in = overlaps_here ? here : before, out = overlaps_here ? before : here;
      const bool open = !out.valid;
      for (int i = 0; i < 60 && !open && std::abs(in.wheel_s - out.wheel_s) > 1e-12; ++i) {
        double t = i % 3 == 2 ? 0.5 : in.gap / (in.gap - out.gap);
        const LocusPoint middle = locus(placement, in.wheel_s + t * (out.wheel_s - in.wheel_s), in.rail_s);
        if (std::abs(middle.gap) < 1e-14) {
          in = middle;
          break;
        }
        (middle.gap < 0 ? in : out) = middle;
      }
      if (overlaps_here)
        overlaps.push_back({in.wheel_s, in.wheel_s, 0, open});
      else
        overlaps.back().wheel_high = in.wheel_s, overlaps.back().at_profile_end |= open;
    }
    if (overlaps_here) overlaps.back().least_gap = std::min(overlaps.back().least_gap, here.gap);
    before = here;
  }
  if (!overlaps.empty() && before.valid && before.gap < 0)
    overlaps.back().wheel_high = before.wheel_s, overlaps.back().at_profile_end = true;
}

} // namespace microslip
