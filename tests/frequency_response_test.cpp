#include "microslip/rolling/frequency_response.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/fitted/fitted_problem.hpp"
#include "microslip/exact/fitted/transient_rolling.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Field = std::vector<double>;

/// With adhesion and slip.
std::vector<EllipticContact> partial_slip_cases() {
  return {steel_contact(6e-3, 12e-3, 0.5, -0.6, 0.3), steel_contact(9e-3, 9e-3, 0.6, 0.5, 0),
          steel_contact(12e-3, 6e-3, -0.3, 0.7, 0.4)};
}

Solver solver(int n) {
  Method method;
  method.mx = method.my = n;
  method.tolerance = 1e-9;
  return Solver(method);
}

ForceResponse response_of(const EllipticContact& contact, int n, double wavenumber) {
  const FrequencyResponse r = solver(n).respond(rolling_problem(contact), std::array{wavenumber});
  EXPECT_EQ(r.solution.report.status, Status::ok) << r.solution.report.reason;
  return r.at.at(0);
}

double largest(const ForceResponse& r, int row) {
  double most = 0;
  for (const Complex& value : r.by_creepage[row]) most = std::max(most, std::abs(value));
  return most;
}

TEST(FrequencyResponse, IsTheDerivativeWhereNothingOscillates) {
  for (const EllipticContact& contact : partial_slip_cases()) {
    const ForceResponse r = response_of(contact, 20, 0);
    const ExactDerivatives d = solver(20).differentiate(rolling_problem(contact));
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(r.by_creepage[i][k] - d.jacobian[i][k]), 2e-5 * largest(r, i));
      EXPECT_LT(std::abs(r.by_load[i] - d.by_load[i]), 2e-5 * std::abs(d.by_load[i])) << i;
    }
  }
}

/// Oscillates the state of transient rolling by +-`amplitude` of `set`, and returns the amplitudes of Fx and Fy per
/// unit: `roll(factor of the step's end)` is called for each step and returns the forces. The state before has passed
/// through the contact `passes` times.
template <class Rolling>
std::array<Complex, 2> oscillated(int steps, int settling, double amplitude, const Rolling& make_rolling) {
  std::array<Complex, 2> out = {};
  const int first = (settling + steps - 1) / steps * steps;
  for (const double sign : {-1.0, 1.0}) {
    auto roll = make_rolling();
    for (int i = 0; i < first + steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      const std::array<double, 2> f = roll(sign * amplitude, angle);
      if (i < first) continue;
      for (int k = 0; k < 2; ++k) out[k] += f[k] * sign / (steps * amplitude) * std::polar(1.0, -angle);
    }
  }
  return out;
}

/// Steps of an element's length at second order, creepage by creepage, waves of a half and of two contact lengths. What
/// differs are errors of both discretisations.
TEST(FrequencyResponse, IsThatOfTransientRollingWithSmallOscillations) {
  constexpr int n = 24;
  for (const EllipticContact& contact : partial_slip_cases())
    for (const int steps : {n / 2, 2 * n}) {
      const FittedContact fitted = fit_ellipse(contact.a, contact.b, n, n, ContactMotion::transient);
      const Field bound = friction_bound(fitted, friction_force(contact));
      const double h = fitted.grid.dx, k = 2 * std::numbers::pi / (steps * h);
      const auto rolling = [&] {
        return [&, rolling = TransientRolling({contact.shear_modulus, contact.poisson_ratio, 0}, fitted)](
                   double amplitude, double angle) mutable {
          const Complex mean = std::polar(1.0, angle) * (1.0 - std::polar(1.0, -k * h)) / Complex(0, k * h);
          SecondOrderInput input;
          input.tolerance = 1e-10;
          input.creepage = contact.creepage;
          input.creepage.longitudinal += amplitude * mean.real();
          const SecondOrderSolution s = rolling.step(bound, input);
          std::array<double, 2> f = {};
          for (std::size_t e = 0; e < bound.size(); ++e) {
            const double area = fitted.elements[e].width() * fitted.grid.dy;
            f[0] += area * s.friction.traction.x[e];
            f[1] += area * s.friction.traction.y[e];
          }
          return f;
        };
      };
      const auto f = oscillated(steps, 3 * n, 1e-3 * contact.creepage.longitudinal, rolling);
      const ForceResponse r = response_of(contact, n, k);
      EXPECT_LT(std::abs(r.by_creepage[0][0] - f[0]), 0.02 * std::abs(f[0])) << steps;
      EXPECT_LT(std::abs(r.by_creepage[1][0] - f[1]), 0.02 * std::abs(f[0])) << steps;
    }
}

/// Means of the traction bound over a grid's elements, in a contact `size` times as long.
Field bounds_on_grid(const EllipticContact& contact, const ElementGrid& grid, double size) {
  constexpr int points = 8;
  Field g(grid.count());
  const double peak = 1.5 * friction_force(contact) / (std::numbers::pi * contact.a * contact.b) * size;
  for (std::size_t k = 0; k < g.size(); ++k) {
    double sum = 0;
    for (int p = 0; p < points * points; ++p) {
      const int column = p % points, row = p / points;
      const double right = (column + 0.5) / points - 0.5, up = (row + 0.5) / points - 0.5;
      const double x = (grid.x(static_cast<int>(k) % grid.mx) + right * grid.dx) / (size * contact.a);
      const double y = (grid.y(static_cast<int>(k) / grid.mx) + up * grid.dy) / (size * contact.b);
      sum += std::sqrt(std::max(0.0, 1 - x * x - y * y));
    }
    g[k] = peak * sum / (points * points);
  }
  return g;
}

/// Classical steps, in which elements at the edges come and go: their error is of first order and extrapolated.
TEST(FrequencyResponse, ByLoadIsThatOfAContactThatGrowsAndShrinks) {
  const EllipticContact contact = steel_contact(9e-3, 9e-3, 0.6, 0.5, 0);
  constexpr int finer = 40;
  std::array<Complex, 2> on[2];
  double k = 0;
  for (const int n : {finer / 2, finer}) {
    const ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, n, 2);
    const int steps = 2 * n;
    k = 2 * std::numbers::pi / (steps * grid.dx);
    const auto rolling = [&] {
      return [&, problem = TangentialProblem({{contact.shear_modulus, contact.poisson_ratio, 0}}, grid),
              last = VectorField()](double amplitude, double angle) mutable {
        TangentialInput input;
        input.motion = ContactMotion::transient;
        input.creepage = contact.creepage;
        input.tolerance = 1e-8;
        input.previous = last.x.empty() ? nullptr : &last;
        const ContactSolution s = problem.solve(bounds_on_grid(contact, grid, 1 + amplitude * std::cos(angle)), input);
        last = s.fields.traction;
        return std::array{s.totals.fx, s.totals.fy};
      };
    };
    on[n == finer] = oscillated(steps, 2 * n, 0.02, rolling);
  }
  const ForceResponse r = response_of(contact, finer, k);
  for (int i = 0; i < 2; ++i) {
    const Complex limit = (2.0 * on[1][i] - on[0][i]) / (3 * contact.normal_force);
    EXPECT_LT(std::abs(r.by_load[i] - limit), 0.03 * std::abs(limit)) << i << r.by_load[i] << limit;
  }
}

/// The state is the same whether its creepages are given or found for their forces.
TEST(FrequencyResponse, OfForcesGivenIsThatOfTheCreepagesFound) {
  const EllipticContact contact = partial_slip_cases()[0];
  RollingProblem by_forces = rolling_problem(contact);
  const Totals totals = solver(16).solve(by_forces).totals;
  by_forces.motion.force_x = totals.fx;
  by_forces.motion.force_y = totals.fy;
  const double k = 1 / contact.a;
  const ForceResponse a = response_of(contact, 16, k), b = solver(16).respond(by_forces, std::array{k}).at.at(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_LT(std::abs(a.by_creepage[i][j] - b.by_creepage[i][j]), 1e-4 * largest(a, i)) << i << j;
}

/// Rolling along -x is the mirror image in x.
TEST(FrequencyResponse, IsMirroredWithTheDirection) {
  const EllipticContact contact = partial_slip_cases()[0];
  RollingProblem there = rolling_problem(contact), back = there;
  back.motion.direction = RollingDirection::backward;
  back.motion.creepage.longitudinal *= -1;
  back.motion.creepage.spin *= -1;
  const std::array k = {2 / contact.a};
  const ForceResponse a = solver(12).respond(there, k).at[0], b = solver(12).respond(back, k).at[0];
  const double side[3] = {-1, 1, -1};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      EXPECT_LT(std::abs(b.by_creepage[i][j] - side[i] * side[j] * a.by_creepage[i][j]), 1e-12 * largest(a, i));
    EXPECT_LT(std::abs(b.by_load[i] - side[i] * a.by_load[i]), 1e-12 * std::abs(a.by_load[i]));
  }
}

/// Where waves are far longer than the contact the lag is a distance, about half the contact's length.
TEST(FrequencyResponse, LagsByADistanceOfTheContactsSize) {
  const EllipticContact contact = steel_contact(9e-3, 9e-3, 0.05, 0, 0);
  const double k = 0.01 / contact.a;
  const Complex c = response_of(contact, 24, k).by_creepage[0][0];
  const double lag = (std::numbers::pi - std::abs(std::arg(c))) / k;
  EXPECT_GT(lag, 0.5 * contact.a);
  EXPECT_LT(lag, 2 * contact.a);
}

/// The mean of a wave over a flat punch's pressure, by a sum in polar coordinates.
TEST(FrequencyResponse, ContactFilterIsTheMeanOverAPunchsPressure) {
  constexpr double a = 5e-3, b = 8e-3;
  constexpr int count = 400;
  for (const auto [kx, ky] : {std::array{0.0, 0.0}, {300.0, 0.0}, {0.0, 250.0}, {-400.0, 200.0}, {900.0, 0.0}}) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        // with r = sin t the pressure 1/sqrt(1 - r^2) on r dr is sin t dt
        const double t = (i + 0.5) / count * std::numbers::pi / 2, angle = (j + 0.5) / count * 2 * std::numbers::pi;
        const double x = a * std::sin(t) * std::cos(angle), y = b * std::sin(t) * std::sin(angle);
        sum += std::sin(t) * std::cos(kx * x + ky * y);
      }
    const double mean = sum * (std::numbers::pi / 2) / (count * count);
    EXPECT_NEAR(contact_filter(a, b, kx, ky), mean, 1e-5);
  }
}

TEST(FrequencyResponse, RefusesWhatHasNone) {
  const RollingProblem problem = rolling_problem(partial_slip_cases()[0]);
  const std::array k = {1.0}, negative = {-1.0};
  EXPECT_THROW(solver(8).respond(problem, negative), Error);
  Method fast;
  fast.theory = Theory::fastsim2;
  EXPECT_THROW(Solver(fast).respond(problem, k), Error);
  RollingProblem transient = problem;
  transient.motion.kind = ContactMotion::transient;
  EXPECT_THROW(solver(8).respond(transient, k), Error);
  RollingProblem dissimilar = problem;
  dissimilar.bodies.material.dissimilarity = 0.1;
  EXPECT_THROW(solver(8).respond(dissimilar, k), Error);
  RollingProblem too_much = problem;
  too_much.motion.force_x = 1e9;
  const FrequencyResponse none = solver(8).respond(too_much, k);
  EXPECT_EQ(none.solution.report.status, Status::no_solution);
  EXPECT_TRUE(none.at.empty());
}

} // namespace
} // namespace microslip
