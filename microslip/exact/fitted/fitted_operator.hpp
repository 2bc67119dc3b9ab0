#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/fitted_product.hpp"
#include "microslip/exact/halfspace/rolling_preconditioner.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/numerics/transform_plans.hpp"
#include "microslip/progress.hpp"

#include <array>
#include <optional>
#include <vector>

namespace microslip {

/// RollingPreconditioner for a fitted contact, which rolls along +x.
template <class Real>
RollingPreconditioner<Real> rolling_preconditioner(const FittedContact& contact, const TransformPlans& plans = {});

/// Contribution of the tractions of a fitted contact to the slip in steady rolling along +x, (E25): D p =
/// (u(centre) - u(end))/(end - centre), with one number for each element. The regular grid's part goes by fast
/// transforms: a fitted element stands there as three of the grid's with its moments of orders 0 to 2, and u between
/// the grid's points comes from polynomials of degree 5. What that misses is corrected exactly within a few elements;
/// beyond, it is below 1e-4 of an element's influence on itself. Elastically similar bodies. Memory O(N), cost one
/// transform there and back. Preconditioned by RollingPreconditioner.
class FittedOperator : public SlipOperator {
public:
  /// Throws Stopped if `progress` returns false.
  FittedOperator(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress = {},
                 const TransformPlans& plans = {});

  /// Changes size and stiffness of the same contact and material: dx [m] and G [Pa]. Costs nothing.
  void rescale(double dx, double shear_modulus);

  /// Makes the operator anew in its memory; products are counted anew. Unusable if stopped.
  void renew(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress,
             const TransformPlans& plans);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    product_->apply(px, py, sx, sy);
  }
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) override;
  bool has_rough_product() const override { return is_large(); }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override {
    preconditioner_ ? preconditioner_->precondition(px, py, qx, qy)
                    : rough_preconditioner_->precondition(px, py, qx, qy);
    return true;
  }
  double diagonal() const override { return diagonal_ / shear_modulus_; }
  long products() const override { return product_->products() + (rough_ ? rough_->products() : 0); }
  const FittedProduct<double>& product() const { return *product_; }

  /// The displacement difference u at the elements' centres [m] for the tractions of the last apply.
  std::vector<double> ux() const { return in_metres(product_->ux()); }
  std::vector<double> uy() const { return in_metres(product_->uy()); }

private:
  bool is_large() const { return 2 * elements_ >= rough_unknowns; }
  void make_preconditioner(const FittedContact& contact, const TransformPlans& plans);
  void make_product(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress,
                    const TransformPlans& plans);
  std::vector<double> in_metres(std::span<const double> displacement) const;

  std::size_t elements_ = 0;
  std::optional<FittedProduct<double>> product_; ///< there is one
  std::optional<RollingPreconditioner<double>> preconditioner_;
  std::optional<RollingPreconditioner<float>> rough_preconditioner_; ///< instead of it on many elements
  std::optional<FittedProduct<float>> rough_;                        ///< G times the product, once it is asked for
  std::array<std::vector<float>, 4> rough_fields_;                   ///< px, py, sx, sy for it
  TransformPlans plans_;
  double diagonal_ = 0;               ///< [1/G]
  double dx_ = 0, shear_modulus_ = 0; ///< units of length and pressure
};

} // namespace microslip
