#include "microslip/exact/classical/tangential_problem.hpp"

#include "tangential_cases.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

TEST(TangentialProblem, NoCreepageNoTraction) {
  const Problem p = elliptic(steel_contact(1), 9, 9);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    TangentialInput input;
    input.motion = motion;
    const ContactSolution s = solve(p, input);
    expect_solution(p, input, s);
    EXPECT_EQ(s.fields.traction.x, Field(p.bound.size(), 0.0));
    EXPECT_EQ(s.fields.traction.y, Field(p.bound.size(), 0.0));
    EXPECT_EQ(s.totals.slip_area, 0);
    EXPECT_EQ(s.report.newton_steps, 0);
  }
}

/// A step of an element's length onto an edge at the next centre is in contact all along: nothing to correct,
/// whatever lies between the bodies.
TEST(TangentialProblem, TheLeadingEdgesCorrectionKnowsTheLayer) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 12, 12, 2);
  Bodies bodies = p.material;
  bodies.layer.flexibility = 0.2 * contact.a / contact.shear_modulus;
  TangentialInput input = with_creepage(scaled_creepage(contact, 0.6, 0.2, 0.3));
  TangentialProblem problem(bodies, p.grid);
  const ContactSolution plain = problem.solve(p.bound, input);
  input.leading_edge = LeadingEdge{.theta = 1};
  const ContactSolution same = problem.solve(p.bound, input);
  ASSERT_EQ(same.report.status, Status::ok);
  EXPECT_EQ(same.fields.traction.x, plain.fields.traction.x);
  EXPECT_EQ(same.fields.traction.y, plain.fields.traction.y);
}

/// The coefficients of the slip's operator are computed on the first call.
TEST(TangentialProblem, TheLeadingEdgesCorrectionCanBeStopped) {
  const Problem p = elliptic(steel_contact(1), 12, 12, 2);
  TangentialInput input;
  input.creepage = {1e-3, 0, 0};
  input.leading_edge = LeadingEdge{};
  input.progress = [](double) { return false; };
  TangentialProblem problem(p.material, p.grid);
  EXPECT_THROW(problem.solve(p.bound, input), Stopped);
}

/// Far beyond saturation p = -g w/|w|, and the force is mu Fn.
TEST(TangentialProblem, FullSliding) {
  const EllipticContact contact = steel_contact(2);
  const Problem p = elliptic(contact, 12, 10);
  for (const double angle : {0.0, 0.9, 2.5, -1.5}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 1e6 * std::cos(angle), 1e6 * std::sin(angle), 0);
    const ContactSolution s = solve(p, input);
    ASSERT_EQ(s.report.status, Status::ok);
    EXPECT_EQ(s.totals.adhesion_area, 0);
    const double w = std::hypot(input.creepage.longitudinal, input.creepage.lateral);
    EXPECT_NEAR(s.totals.fx / p.capacity, -input.creepage.longitudinal / w, 1e-5);
    EXPECT_NEAR(s.totals.fy / p.capacity, -input.creepage.lateral / w, 1e-5);
    EXPECT_NEAR(std::hypot(s.totals.fx, s.totals.fy), p.capacity, 1e-9 * p.capacity);
    EXPECT_NEAR(s.totals.frictional_power / (p.capacity * w), 1, 1e-5);
  }
}

/// With enough friction nothing slides, forces are linear in the creepages, and the finer the grid the closer to
/// Kalker's coefficients (Kalker 1990, table E.3: a/b = 1, nu = 1/4).
TEST(TangentialProblem, NoSlipGivesKalkersCoefficients) {
  EllipticContact contact = steel_contact(1);
  contact.poisson_ratio = 0.25;
  const double size = 1e-5, enough = 1e3 * size * contact.shear_modulus;
  const double unit = contact.shear_modulus * contact.a * contact.b, c = std::sqrt(contact.a * contact.b);
  for (const int n : {12, 24, 48}) {
    SCOPED_TRACE(n);
    Problem p = elliptic(contact, n, n);
    for (double& g : p.bound) g = g > 0 ? enough : 0;
    TangentialProblem problem(p.material, p.grid);
    TangentialInput input;
    input.tolerance = 1e-10;
    const auto forces = [&](double xi, double eta, double phi) {
      input.creepage = {xi * size, eta * size, phi * size / c};
      return problem.solve(p.bound, input).forces();
    };
    const ContactForces xi = forces(1, 0, 0), eta = forces(0, 1, 0), phi = forces(0, 0, 1), all = forces(2, 3, -2);
    EXPECT_EQ(xi.slip_area + eta.slip_area + phi.slip_area + all.slip_area, 0);
    const double found[] = {xi.fx, eta.fy, phi.fy, eta.mz / c, phi.mz / c}, kalker[] = {4.12, 3.67, 1.47, -1.47, 1.19};
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(-found[k] / (unit * size), kalker[k], 3.2 / n * std::abs(kalker[k])) << k;
    const double rounding = 1e-5 * unit * size;
    expect_forces(all, {2 * xi.fx, 3 * eta.fy - 2 * phi.fy, 3 * eta.mz - 2 * phi.mz}, rounding, rounding * c);
  }
}

/// Elements of any kind of patch: a ring of no friction, a bound that varies from element to element.
TEST(TangentialProblem, FrictionThatVariesOverThePatch) {
  const EllipticContact contact = steel_contact(1.5);
  Problem p = elliptic(contact, 13, 11);
  RandomContacts random(4);
  for (double& g : p.bound) g *= random.between(0, 2);
  for (std::size_t k = 0; k < p.bound.size(); k += 5) p.bound[k] = 0;
  p.capacity = 0;
  for (double g : p.bound) p.capacity += g * p.grid.element_area();
  for (const double size : {0.1, 0.5, 1.5, 1e5}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, size, -0.7 * size, 0.3 * size);
    const ContactSolution s = solve(p, input);
    expect_solution(p, input, s);
    EXPECT_LE(std::hypot(s.totals.fx, s.totals.fy), p.capacity);
  }
}

TEST(TangentialProblem, NoBoundAnywhere) {
  Problem p = elliptic(steel_contact(1), 6, 6);
  std::fill(p.bound.begin(), p.bound.end(), 0.0);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    TangentialInput input;
    input.motion = motion;
    input.creepage = {1e-3, 2e-3, 0.1};
    const ContactSolution s = solve(p, input);
    EXPECT_EQ(s.report.status, Status::ok);
    EXPECT_EQ(s.fields.traction.x, p.bound);
    EXPECT_EQ(s.totals.fx, 0);
    EXPECT_EQ(s.totals.mz, 0);
    EXPECT_EQ(s.totals.adhesion_area + s.totals.slip_area, 0);
    EXPECT_EQ(s.report.residual, 0);
    for (const CellState state : s.fields.state) EXPECT_EQ(state, CellState::exterior);
    input.force_x = 0;
    EXPECT_EQ(solve(p, input).report.status, Status::ok);
    input.force_x = 1;
    EXPECT_EQ(solve(p, input).report.status, Status::no_solution);
  }
}

/// One element: p = -w/D up to the bound, in the direction of w beyond it.
TEST(TangentialProblem, OneElement) {
  const ElementGrid grid{.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3, .line = false};
  const Problem p{{82e9, 0.28, 0}, grid, {1e6}, 1e6 * grid.element_area(), 5e-4};
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady})
    for (const double size : {0.3, 3.0}) {
      TangentialInput input;
      input.motion = motion;
      input.tolerance = 1e-12;
      const double self = diagonal(p, input), w = size * self * 1e6;
      input.creepage = {w * 0.6, w * -0.8, 0};
      const ContactSolution s = solve(p, input);
      expect_solution(p, input, s);
      EXPECT_EQ(s.fields.state[0], size > 1 ? CellState::slip : CellState::adhesion);
      // For a square D_xx and D_yy of a step along x differ, so the direction of a sliding one follows from both.
      if (motion != ContactMotion::steady) {
        EXPECT_NEAR(s.fields.traction.x[0], -0.6e6 * std::min(size, 1.0), 10);
        EXPECT_NEAR(s.fields.traction.y[0], 0.8e6 * std::min(size, 1.0), 10);
      }
    }
}

TEST(TangentialProblem, ToleranceOnRequest) {
  const EllipticContact contact = steel_contact(0.4);
  const Problem p = elliptic(contact, 15, 15);
  for (const double tolerance : {1e-3, 1e-6, 1e-10, 1e-12}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 0.5, 0.4, 0.6);
    input.tolerance = tolerance;
    expect_solution(p, input, solve(p, input));
  }
}

/// Whatever distance is rolled in a step: a solution, and with finer grids the same one.
TEST(TangentialProblem, AnyStep) {
  EllipticContact contact = steel_contact(1);
  contact.creepage = scaled_creepage(contact, 0.5, 0, 0);
  const auto force = [&](int n, double elements, RollingDirection direction) {
    const Problem p = elliptic(contact, n, n);
    TangentialInput input;
    input.direction = direction;
    input.step = elements * p.grid.dx;
    input.creepage = contact.creepage;
    const ContactSolution s = solve(p, input);
    EXPECT_EQ(s.report.status, Status::ok);
    if (n == 16) expect_solution(p, input, s);
    return -s.totals.fx / p.capacity;
  };
  const double limit = 2 * force(64, 1, forward) - force(32, 1, forward);
  for (const double elements : {0.25, 0.5, 1.0, 2.0, 5.0}) {
    SCOPED_TRACE(elements);
    const double coarse = force(16, elements, forward), fine = force(32, elements, forward);
    EXPECT_NEAR(fine, limit, 0.05 + 0.01 * elements);
    EXPECT_GT((coarse - limit) / (fine - limit), 1.8);
    EXPECT_NEAR(force(16, elements, backward), coarse, 1e-6);
  }
}

/// Steps much longer than the contact: a shift each, and with this creepage full sliding.
TEST(TangentialProblem, VeryLongSteps) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 15, 15);
  TangentialInput input;
  input.step = 100 * p.grid.dx;
  input.creepage = scaled_creepage(contact, 0.5, 0, 0);
  const ContactSolution s = solve(p, input);
  expect_solution(p, input, s);
  EXPECT_NEAR(s.totals.fx, -p.capacity, 1e-4 * p.capacity);
}

/// dq = 0 means the elements' length.
TEST(TangentialProblem, DefaultStepIsAnElement) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 9, 9);
  TangentialInput input = with_creepage(scaled_creepage(contact, 0.5, 0.1, 0.2));
  const ContactSolution s = solve(p, input);
  input.step = p.grid.dx;
  EXPECT_EQ(solve(p, input).fields.traction.x, s.fields.traction.x);
}

/// The rigid slip is taken spin_offset steps ahead of an element's centre: as if the origin lay that much behind it.
TEST(TangentialProblem, SpinOffset) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 10);
  for (const RollingDirection direction : {forward, backward})
    for (const double offset : {0.0, 0.5, 1.0}) {
      TangentialInput input;
      input.direction = direction;
      input.spin_offset = offset;
      input.creepage = scaled_creepage(contact, 0.2, 0.3, 0.5);
      const ContactSolution s = solve(p, input);
      expect_solution(p, input, s);
      const double ahead = offset * signed_step(p, input);
      input.spin_offset = 0;
      input.creepage.lateral += input.creepage.spin * ahead;
      EXPECT_NEAR(solve(p, input).totals.fy, s.totals.fy, 1e-9 * p.capacity);
    }
}

/// A transient step from no tractions is a shift by the creepages times the distance.
TEST(TangentialProblem, FirstStepIsAShift) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 11, 11);
  TangentialInput step, shift;
  step.tolerance = shift.tolerance = 1e-10;
  step.motion = ContactMotion::transient;
  step.step = 3 * p.grid.dx;
  step.spin_offset = 0;
  step.creepage = scaled_creepage(contact, 2, 1, 1);
  shift.motion = ContactMotion::shift;
  const Creepage& c = step.creepage;
  shift.creepage = {c.longitudinal * step.step, c.lateral * step.step, c.spin * step.step};
  const ContactSolution rolled = solve(p, step), shifted = solve(p, shift);
  EXPECT_GT(rolled.totals.slip_area, 0);
  EXPECT_NEAR(rolled.totals.fx, shifted.totals.fx, 1e-8 * p.capacity);
  EXPECT_NEAR(rolled.totals.fy, shifted.totals.fy, 1e-8 * p.capacity);
  EXPECT_NEAR(rolled.totals.frictional_power * step.step, shifted.totals.frictional_power,
              1e-8 * shifted.totals.frictional_power);
}

/// Steady rolling is where transient rolling ends.
TEST(TangentialProblem, MarchingEndsInTheSteadyState) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 11);
  for (const RollingDirection direction : {forward, backward})
    for (const double elements : {1.0, 2.0}) {
      TangentialProblem problem(p.material, p.grid);
      TangentialInput input;
      input.direction = direction;
      input.tolerance = 1e-8;
      input.step = elements * p.grid.dx;
      input.creepage = scaled_creepage(contact, 0.5, 0.3, 0.4);
      const ContactSolution steady = problem.solve(p.bound, input);
      input.motion = ContactMotion::transient;
      VectorField state;
      ContactSolution s;
      for (double rolled = 0; rolled < 16 * contact.a; rolled += input.step) {
        input.previous = input.start = &state;
        s = problem.solve(p.bound, input);
        ASSERT_EQ(s.report.status, Status::ok);
        state = s.fields.traction;
      }
      expect_forces(s.forces(), steady.forces(), 1e-5 * p.capacity, 1e-5 * p.capacity * contact.a);
      EXPECT_NEAR(s.totals.frictional_power, steady.totals.frictional_power, 1e-4 * steady.totals.frictional_power);
    }
}

/// Without spin the frictional power by slip is below that by creepages, by p.Dp; the difference is of first order.
TEST(TangentialProblem, BothPowersMeetAsTheGridIsRefined) {
  const EllipticContact contact = steel_contact(1);
  double before = 0;
  for (const int n : {8, 16, 32}) {
    const Problem p = elliptic(contact, n, n);
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 0.5, 0.3, 0);
    const ContactSolution s = solve(p, input);
    EXPECT_GT(s.totals.frictional_power, 0);
    EXPECT_LT(s.totals.frictional_power, s.totals.power_by_creepage);
    const double difference = 1 - s.totals.frictional_power / s.totals.power_by_creepage;
    EXPECT_LT(difference, 4.2 / n);
    if (n > 8) {
      EXPECT_GT(before / difference, 1.65);
    }
    before = difference;
  }
}

/// Seeded contacts of all shapes and motions, directions, steps, creepages or forces.
TEST(TangentialProblem, RandomProblems) {
  RandomContacts random(33);
  for (int n = 0; n < 24; ++n) {
    EllipticContact contact = random.next();
    const int mx = static_cast<int>(random.between(1, 16)), my = static_cast<int>(random.between(1, 16));
    Problem p = elliptic(contact, mx, my);
    TangentialInput input;
    input.motion = static_cast<ContactMotion>(n % 3);
    input.direction = random.between(0, 1) < 0.5 ? forward : backward;
    input.step = random.about(0.3, 4) * p.grid.dx;
    input.spin_offset = random.between(0, 1);
    input.rolling_speed = contact.rolling_speed;
    input.creepage = contact.creepage;
    input.tolerance = n % 2 == 0 ? 1e-6 : 1e-10;
    const double length = input.motion == ContactMotion::shift ? contact.a : 1;
    for (double* c : {&input.creepage.longitudinal, &input.creepage.lateral, &input.creepage.spin}) *c *= length;
    VectorField before;
    if (input.motion != ContactMotion::steady && n % 4 < 3) {
      TangentialInput first = input;
      first.creepage = {-input.creepage.lateral, input.creepage.longitudinal, -input.creepage.spin};
      before = solve(p, first).fields.traction;
      input.previous = &before;
    }
    const double angle = random.between(0, 6.28), share = random.between(0, 0.9);
    if (n % 5 == 1 || n % 5 == 3) input.force_x = share * p.capacity * std::cos(angle);
    if (n % 5 == 2 || n % 5 == 3) input.force_y = share * p.capacity * std::sin(angle);
    SCOPED_TRACE(std::to_string(n) + ": " + std::to_string(mx) + " x " + std::to_string(my) + ", " + describe(contact));
    expect_solution(p, input, solve(p, input));
  }
}

/// A start somewhere else leads to the same solution; the solution as a start takes no step.
TEST(TangentialProblem, TheStartDoesNotMatter) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 12, 12);
  TangentialInput input;
  input.tolerance = 1e-9;
  input.creepage = scaled_creepage(contact, 0.5, 0.3, 0.4);
  const ContactSolution cold = solve(p, input);
  VectorField sliding{p.bound, Field(p.bound.size(), 0.0)};
  input.start = &sliding;
  const ContactSolution other = solve(p, input);
  EXPECT_NEAR(other.totals.fx, cold.totals.fx, 1e-7 * p.capacity);
  EXPECT_NEAR(other.totals.mz, cold.totals.mz, 1e-7 * p.capacity * contact.a);
  input.start = &cold.fields.traction;
  input.tolerance = 1e-8;
  EXPECT_EQ(solve(p, input).report.newton_steps, 0);
}

/// What was solved before leaves no trace, whatever motion and step it had.
TEST(TangentialProblem, OneObjectForManyProblems) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 9);
  TangentialProblem problem(p.material, p.grid);
  VectorField before;
  std::vector<TangentialInput> inputs;
  for (const ContactMotion motion : {ContactMotion::steady, ContactMotion::shift, ContactMotion::transient})
    for (const RollingDirection direction : {forward, backward})
      for (const double step : {0.0, 0.5 * p.grid.dx}) {
        TangentialInput input;
        input.motion = motion;
        input.direction = direction;
        input.step = step;
        const double length = motion == ContactMotion::shift ? contact.a : 1;
        input.creepage = scaled_creepage(contact, 0.5 * length, 0.3 * length, 0.2 * length);
        if (motion == ContactMotion::transient) input.previous = &before;
        inputs.push_back(input);
      }
  before = solve(p, inputs[0]).fields.traction;
  for (const std::size_t order : {1U, 5U, 7U}) // coprime to their number: all of them, in another order
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const TangentialInput& input = inputs[k * order % inputs.size()];
      const ContactSolution s = problem.solve(p.bound, input), fresh = solve(p, input);
      EXPECT_EQ(s.fields.traction.x, fresh.fields.traction.x);
      EXPECT_EQ(s.fields.traction.y, fresh.fields.traction.y);
      EXPECT_EQ(s.totals.frictional_power, fresh.totals.frictional_power);
    }
}

TEST(TangentialProblem, RefusesInputThatMakesNoSense) {
  const Problem p = elliptic(steel_contact(1), 4, 4);
  const auto expect = [&](auto change, const std::string& field, const std::string& range) {
    TangentialInput input;
    change(input);
    expect_error([&] { solve(p, input); }, field, range);
  };
  for (const double bad : {-1e-4, nan, infinity})
    expect([&](auto& in) { in.step = bad; }, "step", "[m]: must be in [0, ");
  for (const double bad : {nan, infinity, -infinity}) {
    expect([&](auto& in) { in.creepage.longitudinal = bad; }, "creepage.longitudinal", "[-]: must be finite");
    expect([&](auto& in) { in.creepage.lateral = bad; }, "creepage.lateral", "[-]: must be finite");
    expect([&](auto& in) { in.creepage.spin = bad; }, "creepage.spin", "[1/m]: must be finite");
    expect([&](auto& in) { in.force_x = bad; }, "force_x", "[N]: must be finite");
    expect([&](auto& in) { in.force_y = bad; }, "force_y", "[N]: must be finite");
  }
  for (const double bad : {-0.1, 1.1, nan})
    expect([&](auto& in) { in.spin_offset = bad; }, "spin_offset", "[-]: must be in [0, 1]");
  for (const double bad : {0.0, -2.0, nan, infinity})
    expect([&](auto& in) { in.rolling_speed = bad; }, "rolling_speed", "[m/s]: must be positive and finite");
  for (const double bad : {0.0, -1e-6, 2.0, nan})
    expect([&](auto& in) { in.tolerance = bad; }, "tolerance", "[-]: must be in [1e-14, 0.1]");
}

TEST(TangentialProblem, RefusesFieldsThatMakeNoSense) {
  Problem p = elliptic(steel_contact(1), 4, 4);
  for (const double bad : {-1.0, nan, infinity}) {
    Problem broken = p;
    broken.bound[3] = bad;
    expect_error([&] { solve(broken, {}); }, "bound[3]", "[Pa]: must be finite and not negative");
  }
  Problem shorter = p;
  shorter.bound.pop_back();
  EXPECT_THROW(solve(shorter, {}), Error);
  VectorField wrong{Field(3, 0.0), Field(3, 0.0)}, half{Field(p.bound.size(), 0.0), {}};
  for (const VectorField* state : {&wrong, &half}) {
    TangentialInput input;
    input.start = state;
    EXPECT_THROW(solve(p, input), Error);
    input.start = nullptr;
    input.previous = state;
    input.motion = ContactMotion::transient;
    EXPECT_THROW(solve(p, input), Error);
  }
  EXPECT_THROW(TangentialProblem(p.material, ElementGrid{}), Error);
}

} // namespace
} // namespace microslip
