#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace microslip {

/// Criterion by which a turn of the polygon through a profile's points is a corner of the shape, not part of an arc.
struct KinkRule {
  double angle = std::numbers::pi / 6;   ///< a kink turns by more than this [rad]
  double around = std::numbers::pi / 30; ///< and every other point near it by no more than this [rad]
  double width = 2e-3;                   ///< near: less than this [m] away, as are all in between

  friend bool operator==(const KinkRule&, const KinkRule&) = default;
};

/// The angle [rad] by which the polygon turns at point k, in (-pi, pi], positive to the left; 0 at both ends.
double turn_at(std::span<const ProfilePoint> points, std::size_t k);

/// The points with every two in succession at which the polygon turns by more than `angle` [rad] replaced by their
/// mean.
std::vector<ProfilePoint> without_zigzags(std::span<const ProfilePoint> points, double angle);

/// Indices of the points that are kinks, ascending. (The rule of the program CONTACT, module m_profile.) Cost O(points)
/// times the number of points within the width.
std::vector<std::size_t> find_kinks(std::span<const ProfilePoint> points, const KinkRule& rule = {});

} // namespace microslip
