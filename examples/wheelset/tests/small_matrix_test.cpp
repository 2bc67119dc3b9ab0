#include "small_matrix.hpp"

#include <algorithm>
#include <complex>

#include <gtest/gtest.h>

namespace {

TEST(SmallMatrix, SolvesWithRowExchange) {
  const Matrix<3> a = {{{0, 2, 1}, {1, 1, 0}, {3, 0, 1}}};
  const Factors<3> factors(a);
  Vector<3> b = {7, 3, 6}, c = {1, 2, 2}; // x = 1, 2, 3 for b
  factors.solve(b);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(b[k], static_cast<double>(k) + 1, 1e-14);
  const Vector<3> given = c;
  factors.solve(c);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i][0] * c[0] + a[i][1] * c[1] + a[i][2] * c[2], given[i], 1e-14);
  EXPECT_THROW(Factors<2>({{{1, 2}, {2, 4}}}), std::runtime_error);
}

TEST(SmallMatrix, EigenvaluesOfACompanionMatrixAreTheRoots) {
  // (s + 1000)(s + 3)(s^2 - 0.2 s + 900), its companion matrix turned by a similarity.
  const double c[] = {2700e3, 1000 * 900 + 3 * 900 - 600, 3000 - 200.6 + 900, 1002.8};
  Matrix<4> a = {{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}, {-c[0], -c[1], -c[2], -c[3]}}};
  for (std::size_t j = 0; j < 4; ++j) a[0][j] += 2 * a[1][j]; // row 0 += 2 row 1, column 1 -= 2 column 0
  for (std::size_t i = 0; i < 4; ++i) a[i][1] -= 2 * a[i][0];
  auto found = eigenvalues(a);
  std::ranges::sort(found, {}, [](const auto& s) { return s.real() + 1e-3 * s.imag(); });
  const std::complex<double> wanted[] = {-1000, -3, {0.1, -std::sqrt(899.99)}, {0.1, std::sqrt(899.99)}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(std::abs(found[k] - wanted[k]), 1e-9 * std::abs(wanted[k])) << found[k];
}

} // namespace
