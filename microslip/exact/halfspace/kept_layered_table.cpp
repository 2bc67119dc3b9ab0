#include "microslip/exact/halfspace/kept_layered_table.hpp"

namespace microslip {
namespace {

bool has_elements_of(const InfluenceTable& table, const ElementGrid& grid, int ahead) {
  return table.mx() == grid.mx + ahead && table.my() == grid.my && table.dx() == grid.dx && table.dy() == grid.dy &&
         table.is_of_strips() == grid.line && table.shape() == grid.shape;
}

} // namespace

LayeredSurfaces& KeptLayeredTable::surfaces(const LayeredBodies& bodies) {
  if (!surfaces_ || surfaces_->bodies() != bodies) {
    table_.reset();
    surfaces_.emplace(bodies);
  }
  return *surfaces_;
}

std::shared_ptr<const InfluenceTable> KeptLayeredTable::table(const LayeredBodies& bodies, const ElementGrid& grid,
                                                              std::optional<double> far, const Progress& progress,
                                                              int ahead) {
  LayeredSurfaces& kept = surfaces(bodies);
  if (!table_ || far_ != far || !has_elements_of(*table_, grid, ahead)) {
    table_ = layered_table(kept, grid, far, progress, ahead);
    far_ = far;
  }
  return table_;
}

} // namespace microslip
