#include "microslip/contact/solver_report.hpp"

#include "microslip/decimal.hpp"

#include <cmath>

namespace microslip {
namespace {

constexpr const char* overflow = "overflow or underflow in the computation: check units and magnitudes";

std::string reason_of(const SolverReport& report) {
  switch (report.status) {
  case Status::ok:
    return "";
  case Status::invalid_input:
    return overflow;
  case Status::not_converged:
    if (!std::isfinite(report.residual)) return overflow;
    if (report.estimated_error)
      return "accuracy not reached: estimated error " + rounded_text(*report.estimated_error, 3) + " mu Fn";
    return "not converged: residual " + rounded_text(report.residual, 3) + " after " +
           std::to_string(report.newton_steps) + " Newton steps";
  case Status::no_contact:
    return "the bodies do not touch";
  case Status::no_solution:
    return "prescribed force exceeds mu Fn; the result shown is full sliding";
  case Status::implausible:
    return "solved, but it cannot be meant: see the warnings";
  case Status::out_of_range:
    return "beyond the creep-force table's range: the forces are those of limits";
  }
  return "";
}

} // namespace

void add_reason(SolverReport& report) {
  if (report.reason.empty()) report.reason = reason_of(report);
}

} // namespace microslip
