#pragma once

#include "io/profile_file.hpp"
#include "microslip/railway/geometry/wheel_placement.hpp"

#include "paths.hpp"

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace microslip {

/// The profile z(y) through `count` points from y0 to y1.
inline Profile profile_of(ProfileRole role, double y0, double y1, int count, const std::function<double(double)>& z) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k < count; ++k) {
    const double y = y0 + (y1 - y0) * k / (count - 1);
    points.push_back({y, z(y)});
  }
  return Profile(role, points);
}

/// A wheel that is part of a sphere whose centre is on the axle at y = 0.
inline Profile spherical_wheel(double radius, double width = 0.06) {
  return profile_of(ProfileRole::wheel, -width, width, 1201,
                    [=](double y) { return radius - std::sqrt(radius * radius - y * y); });
}

/// A rail's head that is an arc with its top at (0, 0).
inline Profile round_head(double radius, double width = 0.03) {
  return profile_of(ProfileRole::rail, -width, width, 1201,
                    [=](double y) { return std::sqrt(radius * radius - y * y) - radius; });
}

/// A profile of the examples.
inline Profile example_profile(const std::string& name) {
  return io::read_profile(MICROSLIP_SOURCE_DIR "/examples/profiles/" + name).profile;
}

/// A file beside the sources that need not be there.
inline std::optional<Profile> shared_profile(const std::string& name) {
  const auto path = std::filesystem::path(MICROSLIP_SOURCE_DIR) / "../shared" / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return io::read_profile(path).profile;
}

} // namespace microslip
