#pragma once

#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// Where a solve on a fitted contact begins; what is empty is not known.
struct RollingStart {
  VectorField tractions;                  ///< [Pa]
  std::optional<Vec2> creepage;           ///< longitudinal and lateral, where forces are given
  std::array<VectorField, 2> by_creepage; ///< derivatives of the tractions with respect to each of them
};

/// Steady rolling along +x at second order, started from the solution on a coarser cover of the same contact, and so on
/// down: so Newton's method takes as many steps on every grid.
class NestedRolling {
public:
  /// Throws Stopped if `progress` returns false.
  NestedRolling(const CombinedMaterial& material, FittedContact contact, std::unique_ptr<NestedRolling> coarser,
                const Progress& progress = {}, const TransformPlans& plans = {});

  /// As SecondOrderRolling's; without what is coarser.
  void renew(const CombinedMaterial& material, FittedContact contact, const Progress& progress) {
    rolling_.renew(material, std::move(contact), progress);
  }
  void rescale(FittedContact contact, double shear_modulus) { rolling_.rescale(std::move(contact), shear_modulus); }
  NestedRolling* coarser() { return coarser_.get(); }

  const FittedContact& contact() const { return rolling_.contact(); }
  /// g of the elements [Pa] if friction bears `capacity` = mu Fn [N].
  std::vector<double> bound(double capacity) const;

  /// What else is known of the solution on a contact with this bound, where `near` is the creepage on the coarser one;
  /// without one, tractions and creepage to begin with.
  using StartOf = std::function<RollingStart(const FittedContact& contact, std::span<const double> bound,
                                             const std::optional<Creepage>& near)>;

  /// `input` without start. Newton steps and products are those on the finest grid. Its progress is told of all grids;
  /// false ends the solve with status not_converged.
  SecondOrderSolution solve(double capacity, SecondOrderInput input, const StartOf& start_of = {});

  /// As SecondOrderRolling::differentiate.
  SecondOrderRolling::Derivatives differentiate(double capacity, const SecondOrderSolution& solution, double tolerance,
                                                const Progress& progress) {
    return rolling_.differentiate(bound(capacity), solution, tolerance, progress);
  }

private:
  SecondOrderRolling rolling_;
  std::unique_ptr<NestedRolling> coarser_;
};

} // namespace microslip
