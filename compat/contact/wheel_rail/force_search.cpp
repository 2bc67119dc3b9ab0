#include "compat/contact/wheel_rail/force_search.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::contact_program {
namespace {

double straightened(double force) {
  return std::copysign(std::pow(std::abs(force), 2.0 / 3), force);
}

} // namespace

void ForceSearch::add(double z, double force) {
  const auto above =
      std::upper_bound(points_.begin(), points_.end(), z, [](double v, const Point& p) { return v < p.z; });
  points_.insert(above, {z, force});
}

/// Through the two points whose forces are next to the target.
double ForceSearch::secant() const {
  std::vector<Point> nearest = points_;
  std::partial_sort(nearest.begin(), nearest.begin() + 2, nearest.end(), [this](const Point& a, const Point& b) {
    return std::abs(a.force - target_) < std::abs(b.force - target_);
  });
  const double f0 = straightened(nearest[0].force), f1 = straightened(nearest[1].force);
  return nearest[0].z + (straightened(target_) - f0) / (f1 - f0) * (nearest[1].z - nearest[0].z);
}

std::optional<double> ForceSearch::next() {
  const double first = points_.front().z, last = points_.back().z, depth = last - first;
  const auto above =
      std::find_if(points_.begin(), points_.end(), [this](const Point& p) { return p.force >= target_; });
  if (above == points_.begin()) return {};
  if (above == points_.end()) {
    constexpr double first_depth = 1e-5, deepest = 0.02, most_at_once = 3; // [m], [m], [-]
    if (depth > deepest) return {};
    if (!(points_.back().force > 0)) return last + std::max(depth, first_depth);
    const double wanted = secant();
    return std::isfinite(wanted) ? std::clamp(wanted, first + 1.001 * depth, first + most_at_once * depth)
                                 : first + most_at_once * depth;
  }
  const double low = (above - 1)->z, high = above->z, width = high - low;
  if (!(width > 1e-12 * (1e-3 + std::abs(high)))) return {};
  ++slow_;
  if (width < 0.5 * width_) {
    width_ = width;
    slow_ = 0;
  }
  constexpr int most_slow = 3;
  const double wanted = secant();
  if (slow_ > most_slow || !(wanted > low && wanted < high)) {
    slow_ = 0;
    return 0.5 * (low + high);
  }
  return wanted;
}

} // namespace microslip::contact_program
