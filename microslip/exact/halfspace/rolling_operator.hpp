#pragma once

#include "microslip/exact/halfspace/rolling_preconditioner.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"

namespace microslip {

/// The map of an operator for steady rolling on a regular grid, with RollingPreconditioner for the elements that have a
/// traction bound. Refers to the operator, whose products it counts.
class RollingOperator : public SlipOperator {
public:
  RollingOperator(SlipOperator& rolling, const ElementGrid& grid, std::span<const double> bound,
                  RollingDirection direction)
      : rolling_(rolling), preconditioner_(grid, bound, direction) {}

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    rolling_.apply(px, py, sx, sy);
  }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override {
    preconditioner_.precondition(px, py, qx, qy);
    return true;
  }
  double diagonal() const override { return rolling_.diagonal(); }
  long products() const override { return rolling_.products(); }

private:
  SlipOperator& rolling_;
  RollingPreconditioner<double> preconditioner_;
};

} // namespace microslip
