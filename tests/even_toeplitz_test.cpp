// Products with an even kernel against sums, the circulant inverse, and threads.

#include "microslip/error.hpp"
#include "microslip/numerics/even_toeplitz.hpp"
#include "microslip/numerics/transforms.hpp"
#include "tests/support/fields.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

namespace microslip {
namespace {

/// Falls like 1/distance, as displacements do.
double kernel(int i, int j) {
  return 1 / std::hypot(i, 0.7 * j, 0.4);
}

void kernel_row(int j, std::span<double> entries) {
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = kernel(static_cast<int>(i), j);
}

Field product(int mx, int my, const Field& in) {
  Field out(in.size());
  EvenToeplitz(mx, my, kernel_row).apply(in, out);
  return out;
}

TEST(EvenToeplitz, IsTheSum) {
  for (int mx = 1; mx <= 11; ++mx)
    for (int my = 1; my <= 11; ++my) {
      const Field in = random_field(static_cast<std::size_t>(mx) * my, 7), out = product(mx, my, in);
      for (int j = 0; j < my; ++j)
        for (int i = 0; i < mx; ++i) {
          double sum = 0, size = 0;
          for (int l = 0; l < my; ++l)
            for (int k = 0; k < mx; ++k) {
              const double term = kernel(std::abs(i - k), std::abs(j - l)) * in[static_cast<std::size_t>(l) * mx + k];
              sum += term;
              size += std::abs(term);
            }
          EXPECT_NEAR(out[static_cast<std::size_t>(j) * mx + i], sum, 1e-13 * size) << mx << " x " << my;
        }
    }
}

TEST(EvenToeplitz, CirculantInverseIsPositiveAndNearTheInverse) {
  for (const int m : {1, 5, 24}) {
    const Field in = random_field(static_cast<std::size_t>(m) * m, 7);
    Field image(in.size()), back(in.size());
    EvenToeplitz matrix(m, m, kernel_row);
    matrix.apply_circulant_inverse(in, back);
    EXPECT_GT(std::inner_product(in.begin(), in.end(), back.begin(), 0.0), 0);
    matrix.apply(in, image);
    matrix.apply_circulant_inverse(image, back);
    double error = 0, size = 0;
    for (std::size_t k = 0; k < in.size(); ++k) {
      error += std::pow(back[k] - in[k], 2);
      size += in[k] * in[k];
    }
    EXPECT_LT(std::sqrt(error / size), 0.7) << m;
    EXPECT_EQ(matrix.products(), 3);
  }
}

/// On grids as long as a period, where the kernel does not reach beyond the next elements.
TEST(EvenToeplitz, CirculantInverseIsThatOfTheRepeatedKernel) {
  const auto next_only = [](int i, int j) {
    constexpr double entries[2][2] = {{1, 0.2}, {0.1, 0.05}};
    return i < 2 && j < 2 ? entries[j][i] : 0;
  };
  for (const int mx : {8, 12, 48})
    for (const int my : {8, 20}) {
      ASSERT_EQ(quick_size(mx), mx);
      ASSERT_EQ(quick_size(my), my);
      const Field in = random_field(static_cast<std::size_t>(mx) * my, 7);
      Field solution(in.size());
      EvenToeplitz(mx, my, [&](int j, std::span<double> entries) {
        for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = next_only(static_cast<int>(i), j);
      }).apply_circulant_inverse(in, solution);
      for (int j = 0; j < my; ++j)
        for (int i = 0; i < mx; ++i) {
          double sum = 0;
          for (int l = -1; l <= 1; ++l)
            for (int k = -1; k <= 1; ++k)
              sum += next_only(std::abs(k), std::abs(l)) *
                     solution[static_cast<std::size_t>((j + l + my) % my) * mx + (i + k + mx) % mx];
          EXPECT_NEAR(sum, in[static_cast<std::size_t>(j) * mx + i], 1e-13) << mx << " x " << my;
        }
    }
}

/// They share memory.
TEST(EvenToeplitz, ProductsOfTheTwoKindsDoNotDisturbEachOther) {
  for (const int mx : {1, 5, 37})
    for (const int my : {1, 6, 29}) {
      const Field in = random_field(static_cast<std::size_t>(mx) * my, 7);
      Field first(in.size()), inverse(in.size()), again(in.size());
      EvenToeplitz matrix(mx, my, kernel_row);
      matrix.apply(in, first);
      matrix.apply_circulant_inverse(in, inverse);
      matrix.apply(in, again);
      EXPECT_EQ(again, first);
      matrix.apply_circulant_inverse(in, again);
      EXPECT_EQ(again, inverse);
    }
}

TEST(EvenToeplitz, ThreadsDoNotMatter) {
  constexpr int m = 301; // large enough for several
  const Field in = random_field(std::size_t{m} * m, 7);
  const auto both_products = [&] {
    EvenToeplitz matrix(m, m, kernel_row);
    std::array<Field, 2> out = {Field(in.size()), Field(in.size())};
    matrix.apply(in, out[0]);
    matrix.apply_circulant_inverse(in, out[1]);
    return out;
  };
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = both_products();
  for (const int threads : {2, 3}) {
    omp_set_num_threads(threads);
    EXPECT_EQ(both_products(), one);
  }
  omp_set_num_threads(before);
}

TEST(EvenToeplitz, NeedsAGrid) {
  EXPECT_THROW(EvenToeplitz(0, 3, kernel_row), Error);
}

} // namespace
} // namespace microslip
