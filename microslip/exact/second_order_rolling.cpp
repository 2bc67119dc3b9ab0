#include "microslip/exact/second_order_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

/// The correction is small of second order, so the solution that it is taken from need not be very good: with 1e-2 or
/// 1e-7 the forces differ by less than 1e-5 mu Fn.
constexpr double tolerance_of_first = 3e-3;

} // namespace

using Field = std::vector<double>;

SecondOrderRolling::SecondOrderRolling(const CombinedMaterial& material, FittedContact contact)
    : contact_(std::move(contact)), response_(material, contact_) {
  for (const FittedElement& e : contact_.elements) area_share_.push_back(e.width() / contact_.grid.dx);
}

/// The mean of the two ways that meet at an element's centre; at the trailing edge, where there is but one,
/// extrapolated.
Field SecondOrderRolling::slip_at_centre(const Field& slip) const {
  Field mean = slip;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    const FittedElement& e = contact_.elements[k];
    if (!e.trails)
      mean[k] = (slip[k - 1] + slip[k]) / 2;
    else if (!e.leads)
      mean[k] = slip[k] + (slip[k] - slip[k + 1]) / 2;
  }
  return mean;
}

/// No creepage gives a force beyond friction's: everything slides in its direction.
SecondOrderSolution SecondOrderRolling::full_sliding(std::span<const double> bound, const SecondOrderInput& input,
                                                     double excess) const {
  SecondOrderSolution out;
  FrictionSolution& s = out.friction;
  const std::size_t n = bound.size();
  for (auto* field : {&s.px, &s.py, &s.sx, &s.sy, &out.ux, &out.uy}) field->assign(n, 0.0);
  s.sliding.assign(n, 1);
  s.status = Status::no_solution;
  s.residual = excess;
  const double fx = input.force_x.value_or(0), fy = input.force_y.value_or(0), size = std::hypot(fx, fy);
  for (std::size_t k = 0; k < n; ++k) s.px[k] = bound[k] * fx / size, s.py[k] = bound[k] * fy / size;
  out.creepage = input.creepage;
  return out;
}

SecondOrderSolution SecondOrderRolling::solve(std::span<const double> bound, const SecondOrderInput& input) {
  const auto& elements = contact_.elements;
  Creepage creepage = input.creepage;
  if (input.force_x) creepage.longitudinal = 0;
  if (input.force_y) creepage.lateral = 0;
  Field cx(elements.size()), cy(cx);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const FittedElement& e = elements[k];
    cx[k] = creepage.longitudinal - creepage.spin * contact_.grid.y(e.row);
    cy[k] = creepage.lateral + creepage.spin * (e.centre() + e.end) / 2;
  }
  const FrictionProblem problem{.response = response_,
                                .bound = bound,
                                .cx = cx,
                                .cy = cy,
                                .element_area = contact_.grid.element_area(),
                                .force_x = input.force_x,
                                .force_y = input.force_y,
                                .area_share = area_share_};
  double capacity = 0;
  for (std::size_t k = 0; k < elements.size(); ++k)
    capacity += bound[k] * area_share_[k] * contact_.grid.element_area();
  const double wanted = std::hypot(input.force_x.value_or(0), input.force_y.value_or(0));
  if (wanted >= capacity && wanted > 0) return full_sliding(bound, input, wanted / capacity - 1);

  FrictionSolution s =
      newton_.solve(problem, {.tolerance = std::max(tolerance_of_first, input.tolerance)}, input.start);
  if (s.status == Status::ok) {
    const Field mean_x = slip_at_centre(s.sx), mean_y = slip_at_centre(s.sy);
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (s.sliding[k]) cx[k] += mean_x[k] - s.sx[k], cy[k] += mean_y[k] - s.sy[k];
    const int steps = s.newton_steps;
    const long products = s.products;
    s = newton_.solve(
        problem, {.tolerance = input.tolerance},
        {.px = s.px, .py = s.py, .constants = Vec2{s.constant_x, s.constant_y}, .growth = input.start.growth});
    s.newton_steps += steps;
    s.products += products;
  }
  SecondOrderSolution out;
  out.creepage = creepage;
  out.creepage.longitudinal += s.constant_x;
  out.creepage.lateral += s.constant_y;
  Field sx(elements.size()), sy(sx);
  response_.apply(s.px, s.py, sx, sy);
  out.ux.assign(response_.ux().begin(), response_.ux().end());
  out.uy.assign(response_.uy().begin(), response_.uy().end());
  out.friction = std::move(s);
  return out;
}

} // namespace microslip
