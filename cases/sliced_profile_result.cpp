#include "cases/sliced_profile_result.hpp"

#include "microslip/railway/profile/profile_preparation.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace microslip::cases {
namespace {

/// Stations along u and lines of equal v that a file has at most, and stations from one slice to the next.
constexpr std::size_t most_stations = 800, most_lines = 400, steps_between = 8;

/// The slices' u and some between them; of more slices than there are stations some of them.
std::vector<double> stations_at(std::span<const double> slices) {
  const std::size_t steps = std::clamp<std::size_t>(most_stations / slices.size(), 1, steps_between);
  const std::size_t stride = (slices.size() + most_stations - 1) / most_stations;
  std::vector<double> stations;
  for (std::size_t k = 0; k + stride < slices.size(); k += stride)
    for (std::size_t i = 0; i < steps; ++i)
      stations.push_back(slices[k] +
                         (slices[k + stride] - slices[k]) * static_cast<double>(i) / static_cast<double>(steps));
  stations.push_back(slices.back());
  return stations;
}

} // namespace

void write_result(const ProfileSurface& surface, ProfileRole role, std::span<const double> slices,
                  io::ResultWriter& file) {
  const std::vector<double> stations = stations_at(slices);
  const std::size_t stride = surface.last_v() / most_lines + 1, lines = surface.last_v() / stride + 1;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> y(stations.size() * lines, none), z = y;
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const SurfaceSlice section = surface.section(stations[k]);
    for (std::size_t line = 0; line < lines && !section.points.empty(); ++line) {
      const std::size_t v = line * stride;
      if (!section.holds(v)) continue;
      y[k * lines + line] = section.points[v - section.first].y;
      z[k * lines + line] = section.points[v - section.first].z;
    }
  }
  const bool is_wheel = role == ProfileRole::wheel;
  const std::string unit = is_wheel ? "rad" : "m",
                    along = is_wheel ? "angle around the axle" : "position along the track";
  file.text("role", std::string(to_string(role)), "what it is a profile of");
  file.array("slices/u", slices, unit, along + " of the slices");
  file.array("surface/u", std::span<const double>(stations), unit, along + " of the stations");
  file.array("surface/y", std::span<const double>(y), "m", "y over stations and lines, to the field side",
             {stations.size(), lines});
  file.array("surface/z", std::span<const double>(z), "m", "z over stations and lines, up", {stations.size(), lines});
}

} // namespace microslip::cases
