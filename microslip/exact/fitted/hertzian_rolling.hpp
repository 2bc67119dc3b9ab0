#pragma once

#include "microslip/exact/fitted/nested_rolling.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace microslip {

/// Steady rolling along +x of a Hertzian contact at second order, with a good start for every problem: from FASTSIM2,
/// on large grids from the solution on a grid with half the elements in each direction, and so on down.
class HertzianRolling {
public:
  /// mx x my elements across every ellipse.
  HertzianRolling(int mx, int my);
  /// Prepared for an ellipse.
  HertzianRolling(double a, double b, const CombinedMaterial& material, int mx, int my, const Progress& progress = {})
      : HertzianRolling(mx, my) {
    prepare(a, b, material, progress);
  }

  /// Prepares for an ellipse and the bodies' material; to be called first. What depends on the number of elements alone
  /// has been found before. Next to nothing is to do for an ellipse with the axes' ratio of the last one and bodies
  /// with its Poisson's ratio: everything else scales. Throws Stopped if `progress` returns false.
  void prepare(double a, double b, const CombinedMaterial& material, const Progress& progress = {});

  const FittedContact& contact() const { return rolling_->contact(); }

  /// Creepages and spin of the contact, or forces [N] instead of its creepages. Newton steps, products and progress as
  /// in NestedRolling.
  SecondOrderSolution solve(const EllipticContact& contact, std::optional<double> force_x,
                            std::optional<double> force_y, double tolerance, const Progress& progress = {});

  /// Differentiates as SecondOrderRolling does, for a solution with creepages given.
  SecondOrderRolling::Derivatives differentiate(const EllipticContact& contact, const SecondOrderSolution& solution,
                                                double tolerance, const Progress& progress = {});

  /// Responds as SecondOrderRolling does.
  SecondOrderRolling::Responses respond(const EllipticContact& contact, const SecondOrderSolution& solution,
                                        double wavenumber, double tolerance, const Progress& progress = {});

private:
  std::unique_ptr<NestedRolling> nested(const Progress& progress) const;

  TransformPlans plans_;
  std::vector<FittedContact> of_circle_; ///< of the radius 1; the finest one, and coarser ones
  double a_ = 0, b_ = 0;                 ///< of rolling_
  CombinedMaterial material_ = {0, 0, 0};
  std::unique_ptr<NestedRolling> rolling_;
};

} // namespace microslip
