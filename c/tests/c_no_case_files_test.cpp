// A library that was built without case files makes no problem, and says so.

#include "microslip.h"

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(CNoCaseFiles, ProblemsAreRefusedInWords) {
  microslip_error error = {};
  microslip_problem* problem = nullptr;
  EXPECT_EQ(microslip_problem_create(MICROSLIP_BODIES, &problem, &error), MICROSLIP_NO_RESULT);
  EXPECT_STREQ(error.text, "this library was built without case files");
  EXPECT_EQ(problem, nullptr);
  EXPECT_EQ(microslip_solve(problem, &error), MICROSLIP_NO_RESULT);
  EXPECT_GT(microslip_count(MICROSLIP_BODIES_INPUT), 0U);
}

} // namespace
} // namespace microslip
