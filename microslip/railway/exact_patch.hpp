#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/exact/fitted/row_variation.hpp"
#include "microslip/railway/patch_outline.hpp"

#include <functional>
#include <vector>

namespace microslip {

/// A patch for the exact theory: elements over its contact, gaps, and how each row moves.
class ExactPatch {
public:
  /// Elements of the size dx, ds [m] over all of the outline, which holds the contact. `contact_gap` < 0 is the gap of
  /// the wheel's surface whose velocity the creepages take (PatchSurface::creepage). Rows outside the profiles are far
  /// apart.
  ExactPatch(const PatchSurface& surface, const PatchOutline& outline, PatchShape shape, double dx, double ds,
             double contact_gap, double speed);

  const ElementGrid& grid() const { return grid_; }
  const PatchRow& row(int j) const { return rows_[static_cast<std::size_t>(j)]; }

  /// The normal force [N] if the wheel comes nearer by `approach` [m] along the frame's normal, and its tractions and
  /// fields if `normal_force` is given. `friction` is mu over the inclination of a row [rad].
  double normal_force(const CombinedMaterial& material, double approach) const;
  struct Rolled {
    ContactSolution solution; ///< in the frame
    double approach = 0;      ///< by how much the wheel comes nearer, beyond where it is [m]
  };
  Rolled roll(const CombinedMaterial& material, double normal_force,
              const std::function<double(double angle)>& friction, RollingDirection direction) const;

private:
  ElementGrid grid_;
  std::vector<PatchRow> rows_;
  std::vector<Creepage> creepage_; ///< of each row about (0, s)
  double least_ = 0;               ///< the least gap, < 0 where the bodies overlap [m]
  std::vector<double> gaps_;       ///< over the least one [m]
  double speed_;
};

} // namespace microslip
