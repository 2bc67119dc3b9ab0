// The problems of the exact theory on bilinear elements.

#include "tangential_cases.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/solver.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace microslip {
namespace {

ElementGrid bilinear(ElementGrid grid) {
  grid.shape = ElementShape::bilinear;
  return grid;
}

TEST(ElementShape, TransformsSumTentsPairByPair) {
  for (const bool line : {false, true}) {
    ElementGrid grid = bilinear({.mx = 9, .my = line ? 1 : 6, .x0 = 0, .y0 = 0, .dx = 3e-4, .dy = 2e-4, .line = line});
    Field px(grid.count()), py(grid.count()), ux(grid.count()), uy(grid.count());
    for (std::size_t k = 0; k < px.size(); ++k) {
      const auto place = static_cast<double>(k);
      px[k] = std::sin(3 * place), py[k] = std::cos(1.7 * place);
    }
    TangentialOperator::displacement(steel, grid).apply(px, py, ux, uy);
    const PlaneFields u = dense_displacement(steel, grid, px, py);
    const double unit = grid.dx / steel.shear_modulus;
    for (std::size_t k = 0; k < px.size(); ++k) {
      EXPECT_NEAR(ux[k], u.x[k], 1e-12 * unit);
      EXPECT_NEAR(uy[k], u.y[k], 1e-12 * unit);
    }
  }
}

/// CONTACT's figures for a ball of steel, pressed by an approach and shifted: constant elements 821.0 N/mm2; bilinear
/// ones 821.8 N/mm2, FN = 1722 N, FX = -451.9 N. With that FN given and FX = -0.875 mu FN, constant ones: approach
/// 0.01132 mm, shift 3.042e-3 mm. The radius 88.4 mm, the approach 0.01131 mm and the shift 3.04e-3 mm are those that
/// go with all six.
TEST(ElementShape, FiguresOfContact) {
  const double radius = 88.4e-3, friction = 0.3;
  const GapCurvatures gap = {0.5 / radius, 0.5 / radius};
  const auto press = [&](const ElementGrid& grid, const NormalLoad& load) {
    const NormalSolution s = NormalProblem(steel, grid).solve(hertzian_gap(gap, grid), load);
    EXPECT_EQ(s.contact_elements, 177);
    return s;
  };
  const auto shift = [&](const ElementGrid& grid, Field bound, double way, std::optional<double> force) {
    for (double& g : bound) g *= friction;
    TangentialInput input;
    input.motion = ContactMotion::shift;
    input.creepage.longitudinal = way;
    input.force_x = force;
    return TangentialProblem(steel, grid).solve(bound, input);
  };
  const ElementGrid constant{.mx = 19, .my = 19, .x0 = -1.2e-3, .y0 = -1.2e-3, .dx = 0.4e-3 / 3, .dy = 0.4e-3 / 3};
  const NormalLoad approach = {NormalLoad::Given::approach, 0.01131e-3};
  EXPECT_NEAR(press(constant, approach).peak_pressure * 1e-6, 821.0, 0.05);
  const NormalSolution tents = press(bilinear(constant), approach);
  EXPECT_NEAR(tents.peak_pressure * 1e-6, 821.8, 0.05);
  EXPECT_NEAR(tents.normal_force, 1722, 0.5);
  EXPECT_NEAR(shift(bilinear(constant), tents.pressure, 3.04e-6, {}).totals.fx, -451.9, 0.05);
  const NormalSolution loaded = press(constant, {NormalLoad::Given::force, 1722});
  EXPECT_NEAR(loaded.approach * 1e3, 0.01132, 5e-6);
  EXPECT_NEAR(shift(constant, loaded.pressure, 0, -0.875 * friction * 1722).creepage.longitudinal * 1e3, 3.042e-3,
              5e-7);
}

/// CONTACT's figure for a single bilinear element of 1 mm under 1 N/mm2, G = 200 and 1 N/mm2: 0.342408 mm.
TEST(ElementShape, ASingleElementOfDissimilarBodies) {
  const CombinedMaterial pair = combine({200e6, 0.28}, {1e6, 0.28});
  const ElementGrid grid = bilinear({.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3});
  const std::vector<double> gap = {0};
  const NormalSolution s = NormalProblem(pair, grid).solve(gap, {NormalLoad::Given::force, 1});
  EXPECT_NEAR(s.approach, 0.342408e-3, 0.5e-9);
}

/// Hertz's force at a given approach: order 2, though with a larger constant than that of constant elements.
TEST(ElementShape, HertzIsMetToSecondOrder) {
  const HertzContact hertz = hertz_from_ellipse(5e-3, 8e-3, steel, 1e5);
  const auto error_on = [&](int across) {
    const ElementGrid grid = bilinear(ElementGrid::across_ellipse(hertz.a, hertz.b, across, 2));
    const NormalSolution s =
        NormalProblem(steel, grid).solve(hertzian_gap(hertz.gap, grid), {NormalLoad::Given::approach, hertz.approach});
    EXPECT_EQ(s.status, Status::ok);
    EXPECT_LE(s.products, 41);
    return std::abs(s.normal_force / hertz.normal_force - 1);
  };
  const double coarse = error_on(12), fine = error_on(96);
  EXPECT_LT(coarse, 0.02);
  EXPECT_NEAR(std::log2(coarse / fine) / 3, 2, 0.35);
}

/// Line contact, steady rolling: Carter's force, at the same order as with constant elements.
TEST(ElementShape, CarterIsMet) {
  const double a = 1e-3, radius = 0.5, friction = 0.3, adhesion = 0.6;
  const double creepage = -friction * a / radius * (1 - adhesion);
  const double wanted = 1 - adhesion * adhesion; // of mu Fn
  const LineContact hertz = line_contact_from_load(0.5 / radius, steel, 1e5);
  const double scale = hertz.half_width / a;
  double before = 0;
  for (const int across : {32, 128}) {
    const ElementGrid grid = bilinear(ElementGrid::across_line(hertz.half_width, across, 2));
    const NormalSolution normal =
        NormalProblem(steel, grid).solve(hertzian_gap({0.5 / radius, 0}, grid), {NormalLoad::Given::force, 1e5});
    Field bound = normal.pressure;
    for (double& g : bound) g *= friction;
    TangentialInput input;
    input.creepage.longitudinal = creepage * scale;
    const ContactSolution s = TangentialProblem(steel, grid).solve(bound, input);
    EXPECT_EQ(s.report.status, Status::ok);
    const double error = std::abs(s.totals.fx / (friction * 1e5) - wanted);
    EXPECT_LT(error, 0.7 / across);
    if (before > 0) {
      EXPECT_GT(before / error, 2.5);
    }
    before = error;
  }
}

/// All motions: tractions within the bound, opposite to the slip where they are on it, slip as summed pair by pair.
TEST(ElementShape, FrictionsLawHolds) {
  const EllipticContact contact = steel_contact(2);
  Problem p = elliptic(contact, 12, 10, 2);
  p.grid = bilinear(p.grid);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady})
    for (const double step : {0.3, 1.0, 2.5}) {
      TangentialInput input;
      input.motion = motion;
      input.creepage = scaled_creepage(contact, 0.5, -0.3, 0.4);
      if (motion == ContactMotion::shift) input.creepage = {1e-6, -5e-7, 1e-4};
      input.step = step * p.grid.dx;
      const ContactSolution s = solve(p, input);
      EXPECT_EQ(s.report.status, Status::ok);
      expect_solution(p, input, s);
    }
}

TEST(ElementShape, TheLeadingEdgesCorrection) {
  const EllipticContact contact = steel_contact(1);
  TangentialInput input;
  input.creepage = scaled_creepage(contact, 0.6, 0, 0);
  input.leading_edge = LeadingEdge{};
  Problem p = elliptic(contact, 24, 24, 3);
  const double constant = solve(p, input).totals.fx / p.capacity;
  p.grid = bilinear(p.grid);
  const ContactSolution s = solve(p, input);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_NEAR(s.totals.fx / p.capacity, constant, 0.01);
}

/// Dissimilar bodies: both solvers give the same, near that of constant elements.
TEST(ElementShape, DissimilarBodies) {
  ContactStep step;
  step.bodies = combine({1e6, 0.3}, {80e9, 0.28});
  step.grid = ElementGrid::across_ellipse(1e-3, 1e-3, 14, 2);
  step.gap = hertzian_gap(hertz_from_ellipse(1e-3, 1e-3, step.bodies.material, 1).gap, step.grid);
  step.load = {NormalLoad::Given::force, 1};
  step.friction = {FrictionLaw::coulomb(0.3)};
  step.motion.creepage = {2e-3, 1e-3, 0};
  step.motion.tolerance = 1e-9;
  const ContactStepSolution constant = ContactSequence().solve(step);
  step.grid = bilinear(step.grid);
  const ContactStepSolution newton = ContactSequence().solve(step);
  step.coupling = Coupling::alternating;
  const ContactStepSolution alternating = ContactSequence().solve(step);
  EXPECT_EQ(newton.report.status, Status::ok);
  EXPECT_EQ(alternating.report.status, Status::ok);
  const double mu_fn = 0.3, fx = newton.totals.fx;
  EXPECT_NEAR(alternating.totals.fx, fx, 1e-6 * mu_fn);
  EXPECT_NEAR(alternating.normal.approach, newton.normal.approach, 1e-6 * newton.normal.approach);
  EXPECT_NEAR(constant.totals.fx, fx, 0.02 * mu_fn);
  EXPECT_NEAR(constant.normal.approach, newton.normal.approach, 0.01 * newton.normal.approach);
}

/// A sequence makes its problems anew when the shape changes.
TEST(ElementShape, ASequenceMayChangeIt) {
  ContactStep step;
  step.bodies = steel;
  step.grid = ElementGrid::across_ellipse(1e-3, 1e-3, 10, 2);
  step.gap = hertzian_gap(hertz_from_ellipse(1e-3, 1e-3, steel, 100).gap, step.grid);
  step.load = {NormalLoad::Given::force, 100};
  step.friction = {FrictionLaw::coulomb(0.3)};
  step.motion.creepage = {1e-3, 0, 0};
  ContactSequence sequence;
  const double constant = sequence.solve(step).totals.fx;
  step.grid = bilinear(step.grid);
  const double tents = sequence.solve(step).totals.fx;
  EXPECT_NE(constant, tents);
  EXPECT_EQ(ContactSequence().solve(step).totals.fx, tents);
}

/// Retarded deformation, for rolling along +x: l du/dx = u - f u_elastic.
TEST(ElementShape, DelayedDeformationOfTents) {
  const ElementGrid grid = bilinear({.mx = 5, .my = 3, .x0 = 0, .y0 = 0, .dx = 1, .dy = 1.3});
  const CombinedMaterial material{1, 0.3, 0.2};
  const double ratio = 1.7, distance = 0.8, h = 1e-3;
  Bodies late(material);
  late.retarded = {{material, {ratio, distance}}};
  const auto delayed_at = [&](double shift) {
    const CoupledKernel all = CoupledKernel::displacement(late, grid, {shift, 0});
    const CoupledKernel elastic = CoupledKernel::displacement(material, grid, {shift, 0});
    const auto of = [](const CoupledKernel& k, int i, int j) {
      return std::vector<double>{k.slip.xx.at(i, j), k.slip.xy.at(i, j), k.slip.yy.at(i, j), k.xz.at(i, j),
                                 k.zz.at(i, j)};
    };
    std::vector<double> values;
    for (const int i : {-2, 0, 1})
      for (const int j : {0, 1}) {
        const std::vector<double> a = of(all, i, j), e = of(elastic, i, j);
        for (std::size_t k = 0; k < a.size(); ++k) values.push_back(a[k] - e[k]), values.push_back(e[k]);
      }
    return values;
  };
  for (const double shift : {0.0, 0.3, 0.7}) {
    const std::vector<double> here = delayed_at(shift), ahead = delayed_at(shift + h), behind = delayed_at(shift - h);
    for (std::size_t k = 0; k < here.size(); k += 2)
      EXPECT_NEAR(distance * (ahead[k] - behind[k]) / (2 * h), here[k] - ratio * here[k + 1], 3e-5)
          << k << ", " << shift;
  }
}

TEST(ElementShape, HertzianContactsTakeIt) {
  EllipticContact contact = steel_contact(1);
  contact.creepage = scaled_creepage(contact, 0.5, 0.2, 0.1);
  Method options{.mx = 24, .my = 24, .discretisation = Discretisation::classical};
  const ContactForces constant = Solver(options).solve(rolling_problem(contact)).forces();
  options.elements = ElementShape::bilinear;
  const ContactForces tents = Solver(options).solve(rolling_problem(contact)).forces();
  const double mu_fn = 0.3 * contact.normal_force;
  EXPECT_EQ(tents.status, Status::ok);
  EXPECT_NE(tents.fx, constant.fx);
  EXPECT_NEAR(tents.fx, constant.fx, 0.01 * mu_fn);
  EXPECT_NEAR(tents.fy, constant.fy, 0.01 * mu_fn);
  options.discretisation = Discretisation::second_order;
  EXPECT_THROW(Solver(options).solve(rolling_problem(contact)), Error);
}

TEST(ElementShape, FittedElementsAreConstant) {
  const ElementGrid grid = bilinear(ElementGrid::across_ellipse(1e-3, 1e-3, 8, 4));
  Field pressure(grid.count());
  pressure[8 * 16 + 8] = 1;
  EXPECT_THROW(fit_contact(grid, pressure), Error);
  ElementGrid constant = grid;
  constant.shape = ElementShape::constant;
  EXPECT_NO_THROW(fit_contact(constant, pressure));
}

} // namespace
} // namespace microslip
