#include "cases/creep_curve.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

/// How far a curve is from the straight line between two neighbouring points, about: the length squared over 8 times
/// the second derivative at either end.
double bend_behind(const CreepCurve& curve, std::size_t first) {
  const auto second_derivative = [&](std::size_t i) {
    const auto slope = [&](std::size_t k, double ContactForces::*force) {
      return (curve.forces[k + 1].*force - curve.forces[k].*force) / (curve.value[k + 1] - curve.value[k]);
    };
    const auto change = [&](double ContactForces::*force) { return slope(i, force) - slope(i - 1, force); };
    const double length = std::abs(curve.value[i + 1] - curve.value[i - 1]) / 2;
    return std::hypot(change(&ContactForces::fx), change(&ContactForces::fy)) / length;
  };
  double largest = 0;
  for (const std::size_t i : {first, first + 1})
    if (i > 0 && i + 1 < curve.value.size()) largest = std::max(largest, second_derivative(i));
  const double length = curve.value[first + 1] - curve.value[first];
  return length * length / 8 * largest;
}

/// The first of the two points between which the curve bends most; of straight lines the ones farthest apart.
std::size_t most_bent(const CreepCurve& curve) {
  constexpr double evenness = 1e-3; // of the largest force: a smaller bend is not seen
  double force = std::numeric_limits<double>::min();
  for (const ContactForces& one : curve.forces) force = std::max(force, std::hypot(one.fx, one.fy));
  std::size_t most = 0;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < curve.value.size(); ++i) {
    const double length = (curve.value[i + 1] - curve.value[i]) / (curve.value.back() - curve.value.front());
    const double bend = bend_behind(curve, i) / force + evenness * length;
    if (bend > largest) most = i, largest = bend;
  }
  return most;
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
  const auto insert = [&](std::size_t at, double value) {
    moved.creepage.*variable.member = value;
    curve.value.insert(curve.value.begin() + static_cast<std::ptrdiff_t>(at), value);
    curve.forces.insert(curve.forces.begin() + static_cast<std::ptrdiff_t>(at), solve(moved));
  };
  const int even = std::max(2, points / 2 + 1);
  for (int i = 0; i < even; ++i) insert(curve.value.size(), begin + (end - begin) * i / (even - 1));
  for (int i = even; i < points; ++i) {
    const std::size_t first = most_bent(curve);
    insert(first + 1, (curve.value[first] + curve.value[first + 1]) / 2);
  }
  return curve;
}

} // namespace microslip::cases
