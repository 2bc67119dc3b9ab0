#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// Returns whether the symmetric part of the steady D on all elements of a grid has a Cholesky decomposition.
bool is_positive_definite(const CombinedMaterial& material, const ElementGrid& grid, double step) {
  const std::size_t n = grid.count();
  std::vector<Field> d(2 * n, Field(2 * n, 0.0));
  const auto add = [&](double shift, double factor) {
    for_pairs(material, grid, shift, [&](std::size_t to, std::size_t from, const Influence& a) {
      const double part[2][2] = {{a.xx, a.xy}, {a.xy, a.yy}};
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t c = 0; c < 2; ++c) {
          d[r * n + to][c * n + from] += factor * part[r][c];
          d[c * n + from][r * n + to] += factor * part[r][c];
        }
    });
  };
  add(0, 1);
  add(step, -1);
  for (std::size_t k = 0; k < 2 * n; ++k) {
    if (!(d[k][k] > 0)) return false;
    for (std::size_t i = k + 1; i < 2 * n; ++i) {
      const double factor = d[i][k] / d[k][k];
      for (std::size_t j = k + 1; j < 2 * n; ++j) d[i][j] -= factor * d[k][j];
    }
  }
  return true;
}

TangentialInput steady(double step) {
  TangentialInput input;
  input.step = step;
  return input;
}

TEST(HasOneSolution, WhereItSaysSoTheSymmetricPartIsPositiveDefinite) {
  for (const double nu : {0.0, 0.28, 0.5})
    for (const double ratio : {0.1, 1.0, 3.0, 30.0}) // dx/dy
      for (const double elements : {0.05, 0.3, 0.55, 1.0, 3.0}) {
        SCOPED_TRACE("nu " + std::to_string(nu) + ", dx/dy " + std::to_string(ratio) + ", dq/dx " +
                     std::to_string(elements));
        const ElementGrid grid{.mx = 7, .my = 9, .x0 = 0, .y0 = 0, .dx = ratio, .dy = 1, .line = false};
        const CombinedMaterial material{1, nu, 0};
        if (has_one_solution(grid, steady(elements * grid.dx))) {
          EXPECT_TRUE(is_positive_definite(material, grid, elements * grid.dx));
        }
      }
}

/// Also where constant elements have several: the transform of a tent is not negative.
TEST(HasOneSolution, BilinearElementsAlwaysHave) {
  for (const double nu : {0.0, 0.28, 0.5})
    for (const double ratio : {0.3, 1.0, 4.0}) // dx/dy
      for (const double elements : {0.05, 0.2, 0.55, 1.0, 3.0}) {
        SCOPED_TRACE("nu " + std::to_string(nu) + ", dx/dy " + std::to_string(ratio) + ", dq/dx " +
                     std::to_string(elements));
        const ElementGrid grid{
            .mx = 6, .my = 12, .x0 = 0, .y0 = 0, .dx = ratio, .dy = 1, .line = false, .shape = ElementShape::bilinear};
        EXPECT_TRUE(has_one_solution(grid, steady(elements * grid.dx)));
        EXPECT_TRUE(is_positive_definite({1, nu, 0}, grid, elements * grid.dx));
      }
}

TEST(HasOneSolution, WhereItDoesNotThePartCanBeIndefinite) {
  const ElementGrid grid{.mx = 6, .my = 24, .x0 = 0, .y0 = 0, .dx = 4, .dy = 1, .line = false};
  for (const double nu : {0.28, 0.5}) {
    const CombinedMaterial material{1, nu, 0};
    EXPECT_FALSE(has_one_solution(grid, steady(0.2 * grid.dx)));
    EXPECT_FALSE(is_positive_definite(material, grid, 0.2 * grid.dx));
  }
}

TEST(HasOneSolution, ShiftsAndStepsOfRollingAlwaysHave) {
  const ElementGrid grid{.mx = 6, .my = 24, .x0 = 0, .y0 = 0, .dx = 4, .dy = 1, .line = false};
  TangentialInput input = steady(0.2 * grid.dx);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient}) {
    input.motion = motion;
    EXPECT_TRUE(has_one_solution(grid, input));
  }
}

/// Where there may be several: an answer, with an honest status.
TEST(HasOneSolution, ElsewhereTheStatusIsHonest) {
  RandomContacts random(8);
  int converged = 0;
  const int n = 40;
  for (int k = 0; k < n; ++k) {
    const double nu = random.between(0.1, 0.5), ratio = random.about(0.5, 5);
    EllipticContact contact = steel_contact(ratio);
    contact.poisson_ratio = nu;
    const Problem p = elliptic(contact, 8, 12);
    TangentialInput input = steady(random.about(0.05, 0.5) * p.grid.dx);
    input.creepage = scaled_creepage(contact, random.signed_about(0.05, 2), random.signed_about(0.05, 2), 0);
    const ContactSolution s = solve(p, input);
    if (s.report.status == Status::ok) {
      ++converged;
      EXPECT_LE(s.report.residual, input.tolerance);
    } else {
      EXPECT_EQ(s.report.status, Status::not_converged);
      EXPECT_GT(s.report.residual, input.tolerance);
      EXPECT_FALSE(has_one_solution(p.grid, input));
    }
    EXPECT_TRUE(std::isfinite(s.report.residual + s.totals.fx + s.totals.fy + s.totals.mz + s.totals.frictional_power));
    for (std::size_t e = 0; e < p.bound.size(); ++e)
      EXPECT_LE(std::hypot(s.fields.traction.x[e], s.fields.traction.y[e]), p.bound[e] * (1 + 1e-15));
  }
  EXPECT_GE(converged, 9 * n / 10);
}

} // namespace
} // namespace microslip
