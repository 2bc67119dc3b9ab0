#include "microslip/exact/halfspace/displacement_operator.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/numerics/precision.hpp"

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

void DisplacementOperator::apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                         std::span<double> uy) {
  if (!rough_) rough_.emplace(displacement_, 1 / diagonal_);
  px_.resize(px.size()), py_.resize(py.size());
  convert(px, 1, px_), convert(py, 1, py_);
  rough_->apply(px_, py_, 1, px_, py_);
  convert(px_, diagonal_, ux), convert(py_, diagonal_, uy);
}

bool DisplacementOperator::precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                        std::span<double> qy) {
  near_inverse_.apply(px, py, scale_, qx, qy);
  return true;
}

} // namespace microslip
