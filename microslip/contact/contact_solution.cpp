#include "microslip/contact/contact_solution.hpp"

#include <limits>
#include <utility>

namespace microslip {

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

} // namespace microslip
