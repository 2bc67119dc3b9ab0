#include "microslip/railway/profile/profile_crossing.hpp"

#include <algorithm>
#include <vector>

namespace microslip {
namespace {

class Sides {
public:
  explicit Sides(std::span<const ProfilePoint> points) : points_(points) {}

  bool cross(std::size_t a, std::size_t b) const {
    if (a > b) std::swap(a, b);
    if (b == a + 1) return false;
    const int a1 = side_of(b, points_[a]), a2 = side_of(b, points_[a + 1]), b1 = side_of(a, points_[b]),
              b2 = side_of(a, points_[b + 1]);
    if (a1 == 0 && a2 == 0) return overlap(a, b);
    return a1 * a2 <= 0 && b1 * b2 <= 0;
  }

private:
  /// Side of the line through side k on which a point lies: 1 or -1, or 0 on it.
  int side_of(std::size_t k, const ProfilePoint& p) const {
    const ProfilePoint &from = points_[k], &to = points_[k + 1];
    const double area = (to.y - from.y) * (p.z - from.z) - (to.z - from.z) * (p.y - from.y);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  /// Returns true if two sides on one line overlap.
  bool overlap(std::size_t a, std::size_t b) const {
    const auto along = [&](const ProfilePoint& p) {
      return (p.y - points_[a].y) * (points_[a + 1].y - points_[a].y) +
             (p.z - points_[a].z) * (points_[a + 1].z - points_[a].z);
    };
    const auto [low, high] = std::minmax({along(points_[b]), along(points_[b + 1])});
    return high >= 0 && low <= along(points_[a + 1]);
  }

  std::span<const ProfilePoint> points_;
};

} // namespace

/// Compares sides whose ranges of y overlap.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(std::span<const ProfilePoint> points) {
  struct Range {
    double low, high;
    std::size_t k;
  };
  std::vector<Range> ranges;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto [low, high] = std::minmax(points[k].y, points[k + 1].y);
    ranges.push_back({low, high, k});
  }
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  const Sides sides(points);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    for (std::size_t j = i + 1; j < ranges.size() && ranges[j].low <= ranges[i].high; ++j)
      if (sides.cross(ranges[i].k, ranges[j].k)) return std::pair(ranges[i].k, ranges[j].k);
  return {};
}

} // namespace microslip
