#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/progress.hpp"

#include <optional>
#include <span>

namespace microslip {

struct DisplacementQuadrant;

/// Contribution of the tractions of a regular grid to the slip in steady rolling of elastic bodies with a step of whole
/// elements: D p = (u(x) - u(x + step))/|step| (E14), from the displacement u = A p (E12) of the grid and the columns
/// that particles come from. So the kernels are those of u, with their symmetries.
class RollingDifference : public SlipOperator {
public:
  /// `columns` is the step in elements, not 0; negative in rolling along -x. Throws Stopped if `progress` returns
  /// false.
  RollingDifference(const Bodies& bodies, const ElementGrid& grid, int columns, const Progress& progress = {});

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) override;
  bool has_rough_product() const override { return true; }
  /// u at the elements' centres [m].
  void displacement(std::span<const double> px, std::span<const double> py, std::span<double> ux, std::span<double> uy);
  double diagonal() const override { return diagonal_; }
  long products() const override { return displacement_.products() + (rough_ ? rough_->products() : 0); }

private:
  RollingDifference(const DisplacementQuadrant& quadrant, const ElementGrid& grid, int columns);
  template <class Real>
  typename SymmetricToeplitz<Real>::Field displace(SymmetricToeplitz<Real>& transform, std::span<const double> px,
                                                   std::span<const double> py);
  template <class Real>
  void find_differences(SymmetricToeplitz<Real>& transform, std::span<const double> px, std::span<const double> py,
                        double unit, std::span<double> sx, std::span<double> sy);

  int mx_, my_, columns_;
  double length_, diagonal_;
  SymmetricToeplitz<double> displacement_;        ///< of the grid and |columns| more
  std::optional<SymmetricToeplitz<float>> rough_; ///< the same over diagonal_ length_, once it is asked for
};

} // namespace microslip
