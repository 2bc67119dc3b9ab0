#include "microslip/contact/solver_report.hpp"
#include "tests/support/numbers.hpp"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string reason_of(SolverReport report) {
  add_reason(report);
  return report.reason;
}

TEST(SolverReport, HasAReasonUnlessItIsOk) {
  EXPECT_EQ(reason_of({}), "");
  EXPECT_EQ(reason_of({.status = Status::no_contact}), "the bodies do not touch");
  EXPECT_EQ(reason_of({.status = Status::no_solution}),
            "prescribed force exceeds mu Fn; the result shown is full sliding");
  EXPECT_EQ(reason_of({.status = Status::out_of_range}),
            "beyond the creep-force table's range: the forces are those of limits");
  EXPECT_EQ(reason_of({.status = Status::not_converged, .residual = 2e-3, .newton_steps = 40}),
            "not converged: residual 0.002 after 40 Newton steps");
}

TEST(SolverReport, WithoutAResidualSpeaksOfOverflow) {
  const std::string overflow = "overflow or underflow in the computation: check units and magnitudes";
  EXPECT_EQ(reason_of({.status = Status::not_converged, .residual = nan}), overflow);
  EXPECT_EQ(reason_of({.status = Status::invalid_input}), overflow);
}

TEST(SolverReport, OfAnAccuracyNotReachedNamesTheError) {
  EXPECT_EQ(reason_of({.status = Status::not_converged, .residual = 1e-7, .estimated_error = 2.5e-5}),
            "accuracy not reached: estimated error 2.5e-05 mu Fn");
}

TEST(SolverReport, KeepsAReasonThatItHas) {
  EXPECT_EQ(reason_of({.status = Status::invalid_input, .reason = "a = 0 [m]: must be positive"}),
            "a = 0 [m]: must be positive");
}

TEST(Status, CodesAreListedWithTheirNames) {
  std::istringstream listed(status_codes);
  std::string name;
  int count = 0;
  for (int code = 0; listed >> code >> name; ++count) {
    if (name.back() == ',') name.pop_back();
    EXPECT_EQ(code, count);
    EXPECT_EQ(name, to_string(static_cast<Status>(code)));
  }
  EXPECT_EQ(to_string(static_cast<Status>(count)), "");
}

} // namespace
} // namespace microslip
