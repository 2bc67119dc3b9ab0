#pragma once

#include "microslip/contact/elliptic_contact.hpp"

#include <vector>

namespace microslip::validation {

/// Forces over mu Fn, moment over mu Fn sqrt(a b).
struct RelativeForces {
  double fx, fy, mz;
};

RelativeForces relative(const ContactForces& forces, const EllipticContact& contact);

/// Neither without creepage nor in full sliding: more than a thousandth of the contact adheres.
bool slides_in_part(const ContactForces& forces, const EllipticContact& contact);

/// Limit of an error C/n from the values on n and fewer elements across.
RelativeForces limit(const RelativeForces& coarse, int coarse_elements, const RelativeForces& fine, int fine_elements);

/// Limit of the exact theory at second order from a grid and one with twice the elements across, of each component.
RelativeForces limit_of_second_order(const RelativeForces& coarse, const RelativeForces& fine);

/// |results - reference| of one component, of all cases or of those marked.
std::vector<double> differences(const std::vector<RelativeForces>& results,
                                const std::vector<RelativeForces>& reference, double RelativeForces::*component,
                                const std::vector<bool>* only = nullptr);

} // namespace microslip::validation
