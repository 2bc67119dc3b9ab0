#include "validation/relative_forces.hpp"

#include "microslip/rolling/accurate_contact.hpp"
#include "validation/hertzian_solve.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

RelativeForces relative(const ContactForces& forces, const EllipticContact& contact) {
  const double bound = contact.friction.static_coefficient() * contact.normal_force;
  return {forces.fx / bound, forces.fy / bound, forces.mz / (bound * std::sqrt(contact.a * contact.b))};
}

bool slides_in_part(const ContactForces& forces, const EllipticContact& contact) {
  const Creepage& c = contact.creepage;
  const bool moves = c.longitudinal != 0 || c.lateral != 0 || c.spin != 0;
  return moves && forces.adhesion_area > 1e-3 * std::numbers::pi * contact.a * contact.b;
}

RelativeForces limit(const RelativeForces& coarse, int coarse_elements, const RelativeForces& fine, int fine_elements) {
  const auto of = [&](double RelativeForces::*component) {
    return limit(coarse.*component, coarse_elements, fine.*component, fine_elements);
  };
  return {of(&RelativeForces::fx), of(&RelativeForces::fy), of(&RelativeForces::mz)};
}

RelativeForces limit_of_second_order(const RelativeForces& coarse, const RelativeForces& fine) {
  return {microslip::limit_of_second_order(coarse.fx, fine.fx), microslip::limit_of_second_order(coarse.fy, fine.fy),
          microslip::limit_of_second_order(coarse.mz, fine.mz)};
}

std::vector<double> differences(const std::vector<RelativeForces>& results,
                                const std::vector<RelativeForces>& reference, double RelativeForces::*component,
                                const std::vector<bool>* only) {
  std::vector<double> e;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!only || (*only)[i]) e.push_back(std::abs(results[i].*component - reference[i].*component));
  return e;
}

} // namespace microslip::validation
