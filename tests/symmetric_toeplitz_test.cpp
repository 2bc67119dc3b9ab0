#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/omp_threads.hpp"
#include "tests/support/two_threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

namespace microslip {
namespace {

struct Shape {
  int mx, my;

  std::size_t count() const { return static_cast<std::size_t>(mx) * my; }
};

std::string text(const Shape& s) {
  return std::to_string(s.mx) + " x " + std::to_string(s.my);
}

/// Kernels with the symmetries of SymmetricToeplitz: random for the offsets 0 .. mx - 1, 0 .. my - 1. xy, being odd, is
/// zero where one of the offsets is.
struct RandomKernels {
  RandomKernels(const Shape& s, unsigned seed)
      : shape(s), xx(random_field(s.count(), seed)), xy(random_field(s.count(), seed + 1)),
        yy(random_field(s.count(), seed + 2)) {
    for (int i = 0; i < s.mx; ++i) xy[i] = 0;
    for (int j = 0; j < s.my; ++j) xy[static_cast<std::size_t>(j) * s.mx] = 0;
  }

  SymmetricToeplitz<double> transform() const { return {shape.mx, shape.my, {xx, xy, yy}}; }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(std::abs(j)) * shape.mx + std::abs(i); }

  Shape shape;
  Field xx, xy, yy;
};

/// Components of a vector field, one after the other.
using Pair = std::array<Field, 2>;

Pair random_pair(const Shape& s, unsigned seed) {
  return {random_field(s.count(), seed), random_field(s.count(), seed + 1)};
}

/// The sums at one element.
std::array<double, 2> dense_product_at(const RandomKernels& kernels, const Pair& p, int i, int j) {
  const auto& [mx, my] = kernels.shape;
  double ux = 0, uy = 0;
  for (int l = 0; l < my; ++l)
    for (int k = 0; k < mx; ++k) {
      const std::size_t offset = kernels.index(i - k, j - l), from = static_cast<std::size_t>(l) * mx + k;
      const double xy = (i < k) == (j < l) ? kernels.xy[offset] : -kernels.xy[offset];
      ux += kernels.xx[offset] * p[0][from] + xy * p[1][from];
      uy += xy * p[0][from] + kernels.yy[offset] * p[1][from];
    }
  return {ux, uy};
}

template <class Real> Pair product(SymmetricToeplitz<Real>& transform, const Shape& s, const Pair& p) {
  const auto field = transform.cleared_field();
  for (std::size_t k = 0; k < s.count(); ++k)
    field.x[k] = static_cast<Real>(p[0][k]), field.y[k] = static_cast<Real>(p[1][k]);
  const auto result = transform.apply();
  Pair u{Field(s.count()), Field(s.count())};
  for (std::size_t k = 0; k < s.count(); ++k) u[0][k] = result.x[k], u[1][k] = result.y[k];
  return u;
}

/// Largest difference to the dense product over the root mean square of its sums, at every `stride`-th element.
double error(const RandomKernels& kernels, const Pair& p, const Pair& u, std::size_t stride = 1) {
  double worst = 0, squares = 0;
  std::size_t sums = 0;
  for (std::size_t k = 0; k < u[0].size(); k += stride) {
    const auto exact =
        dense_product_at(kernels, p, static_cast<int>(k % kernels.shape.mx), static_cast<int>(k / kernels.shape.mx));
    for (std::size_t c = 0; c < 2; ++c, ++sums) {
      worst = std::max(worst, std::abs(u[c][k] - exact[c]));
      squares += exact[c] * exact[c];
    }
  }
  return worst / std::sqrt(squares / static_cast<double>(sums));
}

/// A grid that the transforms do in several threads.
constexpr Shape large{130, 171};

TEST(SymmetricToeplitz, IsTheDenseProduct) {
  for (int mx = 1; mx <= 12; ++mx)
    for (int my = 1; my <= 12; ++my) {
      const Shape s{mx, my};
      const RandomKernels kernels(s, 3);
      SymmetricToeplitz transform = kernels.transform();
      const Pair p = random_pair(s, 7);
      EXPECT_LT(error(kernels, p, product(transform, s, p)), 1e-13) << text(s);
    }
}

TEST(SymmetricToeplitz, IsTheDenseProductOnLongAndLargeGrids) {
  for (const Shape& s : {Shape{301, 1}, {1, 301}, {97, 2}, {2, 97}, {61, 48}, large}) {
    const RandomKernels kernels(s, 3);
    SymmetricToeplitz transform = kernels.transform();
    const Pair p = random_pair(s, 7);
    EXPECT_LT(error(kernels, p, product(transform, s, p), s.count() / 200 + 1), 1e-13) << text(s);
  }
}

/// A unit gives the kernel around it back, so that each number of a kernel is seen for itself and nothing wraps around.
TEST(SymmetricToeplitz, UnitsGiveTheKernelsBack) {
  for (const Shape& s : {Shape{1, 1}, {2, 3}, {7, 4}, {12, 12}}) {
    const RandomKernels kernels(s, 11);
    SymmetricToeplitz transform = kernels.transform();
    for (std::size_t place = 0; place < s.count(); ++place)
      for (std::size_t c = 0; c < 2; ++c) {
        Pair p{Field(s.count(), 0.0), Field(s.count(), 0.0)};
        p[c][place] = 1;
        EXPECT_LT(error(kernels, p, product(transform, s, p)), 1e-14) << text(s) << ' ' << place << ' ' << c;
      }
  }
}

/// Threads share out rows and columns, which are transformed alike by any thread.
TEST(SymmetricToeplitz, NumberOfThreadsDoesNotMatterToTheLastBit) {
  const RandomKernels kernels(large, 21);
  const Pair p = random_pair(large, 22);
  std::vector<Pair> results;
  for (const int count : {1, 2, 3}) {
    const OmpThreads threads(count);
    SymmetricToeplitz transform = kernels.transform();
    results.push_back(product(transform, large, p));
  }
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

/// The threads that there are when it is used may be fewer than when it was made, as inside of a parallel region.
TEST(SymmetricToeplitz, FewerThreadsThanItWasMadeFor) {
  const RandomKernels kernels(large, 31);
  const Pair p = random_pair(large, 32);
  const OmpThreads threads(3);
  SymmetricToeplitz transform = kernels.transform();
  const Pair with_three = product(transform, large, p);
  const int levels = omp_get_max_active_levels();
  omp_set_max_active_levels(0);
  const Pair with_one = product(transform, large, p);
  omp_set_max_active_levels(levels);
  EXPECT_EQ(with_one, with_three);
}

/// What was done before leaves no trace.
TEST(SymmetricToeplitz, CanBeUsedAgain) {
  for (const Shape& s : {Shape{9, 5}, {12, 16}}) {
    const RandomKernels kernels(s, 41);
    SymmetricToeplitz transform = kernels.transform();
    const Pair p = random_pair(s, 42);
    const Pair first = product(transform, s, p);
    product(transform, s, random_pair(s, 43));
    EXPECT_EQ(product(transform, s, p), first);
    EXPECT_EQ(transform.products(), 3);
  }
}

TEST(SymmetricToeplitz, ReplacedKernelsAreAsFreshOnesToTheLastBit) {
  for (const Shape& s : {Shape{1, 1}, {9, 5}, {24, 17}, large}) {
    const RandomKernels kernels(s, 71), others(s, 72);
    const TransformPlans plans;
    SymmetricToeplitz<double> transform(s.mx, s.my, {kernels.xx, kernels.xy, kernels.yy}, plans);
    const Pair p = random_pair(s, 73);
    product(transform, s, p);
    transform.replace({others.xx, others.xy, others.yy});
    SymmetricToeplitz fresh = others.transform();
    EXPECT_EQ(product(transform, s, p), product(fresh, s, p)) << text(s);
    EXPECT_EQ(transform.products(), 1);
  }
}

TEST(SymmetricToeplitz, AFactorTimesItInSinglePrecision) {
  for (const Shape& s : {Shape{1, 1}, {9, 5}, {24, 17}, large}) {
    const RandomKernels kernels(s, 61);
    const SymmetricToeplitz transform = kernels.transform();
    SymmetricToeplitz<float> single(transform, -4);
    const Pair p = random_pair(s, 62);
    Pair u = product(single, s, p);
    for (Field& component : u)
      for (double& value : component) value /= -4;
    EXPECT_LT(error(kernels, p, u, s.count() / 200 + 1), 3e-6) << text(s);
  }
}

/// Of kernels like those of displacements, 1/distance and as anisotropic.
struct FallingKernels {
  explicit FallingKernels(const Shape& s) : shape(s), xx(s.count()), xy(s.count()), yy(s.count()) {
    for (int j = 0; j < s.my; ++j)
      for (int i = 0; i < s.mx; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * s.mx + i;
        const double r = std::hypot(i, j), nu = 0.28;
        xx[k] = k == 0 ? 3.5 * (1 - nu / 2) : (1 - nu) / r + nu * i * i / (r * r * r);
        yy[k] = k == 0 ? 3.5 * (1 - nu / 2) : (1 - nu) / r + nu * j * j / (r * r * r);
        xy[k] = k == 0 ? 0 : nu * i * j / (r * r * r);
      }
  }

  SymmetricToeplitz<double>::Kernels view() const { return {xx, xy, yy}; }

  Shape shape;
  Field xx, xy, yy;
};

double dot(const Pair& a, const Pair& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a[0].size(); ++k) sum += a[0][k] * b[0][k] + a[1][k] * b[1][k];
  return sum;
}

Pair product(SymmetricToeplitz<double>& matrix, const Pair& p) {
  Pair u = {Field(p[0].size()), Field(p[0].size())};
  matrix.apply(p[0], p[1], 1.0, u[0], u[1]);
  return u;
}

/// And of its part on a disk: u.M^-1 u is near p.u for u = A p, whatever the grid.
TEST(SymmetricToeplitz, NearInverse) {
  for (const Shape& s : {Shape{9, 9}, Shape{40, 24}, Shape{1, 12}, Shape{90, 70}}) {
    SCOPED_TRACE(text(s));
    const FallingKernels kernels(s);
    SymmetricToeplitz<double> matrix(s.mx, s.my, kernels.view());
    auto near_inverse = SymmetricToeplitz<double>::near_inverse(s.mx, s.my, kernels.view());
    const Pair some = random_pair(s, 5), other = random_pair(s, 17);
    EXPECT_NEAR(dot(some, product(near_inverse, other)), dot(other, product(near_inverse, some)),
                1e-12 * static_cast<double>(s.count()));
    const bool smooth[] = {false, true};
    for (const bool is_smooth : smooth) {
      Pair p = is_smooth ? Pair{Field(s.count(), 1.0), Field(s.count(), 0.5)} : some;
      for (int j = 0; j < s.my; ++j)
        for (int i = 0; i < s.mx; ++i)
          if (std::hypot((i + 0.5) / s.mx - 0.5, (j + 0.5) / s.my - 0.5) > 0.45)
            p[0][static_cast<std::size_t>(j) * s.mx + i] = p[1][static_cast<std::size_t>(j) * s.mx + i] = 0;
      Pair u = product(matrix, p);
      for (std::size_t k = 0; k < s.count(); ++k)
        if (p[0][k] == 0) u[0][k] = u[1][k] = 0; // the part on the disk
      const double ratio = dot(u, product(near_inverse, u)) / dot(p, u);
      EXPECT_GT(ratio, 0.5) << is_smooth;
      EXPECT_LT(ratio, 3) << is_smooth;
    }
  }
}

TEST(SymmetricToeplitz, MovedObjectsWork) {
  const Shape s{6, 4};
  const RandomKernels kernels(s, 51), others({3, 3}, 52);
  const Pair p = random_pair(s, 53);
  SymmetricToeplitz transform = kernels.transform();
  SymmetricToeplitz moved(std::move(transform));
  EXPECT_LT(error(kernels, p, product(moved, s, p)), 1e-13);
  SymmetricToeplitz assigned = others.transform();
  assigned = std::move(moved);
  EXPECT_LT(error(kernels, p, product(assigned, s, p)), 1e-13);
}

/// Objects made, used and destroyed in two threads at once.
TEST(SymmetricToeplitz, DistinctObjectsInDistinctThreads) {
  const double worst = worst_in_two_threads([](unsigned thread, unsigned round) {
    const Shape s{3 + static_cast<int>(7 * thread + round % 9), 5 + static_cast<int>(round % 4)};
    const RandomKernels kernels(s, 100 * thread + round);
    SymmetricToeplitz transform = kernels.transform();
    const Pair p = random_pair(s, 7 * round + thread);
    return error(kernels, p, product(transform, s, p));
  });
  EXPECT_LT(worst, 1e-13);
}

} // namespace
} // namespace microslip
