#include "microslip/exact/fitted/second_order_rolling.hpp"

#include "microslip/exact/fitted/centred_operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

/// Of the solution that tells where contact slides. By trial on 8 to 192 rows: with 1e-2 the errors of fine grids grow,
/// with 3e-4 no figure of the accuracy changes and products are more by a tenth.
constexpr double tolerance_of_first = 3e-3;

} // namespace

using Field = std::vector<double>;

SecondOrderRolling::SecondOrderRolling(const CombinedMaterial& material, FittedContact contact,
                                       const Progress& progress, const TransformPlans& plans)
    : plans_(plans), contact_(std::move(contact)), operator_(material, contact_, progress, plans) {
  find_area_shares();
}

void SecondOrderRolling::renew(const CombinedMaterial& material, FittedContact contact, const Progress& progress) {
  contact_ = std::move(contact);
  derivative_.reset();
  operator_.renew(material, contact_, progress, plans_);
  find_area_shares();
}

void SecondOrderRolling::rescale(FittedContact contact, double shear_modulus) {
  contact_ = std::move(contact);
  derivative_.reset();
  operator_.rescale(contact_.grid.dx, shear_modulus);
}

void SecondOrderRolling::find_area_shares() {
  area_share_.clear();
  for (const FittedElement& e : contact_.elements) area_share_.push_back(e.width() / contact_.grid.dx);
}

/// No creepage gives a force beyond friction's: everything slides in its direction.
FrictionSolution SecondOrderRolling::full_sliding(std::span<const double> bound, const SecondOrderInput& input,
                                                  double excess) const {
  FrictionSolution s;
  for (auto* field : {&s.px, &s.py, &s.sx, &s.sy}) field->assign(bound.size(), 0.0);
  s.sliding.assign(bound.size(), 1);
  s.status = Status::no_solution;
  s.residual = excess;
  const double fx = input.force_x.value_or(0), fy = input.force_y.value_or(0), size = std::hypot(fx, fy);
  for (std::size_t k = 0; k < bound.size(); ++k) s.px[k] = bound[k] * fx / size, s.py[k] = bound[k] * fy / size;
  return s;
}

/// w at the middle of each element's slip interval, the first term of (E25).
void SecondOrderRolling::rigid_slip(const Creepage& creepage, const RowVariation& variation, Field& cx,
                                    Field& cy) const {
  for (std::size_t k = 0; k < contact_.elements.size(); ++k) {
    const FittedElement& e = contact_.elements[k];
    const double x = (e.centre() + e.end) / 2, y = contact_.grid.y(e.row);
    const Creepage more = variation.creepage_at(y);
    cx[k] = creepage.longitudinal - creepage.spin * y + more.longitudinal;
    cy[k] = creepage.lateral + more.lateral + (creepage.spin + more.spin) * x;
  }
}

/// With the slip on the elements' ways, roughly, then with that at the centres of those that slide.
void SecondOrderRolling::solve_twice(std::span<const double> bound, const SecondOrderInput& input,
                                     SecondOrderSolution& out) {
  Field cx(bound.size()), cy(cx);
  rigid_slip(out.creepage, input.variation, cx, cy);
  const auto problem = [&](SlipOperator& slip_operator) {
    return FrictionProblem{.slip_operator = slip_operator,
                           .bound = bound,
                           .cx = cx,
                           .cy = cy,
                           .element_area = contact_.grid.element_area(),
                           .force_x = input.force_x,
                           .force_y = input.force_y,
                           .constant_share = {},
                           .area_share = area_share_};
  };
  FrictionSolution& s = out.friction;
  const double tolerance = std::max(tolerance_of_first, input.tolerance);
  s = newton_.solve(problem(operator_), {.tolerance = tolerance, .progress = part(input.progress, 0, 0.3)},
                    input.start);
  if (s.status != Status::ok) return;
  out.centred = s.sliding;
  CentredSlip<double> at_centres(contact_, out.centred);
  at_centres.move(cx);
  at_centres.move(cy);
  CentredOperator centred(operator_, std::move(at_centres));
  const FrictionSolution first = std::move(s);
  s = newton_.solve(problem(centred), {.tolerance = input.tolerance, .progress = part(input.progress, 0.3, 1)},
                    {.px = first.px,
                     .py = first.py,
                     .constants = Vec2{first.constant_x, first.constant_y},
                     .by_constants = input.start.by_constants});
  s.newton_steps += first.newton_steps;
  s.products += first.products;
}

SecondOrderSolution SecondOrderRolling::solve(std::span<const double> bound, const SecondOrderInput& input) {
  SecondOrderSolution out;
  out.creepage = input.creepage;
  out.centred.assign(bound.size(), 0);
  if (input.force_x) out.creepage.longitudinal = 0;
  if (input.force_y) out.creepage.lateral = 0;
  double capacity = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) capacity += bound[k] * area_share_[k] * contact_.grid.element_area();
  const double wanted = std::hypot(input.force_x.value_or(0), input.force_y.value_or(0));
  if (wanted >= capacity && wanted > 0)
    out.friction = full_sliding(bound, input, wanted / capacity - 1);
  else
    solve_twice(bound, input, out);
  const FrictionSolution& s = out.friction;
  out.creepage.longitudinal += s.constant_x;
  out.creepage.lateral += s.constant_y;
  Field sx(bound.size()), sy(sx);
  operator_.apply(s.px, s.py, sx, sy);
  out.ux = operator_.ux();
  out.uy = operator_.uy();
  return out;
}

SecondOrderRolling::Derivatives SecondOrderRolling::differentiate(std::span<const double> bound,
                                                                  const SecondOrderSolution& solution, double tolerance,
                                                                  const Progress& progress) {
  if (!derivative_) derivative_.emplace(operator_, contact_, plans_);
  derivative_->linearise(bound, solution.friction, CentredSlip<float>(contact_, solution.centred));
  CentredSlip<double> at_centres(contact_, solution.centred);
  Field dcx(contact_.elements.size()), dcy(dcx);
  Derivatives out;
  const std::array units = {Creepage{1, 0, 0}, Creepage{0, 1, 0}, Creepage{0, 0, 1}};
  for (std::size_t i = 0; i < units.size(); ++i) {
    rigid_slip(units[i], {}, dcx, dcy);
    at_centres.move(dcx);
    at_centres.move(dcy);
    const double from = static_cast<double>(i) / units.size();
    out.by[i] = derivative_->solve(dcx, dcy, tolerance, part(progress, from, from + 1.0 / units.size()));
    out.products += out.by[i].products;
  }
  return out;
}

} // namespace microslip
