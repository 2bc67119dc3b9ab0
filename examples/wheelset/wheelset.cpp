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
constexpr std::array rows = {Wheelset::lateral_rate, Wheelset::yaw_rate, Wheelset::rotation};

Vector<3> force_of(const microslip::ContactForces& forces) {
  if (forces.status != microslip::Status::ok) throw std::runtime_error("the motion left all bounds");
  return {forces.fx, forces.fy, forces.mz};
}

} // namespace

Wheelset::Wheelset(const WheelsetParameters& parameters) : p_(parameters) {
  contact_.fill(wheel_on_rail(p_));
}

microslip::Creepage Wheelset::creepage(double side, const State& z) const {
  const double v = p_.speed, turning = v / p_.radius + z[rotation];
  return {(v - side * p_.half_gauge * z[yaw_rate] - turning * rolling_radius(side, z)) / v,
          z[lateral_rate] / v - z[yaw], z[yaw_rate] / v - side * p_.conicity / p_.radius};
}

/// Of xi, eta, phi with respect to the state.
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

std::array<Vector<3>, 3> Wheelset::levers(double side, const State& z) const {
  return {{{0, 1 / p_.mass, 0},
           {-side * p_.half_gauge / p_.yaw_inertia, 0, 1 / p_.yaw_inertia},
           {-rolling_radius(side, z) / p_.rolling_inertia, 0, 0}}};
}

void Wheelset::add_wheel(double side, const State& z, const microslip::ContactDerivatives& found,
                         Jacobian& jacobian) const {
  const auto lever = levers(side, z);
  const std::array<State, 3> by_state = creepage_derivatives(side, z);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t f = 0; f < 3; ++f)
      for (std::size_t creep = 0; creep < 3; ++creep)
        for (std::size_t j = 0; j < states; ++j)
          jacobian[rows[row]][j] += lever[row][f] * found.jacobian[f][creep] * by_state[creep][j];
  jacobian[rotation][lateral] -= side * p_.conicity / p_.rolling_inertia * found.forces.fx; // the lever itself
}

double Wheelset::flange_force(double displacement) const {
  const double beyond = std::abs(displacement) - p_.flange_clearance;
  return beyond > 0 ? std::copysign(p_.flange_stiffness * beyond, displacement) : 0;
}

Wheelset::State Wheelset::without_derivatives(const State& z, const std::array<Vector<3>, 2>& forces) const {
  State rate = {z[lateral_rate], z[yaw_rate], 0, 0, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto lever = levers(sides[k], z);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t f = 0; f < 3; ++f) rate[rows[row]] += lever[row][f] * forces[k][f];
  }
  rate[lateral_rate] -= (p_.lateral_stiffness * z[lateral] + flange_force(z[lateral])) / p_.mass;
  rate[yaw_rate] -= p_.yaw_stiffness * z[yaw] / p_.yaw_inertia;
  return rate;
}

template <class Solve> void Wheelset::solve_contacts(const State& z, const Solve& solve) {
  for (std::size_t k = 0; k < 2; ++k) contact_[k].creepage = creepage(sides[k], z);
  const auto before = std::chrono::steady_clock::now();
  solve();
  contact_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  contacts_ += 2;
}

void Wheelset::rates(const State& z, State& rate) {
  std::array<microslip::ContactForces, 2> found;
  solve_contacts(z, [&] { law_.solve(contact_, found); });
  rate = without_derivatives(z, {force_of(found[0]), force_of(found[1])});
}

void Wheelset::rates(const State& z, State& rate, Jacobian& jacobian) {
  std::array<microslip::ContactDerivatives, 2> found;
  solve_contacts(z, [&] { law_.differentiate(contact_, found); });
  rate = without_derivatives(z, {force_of(found[0].forces), force_of(found[1].forces)});
  jacobian = {};
  jacobian[lateral][lateral_rate] = jacobian[yaw][yaw_rate] = 1;
  for (std::size_t k = 0; k < 2; ++k) add_wheel(sides[k], z, found[k], jacobian);
  const bool touches = flange_force(z[lateral]) != 0;
  jacobian[lateral_rate][lateral] -= (p_.lateral_stiffness + (touches ? p_.flange_stiffness : 0)) / p_.mass;
  jacobian[yaw_rate][yaw] -= p_.yaw_stiffness / p_.yaw_inertia;
}
