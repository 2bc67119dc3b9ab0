#include "microslip/railway/geometry/relative_motion.hpp"

#include <cmath>
#include <utility>

namespace microslip {
namespace {

using Number = Dual<double, static_cast<int>(state_numbers)>;

Vec3<double> value(const Vec3<Number>& v) {
  return {v.x.value, v.y.value, v.z.value};
}
Vec3<double> partial(const Vec3<Number>& v, int k) {
  return {v.x.partial[k], v.y.partial[k], v.z.partial[k]};
}

/// The rotation vector of a change of axes.
Vec3<double> rotation(const Rotation<Number>& axes, int k) {
  Vec3<double> sum;
  for (const Vec3<Number>* e : {&axes.ex, &axes.ey, &axes.ez}) sum = sum + cross(value(*e), partial(*e, k));
  return 0.5 * sum;
}

WheelPlacement<Number> placement(const NominalPlacement& nominal, WheelState<double> state) {
  WheelState<Number> seeded;
  const auto from = state.numbers();
  const auto to = seeded.numbers();
  for (std::size_t k = 0; k < state_numbers; ++k) *to[k] = Number::variable(*from[k], static_cast<int>(k));
  return place(nominal, seeded);
}

/// Effect of a change as seen from the rail: position of the wheel's centre across the rail, rotation about the two
/// axes of the wheel that are not its axle, velocity and angular velocity.
std::array<double, basic_motions> seen_from_rail(const WheelPlacement<Number>& p, int k) {
  const MovingFrame<Number>&wheel = p.wheel, &rail = p.rail;
  const Vec3<double> turn = rotation(rail.frame.axes, k);
  const Vec3<double> lever = value(wheel.frame.origin) - value(rail.frame.origin);
  const auto change = [&](const Vec3<Number>& v) { return partial(v, k) - cross(turn, value(v)); };
  const Vec3<double> shift = partial(wheel.frame.origin, k) - partial(rail.frame.origin, k) - cross(turn, lever);
  const Vec3<double> angle = rotation(wheel.frame.axes, k) - turn;
  const Vec3<double> rail_spin = change(rail.angular_velocity);
  const Vec3<double> spin = change(wheel.angular_velocity) - rail_spin;
  // The rail is the same all along; moved back along it, the wheel meets what the rail's rotation in a curve adds
  // ahead.
  const Vec3<double> ahead = cross(Vec3<double>{0, 0, value(rail.angular_velocity).z}, {shift.x, 0, 0});
  const Vec3<double> velocity = change(wheel.velocity) - change(rail.velocity) - cross(rail_spin, lever) - ahead;
  return {shift.y,
          shift.z,
          dot(angle, value(wheel.frame.axes.ex)),
          dot(angle, value(wheel.frame.axes.ez)),
          velocity.x,
          velocity.y,
          velocity.z,
          spin.x,
          spin.y,
          spin.z};
}

/// Columns c of A c = b for all right-hand sides at once, by elimination with row pivots; A regular.
template <std::size_t n, std::size_t m>
void solve(std::array<std::array<double, n>, n> a, std::array<std::array<double, m>, n>& b) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      for (std::size_t j = 0; j < m; ++j) b[i][j] -= factor * b[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (double& x : b[i]) x /= a[i][i];
}

} // namespace

std::array<RelativeMotion, state_numbers> relative_motions(const NominalPlacement& nominal,
                                                           const WheelState<double>& state) {
  const WheelPlacement<Number> placed = placement(nominal, state);
  std::array<std::array<double, basic_motions>, basic_motions> basic;
  std::array<std::array<double, state_numbers>, basic_motions> all;
  for (std::size_t k = 0; k < state_numbers; ++k) {
    const auto seen = seen_from_rail(placed, static_cast<int>(k));
    for (std::size_t i = 0; i < basic_motions; ++i) {
      all[i][k] = seen[i];
      if (k < basic_motions) basic[i][k] = seen[i];
    }
  }
  solve(basic, all);
  const auto ahead = [&](std::size_t k) {
    return partial(placed.wheel.frame.origin, static_cast<int>(k)).x -
           partial(placed.rail.frame.origin, static_cast<int>(k)).x;
  };
  std::array<RelativeMotion, state_numbers> motions;
  for (std::size_t k = 0; k < state_numbers; ++k) {
    for (std::size_t i = 0; i < basic_motions; ++i) motions[k].combination[i] = all[i][k];
    motions[k].ahead = ahead(k);
    for (std::size_t i = 0; i < basic_motions; ++i) motions[k].ahead -= motions[k].combination[i] * ahead(i);
    motions[k].turn = rotation(placed.rail.frame.axes, static_cast<int>(k));
  }
  motions[longitudinal_number].ahead = 1; // whether wheel or slices move
  return motions;
}

} // namespace microslip
