#include "validation/worn_profiles.hpp"

#include "io/profile_file.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "validation/draw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace microslip::validation {
namespace {

Profile example(const char* name) {
  return io::read_profile(std::filesystem::path(MICROSLIP_EXAMPLES) / "profiles" / name).profile;
}

/// The profile's points with another height z(y, z).
Profile reshaped(const Profile& whole, const std::function<double(const ProfilePoint&)>& height) {
  std::vector<ProfilePoint> points;
  for (const ProfilePiece& piece : whole.pieces()) points.push_back({piece.c[0].y, height(piece.c[0])});
  const ProfilePoint last = whole.at(whole.length()).value;
  points.push_back({last.y, height(last)});
  ProfileTreatment smoothed;
  smoothed.smoothing_length = 4e-3; // where the new shape has kinks
  return prepare_profile(whole.role(), std::move(points), smoothed).profile;
}

/// A tread that is worn by `depth` [m] in the middle of a hollow from y = -20 to 30 mm.
Profile hollow(const Profile& wheel, double depth) {
  return reshaped(wheel, [depth](const ProfilePoint& p) {
    const double t = std::clamp((p.y - 0.005) / 0.025, -1.0, 1.0);
    return p.z + depth * (1 - t * t) * (1 - t * t);
  });
}

/// A head whose top is worn by `depth` [m] to an arc of 0.5 m radius.
Profile worn(const Profile& rail, double depth) {
  double top = 0;
  for (const ProfilePiece& piece : rail.pieces()) top = std::max(top, piece.c[0].z);
  return reshaped(rail, [=](const ProfilePoint& p) { return std::min(p.z, top - depth - p.y * p.y); });
}

/// As measured: points every 0.25 mm with white noise of `deviation` [m], smoothed.
Profile measured(const Profile& whole, double deviation, std::uint64_t seed) {
  constexpr double spacing = 0.25e-3, wavelength = 3e-3;
  Draw draw(seed);
  std::vector<ProfilePoint> points;
  for (int k = 0; k * spacing < whole.length(); ++k) {
    ProfilePoint p = whole.at(k * spacing).value;
    p.z += deviation * draw.normal();
    points.push_back(p);
  }
  ProfileTreatment smoothed;
  smoothed.smoothing_length = wavelength;
  return prepare_profile(whole.role(), std::move(points), smoothed).profile;
}

} // namespace

std::vector<ProfilePair> worn_pairs() {
  const Profile rail = example("60e1.prr"), wheel = example("s1002.prw");
  std::vector<ProfilePair> all;
  const auto add = [&](const char* name, const Profile& on_rail, const Profile& on_wheel, double cant) {
    WheelRailBodies bodies{.rail = on_rail, .wheel = on_wheel, .track = {}, .wheelset = {}, .friction = {{0, 0.3}}};
    bodies.track.cant = cant, bodies.material = {82e9, 0.28, 0};
    all.push_back({name, std::move(bodies)});
  };
  add("S1002 on 60E1", rail, wheel, 1.0 / 40);
  add("hollow wheel", rail, hollow(wheel, 3e-3), 1.0 / 40);
  add("worn rail", worn(rail, 1e-3), wheel, 1.0 / 40);
  add("hollow on worn", worn(rail, 1e-3), hollow(wheel, 2e-3), 1.0 / 20);
  add("measured, 10 um", measured(rail, 10e-6, 1), measured(wheel, 10e-6, 2), 1.0 / 40);
  return all;
}

} // namespace microslip::validation
