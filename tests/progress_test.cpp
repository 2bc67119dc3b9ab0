// Long work tells of its progress and may be ended: what it returns then says so.

#include "microslip/progress.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A progress function that remembers what it was told and ends the work at some call; 0: never.
class Listener {
public:
  explicit Listener(std::size_t last = 0) : last_(last) {}
  Progress progress() {
    return [this](double fraction) {
      told.push_back(fraction);
      return told.size() != last_;
    };
  }

  std::vector<double> told;

private:
  std::size_t last_;
};

/// `solve(progress)` returns a status. It must be ok with a listener that only listens, who is told of fractions from 0
/// to 1, and not_converged with one who ends the work at its second call: no further one comes.
template <class Solve> void expect_heard(const Solve& solve) {
  Listener patient, impatient(2);
  EXPECT_EQ(solve({}), Status::ok); // what is kept for the next solve is there then
  EXPECT_EQ(solve(patient.progress()), Status::ok);
  ASSERT_GE(patient.told.size(), 3u);
  EXPECT_GE(*std::min_element(patient.told.begin(), patient.told.end()), 0);
  EXPECT_LE(*std::max_element(patient.told.begin(), patient.told.end()), 1);
  EXPECT_EQ(solve(impatient.progress()), Status::not_converged);
  ASSERT_EQ(impatient.told.size(), 2u);
  EXPECT_EQ(impatient.told[1], patient.told[1]);
  EXPECT_EQ(solve({}), Status::ok); // the solver is as good as before
}

EllipticContact contact() {
  return steel_contact(5e-3, 6e-3, 0.4, -0.5, 0.3);
}

TEST(Progress, OfHertzianContacts) {
  for (const auto discretisation : {Discretisation::second_order, Discretisation::classical}) {
    Solver solver({.mx = 16, .my = 16, .discretisation = discretisation});
    for (const auto kind : {ContactMotion::steady, ContactMotion::shift, ContactMotion::transient}) {
      EllipticContact moved = contact();
      if (kind == ContactMotion::shift) moved.creepage = {5e-6, 3e-6, 0};
      expect_heard([&](const Progress& progress) {
        return solver.solve(rolling_problem(moved, {.kind = kind, .steps = 5}), progress).report.status;
      });
    }
  }
}

TEST(Progress, TransientRollingKeepsTheStepsSoFar) {
  Solver solver({.mx = 12, .my = 12});
  const Motion motion{.kind = ContactMotion::transient, .steps = 6};
  const auto whole = solver.solve(rolling_problem(contact(), motion));
  for (const double end : {4.01 / 6, 4.3 / 6, 4.999 / 6}) { // within the fifth step
    const auto part = solver.solve(rolling_problem(contact(), motion), [&](double fraction) { return fraction < end; });
    EXPECT_EQ(part.report.status, Status::not_converged);
    ASSERT_EQ(part.history.size(), 4u) << end;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(part.history[i].totals.fx, whole.history[i].totals.fx);
      EXPECT_EQ(part.history[i].report.status, Status::ok);
    }
    EXPECT_EQ(part.totals.fx, whole.history[3].totals.fx);
    EXPECT_EQ(part.fields.traction.x,
              solver.solve(rolling_problem(contact(), {.kind = motion.kind, .steps = 4})).fields.traction.x);
  }
  const auto nothing = solver.solve(rolling_problem(contact(), motion), [](double) { return false; });
  EXPECT_EQ(nothing.report.status, Status::not_converged);
  EXPECT_TRUE(std::isnan(nothing.totals.fx));
  Listener listener; // after its last step work cannot be ended any more
  solver.solve(rolling_problem(contact(), motion), listener.progress());
  Listener last(listener.told.size());
  EXPECT_EQ(solver.solve(rolling_problem(contact(), motion), last.progress()).report.status, Status::ok);
}

TEST(Progress, TransientRollingWithFallingFriction) {
  auto falling = contact();
  falling.friction = FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 0.1});
  Solver solver({.mx = 10, .my = 10});
  RollingProblem problem = rolling_problem(falling, {.kind = ContactMotion::transient, .steps = 4});
  problem.friction.memory = {1e-3, 1e-3};
  expect_heard([&](const Progress& progress) { return solver.solve(problem, progress).report.status; });
  const auto solution = solver.solve(problem);
  ASSERT_EQ(solution.history.size(), 4u);
  EXPECT_EQ(solution.history[3].totals.fx, solution.totals.fx);
  EXPECT_EQ(solution.history[3].totals.peak_pressure, solution.totals.peak_pressure);
}

TEST(Progress, OfDerivatives) {
  Solver solver({.mx = 16, .my = 16});
  expect_heard([&](const Progress& progress) {
    return solver.differentiate(rolling_problem(contact()), progress).solution.report.status;
  });
}

/// `solve(progress)` is work that begins with a new grid. It must tell of its progress at least `often`, and end with
/// not_converged wherever the progress function returns false: at once while it prepares, in between, at its end.
template <class Solve> void expect_ended_anywhere(std::size_t often, const Solve& solve) {
  Listener patient;
  EXPECT_EQ(solve(patient.progress()), Status::ok);
  EXPECT_GE(patient.told.size(), often);
  for (const std::size_t last : {std::size_t(1), patient.told.size() / 3, patient.told.size() / 2,
                                 patient.told.size() * 2 / 3, patient.told.size() - 1}) {
    Listener impatient(last);
    EXPECT_EQ(solve(impatient.progress()), Status::not_converged) << last << " of " << patient.told.size();
    EXPECT_EQ(impatient.told.size(), last) << "of " << patient.told.size();
  }
}

TEST(Progress, OfPreparationsAndProducts) {
  for (const auto discretisation : {Discretisation::second_order, Discretisation::classical}) {
    const Method options{.mx = 20, .my = 20, .discretisation = discretisation};
    long products = 0;
    expect_ended_anywhere(40, [&](const Progress& progress) {
      const auto solved = Solver(options).solve(rolling_problem(contact()), progress);
      if (solved.report.status == Status::ok) products = solved.report.products;
      return solved.report.status;
    });
    Listener listener;
    Solver(options).solve(rolling_problem(contact()), listener.progress());
    // One for each product of the linear solvers and for each row of coefficients; residuals take products without.
    EXPECT_GE(listener.told.size(), static_cast<std::size_t>(products) / 2 + 20);
  }
}

TEST(Progress, OfCoarserGridsAndGivenForces) {
  const Method options{.mx = 64, .my = 64};
  Listener once;
  Solver solver(options);
  solver.solve(rolling_problem(contact()), {});
  const auto solved = solver.solve(rolling_problem(contact()), once.progress());
  EXPECT_GT(once.told.size(),
            static_cast<std::size_t>(solved.report.products) + 10); // those of the coarser grid as well
  EXPECT_TRUE(std::is_sorted(once.told.begin(), once.told.end()));
  expect_ended_anywhere(100, [&](const Progress& progress) {
    return Solver(options).solve(rolling_problem(contact(), {.force_x = 5e3}), progress).report.status;
  });
}

TEST(Progress, OfBodiesAndFrictionThatNeedASequence) {
  const Material aluminium{26e9, 0.34};
  const auto pair = combine(steel_body, aluminium);
  RollingProblem unlike = rolling_problem(contact()), retarded = unlike, layered = unlike, falling = unlike;
  unlike.bodies = Bodies(pair);
  retarded.bodies = viscoelastic(steel_body, {0.5, 1e-3}, steel_body, {}, 10);
  layered.bodies = Bodies(combine(steel_body, steel_body));
  layered.bodies.layer = {.flexibility = 1e-14};
  falling.friction.law = FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 0.1});
  const auto ended_anywhere = [](const RollingProblem& problem, Coupling coupling = Coupling::newton) {
    expect_ended_anywhere(60, [&](const Progress& progress) {
      return Solver({.mx = 12, .my = 12, .coupling = coupling}).solve(problem, progress).report.status;
    });
  };
  ended_anywhere(unlike);
  ended_anywhere(unlike, Coupling::alternating);
  ended_anywhere(retarded);
  ended_anywhere(layered);
  ended_anywhere(falling);
}

TEST(Progress, OfAccurateContacts) {
  expect_ended_anywhere(60, [&](const Progress& progress) {
    const auto solved = AccurateContactSolver({.accuracy = 1e-2}).solve(rolling_problem(contact()), progress);
    if (solved.forces.status != Status::ok && solved.elements == 0) {
      EXPECT_TRUE(std::isnan(solved.forces.fx));
    }
    return solved.forces.status;
  });
}

TEST(Progress, OfTheDeformedGap) {
  Solver solver({.mx = 16, .my = 16});
  Listener patient, impatient(10);
  const auto gap = solver.deformed_gap(rolling_problem(contact()), patient.progress());
  EXPECT_GE(patient.told.size(), 20u);
  EXPECT_THROW(solver.deformed_gap(rolling_problem(contact()), impatient.progress()), Stopped);
  EXPECT_EQ(solver.deformed_gap(rolling_problem(contact())).gap, gap.gap);
}

/// The contact above on a grid.
struct OnGrid {
  CombinedMaterial material = steel;
  EllipticContact elliptic = contact();
  ElementGrid grid = ElementGrid::across_ellipse(elliptic.a, elliptic.b, 24, 24, 4);
  std::vector<double> gap =
      hertzian_gap(hertz_from_ellipse(elliptic.a, elliptic.b, material, elliptic.normal_force).gap, grid);
  NormalLoad load{NormalLoad::Given::force, elliptic.normal_force};
};

TEST(Progress, OfTheNormalProblem) {
  const OnGrid on;
  NormalProblem problem(on.material, on.grid);
  expect_heard([&](const Progress& progress) { return problem.solve(on.gap, on.load, 1e-8, progress).status; });
}

TEST(Progress, OfTheTangentialProblem) {
  const OnGrid on;
  auto bound = NormalProblem(on.material, on.grid).solve(on.gap, on.load).pressure;
  for (double& g : bound) g *= 0.3;
  TangentialProblem problem(on.material, on.grid);
  for (const auto motion : {ContactMotion::steady, ContactMotion::transient})
    expect_heard([&](const Progress& progress) {
      TangentialInput input;
      input.motion = motion;
      input.creepage = on.elliptic.creepage;
      input.progress = progress;
      return problem.solve(bound, input).report.status;
    });
}

TEST(Progress, OfPatches) {
  const OnGrid on;
  std::optional<PatchRolling> rolling;
  expect_heard([&](const Progress& progress) {
    rolling.emplace(on.material, on.grid, on.gap, on.load, RollingDirection::forward, progress);
    return rolling->solve({.friction = 0.3, .creepage = on.elliptic.creepage}).report.status;
  });
  expect_heard([&](const Progress& progress) {
    return rolling->solve({.friction = 0.3, .creepage = on.elliptic.creepage, .progress = progress}).report.status;
  });
}

} // namespace
} // namespace microslip
