#pragma once

#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"

#include <span>
#include <vector>

namespace microslip {

/// An operator D of a fitted contact with its slip moved to the elements' centres: T D, preconditioned by M^-1 (2 - T),
/// with M^-1 of D and T of CentredSlip. Refers to D, whose products it counts.
class CentredOperator : public SlipOperator {
public:
  CentredOperator(SlipOperator& uncentred, CentredSlip<double> centred);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) override;
  bool has_rough_product() const override { return uncentred_.has_rough_product(); }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override;
  double diagonal() const override { return uncentred_.diagonal(); }
  long products() const override { return uncentred_.products(); }

private:
  SlipOperator& uncentred_;
  CentredSlip<double> centred_;
  std::vector<double> undone_x_, undone_y_; ///< (2 - T) p
};

} // namespace microslip
