#pragma once

#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// Start from a simpler theory.
struct RollingEstimate {
  /// Tractions of the elements [Pa] with these creepages, where friction's bound is g [Pa].
  std::function<VectorField(const FittedContact& contact, std::span<const double> bound, const Creepage& creepage)>
      tractions;
  /// The creepages with which they have the prescribed forces; nothing if there are none.
  std::function<std::optional<Creepage>()> creepage;
  double stiffness = 0; ///< G a b [N]: slope of forces by a creepage, up to a factor of the order of 4
  bool near = false;    ///< the tractions are so near the solution that coarser elements would tell nothing
};

/// Steady rolling along +x at second order, started from the solution on a coarser cover of the same contact, and so on
/// down: so Newton's method takes as many steps on every grid.
class NestedRolling {
public:
  /// Throws Stopped if `progress` returns false.
  NestedRolling(const CombinedMaterial& material, FittedContact contact, std::unique_ptr<NestedRolling> coarser,
                const Progress& progress = {}, const TransformPlans& plans = {});

  /// Renews as SecondOrderRolling does; without coarser levels.
  void renew(const CombinedMaterial& material, FittedContact contact, const Progress& progress) {
    rolling_.renew(material, std::move(contact), progress);
  }
  void rescale(FittedContact contact, double shear_modulus) { rolling_.rescale(std::move(contact), shear_modulus); }
  NestedRolling* coarser() { return coarser_.get(); }
  SecondOrderRolling& finest() { return rolling_; }

  const FittedContact& contact() const { return rolling_.contact(); }
  /// g of the elements [Pa] for mu Fn = `capacity` [N], mu that of the contact.
  std::vector<double> bound(double capacity, const RowVariation& variation = {}) const {
    return friction_bound(contact(), capacity, variation);
  }

  /// `input` without start. Newton steps and products are those on the finest grid. Its progress is called on all
  /// grids; false ends the solve with status not_converged.
  SecondOrderSolution solve(double capacity, SecondOrderInput input, const RollingEstimate& estimate);

  /// Differentiates as SecondOrderRolling does.
  SecondOrderRolling::Derivatives differentiate(double capacity, const SecondOrderSolution& solution, double tolerance,
                                                const Progress& progress) {
    return rolling_.differentiate(bound(capacity), solution, tolerance, progress);
  }
  /// Responds as SecondOrderRolling does.
  SecondOrderRolling::Responses respond(double capacity, const SecondOrderSolution& solution, double wavenumber,
                                        double tolerance, const Progress& progress) {
    return rolling_.respond(bound(capacity), solution, wavenumber, tolerance, progress);
  }

private:
  struct Start;
  Start start(std::span<const double> bound, const SecondOrderInput& input, const std::optional<Creepage>& near,
              const RollingEstimate& estimate) const;

  SecondOrderRolling rolling_;
  std::unique_ptr<NestedRolling> coarser_;
};

} // namespace microslip
