#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/exact/halfspace/rolled_influence.hpp"
#include "microslip/progress.hpp"

#include <memory>

namespace microslip {

/// Displacement differences u1 - u2 of layered bodies at the elements' centres by offset, from unit tractions on
/// rectangular elements, or strips: that of two half-spaces of the surfaces' materials in closed form, (E7) to (E9),
/// with their creep (B4), and what layers add. Normal tractions move body 2's surface along it the other way: uxz and
/// uyz are differences. uxz = -uzx, uyz = -uzy, uyx = uxy, as of half-spaces.
class LayeredInfluence {
public:
  /// For offsets of fewer than `columns` along x and `rows` along y, one row of strips. Throws Error for values out of
  /// range and two rigid bodies; Stopped if `progress` returns false.
  LayeredInfluence(const LayeredBodies& bodies, const ElementSides& sides, int columns, int rows,
                   const Progress& progress = {});

  /// Influence of an element on the one i columns and j rows further [m/Pa].
  Influence at(int i, int j) const;

private:
  InfluenceRows rows_; ///< of rolling along +x
  bool mirrored_;      ///< they roll along -x
};

/// Table of the influence of layered bodies' elements, for ElementResponse: one column more than the grid has, which
/// slip in rolling needs. That of viscoelastic bodies is for steady rolling with their speed. Throws Error as
/// LayeredInfluence does, and for other elements than constant ones. In line contact displacements of half-spaces below
/// layers approach 0 at the grid's length from the element; those of layers on rigid cores decay by themselves.
std::shared_ptr<const InfluenceTable> layered_table(const LayeredBodies& bodies, const ElementGrid& grid,
                                                    const Progress& progress = {});

} // namespace microslip
