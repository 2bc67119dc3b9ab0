#include "microslip/exact/rolling_preconditioner.hpp"

#include "microslip/exact/fitted_response.hpp"
#include "microslip/exact/friction_newton.hpp"
#include "microslip/numerics/fftw.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

constexpr CombinedMaterial steel = {82e9, 0.28, 0};

double some_traction(std::size_t k) {
  return std::sin(1.3 * double(k)) + 0.2 * std::cos(0.1 * double(k * k % 97));
}

/// The periodic |ky| on a column by its definition, a sum over all waves; in units of 1/h.
Field column_filter(const Field& column, double h_over_dy) {
  const int n = fftw::good_even_size(static_cast<int>(column.size()));
  Field out(column.size());
  for (std::size_t to = 0; to < column.size(); ++to)
    for (std::size_t from = 0; from < column.size(); ++from)
      for (int wave = 0; wave < n; ++wave) {
        const double angle = 2 * M_PI * wave / n;
        const double size = std::min(angle, 2 * M_PI - angle) * h_over_dy;
        out[to] += size / n * std::cos(angle * (double(to) - double(from))) * column[from];
      }
  return out;
}

TEST(RollingPreconditioner, SumsWavesFromTheLeadingEdgeOn) {
  for (const auto& [mx, my] : {std::pair{9, 7}, {12, 20}, {1, 5}, {6, 1}}) {
    const FittedContact contact = fit_ellipse(6e-3, 4e-3, mx, my);
    const std::size_t n = contact.elements.size();
    const ElementGrid& grid = contact.grid;
    Field px(n), py(n), qx(n), qy(n), filtered(grid.count());
    for (std::size_t k = 0; k < n; ++k) px[k] = some_traction(k), py[k] = some_traction(k + 1000);
    RollingPreconditioner preconditioner(contact);
    preconditioner.apply(px, py, qx, qy);
    for (const auto& [p, q] : {std::pair{&px, &qx}, {&py, &qy}}) {
      for (int i = 0; i < grid.mx; ++i) {
        Field column(static_cast<std::size_t>(grid.my), 0.0);
        for (std::size_t k = 0; k < n; ++k)
          if (static_cast<int>(contact.elements[k].cell % grid.mx) == i) column[contact.elements[k].row] = (*p)[k];
        column = column_filter(column, grid.dx / grid.dy);
        for (int j = 0; j < grid.my; ++j) filtered[static_cast<std::size_t>(j) * grid.mx + i] = column[j];
      }
      for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (std::size_t other = k; other < n && contact.elements[other].row == contact.elements[k].row; ++other)
          sum += filtered[contact.elements[other].cell];
        EXPECT_NEAR((*q)[k], sum, 1e-12 * mx * (1 + grid.dx / grid.dy)) << mx << ' ' << my << ' ' << k;
      }
    }
  }
}

/// Partial slip with all three creepages.
TEST(RollingPreconditioner, LeavesTheSolutionAndSavesProducts) {
  long plain_products = 0, fast_products = 0;
  for (const double ratio : {0.2, 1.0, 5.0}) {
    const FittedContact contact = fit_ellipse(6e-3, 6e-3 / ratio, 48, 48);
    const std::size_t n = contact.elements.size();
    const double spin = 3e-4 / (6e-3 / std::min(ratio, 1.0));
    FittedResponse response(steel, contact);
    RollingPreconditioner preconditioner(contact);
    Field bound(n), cx(n), cy(n);
    for (std::size_t k = 0; k < n; ++k) {
      const FittedElement& e = contact.elements[k];
      bound[k] = 20e3 * contact.load_share[k];
      cx[k] = 4e-4 - spin * contact.grid.y(e.row);
      cy[k] = 2e-4 + spin * e.centre();
    }
    FrictionProblem problem{
        .response = response, .bound = bound, .cx = cx, .cy = cy, .element_area = contact.grid.element_area()};
    FrictionNewton newton;
    const FrictionSolution plain = newton.solve(problem, {.tolerance = 1e-9});
    problem.preconditioner = &preconditioner;
    const FrictionSolution fast = newton.solve(problem, {.tolerance = 1e-9});
    ASSERT_EQ(plain.status, Status::ok);
    ASSERT_EQ(fast.status, Status::ok);
    plain_products += plain.products;
    fast_products += fast.products;
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(fast.px[k], plain.px[k], 1e-5 * bound[n / 2]);
      EXPECT_NEAR(fast.py[k], plain.py[k], 1e-5 * bound[n / 2]);
    }
  }
  EXPECT_LT(double(fast_products), 0.7 * double(plain_products));
}

} // namespace
} // namespace microslip
