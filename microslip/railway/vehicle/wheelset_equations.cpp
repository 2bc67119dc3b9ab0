#include "microslip/railway/vehicle/wheelset_equations.hpp"

#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr std::size_t column(WheelsetVariable which) {
  return static_cast<std::size_t>(which);
}
/// The numbers of the state come first, in the same order as for a wheel.
static_assert(column(WheelsetVariable::vertical_force) == basic_motions);
static_assert(static_cast<std::size_t>(WheelVariable::yaw_velocity) == column(WheelsetVariable::yaw_velocity));

/// Indices of the unknowns in the state, and in the table of results.
constexpr std::array<std::size_t, 3> results = {6, 7, 8};
constexpr std::array<std::size_t, 3> numbers = {column(WheelsetVariable::vertical), column(WheelsetVariable::roll),
                                                column(WheelsetVariable::pitch_velocity)};

Vec3<double> axle(const WheelState<double>& s) {
  return rotation_about_x(s.roll) * rotation_about_z(s.yaw).ey;
}

} // namespace

WheelsetEquations::WheelsetEquations(const WheelsetState& state, const WheelsetLoad& load, const WheelPair& wheels,
                                     double vertical_force)
    : has_load_(load.vertical.has_value()), has_torque_(load.axle_torque.has_value()) {
  const double base = wheels.half_base(), radius = wheels.nominal_radius();
  double whole = std::max(std::abs(vertical_force), 1.0);
  if (has_load_) {
    if (const auto* both = std::get_if<AxleLoad>(&*load.vertical)) {
      whole = both->vertical_force;
      value_ = {whole, both->roll_moment};
      sizes_[1] = whole * base;
    } else {
      const auto& [left, right] = std::get<WheelLoads>(*load.vertical);
      whole = left + right;
      has_wheel_loads_ = true;
      value_ = {whole, left - right};
      sizes_[1] = whole;
    }
  }
  value_[2] = -load.axle_torque.value_or(0);
  sizes_[0] = whole, sizes_[2] = whole * radius;
  constexpr double lift = 1e-5, creepage = 1e-3, least_speed = 1e-3; // [m], [-], [m/s]
  const double speed = std::max(std::abs(state.left.forward_velocity), least_speed);
  sizes_of_unknowns_ = {lift, lift / base, creepage * speed / radius};
}

WheelsetState WheelsetEquations::moved(WheelsetState state, const Vector& step) const {
  state.left.vertical += step[height] * size_of(height);
  state.left.roll += step[roll] * size_of(roll);
  state.left.pitch_velocity += step[pitch_velocity] * size_of(pitch_velocity);
  return state;
}

WheelsetEquations::Vector WheelsetEquations::scaled(const Vector& found) const {
  Vector r{};
  for (std::size_t i = 0; i < r.size(); ++i)
    if (finds(i)) r[i] = found[i] / sizes_[i];
  return r;
}

WheelsetEquations::Vector WheelsetEquations::residual(const WheelsetState& state, const WheelsetSolution& found) const {
  const double second = has_wheel_loads_ ? found.left.force.z - found.right.force.z : found.moment.x;
  return scaled({found.force.z - value_[0], second - value_[1], dot(axle(state.left), found.moment) - value_[2]});
}

/// Derivatives of the residuals by a number of the state.
WheelsetEquations::Vector WheelsetEquations::slope(const WheelsetState& state, const WheelsetSolution& found,
                                                   const WheelPairDerivatives& by, std::size_t number) const {
  const Vec3<double> direction = axle(state.left), moment = by.moment[number];
  const double second = has_wheel_loads_ ? by.difference[number] : moment.x;
  return scaled({by.force[number].z, second,
                 dot(direction, moment) + dot(cross(turning_axis(state.left, number), direction), found.moment)});
}

WheelsetEquations::Matrix WheelsetEquations::jacobian(const WheelsetState& state, const WheelsetSolution& found,
                                                      const WheelPairDerivatives& by) const {
  Matrix m{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector column = slope(state, found, by, numbers[j]);
    for (std::size_t i = 0; i < 3; ++i) m[3 * i + j] = finds(i) && finds(j) ? column[i] * size_of(j) : i == j;
  }
  return m;
}

void WheelsetEquations::hold(const WheelsetState& state, const WheelsetSolution& found, const WheelPairDerivatives& by,
                             WheelsetDerivatives& out) const {
  const Matrix matrix = jacobian(state, found, by);
  // Adds what the unknowns do when the residuals would change by `change` with a variable.
  const auto add = [&](std::size_t variable, const Vector& change) {
    const auto moved = solve_linear<3>(matrix, change);
    if (!moved) return;
    Vec3<double> force = out.force(variable), moment = out.moment(variable);
    for (std::size_t j = 0; j < 3; ++j) {
      if (!finds(j)) continue;
      const double unknown = out.at(results[j], variable) = -(*moved)[j] * size_of(j);
      force = force + unknown * by.force[numbers[j]];
      moment = moment + unknown * by.moment[numbers[j]];
    }
    out.set(variable, force, moment);
  };
  for (std::size_t k = 0; k < basic_motions; ++k) {
    const auto unknown = static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), k) - numbers.begin());
    if (unknown < 3 && finds(unknown)) continue;
    out.set(k, by.force[k], by.moment[k]);
    add(k, slope(state, found, by, k));
  }
  const double by_force = -1 / sizes_[0], by_second = -1 / sizes_[1];
  if (has_wheel_loads_) {
    add(column(WheelsetVariable::vertical_force_left), {by_force, by_second, 0});
    add(column(WheelsetVariable::vertical_force_right), {by_force, -by_second, 0});
  } else if (has_load_) {
    add(column(WheelsetVariable::vertical_force), {by_force, 0, 0});
    add(column(WheelsetVariable::roll_moment), {0, by_second, 0});
  }
  if (has_torque_) add(column(WheelsetVariable::axle_torque), {0, 0, 1 / sizes_[2]});
}

} // namespace microslip
