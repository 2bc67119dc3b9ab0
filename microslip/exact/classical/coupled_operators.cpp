#include "microslip/exact/classical/coupled_operators.hpp"

#include "microslip/exact/classical/tangential_totals.hpp"

#include <cmath>

namespace microslip {

CoupledOperator& CoupledOperators::displacement(const Progress& progress) {
  if (!displacement_)
    displacement_ =
        std::make_unique<CoupledOperator>(CoupledOperator::displacement(bodies_, grid_, {}, 1, progress, response_));
  return *displacement_;
}

CoupledOperator& CoupledOperators::displacement_at(Vec2 offset, const Progress& progress) {
  if (offset.x == 0 && offset.y == 0) return displacement(progress);
  if (!ahead_ || offset_.x != offset.x || offset_.y != offset.y) {
    ahead_ = std::make_unique<CoupledOperator>(
        CoupledOperator::displacement(bodies_, grid_, offset, 1, progress, response_));
    offset_ = offset;
  }
  return *ahead_;
}

CoupledOperator& CoupledOperators::slip(const TangentialInput& motion, double step) {
  if (motion.motion == ContactMotion::shift) return displacement(motion.progress);
  const Vec2 offset = way_of(motion, step);
  if (motion_ != motion.motion || step_.x != offset.x || step_.y != offset.y) {
    slip_ = std::make_unique<CoupledOperator>(
        motion.motion == ContactMotion::steady
            ? CoupledOperator::difference(bodies_, grid_, offset, motion.progress, response_)
            : CoupledOperator::displacement(bodies_, grid_, {}, std::abs(step), motion.progress, response_));
    motion_ = motion.motion;
    step_ = offset;
  }
  return *slip_;
}

} // namespace microslip
