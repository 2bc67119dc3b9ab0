#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/exact/halfspace/rolled_influence.hpp"
#include "microslip/progress.hpp"

#include <memory>
#include <optional>

namespace microslip {

/// Two layered bodies with what their layers add to the influence of elements, found once for grid after grid.
class LayeredSurfaces {
public:
  /// Throws Error for values out of range and two rigid bodies.
  explicit LayeredSurfaces(const LayeredBodies& bodies);

  const LayeredBodies& bodies() const { return bodies_; }
  /// Influence of elements when the bodies are rolled over along +x.
  InfluenceRows find(const ElementSides& sides, int columns, int rows, const Progress& progress);

private:
  LayeredBodies bodies_;
  std::optional<RolledLayers> layers1_, layers2_;
};

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
  LayeredInfluence(LayeredSurfaces& surfaces, const ElementSides& sides, int columns, int rows,
                   const Progress& progress = {});

  /// Influence of an element on the one i columns and j rows further [m/Pa].
  Influence at(int i, int j) const;

private:
  InfluenceRows rows_; ///< of rolling along +x
  bool mirrored_;      ///< they roll along -x
};

/// Table of the influence of layered bodies' elements, for ElementResponse: `ahead` columns more than the grid has,
/// which slip in rolling over that many elements in a step needs. That of viscoelastic bodies is for steady rolling
/// with their speed. Throws Error as LayeredInfluence does, and for bilinear strips. In line contact
/// displacements of half-spaces below layers approach 0 at the distance `far` from the element, or else at the grid's
/// length; those of layers on rigid cores decay by themselves.
std::shared_ptr<const InfluenceTable> layered_table(const LayeredBodies& bodies, const ElementGrid& grid,
                                                    const Progress& progress = {});
std::shared_ptr<const InfluenceTable> layered_table(LayeredSurfaces& surfaces, const ElementGrid& grid,
                                                    std::optional<double> far = {}, const Progress& progress = {},
                                                    int ahead = 1);

} // namespace microslip
