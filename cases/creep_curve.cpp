#include "cases/creep_curve.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::cases {
namespace {

struct Variable {
  const char* name;
  const char* unit;
  double Creepage::*member;
  double sliding; ///< where linear theory reaches full sliding
};

Variable choose_variable(const EllipticContact& contact) {
  const auto& creepage = contact.creepage;
  const auto coefficients = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const auto area = contact.a * contact.b;
  const auto limit = contact.friction.peak_coefficient() * contact.normal_force / (contact.shear_modulus * area);
  if (creepage.longitudinal == 0 && creepage.lateral == 0 && creepage.spin != 0)
    return {"spin", "1/m", &Creepage::spin, limit / (coefficients.c23 * std::sqrt(area))};
  if (std::abs(creepage.longitudinal) >= std::abs(creepage.lateral))
    return {"creepage_longitudinal", "-", &Creepage::longitudinal, limit / coefficients.c11};
  return {"creepage_lateral", "-", &Creepage::lateral, limit / coefficients.c22};
}

} // namespace

CreepCurve creep_curve(const EllipticContact& contact, int points,
                       const std::function<ContactForces(const EllipticContact&)>& solve, CurveSpan span) {
  const auto variable = choose_variable(contact);
  const auto point = contact.creepage.*variable.member;
  const auto end = std::copysign(3 * std::max(std::abs(point), variable.sliding), point);
  CreepCurve curve = {
      .variable = variable.name, .unit = variable.unit, .value = {}, .forces = {}, .point_value = point};
  const double begin = span == CurveSpan::both_signs ? -end : 0;
  auto moved = contact;
  for (int i = 0; i < points; ++i) {
    moved.creepage.*variable.member = begin + (end - begin) * i / (points - 1);
    curve.value.push_back(moved.creepage.*variable.member);
    curve.forces.push_back(solve(moved));
  }
  return curve;
}

} // namespace microslip::cases
