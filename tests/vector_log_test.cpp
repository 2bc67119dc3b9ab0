#include "microslip/numerics/vector_log.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace microslip {
namespace {

double error(double v) {
  return static_cast<double>(std::abs(vector_log(v) - std::log(static_cast<long double>(v))));
}

TEST(VectorLog, IsTheLogarithmToTwoUnitsOfTheLastPlace) {
  std::mt19937_64 engine(5);
  for (int k = 0; k < 100000; ++k) {
    const double v = std::exp2(2000 * (static_cast<double>(engine()) * 0x1p-64 - 0.5));
    EXPECT_LT(error(v), 2 * DBL_EPSILON * std::max(0.5, std::abs(std::log(v)))) << v;
  }
}

/// No digits are lost where it is small.
TEST(VectorLog, NearOneToo) {
  EXPECT_EQ(vector_log(1), 0);
  for (double distance = 0.3; distance > 1e-15; distance /= 1.7)
    for (const double v : {1 - distance, 1 + distance})
      EXPECT_LT(error(v), 2 * DBL_EPSILON * std::abs(std::log(v))) << v;
}

TEST(VectorLog, AtTheEndsOfItsRange) {
  for (const double v : {DBL_MIN, DBL_MAX, std::sqrt(0.5), std::sqrt(2.0), std::nextafter(std::sqrt(0.5), 0.0)})
    EXPECT_LT(error(v), 2 * DBL_EPSILON * std::max(0.5, std::abs(std::log(v)))) << v;
}

} // namespace
} // namespace microslip
