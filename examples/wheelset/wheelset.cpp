#include "wheelset.hpp"

#include <microslip/elasticity/hertz.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

/// A cone on a rail head.
microslip::EllipticContact wheel_on_rail(const WheelsetParameters& p) {
  constexpr double flat = std::numeric_limits<double>::infinity();
  const auto steel = microslip::Material::from_young(210e9, 0.28);
  const auto pair = microslip::combine(steel, steel);
  const auto gap = microslip::gap_curvatures({p.radius, flat, flat, p.rail_head_radius});
  const auto hertz = microslip::hertz_from_load(gap, pair, p.wheel_load);
  return {.a = hertz.a,
          .b = hertz.b,
          .shear_modulus = pair.shear_modulus,
          .poisson_ratio = pair.poisson_ratio,
          .normal_force = p.wheel_load,
          .friction = microslip::FrictionLaw::coulomb(p.friction),
          .creepage = {},
          .rolling_speed = p.speed};
}

constexpr std::array<double, 2> sides = {1, -1}; // left, right

} // namespace

Wheelset::Wheelset(const WheelsetParameters& parameters) : p_(parameters) {
  contact_.fill(wheel_on_rail(p_));
}

microslip::Creepage Wheelset::creepage(double side, const State& z) const {
  const double v = p_.speed, turning = v / p_.radius + z[rotation];
  return {(v - side * p_.half_gauge * z[yaw_rate] - turning * rolling_radius(side, z)) / v,
          z[lateral_rate] / v - z[yaw], z[yaw_rate] / v - side * p_.conicity / p_.radius};
}

/// Of xi, eta, phi to the state.
std::array<Wheelset::State, 3> Wheelset::creepage_derivatives(double side, const State& z) const {
  const double v = p_.speed, turning = v / p_.radius + z[rotation];
  std::array<State, 3> by = {};
  by[0][lateral] = -turning * side * p_.conicity / v;
  by[0][yaw_rate] = -side * p_.half_gauge / v;
  by[0][rotation] = -rolling_radius(side, z) / v;
  by[1][lateral_rate] = 1 / v;
  by[1][yaw] = -1;
  by[2][yaw_rate] = 1 / v;
  return by;
}

/// What the forces on a wheel do to the rates: levers times (fx, fy, mz).
void Wheelset::add_wheel(double side, const State& z, const microslip::ContactDerivatives& found, State& rate,
                         Jacobian& jacobian) const {
  const std::array<Vector<3>, 3> lever = {{{0, 1 / p_.mass, 0},
                                           {-side * p_.half_gauge / p_.yaw_inertia, 0, 1 / p_.yaw_inertia},
                                           {-rolling_radius(side, z) / p_.rolling_inertia, 0, 0}}};
  constexpr std::array rows = {lateral_rate, yaw_rate, rotation};
  const Vector<3> force = {found.forces.fx, found.forces.fy, found.forces.mz};
  const std::array<State, 3> by_state = creepage_derivatives(side, z);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t f = 0; f < 3; ++f) {
      rate[rows[row]] += lever[row][f] * force[f];
      for (std::size_t creep = 0; creep < 3; ++creep)
        for (std::size_t j = 0; j < states; ++j)
          jacobian[rows[row]][j] += lever[row][f] * found.jacobian[f][creep] * by_state[creep][j];
    }
  jacobian[rotation][lateral] -= side * p_.conicity / p_.rolling_inertia * force[0]; // the lever itself
}

void Wheelset::add_springs(const State& z, State& rate, Jacobian& jacobian) const {
  const double beyond = std::abs(z[lateral]) - p_.flange_clearance;
  const bool touches = beyond > 0;
  const double flange = touches ? std::copysign(p_.flange_stiffness * beyond, z[lateral]) : 0;
  rate[lateral_rate] -= (p_.lateral_stiffness * z[lateral] + flange) / p_.mass;
  rate[yaw_rate] -= p_.yaw_stiffness * z[yaw] / p_.yaw_inertia;
  jacobian[lateral_rate][lateral] -= (p_.lateral_stiffness + (touches ? p_.flange_stiffness : 0)) / p_.mass;
  jacobian[yaw_rate][yaw] -= p_.yaw_stiffness / p_.yaw_inertia;
}

void Wheelset::rates(const State& z, State& rate, Jacobian& jacobian) {
  for (std::size_t k = 0; k < 2; ++k) contact_[k].creepage = creepage(sides[k], z);
  std::array<microslip::ContactDerivatives, 2> found;
  const auto before = std::chrono::steady_clock::now();
  law_.differentiate(contact_, found);
  contact_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  contacts_ += 2;

  rate = {z[lateral_rate], z[yaw_rate], 0, 0, 0};
  jacobian = {};
  jacobian[lateral][lateral_rate] = jacobian[yaw][yaw_rate] = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    if (found[k].forces.status != microslip::Status::ok) throw std::runtime_error("the motion left all bounds");
    add_wheel(sides[k], z, found[k], rate, jacobian);
  }
  add_springs(z, rate, jacobian);
}
