#include "microslip/exact/fitted/second_order_rolling.hpp"

#include "microslip/exact/fitted/centred_operator.hpp"
#include "microslip/exact/fitted/fitted_problem.hpp"
#include "microslip/exact/fitted/growing_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

/// Tolerance of the solution that tells where contact slides. By trial on 8 to 192 rows: with 1e-2 the errors of fine
/// grids grow, with 3e-4 no figure of the accuracy changes and products are more by a tenth.
constexpr double tolerance_of_first = 3e-3;

} // namespace

using Field = std::vector<double>;

SecondOrderRolling::SecondOrderRolling(const CombinedMaterial& material, FittedContact contact,
                                       const Progress& progress, const TransformPlans& plans)
    : plans_(plans), contact_(std::move(contact)), operator_(material, contact_, progress, plans),
      area_share_(area_shares(contact_)) {}

void SecondOrderRolling::renew(const CombinedMaterial& material, FittedContact contact, const Progress& progress) {
  contact_ = std::move(contact);
  derivative_.reset();
  response_.reset();
  operator_.renew(material, contact_, progress, plans_);
  area_share_ = area_shares(contact_);
}

void SecondOrderRolling::rescale(FittedContact contact, double shear_modulus) {
  contact_ = std::move(contact);
  derivative_.reset();
  response_.reset();
  operator_.rescale(contact_.grid.dx, shear_modulus);
}

/// Solves with the slip on the elements' paths, roughly, unless it is known which of them slide; then with that at the
/// centres of these.
void SecondOrderRolling::solve_twice(std::span<const double> bound, const SecondOrderInput& input,
                                     SecondOrderSolution& out) {
  Field cx(bound.size()), cy(cx);
  find_rigid_slip(contact_, out.creepage, input.variation, cx, cy);
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
  FrictionSolution first;
  FrictionStart start = input.start;
  if (input.centred.empty()) {
    const double tolerance = std::max(tolerance_of_first, input.tolerance);
    first = newton_.solve(problem(operator_), {.tolerance = tolerance, .progress = part(input.progress, 0, 0.3)},
                          input.start);
    out.centred = first.sliding;
    start.px = first.traction.x, start.py = first.traction.y, start.constants = first.constants;
  } else {
    out.centred.assign(input.centred.begin(), input.centred.end());
  }
  FrictionSolution& s = out.friction;
  if (first.report.status != Status::ok) {
    s = std::move(first);
    return;
  }
  CentredSlip<double> at_centres(contact_, out.centred);
  at_centres.move(cx);
  at_centres.move(cy);
  CentredOperator centred(operator_, std::move(at_centres));
  s = newton_.solve(problem(centred), {.tolerance = input.tolerance, .progress = part(input.progress, 0.3, 1)}, start);
  s.report.newton_steps += first.report.newton_steps;
  s.report.products += first.report.products;
}

SecondOrderSolution::SecondOrderSolution(const SecondOrderInput& input, std::size_t elements)
    : centred(elements, 0), creepage(input.creepage) {
  if (input.force_x) creepage.longitudinal = 0;
  if (input.force_y) creepage.lateral = 0;
}

void SecondOrderSolution::add_found_creepages() {
  creepage.longitudinal += friction.constants.x;
  creepage.lateral += friction.constants.y;
}

SecondOrderSolution SecondOrderRolling::solve(std::span<const double> bound, const SecondOrderInput& input) {
  SecondOrderSolution out(input, bound.size());
  solve_twice(bound, input, out);
  out.add_found_creepages();
  const auto& [px, py] = out.friction.traction;
  out.frictional_work = work_on_rigid_slip(contact_, out.creepage, input.variation, px, py);
  Field sx(bound.size()), sy(sx);
  operator_.apply(px, py, sx, sy);
  out.displacement = {operator_.ux(), operator_.uy()};
  if (input.variation.displacement)
    for (std::size_t k = 0; k < bound.size(); ++k) {
      const FittedElement& e = contact_.elements[k];
      const Vec2 more = input.variation.displacement(e.point, contact_.grid.y(e.row));
      out.displacement.x[k] += more.x;
      out.displacement.y[k] += more.y;
    }
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
    find_rigid_slip(contact_, units[i], {}, dcx, dcy);
    at_centres.move(dcx);
    at_centres.move(dcy);
    const double from = static_cast<double>(i) / units.size();
    out.by[i] = derivative_->solve(dcx, dcy, tolerance, part(progress, from, from + 1.0 / units.size()));
    out.products += out.by[i].products;
  }
  return out;
}

RollingResponse& SecondOrderRolling::linearised_response(std::span<const double> bound,
                                                         const SecondOrderSolution& solution) {
  if (!response_) response_.emplace(operator_, contact_, plans_);
  response_->linearise(bound, solution.friction, solution.centred);
  return *response_;
}

std::array<RollingResponse::Change, 3> SecondOrderRolling::respond_to_creepages(std::span<const double> bound,
                                                                                const SecondOrderSolution& solution,
                                                                                double wavenumber, double tolerance,
                                                                                const Progress& progress) {
  RollingResponse& response = linearised_response(bound, solution);
  RollingResponse::Cause cause(contact_.elements.size());
  std::array<RollingResponse::Change, 3> out;
  const std::array units = {Creepage{1, 0, 0}, Creepage{0, 1, 0}, Creepage{0, 0, 1}};
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Creepage& c = units[i];
    for (std::size_t k = 0; k < contact_.elements.size(); ++k) {
      const FittedElement& e = contact_.elements[k];
      const double y = contact_.grid.y(e.row);
      cause.cx[k] = mean_over_path(e, wavenumber, [&](double) { return c.longitudinal - c.spin * y; });
      cause.cy[k] = mean_over_path(e, wavenumber, [&](double x) { return c.lateral + c.spin * x; });
    }
    const double third = static_cast<double>(i) / 3;
    out[i] = response.solve(wavenumber, cause, tolerance, part(progress, third, third + 1.0 / 3));
  }
  return out;
}

RollingResponse::Change SecondOrderRolling::respond_to(const RollingResponse::Cause& cause,
                                                       std::span<const double> bound,
                                                       const SecondOrderSolution& solution, double wavenumber,
                                                       double tolerance, const Progress& progress) {
  return linearised_response(bound, solution).solve(wavenumber, cause, tolerance, progress);
}

VectorField SecondOrderRolling::slip_by(const VectorField& traction) {
  VectorField slip(traction.x.size());
  operator_.apply(traction.x, traction.y, slip.x, slip.y);
  return slip;
}

SecondOrderRolling::Responses SecondOrderRolling::respond(std::span<const double> bound,
                                                          const SecondOrderSolution& solution, double wavenumber,
                                                          double tolerance, const Progress& progress) {
  Responses out{respond_to_creepages(bound, solution, wavenumber, tolerance, part(progress, 0, 0.75)), {}};
  VectorField slip = slip_by(solution.friction.traction);
  RollingResponse::Cause growth(bound.size());
  find_slip_of_growth(contact_, {operator_.ux(), operator_.uy()}, slip, solution.creepage.spin, wavenumber, growth.cx,
                      growth.cy);
  growth.bound.assign(bound.begin(), bound.end());
  out.by_size = respond_to(growth, bound, solution, wavenumber, tolerance, part(progress, 0.75, 1));
  return out;
}

} // namespace microslip
