#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/progress.hpp"

#include <optional>
#include <vector>

namespace microslip {

struct DisplacementQuadrant;

/// The tangential displacement difference u = A p (E12) of elastic bodies, which is the tractions' part of the slip in
/// a shift, with its preconditioner, SymmetricToeplitz::near_inverse.
class DisplacementOperator : public SlipOperator {
public:
  DisplacementOperator(const Bodies& bodies, const ElementGrid& grid, const Progress& progress = {});

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
             std::span<double> uy) override;
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                     std::span<double> uy) override;
  bool has_rough_product() const override { return true; }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override;
  double diagonal() const override { return diagonal_; }
  double scale() const override { return scale_; }
  long products() const override { return displacement_.products() + (rough_ ? rough_->products() : 0); }

private:
  using Transform = SymmetricToeplitz<double>;

  DisplacementOperator(const DisplacementQuadrant& quadrant, const ElementGrid& grid);

  double diagonal_, scale_;
  Transform displacement_, near_inverse_;
  std::optional<SymmetricToeplitz<float>> rough_; ///< the displacement over diagonal_, once it is asked for
  std::vector<float> px_, py_;                    ///< and what it is asked for
};

} // namespace microslip
