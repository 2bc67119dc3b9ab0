#include "microslip/exact/halfspace/rolling_preconditioner.hpp"

#include "microslip/exact/fitted/fitted_operator.hpp"
#include "microslip/exact/halfspace/rolling_operator.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/exact/newton/friction_newton.hpp"
#include "microslip/numerics/transforms.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

double some_traction(std::size_t k) {
  return std::sin(1.3 * double(k)) + 0.2 * std::cos(0.1 * double(k * k % 97));
}

using Complex = std::complex<double>;

/// The coefficients of size c (1 - 0.75 z/c)/(1 - 0.25 z/c) as a power series in z.
Field series(double size, double c, int count) {
  Field out;
  for (int n = 0; n < count; ++n) out.push_back(size * c * (n == 0 ? 1 : -0.5 / c * std::pow(0.25 / c, n - 1)));
  return out;
}

/// M^-1 by its definition on a grid of columns: sums over all waves along y, and over all elements behind and ahead.
class Definition {
public:
  Definition(const ElementGrid& grid, std::span<const double> p)
      : grid_(grid), n_(quick_size(grid.my)), waves_(static_cast<std::size_t>(grid.mx) * n_) {
    for (int i = 0; i < grid.mx; ++i)
      for (int wave = 0; wave < n_; ++wave)
        for (int j = 0; j < grid.my; ++j)
          waves_[i * n_ + wave] += p[j * grid.mx + i] / n_ * std::polar(1.0, -2 * std::numbers::pi * wave * j / n_);
    for (int wave = 0; wave < n_; ++wave) filter(wave);
  }

  /// Without the sum along the row.
  double at(int i, int j) const {
    Complex sum = 0;
    for (int wave = 0; wave < n_; ++wave)
      sum += waves_[i * n_ + wave] * std::polar(1.0, 2 * std::numbers::pi * wave * j / n_);
    return sum.real();
  }

private:
  void filter(int wave) {
    const double h_ky = grid_.dx * 2 * std::numbers::pi / (n_ * grid_.dy) * std::min(wave, n_ - wave),
                 c = 1 + 0.35 * h_ky;
    const Field behind = series(0.45, c, grid_.mx), ahead = series(1 / c, c, grid_.mx);
    std::vector<Complex> first(grid_.mx), second(grid_.mx);
    for (int to = 0; to < grid_.mx; ++to)
      for (int from = 0; from <= to; ++from) first[to] += behind[to - from] * waves_[from * n_ + wave];
    for (int to = 0; to < grid_.mx; ++to)
      for (int from = to; from < grid_.mx; ++from) second[to] += ahead[from - to] * first[from];
    for (int i = 0; i < grid_.mx; ++i) waves_[i * n_ + wave] = second[i];
  }

  const ElementGrid& grid_;
  int n_;
  std::vector<Complex> waves_;
};

TEST(RollingPreconditioner, FiltersWavesAndSumsFromTheLeadingEdgeOn) {
  for (const auto& [mx, my] : {std::pair{9, 7}, {12, 20}, {1, 5}, {6, 1}}) {
    const FittedContact contact = fit_ellipse(6e-3, 4e-3, mx, my);
    const std::size_t n = contact.elements.size();
    const ElementGrid& grid = contact.grid;
    Field px(n), py(n), qx(n), qy(n);
    for (std::size_t k = 0; k < n; ++k) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
    RollingPreconditioner<double> preconditioner = rolling_preconditioner<double>(contact);
    preconditioner.apply(px, py, qx, qy);
    for (const auto& [p, q] : {std::pair{&px, &qx}, {&py, &qy}}) {
      Field on_grid(grid.count());
      for (std::size_t k = 0; k < n; ++k) on_grid[contact.elements[k].cell] = (*p)[k];
      const Definition filtered(grid, on_grid);
      for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (std::size_t other = k; other < n && contact.elements[other].row == contact.elements[k].row; ++other) {
          const std::size_t cell = contact.elements[other].cell;
          sum += filtered.at(static_cast<int>(cell % grid.mx), static_cast<int>(cell / grid.mx));
        }
        EXPECT_NEAR((*p)[k] + (*q)[k], sum, 1e-12 * mx * (1 + grid.dx / grid.dy)) << mx << ' ' << my << ' ' << k;
      }
    }
  }
}

TEST(RollingPreconditioner, OfAGridIsThatOfItsElementsInContact) {
  const FittedContact contact = fit_ellipse(6e-3, 4e-3, 12, 20);
  const std::size_t n = contact.elements.size(), count = contact.grid.count();
  Field px(n), py(n), qx(n), qy(n), bound(count), grid_px(count, NAN), grid_py(count, NAN), grid_qx(count, -7.0),
      grid_qy(count);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t cell = contact.elements[k].cell;
    bound[cell] = 1;
    grid_px[cell] = px[k] = some_traction(k);
    grid_py[cell] = py[k] = some_traction(k + 1000);
  }
  rolling_preconditioner<double>(contact).apply(px, py, qx, qy);
  RollingPreconditioner<double>(contact.grid, bound, RollingDirection::forward)
      .apply(grid_px, grid_py, grid_qx, grid_qy);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_DOUBLE_EQ(grid_qx[contact.elements[k].cell], qx[k]);
    EXPECT_DOUBLE_EQ(grid_qy[contact.elements[k].cell], qy[k]);
  }
  for (std::size_t k = 0; k < count; ++k) EXPECT_TRUE(bound[k] > 0 || grid_qx[k] == -7) << k;
}

/// Two patches in the same rows.
TEST(RollingPreconditioner, TheOtherDirectionIsTheMirrorImage) {
  const ElementGrid grid{.mx = 14, .my = 6, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 2e-3};
  const std::size_t count = grid.count();
  const auto mirrored = [&](std::size_t k) { return k / 14 * 14 + 13 - k % 14; };
  Field bound(count), px(count), py(count), qx(count), qy(count), other_bound(bound), other_px(px), other_py(py),
      other_qx(qx), other_qy(qy);
  for (std::size_t k = 0; k < count; ++k) {
    other_bound[mirrored(k)] = bound[k] = k % 14 != 6 && k % 14 > k / 14;
    other_px[mirrored(k)] = px[k] = some_traction(k);
    other_py[mirrored(k)] = py[k] = some_traction(k + 1000);
  }
  RollingPreconditioner<double>(grid, bound, RollingDirection::forward).apply(px, py, qx, qy);
  RollingPreconditioner<double>(grid, other_bound, RollingDirection::backward)
      .apply(other_px, other_py, other_qx, other_qy);
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_NEAR(other_qx[mirrored(k)], qx[k], 1e-12);
    EXPECT_NEAR(other_qy[mirrored(k)], qy[k], 1e-12);
  }
}

/// 1/(1 - z^n) in place of 1/(1 - z): differences over the step are those over an element of the map for a step of one.
/// Two patches in the same rows.
TEST(RollingPreconditioner, ForLongerStepsSumsFromStepToStep) {
  const ElementGrid grid{.mx = 17, .my = 6, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 2e-3};
  const std::size_t count = grid.count();
  Field bound(count), px(count), py(count), of_one_x(count), of_one_y(count), qx(count), qy(count);
  for (std::size_t k = 0; k < count; ++k) {
    bound[k] = k % 17 != 8 && k % 17 > k / 17;
    if (bound[k] > 0) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
  }
  for (const RollingDirection direction : {RollingDirection::forward, RollingDirection::backward}) {
    const int side = direction == RollingDirection::forward ? 1 : -1;
    const auto ahead = [&](const Field& q, int row, int column, int step) {
      const int there = column + side * step, cell = row * grid.mx + there;
      return there >= 0 && there < grid.mx && bound[cell] > 0 ? q[cell] : 0.0;
    };
    RollingPreconditioner<double>(grid, bound, direction).precondition(px, py, of_one_x, of_one_y);
    for (const int columns : {2, 3}) {
      RollingPreconditioner<double>(grid, bound, direction, columns).precondition(px, py, qx, qy);
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i) {
          const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
          if (!(bound[k] > 0)) continue;
          EXPECT_NEAR(qx[k] - ahead(qx, j, i, columns), of_one_x[k] - ahead(of_one_x, j, i, 1), 1e-12);
          EXPECT_NEAR(qy[k] - ahead(qy, j, i, columns), of_one_y[k] - ahead(of_one_y, j, i, 1), 1e-12);
        }
    }
  }
}

TEST(RollingPreconditioner, SinglePrecisionIsNearDouble) {
  const FittedContact contact = fit_ellipse(6e-3, 4e-3, 30, 20);
  const std::size_t n = contact.elements.size();
  Field px(n), py(n), qx(n), qy(n);
  for (std::size_t k = 0; k < n; ++k) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
  rolling_preconditioner<double>(contact).apply(px, py, qx, qy);
  const std::vector<float> single_px(px.begin(), px.end()), single_py(py.begin(), py.end());
  std::vector<float> single_qx(n), single_qy(n);
  rolling_preconditioner<float>(contact).apply(single_px, single_py, single_qx, single_qy);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_NEAR(single_qx[k], qx[k], 1e-5);
    EXPECT_NEAR(single_qy[k], qy[k], 1e-5);
  }
}

/// M^-1 p is what `apply` gives and p.
TEST(RollingPreconditioner, PreconditionsByTheWholeMap) {
  const FittedContact contact = fit_ellipse(6e-3, 4e-3, 9, 7);
  const std::size_t n = contact.elements.size();
  Field px(n), py(n), qx(n), qy(n), whole_x(n), whole_y(n);
  for (std::size_t k = 0; k < n; ++k) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
  RollingPreconditioner<double> preconditioner = rolling_preconditioner<double>(contact);
  preconditioner.apply(px, py, qx, qy);
  preconditioner.precondition(px, py, whole_x, whole_y);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_EQ(whole_x[k], qx[k] + px[k]);
    EXPECT_EQ(whole_y[k], qy[k] + py[k]);
  }
}

/// The same map without its preconditioner.
class Unpreconditioned : public SlipOperator {
public:
  explicit Unpreconditioned(SlipOperator& whole) : whole_(whole) {}
  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    whole_.apply(px, py, sx, sy);
  }
  double diagonal() const override { return whole_.diagonal(); }
  long products() const override { return whole_.products(); }

private:
  SlipOperator& whole_;
};

/// Partial slip with all three creepages.
TEST(RollingPreconditioner, LeavesTheSolutionAndSavesProducts) {
  long plain_products = 0, fast_products = 0;
  for (const double ratio : {0.2, 1.0, 5.0}) {
    const FittedContact contact = fit_ellipse(6e-3, 6e-3 / ratio, 48, 48);
    const std::size_t n = contact.elements.size();
    const double spin = 3e-4 / (6e-3 / std::min(ratio, 1.0));
    FittedOperator fitted(steel, contact);
    Unpreconditioned plain_operator(fitted);
    Field bound(n), cx(n), cy(n);
    for (std::size_t k = 0; k < n; ++k) {
      const FittedElement& e = contact.elements[k];
      bound[k] = 20e3 * contact.load_share[k];
      cx[k] = 4e-4 - spin * contact.grid.y(e.row);
      cy[k] = 2e-4 + spin * e.centre();
    }
    const double area = contact.grid.element_area();
    FrictionNewton newton;
    const FrictionSolution plain = newton.solve({plain_operator, bound, cx, cy, area}, {.tolerance = 1e-9});
    const FrictionSolution fast = newton.solve({fitted, bound, cx, cy, area}, {.tolerance = 1e-9});
    ASSERT_EQ(plain.report.status, Status::ok);
    ASSERT_EQ(fast.report.status, Status::ok);
    plain_products += plain.report.products;
    fast_products += fast.report.products;
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(fast.traction.x[k], plain.traction.x[k], 1e-5 * bound[n / 2]);
      EXPECT_NEAR(fast.traction.y[k], plain.traction.y[k], 1e-5 * bound[n / 2]);
    }
  }
  EXPECT_LT(double(fast_products), 0.5 * double(plain_products));
}

/// On a regular grid: the operator's map and M^-1 of the elements in contact.
TEST(RollingOperator, IsTheMapWithItsPreconditioner) {
  const ElementGrid grid = ElementGrid::across_ellipse(6e-3, 4e-3, 12, 10, 1);
  const std::size_t count = grid.count();
  Field bound(count), px(count), py(count), sx(count), sy(count), qx(count), qy(count), rolling_x(count),
      rolling_y(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = grid.x(static_cast<int>(k % grid.mx)) / 6e-3, y = grid.y(static_cast<int>(k / grid.mx)) / 4e-3;
    bound[k] = std::max(0.0, 1 - x * x - y * y);
    if (bound[k] > 0) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
  }
  for (const RollingDirection direction : {RollingDirection::forward, RollingDirection::backward}) {
    const double step = direction == RollingDirection::forward ? grid.dx : -grid.dx;
    TangentialOperator plain = TangentialOperator::difference(steel, grid, step);
    RollingOperator rolling(plain, grid, bound, direction, 1);
    plain.apply(px, py, sx, sy);
    rolling.apply(px, py, rolling_x, rolling_y);
    EXPECT_EQ(rolling_x, sx);
    EXPECT_EQ(rolling_y, sy);
    EXPECT_EQ(rolling.diagonal(), plain.diagonal());
    EXPECT_EQ(rolling.products(), 2);
    EXPECT_FALSE(plain.precondition(px, py, qx, qy));
    ASSERT_TRUE(rolling.precondition(px, py, rolling_x, rolling_y));
    RollingPreconditioner<double>(grid, bound, direction).precondition(px, py, qx, qy);
    for (std::size_t k = 0; k < count; ++k)
      if (bound[k] > 0) {
        EXPECT_EQ(rolling_x[k], qx[k]);
        EXPECT_EQ(rolling_y[k], qy[k]);
      }
  }
}

} // namespace
} // namespace microslip
