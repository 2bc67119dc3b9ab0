#include "microslip/exact/fitted/fitted_operator.hpp"

#include "microslip/elasticity/influence.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// What every element does to the points and the ends of all, from the closed forms; in the order x, y.
struct DenseResponse {
  DenseResponse(const CombinedMaterial& material, const FittedContact& contact) : elements(contact.elements) {
    const std::size_t n = elements.size();
    for (auto* field : {&at_point, &at_end}) field->resize(4 * n * n);
    for (std::size_t to = 0; to < n; ++to)
      for (std::size_t from = 0; from < n; ++from) {
        const FittedElement &e = elements[to], &source = elements[from];
        const double y = contact.grid.y(e.row) - contact.grid.y(source.row);
        const auto fill = [&](Field& field, double x) {
          const Influence a = influence(material, source.width(), contact.grid.dy, x - source.centre(), y);
          const double block[2][2] = {{a.xx, a.xy}, {a.xy, a.yy}};
          for (std::size_t c = 0; c < 2; ++c)
            for (std::size_t d = 0; d < 2; ++d) field[((c * n + to) * 2 + d) * n + from] = block[c][d];
        };
        fill(at_point, e.point);
        fill(at_end, e.end);
      }
  }

  /// Component c at element `to` from the traction d at element `from`.
  double displacement(std::size_t c, std::size_t to, std::size_t d, std::size_t from) const {
    return at_point[((c * elements.size() + to) * 2 + d) * elements.size() + from];
  }
  double slip(std::size_t c, std::size_t to, std::size_t d, std::size_t from) const {
    const std::size_t k = ((c * elements.size() + to) * 2 + d) * elements.size() + from;
    return (at_point[k] - at_end[k]) / (elements[to].end - elements[to].point);
  }

  const std::vector<FittedElement>& elements;
  Field at_point, at_end;
};

using Pair = std::array<Field, 2>;

/// Largest errors of displacement at the centres and of slip, over those that an element of the grid makes to itself.
struct Errors {
  double displacement = 0, slip = 0;
};

/// Of each element's influence on each.
Errors errors(const CombinedMaterial& material, const FittedContact& contact) {
  const DenseResponse dense(material, contact);
  FittedOperator response(material, contact);
  const std::size_t n = contact.elements.size();
  const ElementGrid& grid = contact.grid;
  const Influence own = influence(material, grid.dx, grid.dy, 0, 0);
  Pair p{Field(n, 0.0), Field(n, 0.0)}, s = p;
  Errors worst;
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t from = 0; from < n; ++from) {
      p[d][from] = 1;
      response.apply(p[0], p[1], s[0], s[1]);
      p[d][from] = 0;
      const std::array u = {response.ux(), response.uy()};
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t to = 0; to < n; ++to) {
          const double in_u = u[c][to] - dense.displacement(c, to, d, from);
          const double in_s = s[c][to] - dense.slip(c, to, d, from);
          worst.displacement = std::max(worst.displacement, std::abs(in_u) / own.xx);
          worst.slip = std::max(worst.slip, std::abs(in_s) / response.diagonal());
        }
    }
  return worst;
}

/// Of the slip by tractions like those of a contact, as a 2-norm over the elements relative to the slip.
double error_of_smooth_tractions(const FittedContact& contact) {
  const DenseResponse dense(steel, contact);
  FittedOperator response(steel, contact);
  const std::size_t n = contact.elements.size();
  Pair p{contact.load_share, contact.load_share}, s{Field(n), Field(n)};
  for (double& py : p[1]) py *= 0.5;
  response.apply(p[0], p[1], s[0], s[1]);
  double error = 0, size = 0;
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t to = 0; to < n; ++to) {
      double exact = 0;
      for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t from = 0; from < n; ++from) exact += dense.slip(c, to, d, from) * p[d][from];
      error += std::pow(s[c][to] - exact, 2);
      size += exact * exact;
    }
  return std::sqrt(error / size);
}

/// n x m elements whose sides dx/dy have that ratio.
FittedContact contact_of(int n, int m, double ratio) {
  return fit_ellipse(2e-3 * ratio * n / m, 2e-3, n, m);
}

struct Shape {
  int n, m;
};
constexpr std::array ratios = {0.05, 0.2, 1.0, 5.0, 20.0};

/// All elements are near each other, in rows no longer than the polynomials' nodes.
TEST(FittedOperator, IsTheDenseProductOnTinyGrids) {
  for (const auto& [n, m] : {Shape{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 2}})
    for (const double ratio : ratios)
      for (const double poisson_ratio : {0.0, 0.28, 0.5}) {
        const Errors e = errors({82e9, poisson_ratio, 0}, contact_of(n, m, ratio));
        EXPECT_LT(e.displacement, 1e-13) << n << " x " << m << ", dx/dy = " << ratio;
        EXPECT_LT(e.slip, 1e-13) << n << " x " << m << ", dx/dy = " << ratio;
      }
}

/// About 1e-4 in displacements, at worst 1.11e-4 (21 x 9 elements, dx/dy = 0.2). Slip is a difference of two of them:
/// where elements are short against their width its value is less, and the error relative to it more.
TEST(FittedOperator, IsTheDenseProductToItsAccuracy) {
  for (const auto& [n, m] : {Shape{1, 7}, {7, 1}, {3, 3}, {4, 5}, {8, 8}, {13, 12}, {21, 9}, {9, 20}})
    for (const double ratio : ratios) {
      const Errors e = errors(steel, contact_of(n, m, ratio));
      EXPECT_LT(e.displacement, 1.2e-4) << n << " x " << m << ", dx/dy = " << ratio;
      EXPECT_LT(e.slip, ratio < 1 ? 3e-4 : 1e-4) << n << " x " << m << ", dx/dy = " << ratio;
    }
}

/// What is left is of changing sign, and nearly cancels in a sum.
TEST(FittedOperator, SlipOfSmoothTractions) {
  for (const int n : {8, 12, 16, 24})
    for (const double ratio : ratios)
      EXPECT_LT(error_of_smooth_tractions(contact_of(n, n, ratio)), 4e-5) << n << ", dx/dy = " << ratio;
}

/// Of steps, whose displacements are taken at the centres of the grid's elements.
TEST(FittedOperator, ElementsOfSteps) {
  for (const int n : {7, 12})
    for (const double ratio : {0.3, 1.0, 3.0}) {
      const Errors e = errors(steel, fit_ellipse(ratio, 1, n, n, ContactMotion::transient));
      EXPECT_LT(e.displacement, 1.5e-4) << n << ", a/b = " << ratio;
      EXPECT_LT(e.slip, 2e-4) << n << ", a/b = " << ratio;
    }
}

/// Rows may have several runs of elements, each with an edge.
TEST(FittedOperator, TwoPatchesInTheSameRows) {
  const FittedContact one = contact_of(7, 6, 1);
  constexpr int apart = 9;
  FittedContact two;
  two.grid = one.grid;
  two.grid.mx += apart;
  std::size_t k = 0;
  for (int row = 0; row < one.grid.my; ++row) {
    const std::size_t first = k;
    for (const bool second : {false, true})
      for (k = first; k < one.elements.size() && one.elements[k].row == row; ++k) {
        FittedElement e = one.elements[k];
        const double moved = second ? apart * one.grid.dx : 0;
        const int shift = second ? apart : 0, column = static_cast<int>(e.cell) % one.grid.mx;
        e.cell = static_cast<std::uint32_t>(row * two.grid.mx + column + shift);
        e.left += moved, e.right += moved, e.point += moved, e.end += moved;
        two.elements.push_back(e);
        two.load_share.push_back(one.load_share[k]);
      }
  }
  ASSERT_EQ(two.elements.size(), 2 * one.elements.size());
  const Errors e = errors(steel, two);
  EXPECT_LT(e.displacement, 1.2e-4);
  EXPECT_LT(e.slip, 1e-4);
}

TEST(FittedOperator, DiagonalIsThatOfARegularElement) {
  const FittedContact contact = contact_of(12, 12, 0.7);
  const FittedOperator response(steel, contact);
  const DenseResponse dense(steel, contact);
  std::size_t checked = 0;
  for (std::size_t k = 0; k < contact.elements.size(); ++k)
    if (!contact.elements[k].leads && !contact.elements[k + 1].leads) {
      EXPECT_NEAR(response.diagonal(), (dense.slip(0, k, 0, k) + dense.slip(1, k, 1, k)) / 2,
                  1e-12 * response.diagonal());
      ++checked;
    }
  EXPECT_GT(checked, 50U);
}

/// What was done before leaves no trace, and products are counted.
TEST(FittedOperator, CanBeUsedAgain) {
  const FittedContact contact = contact_of(8, 8, 1);
  const std::size_t n = contact.elements.size();
  FittedOperator response(steel, contact);
  Pair first{Field(n), Field(n)}, again = first;
  response.apply(contact.load_share, contact.load_share, first[0], first[1]);
  response.apply(Field(n, 1.0), Field(n, -2.0), again[0], again[1]);
  response.apply(contact.load_share, contact.load_share, again[0], again[1]);
  EXPECT_EQ(again, first);
  EXPECT_EQ(response.products(), 3);
}

/// The products of two operators with the same tractions.
Pair product(FittedOperator& response, const FittedContact& contact) {
  const std::size_t n = contact.elements.size();
  Pair p{Field(n), Field(n)}, s = p;
  for (std::size_t k = 0; k < n; ++k) p[0][k] = std::sin(double(k) + 1), p[1][k] = std::cos(1.7 * double(k));
  response.apply(p[0], p[1], s[0], s[1]);
  return s;
}

/// Whatever it was before, larger or smaller.
TEST(FittedOperator, RenewedIsTheSameAsFreshToTheLastBit) {
  const std::array contacts = {contact_of(12, 12, 1), contact_of(12, 12, 0.3), contact_of(20, 7, 0.8),
                               contact_of(5, 9, 2),   fit_line(2e-3, 15),      contact_of(12, 12, 1)};
  const TransformPlans plans;
  FittedOperator response(steel, contacts[2], {}, plans);
  for (const FittedContact& contact : contacts) {
    response.renew(steel, contact, {}, plans);
    FittedOperator fresh(steel, contact);
    EXPECT_EQ(product(response, contact), product(fresh, contact));
    EXPECT_EQ(response.ux(), fresh.ux());
    EXPECT_EQ(response.diagonal(), fresh.diagonal());
    EXPECT_EQ(response.products(), 1);
  }
}

/// Lengths and stiffness scale out; by powers of 2, to the last bit.
TEST(FittedOperator, RescaledIsTheSameAsFresh) {
  const FittedContact contact = contact_of(13, 10, 0.6), larger = stretched(contact, 4, 4);
  const CombinedMaterial softer = {steel.shear_modulus / 8, steel.poisson_ratio, 0};
  FittedOperator response(steel, contact), fresh(softer, larger);
  const Pair before = product(response, contact);
  response.rescale(larger.grid.dx, softer.shear_modulus);
  const Pair after = product(response, larger);
  EXPECT_EQ(after, product(fresh, larger));
  EXPECT_EQ(response.uy(), fresh.uy());
  EXPECT_EQ(response.diagonal(), fresh.diagonal());
  for (std::size_t k = 0; k < before[0].size(); ++k) EXPECT_EQ(after[0][k], 8 * before[0][k]);
}

/// Rows and columns that nothing uses change nothing.
TEST(FittedOperator, SpareElementsDoNotMatter) {
  const FittedContact contact = contact_of(9, 8, 1.2);
  FittedContact wide = contact;
  constexpr int columns = 7, rows = 5;
  wide.grid.mx += columns, wide.grid.my += rows + 3;
  wide.grid.x0 -= columns * wide.grid.dx, wide.grid.y0 -= rows * wide.grid.dy;
  for (FittedElement& e : wide.elements) {
    e.cell = (e.cell / contact.grid.mx + rows) * wide.grid.mx + e.cell % contact.grid.mx + columns;
    e.row += rows;
  }
  FittedOperator response(steel, contact), on_wide(steel, wide);
  const Pair s = product(response, contact), on_wide_s = product(on_wide, wide);
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k < s[c].size(); ++k) EXPECT_NEAR(on_wide_s[c][k], s[c][k], 1e-12 * response.diagonal());
}

/// Slip in units of the size of its terms.
TEST(FittedProduct, SinglePrecisionIsNearDouble) {
  for (const auto& [n, m] : {Shape{1, 1}, {2, 5}, {24, 24}, {60, 31}})
    for (const double factor : {1.0, 3e12}) {
      const FittedContact contact = contact_of(n, m, 1.3);
      const std::size_t count = contact.elements.size();
      FittedOperator response(steel, contact);
      FittedProduct<float> single(response.product(), factor);
      Pair p{contact.load_share, contact.load_share}, s{Field(count), Field(count)};
      for (std::size_t k = 0; k < count; ++k) p[1][k] *= std::sin(double(k));
      response.apply(p[0], p[1], s[0], s[1]);
      const std::vector<float> px(p[0].begin(), p[0].end()), py(p[1].begin(), p[1].end());
      std::vector<float> sx(count), sy(count);
      single.apply(px, py, sx, sy);
      const double size = response.diagonal() * *std::max_element(p[0].begin(), p[0].end());
      for (std::size_t k = 0; k < count; ++k) {
        EXPECT_NEAR(sx[k] / factor, s[0][k], 2e-5 * size) << n << ' ' << m << ' ' << k;
        EXPECT_NEAR(sy[k] / factor, s[1][k], 2e-5 * size) << n << ' ' << m << ' ' << k;
      }
      EXPECT_EQ(single.products(), 1);
    }
}

} // namespace
} // namespace microslip
