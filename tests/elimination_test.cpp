#include "microslip/numerics/elimination.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace microslip {
namespace {

TEST(Elimination, SolvesForSeveralRightHandSides) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const std::size_t n : {1U, 2U, 7U, 30U}) {
    std::vector<double> matrix(n * n), first(n), second(n);
    for (std::vector<double>* all : {&matrix, &first, &second})
      for (double& x : *all) x = any(random);
    if (n > 1) matrix[0] = 0; // rows must be exchanged
    std::vector<double> work = matrix, x = first, y = second;
    ASSERT_TRUE(eliminate(work, {x, y}));
    for (std::size_t i = 0; i < n; ++i) {
      double one = -first[i], two = -second[i];
      for (std::size_t j = 0; j < n; ++j) one += matrix[i * n + j] * x[j], two += matrix[i * n + j] * y[j];
      EXPECT_NEAR(one, 0, 1e-11);
      EXPECT_NEAR(two, 0, 1e-11);
    }
  }
}

TEST(Elimination, SaysWhereAMatrixIsSingular) {
  std::vector<double> matrix = {1, 2, 2, 4}, b = {1, 1};
  EXPECT_FALSE(eliminate(matrix, {b}));
}

} // namespace
} // namespace microslip
