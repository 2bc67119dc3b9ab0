#pragma once

#include "microslip/exact/halfspace/rolling_preconditioner.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"

#include <algorithm>
#include <optional>

namespace microslip {

/// The map of an operator for steady rolling on a regular grid, with RollingPreconditioner for the elements that have a
/// traction bound. Refers to the operator, whose products it counts.
class RollingOperator : public SlipOperator {
public:
  /// `columns`: the step in elements, rounded, at least 1.
  RollingOperator(SlipOperator& rolling, const ElementGrid& grid, std::span<const double> bound,
                  RollingDirection direction, int columns)
      : rolling_(rolling) {
    const auto in_contact =
        static_cast<std::size_t>(std::count_if(bound.begin(), bound.end(), [](double g) { return g > 0; }));
    if (2 * in_contact < rough_unknowns || !rolling.has_rough_product())
      preconditioner_.emplace(grid, bound, direction, columns);
    else
      rough_.emplace(grid, bound, direction, columns);
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    rolling_.apply(px, py, sx, sy);
  }
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) override {
    rolling_.apply_roughly(px, py, sx, sy);
  }
  bool has_rough_product() const override { return rolling_.has_rough_product(); }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override {
    preconditioner_ ? preconditioner_->precondition(px, py, qx, qy) : rough_->precondition(px, py, qx, qy);
    return true;
  }
  double diagonal() const override { return rolling_.diagonal(); }
  long products() const override { return rolling_.products(); }

private:
  SlipOperator& rolling_;
  std::optional<RollingPreconditioner<double>> preconditioner_;
  std::optional<RollingPreconditioner<float>> rough_; ///< instead of it with rough products
};

} // namespace microslip
