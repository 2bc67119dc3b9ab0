#include "microslip/exact/fitted/fitted_contact.hpp"

#include "microslip/exact/fitted/edge_element.hpp"
#include "tests/support/expect_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using std::numbers::pi;

struct Ellipse {
  double a, b;
  int n, m;
};

constexpr Ellipse ellipses[] = {{5e-3, 5e-3, 1, 1},   {5e-3, 5e-3, 1, 2},   {5e-3, 5e-3, 2, 1},   {5e-3, 5e-3, 3, 4},
                                {4e-3, 20e-3, 8, 8},  {20e-3, 4e-3, 8, 8},  {6e-3, 12e-3, 13, 9}, {1, 1, 24, 24},
                                {9e-3, 9e-3, 12, 31}, {9e-3, 9e-3, 31, 12}, {1e-3, 1e-3, 2, 200}, {1e-3, 1e-3, 3, 101},
                                {1e-5, 5e-6, 96, 96}};

/// Half the length of a row's contact, at its middle.
double edge_of(const Ellipse& ellipse, const FittedContact& contact, int row) {
  const double y = contact.grid.y(row) / ellipse.b;
  return ellipse.a * std::sqrt((1 - y) * (1 + y));
}

/// Calls check(ellipse, contact, elements of a row) for all rows.
template <class Check> void for_rows(Check check) {
  for (const Ellipse& ellipse : ellipses) {
    SCOPED_TRACE(testing::Message() << ellipse.a << ' ' << ellipse.b << ' ' << ellipse.n << " x " << ellipse.m);
    const FittedContact contact = fit_ellipse(ellipse.a, ellipse.b, ellipse.n, ellipse.m);
    ASSERT_EQ(contact.grid.my, ellipse.m);
    ASSERT_EQ(contact.load_share.size(), contact.elements.size());
    auto from = contact.elements.begin();
    for (int row = 0; row < ellipse.m; ++row) {
      const auto to = std::find_if(from, contact.elements.end(), [row](const auto& e) { return e.row != row; });
      ASSERT_NE(from, to) << "no elements in row " << row;
      check(ellipse, contact, std::vector<FittedElement>(from, to));
      from = to;
    }
    EXPECT_EQ(from, contact.elements.end());
  }
}

TEST(FittedContact, SharesTimesAreasHaveTheSumOne) {
  for (const Ellipse& e : ellipses) {
    const FittedContact contact = fit_ellipse(e.a, e.b, e.n, e.m);
    double sum = 0;
    for (std::size_t k = 0; k < contact.elements.size(); ++k) {
      EXPECT_GT(contact.load_share[k], 0);
      sum += contact.load_share[k] * contact.elements[k].width() * contact.grid.dy;
    }
    EXPECT_NEAR(sum, 1, 1e-14) << e.n << " x " << e.m;
  }
}

/// Without gaps, from an element that contains the trailing edge, or begins at it, to the leading one.
TEST(FittedContact, ElementsTileTheirRows) {
  for_rows([](const Ellipse& ellipse, const FittedContact& contact, const std::vector<FittedElement>& row) {
    const double h = contact.grid.dx, edge = edge_of(ellipse, contact, row[0].row);
    for (std::size_t k = 0; k < row.size(); ++k) {
      EXPECT_EQ(row[k].trails, k == 0);
      EXPECT_EQ(row[k].leads, k + 1 == row.size());
      EXPECT_EQ(row[k].fitted, row[k].leads);
      if (k > 0) {
        EXPECT_NEAR(row[k].left, row[k - 1].right, 1e-12 * h);
        EXPECT_EQ(row[k].cell, row[k - 1].cell + 1);
      }
      EXPECT_LT(row[k].left, row[k].right);
    }
    EXPECT_LE(row[0].left, -edge + 1e-11 * h);
    EXPECT_GT(row[0].right, -edge);
  });
}

TEST(FittedContact, ElementsThatAreNotFittedAreTheGrids) {
  for_rows([](const Ellipse&, const FittedContact& contact, const std::vector<FittedElement>& row) {
    const ElementGrid& grid = contact.grid;
    for (const FittedElement& e : row) {
      ASSERT_LT(e.cell, grid.count());
      EXPECT_EQ(e.cell / grid.mx, static_cast<std::size_t>(e.row));
      if (e.fitted) continue;
      EXPECT_NEAR(e.centre(), grid.x(static_cast<int>(e.cell % grid.mx)), 1e-12 * grid.dx);
      EXPECT_NEAR(e.width(), grid.dx, 1e-12 * grid.dx);
    }
  });
}

/// The edge lies omega + beta element lengths ahead of the leading element's rear side; omega is from 0.6 to 1.57.
TEST(FittedContact, LeadingElementsAreFittedToTheEdge) {
  for_rows([](const Ellipse& ellipse, const FittedContact& contact, const std::vector<FittedElement>& row) {
    const FittedElement& e = row.back();
    const double h = contact.grid.dx, edge = edge_of(ellipse, contact, e.row), omega = e.width() / h;
    if (row.size() == 1 && std::abs(e.left + edge) < 1e-12 * h) return; // shorter than an element
    EXPECT_NEAR((edge - e.left) / h, edge_distance(omega), 1e-11);
    EXPECT_GT(omega, 0.6);
    EXPECT_LT(omega, 1.57);
    EXPECT_GT(e.centre(), -edge);
  });
}

TEST(FittedContact, RowsShorterThanAnElementHaveOneOfTheirLength) {
  int tips = 0;
  for_rows([&](const Ellipse& ellipse, const FittedContact& contact, const std::vector<FittedElement>& row) {
    const double h = contact.grid.dx, edge = edge_of(ellipse, contact, row[0].row);
    if (2 * edge < 0.6 * h) {
      ++tips;
      ASSERT_EQ(row.size(), 1U);
      EXPECT_NEAR(row[0].left, -edge, 1e-13 * ellipse.a);
      EXPECT_NEAR(row[0].right, edge, 1e-13 * ellipse.a);
      EXPECT_NEAR(row[0].end, edge + h / 2, 1e-13 * ellipse.a);
    }
    EXPECT_LT(2 * edge, (static_cast<double>(row.size()) + 1.5) * h);
  });
  EXPECT_GT(tips, 10);
}

/// Slip is that of the path to the next centre; of the leading element to h/2 beyond it.
TEST(FittedContact, WaysOfSlipEndAtTheNextCentre) {
  for_rows([](const Ellipse&, const FittedContact& contact, const std::vector<FittedElement>& row) {
    const double h = contact.grid.dx;
    for (std::size_t k = 0; k + 1 < row.size(); ++k) EXPECT_NEAR(row[k].end, row[k + 1].centre(), 1e-11 * h);
    EXPECT_NEAR(row.back().end, row.back().right + h / 2, 1e-12 * h);
  });
}

/// Upper and lower half are mirror images.
TEST(FittedContact, IsSymmetricInY) {
  for (const Ellipse& ellipse : ellipses) {
    const FittedContact contact = fit_ellipse(ellipse.a, ellipse.b, ellipse.n, ellipse.m);
    const auto& elements = contact.elements;
    std::vector<std::size_t> order(elements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return elements[i].row > elements[j].row; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const FittedElement &e = elements[k], &other = elements[order[k]];
      ASSERT_EQ(e.row, ellipse.m - 1 - other.row);
      EXPECT_NEAR(e.left, other.left, 1e-11 * contact.grid.dx);
      EXPECT_NEAR(e.right, other.right, 1e-11 * contact.grid.dx);
      EXPECT_NEAR(contact.load_share[k], contact.load_share[order[k]], 1e-9 * contact.load_share[k]);
    }
  }
}

/// The mean of the ellipsoid 3/(2 pi a b) sqrt(1 - (x/a)^2 - (y/b)^2) over an element, by the midpoint rule.
double mean_over(const FittedElement& e, const Ellipse& ellipse, const ElementGrid& grid, double left, double right) {
  constexpr int points = 400;
  double sum = 0;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      const double x = std::lerp(left, right, (i + 0.5) / points) / ellipse.a;
      const double y = (grid.y(e.row) + grid.dy * ((j + 0.5) / points - 0.5)) / ellipse.b;
      sum += std::sqrt(std::max(0.0, 1 - x * x - y * y));
    }
  return sum * (right - left) / (e.width() * points * points) * 3 / (2 * pi * ellipse.a * ellipse.b);
}

/// Of the area that an element stands for; the first and the last of a row for what lies beyond them, too. The rule of
/// eight points is off by up to 2e-3 where the edge of the ellipse crosses an element.
TEST(FittedContact, SharesAreMeansOfTheEllipsoid) {
  for (const Ellipse& ellipse : {Ellipse{3, 2, 5, 4}, {3, 2, 8, 3}, {1, 4, 2, 9}}) {
    const FittedContact contact = fit_ellipse(ellipse.a, ellipse.b, ellipse.n, ellipse.m);
    for (std::size_t k = 0; k < contact.elements.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double left = e.trails ? -ellipse.a : e.left, right = e.leads ? ellipse.a : e.right;
      const double mean = mean_over(e, ellipse, contact.grid, left, right);
      EXPECT_NEAR(contact.load_share[k], mean, 3e-3 * mean) << ellipse.n << " x " << ellipse.m << ", " << k;
    }
  }
}

TEST(FittedContact, DoesNotDependOnUnits) {
  const FittedContact metres = fit_ellipse(3e-3, 7e-3, 9, 8), millimetres = fit_ellipse(3, 7, 9, 8);
  ASSERT_EQ(metres.elements.size(), millimetres.elements.size());
  for (std::size_t k = 0; k < metres.elements.size(); ++k) {
    EXPECT_NEAR(metres.elements[k].left * 1e3, millimetres.elements[k].left, 1e-12);
    EXPECT_NEAR(metres.elements[k].right * 1e3, millimetres.elements[k].right, 1e-12);
    EXPECT_NEAR(metres.load_share[k], millimetres.load_share[k] * 1e6, 1e-6 * metres.load_share[k]);
  }
}

TEST(FittedContact, OfAnEllipseIsThatOfACircleStretched) {
  for (const Ellipse& e : ellipses) {
    const FittedContact direct = fit_ellipse(e.a, e.b, e.n, e.m);
    const FittedContact circle = stretched(fit_ellipse(1, 1, e.n, e.m), e.a, e.b);
    const double rounding = 1e-14 * e.a;
    EXPECT_NEAR(circle.grid.x0, direct.grid.x0, rounding);
    EXPECT_NEAR(circle.grid.dx, direct.grid.dx, rounding);
    EXPECT_NEAR(circle.grid.y0, direct.grid.y0, 1e-14 * e.b);
    EXPECT_NEAR(circle.grid.dy, direct.grid.dy, 1e-14 * e.b);
    ASSERT_EQ(circle.elements.size(), direct.elements.size());
    for (std::size_t k = 0; k < direct.elements.size(); ++k) {
      EXPECT_EQ(circle.elements[k].cell, direct.elements[k].cell);
      EXPECT_NEAR(circle.elements[k].left, direct.elements[k].left, rounding);
      EXPECT_NEAR(circle.elements[k].right, direct.elements[k].right, rounding);
      EXPECT_NEAR(circle.elements[k].end, direct.elements[k].end, rounding);
      EXPECT_NEAR(circle.load_share[k], direct.load_share[k], 1e-11 * direct.load_share[k]);
    }
  }
}

TEST(FittedContact, RefusesWhatIsNoEllipse) {
  expect_error([] { fit_ellipse(0, 1, 3, 3); }, "a", "[m]");
  expect_error([] { fit_ellipse(1, -1, 3, 3); }, "b", "[m]");
  expect_error([] { fit_ellipse(1, 1, 0, 3); }, "elements across", "[-]");
  expect_error([] { fit_ellipse(1, 1, 3, -2); }, "elements across", "[-]");
}

/// Two runs of a row that a load joins, or one that parts: the load is shared once, whichever it was.
TEST(FittedContact, RunsThatJoinOrPartShareTheLoadOnce) {
  const ElementGrid grid{.mx = 30, .my = 5, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3};
  const auto pressure = [&](double bridge) {
    std::vector<double> p(grid.count());
    for (int j = 1; j < 4; ++j)
      for (int i = 3; i < 25; ++i) {
        const double from_middle = i < 14 ? (i - 8) / 6.0 : (i - 19.5) / 6;
        p[static_cast<std::size_t>(j) * grid.mx + i] = i == 14 ? bridge : std::sqrt(1 - from_middle * from_middle);
      }
    return p;
  };
  const auto load = [](const FittedContact& contact) {
    double sum = 0;
    for (std::size_t k = 0; k < contact.elements.size(); ++k)
      sum += contact.load_share[k] * contact.elements[k].width() * contact.grid.dy;
    return sum;
  };
  const std::vector<double> apart = pressure(0), joined = pressure(0.02);
  EXPECT_NEAR(load(refitted(fit_contact(grid, apart), apart, joined)), 1, 1e-12);
  EXPECT_NEAR(load(refitted(fit_contact(grid, joined), joined, apart)), 1, 1e-12);
  // What changes little leaves the shares nearly as they are.
  const FittedContact before = fit_contact(grid, apart), after = refitted(before, apart, joined);
  for (std::size_t k = 0; k < before.elements.size(); ++k)
    EXPECT_NEAR(after.load_share[k] * after.elements[k].width(), before.load_share[k] * before.elements[k].width(),
                0.2 * *std::max_element(before.load_share.begin(), before.load_share.end()) * grid.dx)
        << k;
}

} // namespace
} // namespace microslip
