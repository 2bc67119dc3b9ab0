#include "microslip/exact/fitted/transient_rolling.hpp"

#include "microslip/exact/fitted/fitted_problem.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

constexpr double tolerance_of_first = 3e-3; // of the solution that tells where contact slides

} // namespace

using Field = std::vector<double>;

FittedStepOperator::FittedStepOperator(const CombinedMaterial& material, const FittedContact& contact,
                                       const Progress& progress, const TransformPlans& plans)
    : FittedStepOperator(material, contact, GridKernel(material.poisson_ratio, contact.grid, progress), progress,
                         plans) {}

FittedStepOperator::FittedStepOperator(const CombinedMaterial& material, const FittedContact& contact,
                                       const GridKernel& kernel, const Progress& progress, const TransformPlans& plans)
    : displacement_(material, contact, progress, plans), near_inverse_(kernel.near_inverse(plans)),
      px_(contact.grid.count()), py_(px_), qx_(px_), qy_(px_), compliance_(1 / material.shear_modulus),
      scale_(compliance_ * kernel.middle()) {
  const double *xx = kernel.row(component::xx, 0), *yy = kernel.row(component::yy, 0);
  diagonal_ = compliance_ * (xx[0] + yy[0]) / 2;
  for (const FittedElement& e : contact.elements) cells_.push_back(e.cell);
}

void FittedStepOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                               std::span<double> sy) {
  displacement_.apply(px, py, sx, sy);
  const auto ux = displacement_.product().ux(), uy = displacement_.product().uy();
  for (std::size_t k = 0; k < sx.size(); ++k) sx[k] = compliance_ * ux[k], sy[k] = compliance_ * uy[k];
}

void FittedStepOperator::find_slip_ahead(std::span<double> sx, std::span<double> sy) const {
  const auto ux = displacement_.product().ux(), uy = displacement_.product().uy();
  const auto ends = displacement_.product().end_points();
  for (std::size_t k = 0; k < sx.size(); ++k) sx[k] = compliance_ * ux[ends[k]], sy[k] = compliance_ * uy[ends[k]];
}

bool FittedStepOperator::precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                      std::span<double> qy) {
  for (std::size_t k = 0; k < cells_.size(); ++k) px_[cells_[k]] = px[k], py_[cells_[k]] = py[k];
  near_inverse_.apply(px_, py_, scale_ / compliance_, qx_, qy_);
  for (std::size_t k = 0; k < cells_.size(); ++k) qx[k] = qx_[cells_[k]], qy[k] = qy_[cells_[k]];
  return true;
}

TransientRolling::TransientRolling(const CombinedMaterial& material, FittedContact contact, const Progress& progress,
                                   const TransformPlans& plans)
    : contact_(std::move(contact)), operator_(material, contact_, progress, plans), area_share_(area_shares(contact_)) {
}

void TransientRolling::restart() {
  tractions_ = ahead_ = slip_ = {};
}

/// Slip, in the step before, of the particles that are an element ahead now; zero for those that were not in contact.
Vec2 TransientRolling::slip_before(std::size_t element) const {
  if (slip_.x.empty() || contact_.elements[element].leads) return {};
  return {slip_.x[element + 1], slip_.y[element + 1]};
}

/// Solves with the slip of the step, roughly, then with that at the step's end where elements slide: from the means s
/// of this step and s' of the one before it is (3 s - s')/2, and only its direction counts.
void TransientRolling::solve_twice(std::span<const double> bound, const SecondOrderInput& input,
                                   SecondOrderSolution& out) {
  Field cx(bound.size()), cy(cx);
  find_rigid_slip(contact_, out.creepage, input.variation, cx, cy);
  for (std::size_t k = 0; k < ahead_.x.size(); ++k) cx[k] -= ahead_.x[k], cy[k] -= ahead_.y[k];
  const FrictionProblem problem{.slip_operator = operator_,
                                .bound = bound,
                                .cx = cx,
                                .cy = cy,
                                .element_area = contact_.grid.element_area(),
                                .force_x = input.force_x,
                                .force_y = input.force_y,
                                .constant_share = {},
                                .area_share = area_share_};
  FrictionSolution& s = out.friction;
  const bool twice = !slip_.x.empty();
  const double tolerance = twice ? std::max(tolerance_of_first, input.tolerance) : input.tolerance;
  const TractionsView before{tractions_.x, tractions_.y};
  s = newton_.solve(problem,
                    {.tolerance = tolerance, .before = before, .progress = part(input.progress, 0, twice ? 0.5 : 1)},
                    {.px = before.px, .py = before.py});
  if (!twice || s.report.status != Status::ok) return;
  out.centred = s.sliding;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    if (!out.centred[k]) continue;
    const Vec2 earlier = slip_before(k);
    cx[k] -= earlier.x / 3, cy[k] -= earlier.y / 3;
  }
  const FrictionSolution first = std::move(s);
  s = newton_.solve(problem, {.tolerance = input.tolerance, .before = before, .progress = part(input.progress, 0.5, 1)},
                    {.px = first.traction.x, .py = first.traction.y, .constants = first.constants});
  s.report.newton_steps += first.report.newton_steps;
  s.report.products += first.report.products;
}

/// The means over the step, for the next one; in the solution that at the end where it was solved for.
void TransientRolling::take_slip(SecondOrderSolution& out) {
  auto& [end_x, end_y] = out.friction.slip;
  VectorField mean = out.friction.slip;
  for (std::size_t k = 0; k < mean.x.size(); ++k) {
    if (!out.centred[k]) continue;
    const Vec2 earlier = slip_before(k);
    mean.x[k] += earlier.x / 3, mean.y[k] += earlier.y / 3;
    end_x[k] *= 1.5, end_y[k] *= 1.5;
  }
  slip_ = std::move(mean);
}

SecondOrderSolution TransientRolling::step(std::span<const double> bound, const SecondOrderInput& input) {
  SecondOrderSolution out(input, bound.size());
  solve_twice(bound, input, out);
  out.add_found_creepages();
  take_slip(out);
  tractions_ = out.friction.traction;
  ahead_ = VectorField(bound.size());
  Field sx(bound.size()), sy(sx);
  operator_.apply(tractions_.x, tractions_.y, sx, sy);
  operator_.find_slip_ahead(ahead_.x, ahead_.y);
  out.displacement = {operator_.ux(), operator_.uy()};
  return out;
}

} // namespace microslip
