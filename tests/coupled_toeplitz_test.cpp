#include "microslip/numerics/coupled_toeplitz.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/omp_threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Kernels with the symmetries of CoupledToeplitz, random for the offsets 0 .. mx - 1, 0 .. my - 1: xx, xy, yy, xz, yz,
/// zz. Odd ones are zero where the offset is.
struct RandomKernels {
  RandomKernels(int columns, int rows) : mx(columns), my(rows) {
    for (unsigned k = 0; k < 6; ++k) {
      Field& kernel = all[k] = random_field(count(), k + 1);
      for (int i = 0; i < mx && (k == 1 || k == 4); ++i) kernel[static_cast<std::size_t>(i)] = 0;
      for (int j = 0; j < my && (k == 1 || k == 3); ++j) kernel[static_cast<std::size_t>(j) * mx] = 0;
    }
  }

  std::size_t count() const { return static_cast<std::size_t>(mx) * my; }
  CoupledToeplitz transform() const { return {mx, my, {all[0], all[1], all[2], all[3], all[4], all[5]}}; }

  int mx, my;
  std::array<Field, 6> all;
};

using Triple = std::array<Field, 3>;

Triple random_triple(std::size_t n) {
  return {random_field(n, 11), random_field(n, 12), random_field(n, 13)};
}

Triple product(CoupledToeplitz transform, const Triple& p) {
  Triple u{p[0], p[1], p[2]};
  transform.apply({p[0], p[1], p[2]}, {u[0], u[1], u[2]});
  return u;
}

/// The sums at one element.
std::array<double, 3> sums_at(const RandomKernels& kernels, const Triple& p, int i, int j) {
  std::array<double, 3> u = {};
  for (int l = 0; l < kernels.my; ++l)
    for (int k = 0; k < kernels.mx; ++k) {
      const auto offset = static_cast<std::size_t>(std::abs(j - l)) * kernels.mx + std::abs(i - k),
                 from = static_cast<std::size_t>(l) * kernels.mx + k;
      const double x_side = i < k ? -1 : 1, y_side = j < l ? -1 : 1;
      const double xx = kernels.all[0][offset], xy = x_side * y_side * kernels.all[1][offset],
                   yy = kernels.all[2][offset], xz = x_side * kernels.all[3][offset],
                   yz = y_side * kernels.all[4][offset], zz = kernels.all[5][offset];
      u[0] += xx * p[0][from] + xy * p[1][from] + xz * p[2][from];
      u[1] += xy * p[0][from] + yy * p[1][from] + yz * p[2][from];
      u[2] += -xz * p[0][from] - yz * p[1][from] + zz * p[2][from];
    }
  return u;
}

TEST(CoupledToeplitz, IsTheSum) {
  for (int mx = 1; mx <= 10; ++mx)
    for (int my = 1; my <= 10; ++my) {
      const RandomKernels kernels(mx, my);
      const Triple p = random_triple(kernels.count()), u = product(kernels.transform(), p);
      for (int j = 0; j < my; ++j)
        for (int i = 0; i < mx; ++i) {
          const auto exact = sums_at(kernels, p, i, j);
          for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(u[c][static_cast<std::size_t>(j) * mx + i], exact[c], 1e-12)
                << mx << " x " << my << ", component " << c;
        }
    }
}

TEST(CoupledToeplitz, WorksInPlaceAndWithoutTheNormal) {
  const RandomKernels kernels(23, 18);
  const Triple p = random_triple(kernels.count()), u = product(kernels.transform(), p);
  CoupledToeplitz transform = kernels.transform();
  Triple in_place = p;
  transform.apply({in_place[0], in_place[1], in_place[2]}, {in_place[0], in_place[1], in_place[2]});
  EXPECT_EQ(in_place, u);
  Triple along = p;
  transform.apply({p[0], p[1], p[2]}, {along[0], along[1], {}});
  EXPECT_EQ(along[0], u[0]);
  EXPECT_EQ(along[1], u[1]);
  EXPECT_EQ(transform.products(), 2);
}

TEST(CoupledToeplitz, DoesNotDependOnThreads) {
  const RandomKernels kernels(130, 171);
  const Triple p = random_triple(kernels.count());
  const OmpThreads one(1);
  const Triple u = product(kernels.transform(), p);
  const auto exact = sums_at(kernels, p, 77, 99);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(u[c][99 * 130 + 77], exact[c], 1e-10);
  const OmpThreads three(3);
  EXPECT_EQ(product(kernels.transform(), p), u);
}

} // namespace
} // namespace microslip
