#include "microslip/exact/fitted/coarse_start.hpp"

#include "microslip/exact/halfspace/traction_shares.hpp"

namespace microslip {

VectorField start_from_coarser(const FittedContact& coarse, std::span<const double> coarse_bound,
                               const VectorField& tractions, const FittedContact& fine, std::span<const double> bound) {
  TractionShares shares(coarse.grid);
  for (std::size_t k = 0; k < coarse.elements.size(); ++k)
    shares.add(coarse.elements[k].row, coarse.elements[k].centre(), coarse_bound[k], {tractions.x[k], tractions.y[k]});
  VectorField start;
  for (std::size_t k = 0; k < fine.elements.size(); ++k) {
    const FittedElement& e = fine.elements[k];
    const Vec2 share = shares.at(e.centre(), fine.grid.y(e.row));
    start.x.push_back(bound[k] * share.x);
    start.y.push_back(bound[k] * share.y);
  }
  return start;
}

} // namespace microslip
