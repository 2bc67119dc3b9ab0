#include "microslip/simplified/model_problem.hpp"

#include "tests/support/expect_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace microslip {
namespace {

double displacement_error(const ModelCase& model, const ModelSolution& solution) {
  double error = 0;
  for (std::size_t i = 0; i < solution.x.size(); ++i)
    error = std::max(error, std::abs(solution.displacement[i] - model.displacement(solution.x[i])));
  return error;
}

double slip_error(const ModelCase& model, const ModelSolution& solution) {
  double error = 0;
  for (std::size_t i = 0; i < solution.x.size(); ++i)
    error = std::max(error, std::abs(solution.slip[i] - model.slip(solution.x[i])));
  return error;
}

double transition_error(const ModelCase& model, const ModelSolution& solution) {
  const auto exact = model.transitions();
  EXPECT_EQ(exact.size(), solution.transitions.size());
  double error = 0;
  for (std::size_t k = 0; k < std::min(exact.size(), solution.transitions.size()); ++k)
    error = std::max(error, std::abs(exact[k] - solution.transitions[k]));
  return error;
}

/// error(mx), the largest of ten grids, so that it does not depend on where transitions lie between grid points.
template <class Error> double largest_error(int first, const Error& error) {
  double largest = 0;
  for (int mx = first; mx < first + 10; ++mx) largest = std::max(largest, error(mx));
  return largest;
}

/// (F20) at the grid points: all that a solution must satisfy besides the differential equation.
void expect_contact_conditions(const ModelProblem& problem, const ModelSolution& solution) {
  for (std::size_t i = 0; i < solution.x.size(); ++i) {
    const double u = solution.displacement[i], s = solution.slip[i], bound = problem.bound(solution.x[i]);
    ASSERT_TRUE(std::isfinite(u) && std::isfinite(s)) << "x = " << solution.x[i];
    ASSERT_LE(std::abs(u), bound) << "x = " << solution.x[i];
    ASSERT_LE(s * u, 0) << "x = " << solution.x[i];
    if (s != 0) {
      ASSERT_EQ(std::abs(u), bound) << "x = " << solution.x[i];
    }
  }
}

ModelProblem multiplied(const ModelProblem& problem, double bound_factor, double rigid_slip_factor) {
  return {[=](double x) { return bound_factor * problem.bound(x); },
          [=](double x) { return bound_factor * problem.bound_slope(x); },
          [=](double x) { return rigid_slip_factor * problem.rigid_slip(x); }};
}

std::vector<double> multiplied(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// Random bounds, creepages and spins from a fixed seed.
std::vector<ModelProblem> random_problems(int count) {
  std::mt19937 random(2010);
  std::uniform_real_distribution<double> creepage(-10, 10), spin(-30, 30);
  std::vector<ModelProblem> problems;
  problems.reserve(count);
  for (int k = 0; k < count; ++k)
    problems.push_back(
        model_problem(k % 2 == 0 ? TractionBound::parabolic : TractionBound::elliptic, creepage(random), spin(random)));
  return problems;
}

TEST(ModelProblem, ExactSolutionsHaveThePublishedTransitions) {
  const auto cases = model_cases();
  EXPECT_DOUBLE_EQ(cases[0].transitions().at(0), 0.39);
  EXPECT_DOUBLE_EQ(cases[1].transitions().at(0), 1.0 / 3);
  EXPECT_NEAR(cases[1].transitions().at(1), 0.8744, 0.5e-4);
  EXPECT_NEAR(cases[2].transitions().at(0), 0.1355, 0.5e-4);
  EXPECT_NEAR(cases[2].transitions().at(1), 0.3992, 0.5e-4);
  EXPECT_NEAR(cases[1].slip(0.2), 6 * 0.2 - 2, 1e-14);
  EXPECT_NEAR(cases[1].slip(0.9), 22 * 0.9 - 10, 1e-13);
}

// The paper prints -0.3203 and 0.9011 for the last two numbers of (F27). They do not satisfy (F20): u would jump.
TEST(ModelProblem, ExactSolutionsSatisfyTheProblem) {
  for (const ModelCase& model : model_cases()) {
    const ModelProblem& problem = model.problem();
    const auto transitions = model.transitions();
    for (const double x : transitions) {
      EXPECT_NEAR(model.displacement(x), model.displacement(std::nextafter(x, 1)), 2e-15) << model.name();
      EXPECT_NEAR(std::abs(model.displacement(x)), problem.bound(x), 2e-15) << model.name();
    }
    const double h = 1e-5;
    for (int i = 1; i <= 100; ++i) {
      const double x = i * 0.0098;
      const double u = model.displacement(x), s = model.slip(x);
      EXPECT_LE(std::abs(u), problem.bound(x));
      EXPECT_LE(s * u, 0) << model.name() << ", x = " << x;
      if (std::any_of(transitions.begin(), transitions.end(), [&](double t) { return std::abs(x - t) < h; })) continue;
      const double slope = (model.displacement(x + h) - model.displacement(x - h)) / (2 * h);
      EXPECT_NEAR(slope - s, -problem.rigid_slip(x), 2e-6) << model.name() << ", x = " << x;
    }
  }
}

TEST(ModelProblem, TrackedTrapezoidalRuleIsExactForAParabolicBound) {
  const auto cases = model_cases();
  for (int k = 0; k < 2; ++k)
    for (int mx = 1; mx <= 100; ++mx) {
      const auto solution = solve_tracked(cases[k].problem(), mx, 0.5);
      EXPECT_LE(displacement_error(cases[k], solution), 1e-14) << cases[k].name() << ", mx = " << mx;
      EXPECT_LE(slip_error(cases[k], solution), 1e-12) << cases[k].name() << ", mx = " << mx;
      EXPECT_LE(transition_error(cases[k], solution), 1e-13) << cases[k].name() << ", mx = " << mx;
    }
}

TEST(ModelProblem, TrackedTrapezoidalRuleLosesOnlyRoundingOnFineGrids) {
  const auto cases = model_cases();
  for (int k = 0; k < 2; ++k) {
    const auto solution = solve_tracked(cases[k].problem(), 10'000, 0.5);
    EXPECT_LE(displacement_error(cases[k], solution), 1e-14);
    EXPECT_LE(slip_error(cases[k], solution), 1e-9);
  }
}

TEST(ModelProblem, TransitionAtAGridPointBelongsToAdhesion) {
  for (const int mx : {100, 1000}) {
    const auto solution = solve_tracked(model_cases()[0].problem(), mx, 0.5);
    const int i = 39 * mx / 100;
    EXPECT_EQ(solution.slip[i], 0);
    EXPECT_NEAR(solution.slip[i + 1], 3.9 - 20 * solution.x[i + 1], 1e-10);
    ASSERT_EQ(solution.transitions.size(), 1U);
    EXPECT_NEAR(solution.transitions[0], 0.39, 1e-14);
  }
}

TEST(ModelProblem, TrackedTrapezoidalRuleIsSecondOrderUnderAnEllipticBound) {
  const ModelCase model = model_cases()[2];
  const auto solve = [&](int mx) { return solve_tracked(model.problem(), mx, 0.5); };
  const auto displacement = [&](int mx) { return displacement_error(model, solve(mx)); };
  const auto transition = [&](int mx) { return transition_error(model, solve(mx)); };
  EXPECT_LE(displacement(10), 1e-4);
  EXPECT_GE(std::log2(largest_error(10, displacement) / largest_error(320, displacement)) / 5, 1.9);
  EXPECT_NEAR(std::log2(largest_error(80, transition) / largest_error(640, transition)) / 3, 2, 0.15);
}

// Rigid slip that is not linear, so that adhesion is not integrated exactly; reference: a grid that holds all others.
TEST(ModelProblem, TrackedTrapezoidalRuleIsSecondOrderForCurvedRigidSlip) {
  ModelProblem problem = model_problem(TractionBound::elliptic, 0, 0);
  problem.rigid_slip = [](double x) { return x - 6 * std::cos(2.5 * x); };
  constexpr int fine = 81'920;
  const auto reference = solve_tracked(problem, fine, 0.5);
  const auto error = [&](int mx) {
    const auto solution = solve_tracked(problem, mx, 0.5);
    double largest = 0;
    for (int i = 0; i <= mx; ++i)
      largest =
          std::max(largest, std::abs(solution.displacement[i] - reference.displacement[std::size_t(i) * (fine / mx)]));
    return largest;
  };
  for (int mx = 40; mx <= 320; mx *= 2) {
    const double ratio = error(mx) / error(2 * mx);
    EXPECT_GE(ratio, 3.5) << "mx = " << mx;
    EXPECT_LE(ratio, 4.5) << "mx = " << mx;
  }
}

// Steps 0 to 4 of the paper, written down once more.
TEST(ModelProblem, BackwardEulerIsTheOriginalFastsim) {
  for (const ModelProblem& problem : random_problems(20)) {
    const int mx = 17;
    const double dx = 1.0 / mx;
    const auto solution = solve_backward_euler(problem, mx);
    double u = 0;
    for (int i = 1; i <= mx; ++i) {
      const double x = double(i) / mx, w = problem.rigid_slip(x), bound = problem.bound(x), before = u;
      u -= dx * w;
      const bool slips = std::abs(u) > bound;
      if (slips) u = std::copysign(bound, u);
      EXPECT_NEAR(solution.displacement[i], u, 1e-13);
      EXPECT_NEAR(solution.slip[i], slips ? (u - before) / dx + w : 0, 1e-11);
    }
  }
}

TEST(ModelProblem, BackwardEulerIsFirstOrder) {
  for (const ModelCase& model : model_cases()) {
    const auto error = [&](int mx) { return displacement_error(model, solve_backward_euler(model.problem(), mx)); };
    EXPECT_NEAR(std::log2(largest_error(40, error) / largest_error(640, error)) / 4, 1, 0.05) << model.name();
  }
}

TEST(ModelProblem, ThetaMethodSatisfiesItsOwnEquation) {
  for (const ModelProblem& problem : random_problems(20))
    for (const double theta : {0.5, 0.7, 1.0}) {
      const auto [x, u, s, transitions] = solve_theta_method(problem, 23, theta);
      for (std::size_t i = 1; i < x.size(); ++i) {
        const double driven =
            theta * (s[i] - problem.rigid_slip(x[i])) + (1 - theta) * (s[i - 1] - problem.rigid_slip(x[i - 1]));
        EXPECT_NEAR((u[i] - u[i - 1]) / (x[i] - x[i - 1]), driven, 1e-11);
      }
    }
}

// What tracked boundaries cure: u is right, slip swings about the exact one with the size of the jump that was missed.
TEST(ModelProblem, TrapezoidalRuleOscillatesAfterAJump) {
  const ModelCase model = model_cases()[0];
  const auto solution = solve_theta_method(model.problem(), 10, 0.5);
  EXPECT_LE(displacement_error(model, solution), 1e-14);
  for (int i = 4; i <= 10; ++i)
    EXPECT_NEAR(solution.slip[i] - model.slip(solution.x[i]), i % 2 == 0 ? 3.3 : -3.3, 1e-12) << "i = " << i;
}

TEST(ModelProblem, LeadingEdgeSlipsWhereRigidSlipExceedsTheBoundsSlope) {
  const auto cases = model_cases();
  EXPECT_EQ(solve_tracked(cases[0].problem(), 5, 0.5).slip[0], 0);
  EXPECT_EQ(solve_tracked(cases[1].problem(), 5, 0.5).slip[0], -2);
  EXPECT_EQ(solve_tracked(cases[2].problem(), 5, 0.5).slip[0], 0) << "an infinite slope of the bound prevents slip";
}

TEST(ModelProblem, EveryStrategyKeepsTheContactConditions) {
  for (const ModelProblem& problem : random_problems(200))
    for (const int mx : {1, 2, 3, 5, 10, 33}) {
      expect_contact_conditions(problem, solve_backward_euler(problem, mx));
      for (const double theta : {0.5, 0.7, 1.0}) {
        expect_contact_conditions(problem, solve_theta_method(problem, mx, theta));
        expect_contact_conditions(problem, solve_tracked(problem, mx, theta));
      }
    }
}

TEST(ModelProblem, StrategiesConvergeToOneSolution) {
  for (const ModelProblem& problem : random_problems(40)) {
    const auto tracked = solve_tracked(problem, 1000, 0.5), euler = solve_backward_euler(problem, 20'000);
    for (int i = 0; i <= 1000; ++i) ASSERT_NEAR(tracked.displacement[i], euler.displacement[20 * std::size_t(i)], 5e-3);
    EXPECT_EQ(tracked.transitions.size(), euler.transitions.size());
  }
}

TEST(ModelProblem, MirroredRigidSlipMirrorsTheSolution) {
  for (const ModelProblem& problem : random_problems(20)) {
    const auto solution = solve_tracked(problem, 12, 0.5),
               mirrored = solve_tracked(multiplied(problem, 1, -1), 12, 0.5);
    EXPECT_EQ(mirrored.displacement, multiplied(solution.displacement, -1));
    EXPECT_EQ(mirrored.slip, multiplied(solution.slip, -1));
    EXPECT_EQ(mirrored.transitions, solution.transitions);
  }
}

// A power of two, so that the numbers must agree to the last bit.
TEST(ModelProblem, UnitsOfDisplacementDoNotMatter) {
  for (const ModelProblem& problem : random_problems(20)) {
    const auto solution = solve_tracked(problem, 12, 0.5),
               scaled = solve_tracked(multiplied(problem, 0x1p-20, 0x1p-20), 12, 0.5);
    EXPECT_EQ(multiplied(scaled.displacement, 0x1p20), solution.displacement);
    EXPECT_EQ(multiplied(scaled.slip, 0x1p20), solution.slip);
    EXPECT_EQ(scaled.transitions, solution.transitions);
  }
}

TEST(ModelProblem, NothingMovesWithoutRigidSlip) {
  const auto solution = solve_tracked(model_problem(TractionBound::elliptic, 0, 0), 10, 0.5);
  for (std::size_t i = 0; i < solution.x.size(); ++i) {
    EXPECT_EQ(solution.displacement[i], 0);
    EXPECT_EQ(solution.slip[i], 0);
  }
  EXPECT_TRUE(solution.transitions.empty());
}

TEST(ModelProblem, FullSlidingFollowsTheBound) {
  const ModelProblem problem = model_problem(TractionBound::parabolic, -20, 0);
  const auto solution = solve_tracked(problem, 10, 0.5);
  for (std::size_t i = 0; i < solution.x.size(); ++i) {
    EXPECT_EQ(solution.displacement[i], problem.bound(solution.x[i]));
    EXPECT_NEAR(solution.slip[i], -20 + problem.bound_slope(solution.x[i]), 1e-12);
  }
  EXPECT_TRUE(solution.transitions.empty());
}

// The crossing lies so near the edge that it cannot be told from it.
TEST(ModelProblem, HugeRigidSlipUnderAnEllipticBoundIsFullSliding) {
  for (const double w : {1e3, 1e9, 1e100}) {
    const ModelProblem problem = model_problem(TractionBound::elliptic, w, 0);
    const auto solution = solve_tracked(problem, 10, 0.5);
    expect_contact_conditions(problem, solution);
    for (int i = 1; i < 10; ++i) EXPECT_EQ(solution.displacement[i], -problem.bound(solution.x[i]));
  }
}

TEST(ModelProblem, RefusesWhatMakesNoSense) {
  const ModelProblem good = model_cases()[0].problem();
  expect_error([&] { solve_backward_euler(good, 0); }, "mx", "in [1, 1e+07]");
  expect_error([&] { solve_theta_method(good, 10, 0.4); }, "theta", "in [0.5, 1]");
  expect_error([&] { solve_tracked(good, 10, std::numeric_limits<double>::quiet_NaN()); }, "theta", "in [0.5, 1]");

  const auto nan = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  ModelProblem bad = good;
  bad.rigid_slip = nan;
  expect_error([&] { solve_tracked(bad, 10, 0.5); }, "rigid_slip", "finite");
  bad = good;
  bad.bound = [](double x) { return -x; };
  expect_error([&] { solve_tracked(bad, 10, 0.5); }, "bound", "not negative");
  bad = good;
  bad.bound_slope = nan;
  expect_error([&] { solve_tracked(bad, 10, 0.5); }, "bound_slope", "a number");
  bad.bound_slope = nullptr;
  EXPECT_THROW(solve_tracked(bad, 10, 0.5), Error);
}

} // namespace
} // namespace microslip
