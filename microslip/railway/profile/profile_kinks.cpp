#include "microslip/railway/profile/profile_kinks.hpp"

#include <cmath>

namespace microslip {
namespace {

/// Returns whether the polygon is nearly straight around point k, which itself does not count.
bool stands_alone(std::span<const ProfilePoint> points, std::span<const double> turns, std::size_t k,
                  const KinkRule& rule) {
  const auto is_near = [&](std::size_t i) {
    return std::hypot(points[i].y - points[k].y, points[i].z - points[k].z) < rule.width;
  };
  for (std::size_t i = k; i-- > 0 && is_near(i);)
    if (std::abs(turns[i]) > rule.around) return false;
  for (std::size_t i = k + 1; i < points.size() && is_near(i); ++i)
    if (std::abs(turns[i]) > rule.around) return false;
  return true;
}

} // namespace

double turn_at(std::span<const ProfilePoint> points, std::size_t k) {
  if (k == 0 || k + 1 >= points.size()) return 0;
  const ProfilePoint &before = points[k - 1], &here = points[k], &after = points[k + 1];
  const double y1 = here.y - before.y, z1 = here.z - before.z, y2 = after.y - here.y, z2 = after.z - here.z;
  return std::atan2(y1 * z2 - z1 * y2, y1 * y2 + z1 * z2);
}

std::vector<ProfilePoint> without_zigzags(std::span<const ProfilePoint> points, double angle) {
  // Ends do not turn, whatever the angle.
  const auto turns_back = [&](std::size_t k) {
    return k > 0 && k + 1 < points.size() && std::abs(turn_at(points, k)) > angle;
  };
  std::vector<ProfilePoint> kept;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (turns_back(k) && turns_back(k + 1)) {
      kept.push_back({(points[k].y + points[k + 1].y) / 2, (points[k].z + points[k + 1].z) / 2});
      ++k;
    } else {
      kept.push_back(points[k]);
    }
  }
  return kept;
}

std::vector<std::size_t> find_kinks(std::span<const ProfilePoint> points, const KinkRule& rule) {
  std::vector<double> turns(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) turns[k] = turn_at(points, k);
  std::vector<std::size_t> kinks;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::abs(turns[k]) > rule.angle && stands_alone(points, turns, k, rule)) kinks.push_back(k);
  return kinks;
}

} // namespace microslip
