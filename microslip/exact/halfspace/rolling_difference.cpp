#include "microslip/exact/halfspace/rolling_difference.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cstdlib>

namespace microslip {
namespace {

SymmetricToeplitz<double> transform_of(const DisplacementQuadrant& quadrant, int mx, int my) {
  return {mx, my, {quadrant.xx, quadrant.xy, quadrant.yy}};
}

} // namespace

RollingDifference::RollingDifference(const Bodies& bodies, const ElementGrid& grid, int columns,
                                     const Progress& progress)
    : RollingDifference(displacement_quadrant(bodies, grid, grid.mx + std::abs(columns), progress), grid, columns) {}

RollingDifference::RollingDifference(const DisplacementQuadrant& quadrant, const ElementGrid& grid, int columns)
    : mx_(grid.mx), my_(grid.my), columns_(columns), length_(std::abs(columns) * grid.dx),
      diagonal_((quadrant.diagonal() - (quadrant.xx[std::abs(columns)] + quadrant.yy[std::abs(columns)]) / 2) /
                length_),
      displacement_(transform_of(quadrant, grid.mx + std::abs(columns), grid.my)) {}

/// u of the grid's first element; that of element (i, j) is j stride + i further, on to the columns that particles come
/// from.
const RollingDifference::Complex* RollingDifference::displace(std::span<const double> px, std::span<const double> py) {
  const std::size_t stride = displacement_.stride(), first = static_cast<std::size_t>(std::max(-columns_, 0));
  Complex* field = displacement_.cleared_field() + first;
  for (int j = 0; j < my_; ++j)
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      field[j * stride + i] = {px[k], py[k]};
    }
  return displacement_.apply() + first;
}

void RollingDifference::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                              std::span<double> sy) {
  const Complex* row = displace(px, py);
  for (int j = 0; j < my_; ++j, row += displacement_.stride())
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      const Complex slip = (row[i] - row[i + columns_]) / length_;
      sx[k] = slip.real();
      sy[k] = slip.imag();
    }
}

void RollingDifference::displacement(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                     std::span<double> uy) {
  const Complex* row = displace(px, py);
  for (int j = 0; j < my_; ++j, row += displacement_.stride())
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      ux[k] = row[i].real();
      uy[k] = row[i].imag();
    }
}

} // namespace microslip
