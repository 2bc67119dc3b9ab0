#pragma once

#include "microslip/exact/halfspace/slip_operator.hpp"

#include <cstddef>
#include <span>

namespace microslip {

/// Elements that do not feel each other.
class SpringOperator : public SlipOperator {
public:
  explicit SpringOperator(double flexibility) : flexibility_(flexibility) {}

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    ++products_;
    for (std::size_t k = 0; k < px.size(); ++k) sx[k] = flexibility_ * px[k], sy[k] = flexibility_ * py[k];
  }
  double diagonal() const override { return flexibility_; }
  long products() const override { return products_; }

private:
  double flexibility_;
  long products_ = 0;
};

} // namespace microslip
