#pragma once

#include "fmi/tangential_law.hpp"

#include <array>
#include <cstddef>

namespace microslip::fmi {

/// The variables of the unit by their value references, which modelDescription.xml repeats; real and integer ones are
/// counted apart. Inputs come first, then outputs.
enum RealVariable : unsigned {
  creepage_longitudinal,
  creepage_lateral,
  spin,
  normal_force,
  friction,
  fx,
  fy,
  mz,
  adhesion_area,
  slip_area,
  semi_axis_x,
  semi_axis_y,
  reference_force,
  shear_modulus,
  poisson_ratio,
  real_count
};
enum IntegerVariable : unsigned { mx, my, contact_status, integer_count };

constexpr bool is_input(RealVariable v) {
  return v <= friction;
}
constexpr bool is_output(RealVariable v) {
  return v >= fx && v <= mz;
}
constexpr bool is_parameter(RealVariable v) {
  return v >= semi_axis_x;
}
constexpr bool is_parameter(IntegerVariable v) {
  return v != contact_status;
}

struct Variables {
  std::array<double, real_count> real;
  std::array<int, integer_count> integer;

  /// Start values.
  Variables() : real{}, integer{} {
    const LawInput input;
    const LawParameters p;
    real[normal_force] = input.normal_force, real[friction] = input.friction;
    real[semi_axis_x] = p.semi_axis_x, real[semi_axis_y] = p.semi_axis_y;
    real[reference_force] = p.reference_force, real[shear_modulus] = p.shear_modulus;
    real[poisson_ratio] = p.poisson_ratio;
    integer[mx] = p.mx, integer[my] = p.my;
  }

  LawInput input() const {
    return {.creepage = {real[creepage_longitudinal], real[creepage_lateral], real[spin]},
            .normal_force = real[normal_force],
            .friction = real[friction]};
  }
  LawParameters parameters() const {
    return {.semi_axis_x = real[semi_axis_x],
            .semi_axis_y = real[semi_axis_y],
            .reference_force = real[reference_force],
            .shear_modulus = real[shear_modulus],
            .poisson_ratio = real[poisson_ratio],
            .mx = integer[mx],
            .my = integer[my]};
  }
  void set_results(const ContactForces& forces) {
    real[fx] = forces.fx, real[fy] = forces.fy, real[mz] = forces.mz;
    real[adhesion_area] = forces.adhesion_area, real[slip_area] = forces.slip_area;
    integer[contact_status] = static_cast<int>(forces.status);
  }
};

} // namespace microslip::fmi
