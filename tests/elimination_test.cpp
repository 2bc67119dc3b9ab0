#include "microslip/numerics/elimination.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace microslip {
namespace {

/// Rows of a matrix of order n with random numbers, and sides.
std::vector<double> random_rows(std::size_t n, std::size_t columns) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<double> rows(n * columns);
  for (double& x : rows) x = any(random);
  return rows;
}

TEST(Elimination, SolvesForSeveralRightHandSides) {
  for (const std::size_t n : {1U, 2U, 7U, 30U})
    for (const std::size_t sides : {1U, 2U, 9U}) {
      const std::size_t columns = n + sides;
      std::vector<double> given = random_rows(n, columns);
      if (n > 1) given[0] = 0; // rows must be exchanged
      std::vector<double> solved = given;
      ASSERT_TRUE(eliminate(solved, n, sides));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t side = n; side < columns; ++side) {
          double residual = -given[i * columns + side];
          for (std::size_t j = 0; j < n; ++j) residual += given[i * columns + j] * solved[j * columns + side];
          EXPECT_NEAR(residual, 0, 1e-11);
        }
    }
}

TEST(Elimination, HasTheSameBitsForEveryInstructionSet) {
  for (const std::size_t columns : {30U, 31U, 32U}) {
    std::vector<double> first;
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
      if (!is_available(set)) continue;
      std::vector<double> rows = random_rows(28, columns), sides;
      ASSERT_TRUE(eliminate(rows, 28, 1, set));
      for (std::size_t i = 0; i < 28; ++i) sides.push_back(rows[i * columns + 28]);
      if (first.empty()) first = sides;
      EXPECT_EQ(sides, first) << columns;
    }
  }
}

TEST(Elimination, SaysWhereAMatrixIsSingular) {
  std::vector<double> rows = {1, 2, 1, 2, 4, 1};
  EXPECT_FALSE(eliminate(rows, 2, 1));
}

} // namespace
} // namespace microslip
