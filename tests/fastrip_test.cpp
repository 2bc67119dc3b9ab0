// FaStrip: strip theory in the rows of FASTSIM.

#include "microslip/simplified/fastrip.hpp"

#include "microslip/error.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

SimplifiedOptions options(int mx, int my, RollingDirection direction = RollingDirection::forward) {
  return {.mx = mx, .my = my, .bound = TractionBound::elliptic, .direction = direction};
}

EllipticContact rolling(double a, double b, const Creepage& creepage) {
  EllipticContact contact = steel_contact(a, b, 82e3, creepage);
  contact.rolling_speed = 30;
  return contact;
}

TEST(Fastrip, TendsToLinearTheoryAsCreepagesVanish) {
  Fastrip solver(options(400, 100));
  for (const double b : {2e-3, 4e-3, 8e-3, 20e-3}) {
    EllipticContact contact = rolling(8e-3, b, {});
    const CreepageCoefficients c = creepage_coefficients(contact.a / b, contact.poisson_ratio);
    const double area = contact.a * b, stiffness = contact.shear_modulus * area;
    const Creepage unit = saturating_creepage(contact);
    const double small = 1e-4;
    contact.creepage = {small * unit.longitudinal, 0, 0};
    EXPECT_NEAR(solver.solve(contact).fx / (-stiffness * c.c11 * contact.creepage.longitudinal), 1, 0.03);
    contact.creepage = {0, small * unit.lateral, 0};
    EXPECT_NEAR(solver.solve(contact).fy / (-stiffness * c.c22 * contact.creepage.lateral), 1, 0.03);
    contact.creepage = {0, 0, small * unit.spin};
    EXPECT_NEAR(solver.solve(contact).fy / (-stiffness * std::sqrt(area) * c.c23 * contact.creepage.spin), 1, 0.03);
  }
}

/// Without spin a row carries mu times its load but for the part with the pressure of a contact of half-length
/// a_y - d, as Carter's strip does: 1 - ((a_y - d)/a_y)^2 of mu pi a_y^2 p0/(2 a).
TEST(Fastrip, IsCartersSolutionInEachRowWithoutSpin) {
  Fastrip solver(options(800, 200));
  for (const double share : {0.2, 0.6, 1.0}) {
    EllipticContact contact = rolling(6e-3, 12e-3, {});
    contact.creepage.longitudinal = share * saturating_creepage(contact).longitudinal;
    const CreepageCoefficients c = creepage_coefficients(0.5, contact.poisson_ratio);
    const double peak = 1.5 * friction_force(contact) / ellipse_area(contact);
    const double d = contact.a * 4 * contact.shear_modulus * c.c11 * contact.creepage.longitudinal /
                     (2 * peak * std::pow(std::numbers::pi, 2));
    double force = 0;
    constexpr int rows = 100000;
    for (int j = 0; j < rows; ++j) {
      const double y = (2 * j + 1.0) / rows - 1, half = contact.a * std::sqrt(1 - y * y),
                   rest = std::max(half - d, 0.0);
      force += std::numbers::pi * peak / (2 * contact.a) * (half * half - rest * rest) * 2 * contact.b / rows;
    }
    EXPECT_NEAR(solver.solve(contact).fx / friction_force(contact), -force / friction_force(contact), 2e-3) << share;
  }
}

TEST(Fastrip, FullSlidingGivesTheFrictionForce) {
  for (const double angle : {0.0, 0.7, 2.0, 4.5}) {
    const EllipticContact contact = rolling(8e-3, 4e-3, {std::cos(angle), std::sin(angle), 0});
    SimplifiedOptions o = options(20, 20);
    o.flexibility = FlexibilityModel::one; // the direction of sliding is that of the creepage then
    const ContactForces f = Fastrip(o).solve(contact);
    EXPECT_NEAR(f.fx, -friction_force(contact) * std::cos(angle), 1e-9 * friction_force(contact));
    EXPECT_NEAR(f.fy, -friction_force(contact) * std::sin(angle), 1e-9 * friction_force(contact));
    EXPECT_EQ(f.adhesion_area, 0);
  }
}

TEST(Fastrip, TractionsStayWithinTheBoundAndTotalsAreTheirSums) {
  RandomContacts random(7);
  for (int n = 0; n < 200; ++n) {
    const EllipticContact contact = random.next();
    const ContactSolution f = Fastrip(options(17, 9)).fields(contact);
    ASSERT_EQ(f.report.status, Status::ok);
    double fx = 0, fy = 0, mz = 0;
    for (std::size_t k = 0; k < f.fields.traction.x.size(); ++k) {
      const double size = std::hypot(f.fields.traction.x[k], f.fields.traction.y[k]);
      EXPECT_LE(size, f.fields.bound[k] * (1 + 1e-12)) << describe(contact);
      const bool slides = f.fields.state[k] == CellState::slip;
      EXPECT_NEAR(slides ? size : f.fields.bound[k], f.fields.bound[k], 1e-12 * f.fields.bound[k]) << describe(contact);
      EXPECT_EQ(slides ? 0 : std::hypot(f.fields.slip.x[k], f.fields.slip.y[k]), 0);
      fx += f.elements.area[k] * f.fields.traction.x[k];
      fy += f.elements.area[k] * f.fields.traction.y[k];
      mz += f.elements.area[k] * (f.elements.x[k] * f.fields.traction.y[k] - f.elements.y[k] * f.fields.traction.x[k]);
    }
    expect_forces(f.totals, {fx, fy, mz}, 1e-12 * friction_force(contact), 1e-12 * friction_moment(contact));
    EXPECT_NEAR(f.totals.adhesion_area + f.totals.slip_area, ellipse_area(contact), 1e-12 * ellipse_area(contact));
    EXPECT_GE(f.totals.frictional_power, 0);
  }
}

/// x -> -x turns xi, phi, Fx, Mz; y -> -y turns eta, phi, Fy, Mz.
TEST(Fastrip, MirrorsInBothAxes) {
  RandomContacts random(11);
  for (int n = 0; n < 50; ++n) {
    EllipticContact contact = random.next();
    const ContactForces f = Fastrip(options(12, 10)).solve(contact);
    const double force = 1e-9 * friction_force(contact), moment = 1e-9 * friction_moment(contact);
    const Creepage c = contact.creepage;
    contact.creepage = {-c.longitudinal, c.lateral, -c.spin};
    const ContactForces back = Fastrip(options(12, 10, RollingDirection::backward)).solve(contact);
    expect_forces(back, {-f.fx, f.fy, -f.mz}, force, moment);
    EXPECT_NEAR(back.slip_area, f.slip_area, 1e-9 * ellipse_area(contact));
    contact.creepage = {c.longitudinal, -c.lateral, -c.spin};
    const ContactForces side = Fastrip(options(12, 10)).solve(contact);
    expect_forces(side, {f.fx, -f.fy, -f.mz}, force, moment);
  }
}

/// The cells of a row that all adhere in FASTSIM, with the memory behind it.
struct Row {
  double y, middle, half;
  std::vector<double> x, bound, px, py, sx, sy;
  std::vector<CellState> state;

  Row(double at_y, double at_x, double half_length, double peak) : y(at_y), middle(at_x), half(half_length) {
    constexpr int cells = 25;
    for (int i = 0; i < cells; ++i) {
      const double t = (2 * i + 1.0) / cells - 1;
      x.push_back(middle + half * t);
      bound.push_back(peak * std::sqrt(1 - t * t));
      px.push_back(-0.3 * bound.back());
      py.push_back(0.4 * bound.back());
    }
    sx = sy = std::vector<double>(cells, 1e-5);
    state.assign(cells, CellState::slip);
  }
  void solve(const StripTheory& theory) { theory.solve({y, middle, half, x, bound, px, py, sx, sy, state}); }
};

/// A row that lies beside the origin is what it is at the origin with the creepage that spin gives it there.
TEST(StripTheory, KnowsWhereTheMiddleOfARowIs) {
  const double shift = 3e-3, half = 5e-3;
  for (const RollingDirection direction : all_directions) {
    EllipticContact contact = rolling(8e-3, 4e-3, {2e-4, -4e-4, 0.3});
    const double peak = 1.5 * friction_force(contact) / ellipse_area(contact);
    Row beside(1e-3, shift, half, 0.7 * peak), at_origin(1e-3, 0, half, 0.7 * peak);
    beside.solve(StripTheory(contact, 0.3, direction));
    contact.creepage.lateral += contact.creepage.spin * shift;
    at_origin.solve(StripTheory(contact, 0.3, direction));
    const auto adhering = std::count(at_origin.state.begin(), at_origin.state.end(), CellState::adhesion);
    EXPECT_GT(adhering, 0);
    EXPECT_LT(adhering, 25);
    for (std::size_t k = 0; k < beside.x.size(); ++k) {
      EXPECT_EQ(beside.state[k], at_origin.state[k]);
      EXPECT_NEAR(beside.px[k], at_origin.px[k], 1e-9 * peak);
      EXPECT_NEAR(beside.py[k], at_origin.py[k], 1e-9 * peak);
    }
  }
}

TEST(StripTheory, AdheresAtTheLeadingEdge) {
  const EllipticContact contact = rolling(8e-3, 4e-3, {5e-4, 0, 0});
  Row row(0, 0, contact.a, 1.5 * friction_force(contact) / ellipse_area(contact));
  row.solve(StripTheory(contact, 0.3, RollingDirection::backward));
  EXPECT_EQ(row.state.front(), CellState::adhesion);
  EXPECT_EQ(row.state.back(), CellState::slip);
  EXPECT_EQ(row.sx.front(), 0);
  EXPECT_EQ(row.sx.back(), 1e-5);
}

TEST(Fastrip, WithoutCreepageOrFrictionThereAreNoTractions) {
  EllipticContact contact = rolling(8e-3, 4e-3, {});
  const ContactForces still = Fastrip(options(10, 10)).solve(contact);
  EXPECT_EQ(still.fx, 0);
  EXPECT_EQ(still.fy, 0);
  contact.friction = FrictionLaw::coulomb(0);
  contact.creepage = {1e-3, 0, 0.1};
  EXPECT_EQ(Fastrip(options(10, 10)).solve(contact).fx, 0);
}

TEST(Fastrip, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(Fastrip(SimplifiedOptions{}), Error);
  SimplifiedOptions reduced = options(10, 10);
  reduced.slope_reduction.initial = 0.5;
  EXPECT_THROW(Fastrip{reduced}, Error);
  EXPECT_THROW(Fastrip({.bound = TractionBound::elliptic, .precision = Precision::single}), Error);
  EllipticContact contact = rolling(8e-3, 4e-3, {1e-3, 0, 0});
  contact.friction = FrictionLaw::polach(0.3, 0.4, 0.6);
  EXPECT_EQ(Fastrip(options(10, 10)).solve(contact).status, Status::invalid_input);
  contact = rolling(-1, 4e-3, {1e-3, 0, 0});
  EXPECT_EQ(Fastrip(options(10, 10)).solve(contact).status, Status::invalid_input);
  EXPECT_TRUE(std::isnan(Fastrip(options(10, 10)).solve(contact).fx));
}

} // namespace
} // namespace microslip
