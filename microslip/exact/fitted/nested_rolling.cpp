#include "microslip/exact/fitted/nested_rolling.hpp"

#include "microslip/exact/fitted/coarse_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr double tolerance_of_coarser = 1e-3; // of the order of the discretisation error between the grids
constexpr double share_of_coarser = 0.2;      // of the work

/// The derivative of estimated tractions, those `at` a creepage, with respect to its longitudinal or lateral part.
/// Nothing near full sliding, where it nearly vanishes: such numbers would mislead.
VectorField derivative(const RollingEstimate& estimate, const FittedContact& contact, std::span<const double> bound,
                       const Creepage& creepage, double Creepage::*part, const VectorField& at) {
  double capacity = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) capacity += bound[k] * contact.elements[k].width() * contact.grid.dy;
  const double unit = 1e-3 * capacity / estimate.stiffness;
  Creepage moved = creepage;
  moved.*part += unit;
  VectorField derivative = estimate.tractions(contact, bound, moved);
  double slope = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    derivative.x[k] = (derivative.x[k] - at.x[k]) / unit;
    derivative.y[k] = (derivative.y[k] - at.y[k]) / unit;
    const double along = part == &Creepage::longitudinal ? derivative.x[k] : derivative.y[k];
    slope += along * contact.elements[k].width() * contact.grid.dy;
  }
  if (std::abs(slope) < 0.02 * estimate.stiffness) return {};
  return derivative;
}

} // namespace

/// Start of a solution; members that are empty are not known.
struct NestedRolling::Start {
  VectorField tractions;
  std::optional<Vec2> creepage;
  std::array<VectorField, 2> by_creepage;

  FrictionStart view() const {
    return {.px = tractions.x,
            .py = tractions.y,
            .constants = creepage,
            .by_constants = {TractionsView{by_creepage[0].x, by_creepage[0].y},
                             TractionsView{by_creepage[1].x, by_creepage[1].y}}};
  }
};

/// Start by the estimate, `near` the creepage of the coarser contact if that is known.
NestedRolling::Start NestedRolling::start(std::span<const double> bound, const SecondOrderInput& input,
                                          const std::optional<Creepage>& near, const RollingEstimate& estimate) const {
  Start start;
  const bool forces_given = input.force_x || input.force_y;
  if (near && !forces_given) return start;
  const auto creepage = near ? near : forces_given ? estimate.creepage() : std::optional(input.creepage);
  if (!creepage) return start;
  start.tractions = estimate.tractions(contact(), bound, *creepage);
  start.creepage = Vec2{creepage->longitudinal, creepage->lateral};
  if (forces_given)
    start.by_creepage = {derivative(estimate, contact(), bound, *creepage, &Creepage::longitudinal, start.tractions),
                         derivative(estimate, contact(), bound, *creepage, &Creepage::lateral, start.tractions)};
  return start;
}

NestedRolling::NestedRolling(const CombinedMaterial& material, FittedContact contact,
                             std::unique_ptr<NestedRolling> coarser, const Progress& progress,
                             const TransformPlans& plans)
    : rolling_(material, std::move(contact), progress, plans), coarser_(std::move(coarser)) {}

SecondOrderSolution NestedRolling::solve(double capacity, SecondOrderInput input, const RollingEstimate& estimate) {
  const std::vector<double> bound = this->bound(capacity, input.variation);
  std::optional<Creepage> near;
  VectorField tractions;
  bool stopped = false;
  const bool from_coarser = coarser_ && !estimate.near;
  if (from_coarser) {
    SecondOrderInput on_coarser = input;
    on_coarser.tolerance = std::max(tolerance_of_coarser, input.tolerance);
    on_coarser.centred = {};
    on_coarser.progress = [&](double done) {
      return !(stopped = input.progress && !input.progress(share_of_coarser * done));
    };
    const SecondOrderSolution coarse = coarser_->solve(capacity, std::move(on_coarser), estimate);
    if (coarse.friction.report.status == Status::ok) {
      near = coarse.creepage;
      tractions = start_from_coarser(coarser_->contact(), coarser_->bound(capacity, input.variation),
                                     coarse.friction.traction, contact(), bound);
    }
  }
  Start start = this->start(bound, input, near, estimate);
  if (near) {
    start.tractions = std::move(tractions);
    start.creepage = Vec2{near->longitudinal, near->lateral};
  }
  input.start = start.view();
  const Progress whole = input.progress;
  if (from_coarser) input.progress = part(whole, share_of_coarser, 1);
  if (stopped) input.progress = [](double) { return false; };
  return rolling_.solve(bound, input);
}

} // namespace microslip
