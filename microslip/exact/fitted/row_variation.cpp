#include "microslip/exact/fitted/row_variation.hpp"

namespace microslip {

std::vector<double> friction_bound(const FittedContact& contact, double capacity, const RowVariation& variation) {
  std::vector<double> bound = contact.load_share;
  for (std::size_t k = 0; k < bound.size(); ++k)
    bound[k] *= capacity * variation.friction_at(contact.grid.y(contact.elements[k].row));
  return bound;
}

} // namespace microslip
