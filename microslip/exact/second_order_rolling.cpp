#include "microslip/exact/second_order_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

/// The correction is small, so the solution that it is taken from need not be very good: against a tolerance of 1e-7
/// the forces of the test set change by some 1e-5 mu Fn, and the products are fewer by a quarter.
constexpr double tolerance_of_first = 3e-4;

/// Derivatives of the plain solution enter those of the forces through the correction only, whose share is some
/// hundredths: its equations and its derivatives need not be as good. By trial at 8 to 128 rows: with more, derivatives
/// of forces become worse.
constexpr double plain_over_corrected = 10, plain_over_corrected_equations = 30;

/// Progress of a part of the work.
Progress part(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double fraction) { return whole(from + (to - from) * fraction); };
}

} // namespace

using Field = std::vector<double>;

SecondOrderRolling::SecondOrderRolling(const CombinedMaterial& material, FittedContact contact)
    : contact_(std::move(contact)), response_(material, contact_), preconditioner_(contact_) {
  for (const FittedElement& e : contact_.elements) area_share_.push_back(e.width() / contact_.grid.dx);
}

/// At an element's centre, where two ways meet: by the four ways around it to third order, (-1, 7, 7, -1)/12, where the
/// row has them; 1/8 of the second difference belongs to the mean of two and 1/24 to the difference quotients. Else the
/// mean of the two; at the trailing edge, where there is but one, extrapolated.
Field SecondOrderRolling::slip_at_centre(const Field& slip) const {
  Field at_centre = slip;
  const auto& elements = contact_.elements;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    const FittedElement& e = elements[k];
    if (!e.trails && !e.leads && !elements[k - 1].trails)
      at_centre[k] = (7 * (slip[k - 1] + slip[k]) - slip[k - 2] - slip[k + 1]) / 12;
    else if (!e.trails)
      at_centre[k] = (slip[k - 1] + slip[k]) / 2;
    else if (!e.leads)
      at_centre[k] = slip[k] + (slip[k] - slip[k + 1]) / 2;
  }
  return at_centre;
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

/// w at the middle of each element's way.
void SecondOrderRolling::rigid_slip(const Creepage& creepage, Field& cx, Field& cy) const {
  for (std::size_t k = 0; k < contact_.elements.size(); ++k) {
    const FittedElement& e = contact_.elements[k];
    cx[k] = creepage.longitudinal - creepage.spin * contact_.grid.y(e.row);
    cy[k] = creepage.lateral + creepage.spin * (e.centre() + e.end) / 2;
  }
}

/// Adds the slip at the elements' centres less that on their ways, for the elements that slide in a solution. Linear in
/// the slip.
void SecondOrderRolling::add_correction(const FrictionSolution& of, const Field& sx, const Field& sy, Field& cx,
                                        Field& cy) const {
  const Field mean_x = slip_at_centre(sx), mean_y = slip_at_centre(sy);
  for (std::size_t k = 0; k < sx.size(); ++k)
    if (of.sliding[k]) cx[k] += mean_x[k] - sx[k], cy[k] += mean_y[k] - sy[k];
}

FrictionProblem SecondOrderRolling::problem(std::span<const double> bound, std::span<const double> cx,
                                            std::span<const double> cy) {
  return {.response = response_,
          .bound = bound,
          .cx = cx,
          .cy = cy,
          .element_area = contact_.grid.element_area(),
          .area_share = area_share_,
          .preconditioner = &preconditioner_};
}

/// The plain problem and the corrected one.
void SecondOrderRolling::solve_twice(std::span<const double> bound, const SecondOrderInput& input,
                                     SecondOrderSolution& out) {
  Field cx(bound.size()), cy(cx);
  rigid_slip(out.creepage, cx, cy);
  FrictionProblem with = problem(bound, cx, cy);
  with.force_x = input.force_x;
  with.force_y = input.force_y;
  double first = std::max(tolerance_of_first, input.tolerance);
  if (input.converge_plain) first = std::min(first, plain_over_corrected_equations * input.tolerance);
  out.plain = newton_.solve(with, {.tolerance = first, .progress = part(input.progress, 0, 0.3)}, input.start);
  FrictionSolution& s = out.friction = out.plain;
  if (s.status != Status::ok) return;
  add_correction(out.plain, out.plain.sx, out.plain.sy, cx, cy);
  s = newton_.solve(with, {.tolerance = input.tolerance, .progress = part(input.progress, 0.3, 1)},
                    {.px = out.plain.px,
                     .py = out.plain.py,
                     .constants = Vec2{out.plain.constant_x, out.plain.constant_y},
                     .growth = input.start.growth});
  s.newton_steps += out.plain.newton_steps;
  s.products += out.plain.products;
}

SecondOrderSolution SecondOrderRolling::solve(std::span<const double> bound, const SecondOrderInput& input) {
  SecondOrderSolution out;
  out.creepage = input.creepage;
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
  response_.apply(s.px, s.py, sx, sy);
  out.ux.assign(response_.ux().begin(), response_.ux().end());
  out.uy.assign(response_.uy().begin(), response_.uy().end());
  return out;
}

SecondOrderRolling::Derivatives SecondOrderRolling::differentiate(std::span<const double> bound,
                                                                  const SecondOrderSolution& solution,
                                                                  double tolerance) {
  const std::size_t n = contact_.elements.size();
  Field dcx(n), dcy(n);
  if (!derivative_) derivative_.emplace(response_, contact_);
  Derivatives out;
  const std::array units = {Creepage{1, 0, 0}, Creepage{0, 1, 0}, Creepage{0, 0, 1}};
  derivative_->linearise(bound, solution.plain);
  for (std::size_t i = 0; i < units.size(); ++i) {
    rigid_slip(units[i], dcx, dcy);
    out.by[i] = derivative_->solve(dcx, dcy, plain_over_corrected * tolerance);
  }
  derivative_->linearise(bound, solution.friction);
  for (std::size_t i = 0; i < units.size(); ++i) {
    auto& change = out.by[i];
    const long products = change.products;
    Field x(n), y(n);
    add_correction(solution.plain, change.sx, change.sy, x, y);
    rigid_slip(units[i], dcx, dcy);
    for (std::size_t k = 0; k < n; ++k) { // the slip that goes with the tractions grows by as much
      dcx[k] += x[k], change.sx[k] += x[k];
      dcy[k] += y[k], change.sy[k] += y[k];
    }
    change = derivative_->solve(dcx, dcy, tolerance, &change);
    out.products += products + change.products;
  }
  return out;
}

} // namespace microslip
