#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace microslip {

/// Two sides of the polygon through points that cross or touch each other, by the indices of their first points; sides
/// next to one another do not count. Cost O(points log(points)) where the sides' ranges of y are narrow.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(std::span<const ProfilePoint> points);

} // namespace microslip
