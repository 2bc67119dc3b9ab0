#include "microslip/contact/solver_report.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace microslip {
namespace {

std::string shortest(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

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
      return "accuracy not reached: estimated error " + shortest(*report.estimated_error) + " mu Fn";
    return "not converged: residual " + shortest(report.residual) + " after " + std::to_string(report.newton_steps) +
           " Newton steps";
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
