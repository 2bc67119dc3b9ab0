#pragma once

#include "microslip/exact/halfspace/layered_influence.hpp"

#include <memory>
#include <optional>

namespace microslip {

/// Tables of the influence of layered bodies' elements for one problem after another: kernels are kept as long as the
/// bodies are the same, a table as long as its elements are, too. What was asked for before changes no number.
class KeptLayeredTable {
public:
  /// The bodies with their kernels. Throws Error as LayeredSurfaces does.
  LayeredSurfaces& surfaces(const LayeredBodies& bodies);
  /// Throws Error and Stopped as layered_table does, whose arguments these are.
  std::shared_ptr<const InfluenceTable> table(const LayeredBodies& bodies, const ElementGrid& grid,
                                              std::optional<double> far, const Progress& progress, int ahead = 1);

private:
  std::optional<LayeredSurfaces> surfaces_;
  std::shared_ptr<const InfluenceTable> table_; ///< of the surfaces
  std::optional<double> far_;                   ///< of the table
};

} // namespace microslip
