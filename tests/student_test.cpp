// Quantiles of Student's distribution: closed forms, and values that every table has.

#include "fit/student.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip::fit {
namespace {

TEST(StudentQuantile, OfOneAndTwoDegreesOfFreedomIsAClosedForm) {
  for (const double p : {0.1, 0.5, 0.9, 0.95, 0.999}) {
    EXPECT_NEAR(student_quantile(p, 1) / std::tan(std::numbers::pi * p / 2), 1, 1e-9);
    EXPECT_NEAR(student_quantile(p, 2) / (p * std::sqrt(2 / (1 - p * p))), 1, 1e-9);
  }
}

TEST(StudentQuantile, IsThatOfTables) {
  EXPECT_NEAR(student_quantile(0.95, 5), 2.570582, 1e-6);
  EXPECT_NEAR(student_quantile(0.95, 10), 2.228139, 1e-6);
  EXPECT_NEAR(student_quantile(0.95, 30), 2.042272, 1e-6);
  EXPECT_NEAR(student_quantile(0.95, 100000), 1.959988, 2e-6); // nearly the normal one, 1.959964
}

TEST(StudentQuantile, RefusesWhatIsNoProbability) {
  EXPECT_THROW(student_quantile(1, 5), Error);
  EXPECT_THROW(student_quantile(0.5, 0), Error);
}

} // namespace
} // namespace microslip::fit
