#include "microslip/railway/geometry/surface_hits.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// A point of a surface with its derivatives with respect to u and v.
struct Station {
  ProfilePoint value, du, dv;
};

double last_number(const BodyShape& body) {
  return body.surface ? static_cast<double>(body.surface->last_v())
                      : static_cast<double>(body.profile->pieces().size());
}

std::optional<Station> station(const BodyShape& body, double u, double v) {
  if (body.surface) {
    const auto p = body.surface->at(u, v);
    if (!p) return {};
    return Station{p->value, p->du, p->dv};
  }
  const auto k = std::min(static_cast<std::size_t>(v), body.profile->pieces().size() - 1);
  const ProfilePiece& piece = body.profile->pieces()[k];
  const CurvePoint p = piece.at(piece.start + (v - static_cast<double>(k)) * piece.length);
  return Station{p.value, {}, {piece.length * p.first.y, piece.length * p.first.z}};
}

/// Two functions of n and v that are zero on the surface, with their derivatives.
struct Equations {
  double f1 = 0, f2 = 0, f1_n = 0, f1_v = 0, f2_n = 0, f2_v = 0;
};

/// Newton's method; `equations` gives nothing where there is no surface.
template <class Function> bool solve(const Function& equations, double last_v, SurfaceHit& hit) {
  constexpr int most_steps = 30;
  constexpr double exact = 1e-13, exact_v = 1e-9, longest = 4; // [m], [-], [-]
  SurfaceHit at{hit.n, std::clamp(hit.v, 0.0, last_v)};
  for (int k = 0; k < most_steps; ++k) {
    const std::optional<Equations> e = equations(at);
    if (!e) return false;
    const double determinant = e->f1_n * e->f2_v - e->f1_v * e->f2_n;
    const double dn = -(e->f1 * e->f2_v - e->f1_v * e->f2) / determinant;
    const double dv = std::clamp(-(e->f1_n * e->f2 - e->f2_n * e->f1) / determinant, -longest, longest);
    if (!std::isfinite(dn + dv)) return false;
    const double v = at.v + dv;
    at = {at.n + dn, std::clamp(v, 0.0, last_v)};
    if (std::abs(dn) >= exact || std::abs(dv) >= exact_v) continue;
    if (std::abs(v - at.v) > exact_v) return false; // beyond the profile
    hit = at;
    return true;
  }
  return false;
}

} // namespace

ProfileSection section_at(const BodyShape& body, double u) {
  if (!body.surface) return {*body.profile, 0};
  const SurfaceSlice slice = body.surface->section(u);
  const bool is_rail = body.profile->role() == ProfileRole::rail;
  if (slice.points.size() < 2)
    throw Error(is_rail ? "rail: interrupted at " + std::to_string(u) + " m" : "wheel: no surface at its lowest line");
  std::vector<std::size_t> kinks;
  for (const std::size_t v : body.surface->kinks())
    if (v > slice.first && v < slice.last()) kinks.push_back(v - slice.first);
  return {Profile(body.profile->role(), slice.points, kinks), static_cast<double>(slice.first)};
}

bool find_on_rail(BodyShape rail, const WheelPlacement<double>& placement, const Vec3<double>& p, const Vec3<double>& d,
                  SurfaceHit& hit) {
  const Frame<double>& frame = placement.rail.frame;
  const Vec3<double> q = frame.inner(p), along = frame.axes.back(d);
  const double roller = placement.roller_radius, u = placement.longitudinal + p.x;
  const auto equations = [&](const SurfaceHit& at) -> std::optional<Equations> {
    const auto surface = station(rail, u, at.v);
    if (!surface) return {};
    const double y = q.y + at.n * along.y, z = q.z + at.n * along.z;
    double height = z, rise = along.z;
    if (roller != 0) { // around the axle, as the profile has it
      const double radius = std::copysign(std::hypot(q.x, z + roller), roller);
      height = radius - roller, rise = along.z * (z + roller) / radius;
    }
    return Equations{y - surface->value.y, height - surface->value.z, along.y, -surface->dv.y, rise, -surface->dv.z};
  };
  return solve(equations, last_number(rail), hit);
}

bool find_on_wheel(BodyShape wheel, const WheelPlacement<double>& placement, const Vec3<double>& p,
                   const Vec3<double>& d, SurfaceHit& hit) {
  const Frame<double>& frame = placement.wheel.frame;
  const Vec3<double> q = frame.inner(p), along = frame.axes.back(d);
  const auto equations = [&](const SurfaceHit& at) -> std::optional<Equations> {
    const Vec3<double> position = q + at.n * along;
    const double square = position.x * position.x + position.z * position.z, rho = std::sqrt(square);
    // Slices count from the line that is the lowest one at pitch = 0.
    const double theta = std::atan2(position.x, -position.z) + placement.pitch;
    const double theta_n = (position.x * along.z - position.z * along.x) / square;
    const auto surface = station(wheel, theta, at.v);
    if (!surface) return {};
    return Equations{position.y - surface->value.y,
                     rho - placement.radius + surface->value.z,
                     along.y - surface->du.y * theta_n,
                     -surface->dv.y,
                     (position.x * along.x + position.z * along.z) / rho + surface->du.z * theta_n,
                     surface->dv.z};
  };
  return solve(equations, last_number(wheel), hit);
}

double number_at(const Profile& profile, double s) {
  const std::size_t k = profile.piece_at(s);
  const ProfilePiece& piece = profile.pieces()[k];
  return static_cast<double>(k) + (s - piece.start) / piece.length;
}

double parameter_at(const Profile& profile, double number) {
  const auto last = static_cast<double>(profile.pieces().size() - 1);
  const double k = std::clamp(std::floor(number), 0.0, last);
  const ProfilePiece& piece = profile.pieces()[static_cast<std::size_t>(k)];
  return piece.start + (number - k) * piece.length;
}

} // namespace microslip
