#pragma once

#include "friction_cases.hpp"
#include "test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace microslip {

/// A bound on the grid of an ellipse a x b: an ellipsoid, one that varies from element to element and has holes, or two
/// patches, one behind or beside the other.
inline Field random_bound(RandomContacts& random, const FrictionCase& c, double a, double b) {
  const HertzContact hertz = hertz_from_ellipse(a, b, c.material, c.material.shear_modulus * a * b * 1e-3);
  const double friction = random.between(0.05, 0.8);
  const int shape = static_cast<int>(random.between(0, 4));
  Field bound;
  for (int j = 0; j < c.grid.my; ++j)
    for (int i = 0; i < c.grid.mx; ++i) {
      const double x = c.grid.x(i), y = c.grid.y(j);
      double p = hertz.pressure(x, y);
      if (shape == 1) p *= random.between(0, 1) < 0.15 ? 0 : random.between(0.2, 2);
      if (shape == 2) p = hertz.pressure(2.2 * x - 1.1 * a, y) + 0.7 * hertz.pressure(2.2 * x + 1.1 * a, 1.3 * y);
      if (shape == 3) p = hertz.pressure(x, 2.2 * y - 1.1 * b) + 0.7 * hertz.pressure(1.3 * x, 2.2 * y + b);
      bound.push_back(friction * p);
    }
  return bound;
}

/// A problem of this motion, of 1 x 1 to 13 x 13 elements: a/b 0.1 to 10, nu 0 to 0.5, creepages from nearly full
/// adhesion to full sliding, spin up to 4 times that of saturation, steps of 0.55 to 8 elements, either direction, from
/// a state before or from none, creepages given or one or both forces.
inline FrictionCase random_friction_case(RandomContacts& random, ContactMotion motion) {
  FrictionCase c;
  const double ratio = random.about(0.1, 10), size = random.about(1e-3, 1e-2);
  const double a = size * std::sqrt(ratio), b = size / std::sqrt(ratio);
  c.material = {random.about(1e7, 1e11), random.between(0, 0.5), 0};
  const int columns = static_cast<int>(random.between(1, 14)), rows = static_cast<int>(random.between(1, 14));
  c.grid = ElementGrid::across_ellipse(a, b, columns, rows, 1);
  c.bound = random_bound(random, c, a, b);

  TangentialInput& input = c.input;
  input.motion = motion;
  input.tolerance = 1e-10;
  input.step = random.about(0.55, 8) * c.grid.dx;
  input.direction = random.between(0, 1) < 0.5 ? RollingDirection::forward : RollingDirection::backward;
  input.spin_offset = random.between(0, 1);
  const CreepageCoefficients k = creepage_coefficients(ratio, c.material.poisson_ratio);
  const double way = motion == ContactMotion::shift ? a : motion == ContactMotion::steady ? 1 : a / input.step;
  const double unit = way * c.capacity() / (c.material.shear_modulus * a * b), angle = random.between(0, 6.28);
  const double creep = random.about(0.02, 4), spin = random.between(0, 1) < 0.3 ? 0 : random.between(-4, 4);
  input.creepage = {unit / k.c11 * creep * std::cos(angle), unit / k.c22 * creep * std::sin(angle),
                    unit / (k.c23 * size) * spin};
  if (motion != ContactMotion::steady && random.between(0, 1) < 0.6) {
    FrictionCase first = c;
    first.input.creepage = {-input.creepage.lateral, input.creepage.longitudinal, -input.creepage.spin};
    c = after(c, first);
  }
  const int given = static_cast<int>(random.between(0, 6));
  const double share = random.between(0, 1) < 0.2 ? 1 - random.about(1e-3, 0.1) : random.between(0, 0.95);
  const double to = random.between(0, 6.28);
  if (given == 1 || given == 3) c.input.force_x = share * c.capacity() * std::cos(to);
  if (given == 2 || given == 3) c.input.force_y = share * c.capacity() * std::sin(to);
  c.name = std::to_string(columns) + " x " + std::to_string(rows) + ", a/b " + std::to_string(ratio) + ", nu " +
           std::to_string(c.material.poisson_ratio) + ", creep " + std::to_string(creep) + ", spin " +
           std::to_string(spin) + ", forces " + std::to_string(given < 4 ? given : 0);
  return c;
}

} // namespace microslip
