#include "microslip/contact/contact_solution.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace microslip {
namespace {

constexpr double left_by_rounding = 1e-10; // of a relative residual, on fine grids

bool are_finite(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); });
}

bool are_finite(const Creepage& c) {
  return are_finite({c.longitudinal, c.lateral, c.spin});
}

/// A solution's, or a step's of its history.
void conclude(SolverReport& report, bool has_numbers, double tolerance) {
  if (is_solved(report.status) || report.status == Status::out_of_range) {
    if (!has_numbers || !std::isfinite(report.residual))
      report.status = Status::invalid_input;
    else if (!(report.residual <= std::max(tolerance, left_by_rounding)))
      report.status = Status::not_converged;
  }
  if (report.status == Status::ok) report.reason.clear();
  add_reason(report);
}

} // namespace

ContactSolution solution_without_result(Status status, std::string reason) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ContactSolution out;
  out.creepage = {nan, nan, nan};
  out.approach = nan;
  static_assert(sizeof(Totals) == 11 * sizeof(double), "each of the totals is set to NaN");
  out.totals = {nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan};
  out.report = {.status = status, .reason = std::move(reason), .residual = nan};
  return out;
}

void conclude(ContactSolution& s, double tolerance) {
  const bool has_numbers =
      is_finite(s.totals) && are_finite(s.creepage) && are_finite({s.approach, s.highest_temperature});
  conclude(s.report, has_numbers, tolerance);
  for (SolutionStep& step : s.history)
    conclude(step.report, is_finite(step.totals) && are_finite(step.creepage), tolerance);
  if (s.report.status == Status::invalid_input) {
    const ContactMotion motion = s.motion;
    s = solution_without_result(Status::invalid_input, std::move(s.report.reason));
    s.motion = motion;
  }
  if (s.report.status == Status::no_contact) s.totals = {};
}

} // namespace microslip
