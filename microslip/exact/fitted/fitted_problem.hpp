#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/row_variation.hpp"

#include <span>
#include <vector>

namespace microslip {

/// The width of each element over the grid's dx.
std::vector<double> area_shares(const FittedContact& contact);

/// w at the middle of each element's slip interval, the first term of (E25), with the slip of given displacements.
void find_rigid_slip(const FittedContact& contact, const Creepage& creepage, const RowVariation& variation,
                     std::vector<double>& cx, std::vector<double>& cy);

/// Work of the tractions per metre rolled, on the slip that there is without them [N]: that on the slip, since elastic
/// bodies give back what they store, without the error of slip between the centres of elements (E23).
double work_on_rigid_slip(const FittedContact& contact, const Creepage& creepage, const RowVariation& variation,
                          std::span<const double> px, std::span<const double> py);

} // namespace microslip
