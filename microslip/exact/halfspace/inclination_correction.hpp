#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/exact/halfspace/inclined_product.hpp"

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// Addition of the inclination of rows to the displacements of a half-space, (B - A) p (RowInclination), at the centres
/// of a grid's elements. B - A is small beside A, and bounded where A is singular: it may be taken from the tractions
/// of the last iteration. Cost of a product and of an InclinedProduct.
class InclinationCorrection {
public:
  InclinationCorrection(const CombinedMaterial& material, const ElementGrid& grid, const RowInclination& inclination);

  using Fields = std::array<std::vector<double>, 3>; ///< along x, lateral, normal
  /// Tractions and pressure [Pa]; displacements [m].
  Fields find(const Fields& tractions);

private:
  InclinedProduct product_;
};

} // namespace microslip
