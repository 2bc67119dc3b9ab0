// The preconditioner of steady rolling with a table of influence numbers.

#include "microslip/exact/halfspace/layered_influence.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/exact/halfspace/table_rolling_preconditioner.hpp"
#include "microslip/rolling/solver.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const Material steel = {82e9, 0.28};
const LayeredBody steel_body = {{}, {steel}};

/// On a bed of springs it is the inverse of slip in rolling, either way and with gaps in the rows.
TEST(TableRollingPreconditioner, OfSpringsIsTheInverse) {
  const ElementGrid grid{9, 7, 0, 0, 0.3, 0.2};
  const auto table = std::make_shared<InfluenceTable>(10, 7, grid.dx, grid.dy);
  table->at(0, 0).xx = table->at(0, 0).yy = table->at(0, 0).zz = 2.5;
  std::mt19937 random(3);
  std::uniform_real_distribution<> number(-1, 1);
  for (const double way : {1.0, -1.0}) {
    ElementResponse response;
    response.table = table;
    CoupledOperator slip = CoupledOperator::difference({}, grid, {way * grid.dx, 0}, {}, response);
    TableRollingPreconditioner inverse(*table, grid, grid.dx);
    const auto n = grid.count();
    std::vector<double> px(n), py(n), none(n), pressure(n), sx(n), sy(n), qx(n), qy(n);
    for (std::size_t k = 0; k < n; ++k)
      if (number(random) < 0.6) pressure[k] = 1, px[k] = number(random), py[k] = number(random);
    slip.apply({px, py, none}, std::array{std::span(sx), std::span(sy)});
    for (std::size_t k = 0; k < n; ++k)
      if (pressure[k] == 0) sx[k] = sy[k] = 0;
    inverse.expect_contact(pressure, way > 0 ? RollingDirection::forward : RollingDirection::backward);
    inverse.precondition(sx, sy, qx, qy);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(qx[k], px[k], 1e-12);
      EXPECT_NEAR(qy[k], py[k], 1e-12);
    }
  }
}

/// Layers from a hundredth of the contact to ten times it, soft, stiff, on a half-space and on a rigid core, take about
/// as many products as half-spaces of different materials do.
TEST(TableRollingPreconditioner, LayersTakeHardlyMoreProductsThanHalfSpaces) {
  const double a = 1e-3, radius = 0.1, creepage = 0.15 * a / radius;
  const Material rubber = {1e6, 0.4}, hard = {820e9, 0.25};
  const ViscoelasticMaterial rigid = {{std::numeric_limits<double>::infinity(), 0}};
  const auto products = [&](const LayeredBody& body) {
    RollingProblem p;
    p.layered = LayeredBodies{steel_body, body};
    p.geometry = GapFormula{ElementGrid::across_ellipse(1.15 * a, 1.15 * a, 40),
                            [=](double x, double y) { return (x * x + y * y) / (2 * radius); }};
    p.load = {NormalLoad::Given::approach, 0.6 * a * a / radius};
    p.friction.law = FrictionLaw::coulomb(0.3);
    p.motion.creepage = {creepage, -0.5 * creepage, 0.3 * creepage / a};
    const ContactSolution s = Solver({.theory = Theory::exact}).solve(p);
    EXPECT_EQ(s.report.status, Status::ok);
    return static_cast<double>(s.report.products);
  };
  const double of_half_spaces = products({{}, {rubber}});
  for (const double h : {0.01 * a, 0.1 * a, a, 10 * a}) {
    EXPECT_LE(products({{{h, {rubber}}}, rigid}), 1.2 * of_half_spaces) << h;
    EXPECT_LE(products({{{h, {rubber}}}, {steel}}), 1.2 * of_half_spaces) << h;
    EXPECT_LE(products({{{h, {hard}}}, {steel}}), 1.4 * of_half_spaces) << h;
  }
}

} // namespace
} // namespace microslip
