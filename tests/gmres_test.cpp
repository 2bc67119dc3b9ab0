#include "microslip/numerics/gmres.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

using Vector = std::vector<double>;

struct Matrix {
  std::size_t n;
  Vector values; ///< row by row

  Vector operator*(const Vector& x) const {
    Vector y(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) y[i] += values[i * n + j] * x[j];
    return y;
  }
  Gmres<double>::Product product() const {
    return [this](std::span<const double> in, std::span<double> out) {
      const Vector y = *this * Vector(in.begin(), in.end());
      std::copy(y.begin(), y.end(), out.begin());
    };
  }
};

/// Random entries, and `weight` sqrt(n) on the diagonal.
Matrix random_matrix(std::size_t n, unsigned seed, double weight) {
  Matrix m{n, random_field(n * n, seed)};
  for (std::size_t i = 0; i < n; ++i) m.values[i * (n + 1)] += weight * std::sqrt(double(n));
  return m;
}
Matrix diagonal_matrix(const Vector& diagonal) {
  const std::size_t n = diagonal.size();
  Matrix m{n, Vector(n * n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) m.values[i * (n + 1)] = diagonal[i];
  return m;
}

double norm(const Vector& v) {
  double sum = 0;
  for (double value : v) sum += value * value;
  return std::sqrt(sum);
}
double residual(const Matrix& a, const Vector& x, const Vector& b) {
  Vector r = a * x;
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= b[i];
  return norm(r);
}

TEST(Gmres, IsExactAfterAsManyProductsAsUnknowns) {
  for (const std::size_t n : {1U, 2U, 7U, 40U, 90U})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Matrix a = random_matrix(n, seed, 0.5);
      const Vector exact = random_field(n, 100 + seed), b = a * exact;
      Vector x(n);
      const auto result = Gmres<double>().solve(a.product(), b, x, 1e-13, static_cast<int>(n));
      EXPECT_LE(result.products, static_cast<int>(n));
      EXPECT_LT(residual(a, x, b), 1e-12 * norm(b)) << n;
      EXPECT_NEAR(result.residual, residual(a, x, b), 1e-12 * norm(b));
    }
}

TEST(Gmres, StopsAtTheTolerance) {
  const std::size_t n = 80;
  const Matrix a = random_matrix(n, 3, 3);
  const Vector b = random_field(n, 4);
  int before = 0;
  for (const double tolerance : {0.5, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    Vector x(n);
    const auto result = Gmres<double>().solve(a.product(), b, x, tolerance, 80);
    EXPECT_LE(residual(a, x, b), 1.0001 * tolerance * norm(b));
    EXPECT_LE(result.residual, tolerance * norm(b));
    EXPECT_GT(result.products, before);
    // One product fewer is not enough.
    Vector shorter(n);
    EXPECT_GT(Gmres<double>().solve(a.product(), b, shorter, tolerance, result.products - 1).residual,
              tolerance * norm(b));
    before = result.products;
  }
  EXPECT_LT(before, 60);
}

/// No vector of the space that k products span leaves a smaller residual; it never grows.
TEST(Gmres, ResidualIsTheLeastOfTheKrylovSpace) {
  const std::size_t n = 30;
  const Matrix a = random_matrix(n, 8, 1);
  const Vector b = random_field(n, 9);
  double before = norm(b);
  for (int k = 1; k < 20; ++k) {
    Vector x(n);
    const auto result = Gmres<double>().solve(a.product(), b, x, 0, k);
    EXPECT_EQ(result.products, k);
    const double r = residual(a, x, b);
    EXPECT_NEAR(result.residual, r, 1e-12 * norm(b));
    EXPECT_LE(r, before * (1 + 1e-12));
    before = r;
    Vector power = b;
    for (int p = 0; p < k; ++p) {
      for (const double step : {1e-4, -1e-4}) {
        Vector other = x;
        for (std::size_t i = 0; i < n; ++i) other[i] += step * norm(x) / norm(power) * power[i];
        EXPECT_GE(residual(a, other, b), r);
      }
      power = a * power;
    }
  }
}

TEST(Gmres, WeightsGiveWhateverWasFoundWithTheProducts) {
  const Matrix a = random_matrix(60, 11, 2);
  const Vector b = random_field(60, 12);
  Vector x(60), sum(60), image_sum(60);
  std::vector<Vector> asked, images;
  const Gmres<double>::Product product = [&](std::span<const double> in, std::span<double> out) {
    asked.emplace_back(in.begin(), in.end());
    images.push_back(a * asked.back());
    std::copy(images.back().begin(), images.back().end(), out.begin());
  };
  const auto result = Gmres<double>().solve(product, b, x, 1e-4, 60);
  ASSERT_GT(asked.size(), 3u);
  ASSERT_EQ(result.weights.size(), asked.size());
  combine<double, double>(result.weights, asked, sum);
  combine<double, double>(result.weights, images, image_sum);
  const Vector image = a * x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(sum[i], x[i], 1e-14);
    EXPECT_NEAR(image_sum[i], image[i], 1e-12);
  }
}

TEST(Gmres, ZeroRightSide) {
  const Matrix a = random_matrix(6, 1, 1);
  Vector x = random_field(6, 2);
  const auto result = Gmres<double>().solve(a.product(), Vector(6, 0.0), x, 1e-6, 10);
  EXPECT_EQ(result.products, 0);
  EXPECT_EQ(result.residual, 0);
  EXPECT_EQ(x, Vector(6, 0.0));
}

TEST(Gmres, StartsFromZeroWhateverXHolds) {
  const Matrix a = random_matrix(12, 1, 2);
  const Vector b = random_field(12, 2);
  Vector x(12, 0.0), filled = random_field(12, 3);
  Gmres<double>().solve(a.product(), b, x, 1e-3, 12);
  Gmres<double>().solve(a.product(), b, filled, 1e-3, 12);
  EXPECT_EQ(x, filled);
}

TEST(Gmres, IdentityTakesOneProduct) {
  const Matrix identity = diagonal_matrix(Vector(20, 1.0));
  const Vector b = random_field(20, 5);
  Vector x(20);
  const auto result = Gmres<double>().solve(identity.product(), b, x, 1e-12, 20);
  EXPECT_EQ(result.products, 1);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], b[i], 1e-15);
}

/// As many products as the matrix has different eigenvalues.
TEST(Gmres, ThreeEigenvaluesTakeThreeProducts) {
  Vector diagonal(30);
  for (std::size_t i = 0; i < diagonal.size(); ++i) diagonal[i] = i % 3 == 0 ? -2 : i % 3 == 1 ? 1 : 5;
  const Vector b = random_field(30, 6);
  Vector x(30);
  EXPECT_EQ(Gmres<double>().solve(diagonal_matrix(diagonal).product(), b, x, 1e-12, 30).products, 3);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], b[i] / diagonal[i], 1e-12);
}

/// A shift register: nothing is gained until the last product, and then everything.
TEST(Gmres, CyclicShiftTakesAllProducts) {
  const std::size_t n = 12;
  Matrix shift{n, Vector(n * n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) shift.values[i * n + (i + 1) % n] = 1;
  Vector b(n, 0.0), x(n);
  b[0] = 1;
  EXPECT_NEAR(Gmres<double>().solve(shift.product(), b, x, 1e-12, static_cast<int>(n) - 1).residual, 1, 1e-14);
  EXPECT_LT(Gmres<double>().solve(shift.product(), b, x, 1e-12, static_cast<int>(n)).residual, 1e-14);
  EXPECT_LT(residual(shift, x, b), 1e-14);
}

/// Of a singular system nothing but finite numbers is asked, and an honest residual.
TEST(Gmres, SingularMatrices) {
  Vector projection(9, 1.0);
  projection[4] = 0;
  Matrix one_way{2, {0, 1, 0, 0}}, rank_one{9, Vector(81, 0.0)};
  const Vector u = random_field(9, 1), v = random_field(9, 2);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j) rank_one.values[i * 9 + j] = u[i] * v[j];
  for (const Matrix& a : {diagonal_matrix(Vector(5, 0.0)), diagonal_matrix(projection), one_way, rank_one}) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      Vector b = random_field(a.n, 10 + seed), x(a.n);
      if (seed == 0) std::fill(b.begin() + 1, b.end(), 0.0);
      const auto result = Gmres<double>().solve(a.product(), b, x, 1e-10, 50);
      for (double value : x) ASSERT_TRUE(std::isfinite(value));
      const double r = residual(a, x, b);
      EXPECT_NEAR(result.residual, r, 1e-6 * norm(b)) << a.n << ", seed " << seed;
      EXPECT_LE(r, norm(b) * (1 + 1e-6));
    }
  }
}

TEST(Gmres, SolvesASingularSystemThatHasASolution) {
  Vector diagonal(9, 2.0);
  diagonal[4] = 0;
  diagonal[7] = 3;
  Vector b = random_field(9, 1), x(9);
  b[4] = 0;
  const auto result = Gmres<double>().solve(diagonal_matrix(diagonal).product(), b, x, 1e-10, 50);
  EXPECT_LT(result.residual, 1e-10 * norm(b));
  EXPECT_LT(residual(diagonal_matrix(diagonal), x, b), 1e-10 * norm(b));
}

/// The memory of an earlier, larger problem does no harm.
TEST(Gmres, OneObjectForManyProblems) {
  Gmres<double> gmres;
  for (const std::size_t n : {50U, 3U, 20U}) {
    const Matrix a = random_matrix(n, static_cast<unsigned>(n), 2);
    const Vector b = random_field(n, 1);
    Vector x(n), fresh(n);
    const auto result = gmres.solve(a.product(), b, x, 1e-8, 100);
    EXPECT_EQ(result.products, Gmres<double>().solve(a.product(), b, fresh, 1e-8, 100).products);
    EXPECT_EQ(x, fresh);
  }
}

/// Tiny and huge numbers: only ratios count.
TEST(Gmres, ScaleDoesNotMatter) {
  const std::size_t n = 25;
  const Matrix a = random_matrix(n, 1, 1);
  const Vector b = random_field(n, 2);
  Vector x(n), scaled(n);
  const auto result = Gmres<double>().solve(a.product(), b, x, 1e-7, 100);
  for (const double of_a : {0x1p-60, 0x1p80})
    for (const double of_b : {0x1p-90, 0x1p70}) {
      Matrix other = a;
      for (double& value : other.values) value *= of_a;
      Vector right = b;
      for (double& value : right) value *= of_b;
      EXPECT_EQ(Gmres<double>().solve(other.product(), right, scaled, 1e-7, 100).products, result.products);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(scaled[i] * of_a / of_b, x[i]);
    }
}

/// It goes on to some times the rounding of a number.
TEST(Gmres, SinglePrecision) {
  const Matrix a = random_matrix(60, 17, 2);
  const Vector b = random_field(60, 18);
  const std::vector<float> right(b.begin(), b.end());
  std::vector<float> x(60);
  const Gmres<float>::Product product = [&](std::span<const float> in, std::span<float> out) {
    const Vector y = a * Vector(in.begin(), in.end());
    std::copy(y.begin(), y.end(), out.begin());
  };
  const auto result = Gmres<float>().solve(product, right, x, 1e-5, 60);
  EXPECT_LE(result.residual, 1e-5 * norm(b));
  EXPECT_NEAR(residual(a, Vector(x.begin(), x.end()), b), result.residual, 3e-6 * norm(b));
}

/// Where vectors of the basis are kept in single precision, the residual is still what it is said to be.
TEST(Gmres, ManyUnknowns) {
  const std::size_t n = many_unknowns + 3;
  const Gmres<double>::Product product = [](std::span<const double> in, std::span<double> out) {
    for (std::size_t i = 0; i < n; ++i)
      out[i] = (1 + static_cast<double>(i % 97) / 97) * in[i] + 0.3 * in[(i + 1) % n] - 0.2 * in[(i + 5) % n];
  };
  const Vector b = random_field(n, 31);
  Vector x(n), image(n);
  Gmres<double> gmres;
  for (const double tolerance : {1e-2, 1e-5}) {
    const auto result = gmres.solve(product, b, x, tolerance, 100);
    product(x, image);
    for (std::size_t i = 0; i < n; ++i) image[i] -= b[i];
    EXPECT_LE(result.residual, tolerance * norm(b));
    EXPECT_NEAR(norm(image), result.residual, 1e-6 * norm(b));
    EXPECT_LT(result.products, 60);
    EXPECT_EQ(result.weights.size(), static_cast<std::size_t>(result.products));
  }
}

} // namespace
} // namespace microslip
