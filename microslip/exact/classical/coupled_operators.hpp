#pragma once

#include "microslip/contact/motion.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"

#include <memory>

namespace microslip {

/// The maps from tractions and pressure to slip and displacements of a grid's elements that a step of coupled bodies
/// needs. Each is made when it is first asked for, and kept for the next step of the same motion and length.
class CoupledOperators {
public:
  CoupledOperators(const Bodies& bodies, const ElementGrid& grid, const ElementResponse& response = {})
      : bodies_(bodies), grid_(grid), response_(response) {}

  const ElementGrid& grid() const { return grid_; }
  /// Displacements at the elements.
  CoupledOperator& displacement(const Progress& progress = {});
  /// Displacements at the points `offset` further.
  CoupledOperator& displacement_at(Vec2 offset, const Progress& progress);
  /// Slip of a motion with steps of this length.
  CoupledOperator& slip(const TangentialInput& motion, double step);

private:
  Bodies bodies_;
  ElementGrid grid_;
  ElementResponse response_;
  std::unique_ptr<CoupledOperator> displacement_, slip_, ahead_;
  ContactMotion motion_ = ContactMotion::shift; ///< of the slip
  Vec2 step_ = {}, offset_ = {};                ///< of the slip and of the displacements ahead
};

} // namespace microslip
