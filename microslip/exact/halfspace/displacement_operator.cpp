#include "microslip/exact/halfspace/displacement_operator.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <vector>

namespace microslip {
namespace {

/// Scale of the mean of both components.
double scale_of(const DisplacementQuadrant& quadrant, int mx) {
  std::vector<double> mean(quadrant.xx.size());
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = (quadrant.xx[k] + quadrant.yy[k]) / 2;
  return middle_eigenvalue(mean, mx);
}

} // namespace

DisplacementOperator::DisplacementOperator(const Bodies& bodies, const ElementGrid& grid, const Progress& progress)
    : DisplacementOperator(displacement_quadrant(bodies, grid, grid.mx, progress), grid) {}

DisplacementOperator::DisplacementOperator(const DisplacementQuadrant& quadrant, const ElementGrid& grid)
    : diagonal_(quadrant.diagonal()), scale_(scale_of(quadrant, grid.mx)),
      displacement_(grid.mx, grid.my, {quadrant.xx, quadrant.xy, quadrant.yy}),
      near_inverse_(Transform::near_inverse(grid.mx, grid.my, {quadrant.xx, quadrant.xy, quadrant.yy})) {}

void DisplacementOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                 std::span<double> uy) {
  displacement_.apply(px, py, 1, ux, uy);
}

bool DisplacementOperator::precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                        std::span<double> qy) {
  near_inverse_.apply(px, py, scale_, qx, qy);
  return true;
}

} // namespace microslip
