#include "microslip/simplified/fastsim2_creepage.hpp"

#include "microslip/simplified/fastsim2.hpp"
#include "microslip/vec2.hpp"

#include <cmath>

namespace microslip {
namespace {

/// The forces that are given as equations for the creepages, relative to mu Fn.
struct GivenForces {
  EllipticContact contact;
  std::optional<double> x, y;

  Vec2 misfit(const ContactForces& f) const {
    const double limit = contact.friction.peak_coefficient() * contact.normal_force;
    return {x ? (f.fx - *x) / limit : 0, y ? (f.fy - *y) / limit : 0};
  }
};

/// Newton's step for the creepages: the misfit divided by the derivatives; those of what is not given are set to one.
Vec2 newton_step(const GivenForces& given, const ContactDerivatives& d) {
  const double limit = given.contact.friction.peak_coefficient() * given.contact.normal_force;
  const auto& j = d.jacobian;
  const double xx = given.x ? j[0][0] / limit : 1, xy = given.x && given.y ? j[0][1] / limit : 0;
  const double yy = given.y ? j[1][1] / limit : 1, yx = given.x && given.y ? j[1][0] / limit : 0;
  const Vec2 m = given.misfit(d.forces);
  const double determinant = xx * yy - xy * yx;
  return {-(yy * m.x - xy * m.y) / determinant, -(xx * m.y - yx * m.x) / determinant};
}

} // namespace

std::optional<Creepage> creepage_from_fastsim2(const EllipticContact& contact, std::optional<double> force_x,
                                               std::optional<double> force_y) {
  constexpr double good_enough = 1e-4;
  constexpr int most_steps = 40, most_trials = 10;
  SimplifiedOptions options;
  options.bound = TractionBound::elliptic;
  options.flexibility = FlexibilityModel::blended;
  Fastsim2 solver(options);
  GivenForces given{contact, force_x, force_y};
  given.contact.dissimilarity = 0;
  Creepage& c = given.contact.creepage;
  if (force_x) c.longitudinal = 0;
  if (force_y) c.lateral = 0;
  ContactDerivatives d = solver.differentiate(given.contact);
  for (int step = 0; step < most_steps; ++step) {
    const Vec2 misfit = given.misfit(d.forces);
    const double size = std::hypot(misfit.x, misfit.y);
    if (size < good_enough) return c;
    const Vec2 change = newton_step(given, d);
    const Creepage before = c;
    double after = size, length = 1;
    for (int trial = 0; trial < most_trials; ++trial, length /= 2) {
      c.longitudinal = before.longitudinal + length * change.x;
      c.lateral = before.lateral + length * change.y;
      d = solver.differentiate(given.contact);
      const Vec2 left = given.misfit(d.forces);
      after = std::hypot(left.x, left.y);
      if (after < size) break;
    }
    if (!(after < size)) return {};
  }
  return {};
}

} // namespace microslip
