// Long work tells of its progress and may be ended: what it returns then says so.

#include "microslip/progress.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/elliptic_contact.hpp"
#include "steel_contact.hpp"

#include <algorithm>
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
    EllipticContactSolver solver({.mx = 16, .my = 16, .discretisation = discretisation});
    for (const auto kind : {ContactMotion::steady, ContactMotion::shift, ContactMotion::transient}) {
      EllipticContact moved = contact();
      if (kind == ContactMotion::shift) moved.creepage = {5e-6, 3e-6, 0};
      expect_heard([&](const Progress& progress) {
        return solver.solve(moved, {.kind = kind, .steps = 5}, progress).report.status;
      });
    }
  }
}

TEST(Progress, TransientRollingKeepsTheStepsSoFar) {
  EllipticContactSolver solver({.mx = 12, .my = 12});
  const ExactMotion motion{.kind = ContactMotion::transient, .steps = 6};
  const auto whole = solver.solve(contact(), motion);
  Listener listener(4);
  const auto part = solver.solve(contact(), motion, listener.progress());
  EXPECT_EQ(part.report.status, Status::not_converged);
  EXPECT_EQ(listener.told, (std::vector<double>{1.0 / 6, 2.0 / 6, 3.0 / 6, 4.0 / 6}));
  ASSERT_EQ(part.history.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(part.history[i].totals.fx, whole.history[i].totals.fx);
    EXPECT_EQ(part.history[i].report.status, Status::ok);
  }
  EXPECT_EQ(part.totals.fx, whole.history[3].totals.fx);
  Listener last(6); // all steps are done
  EXPECT_EQ(solver.solve(contact(), motion, last.progress()).report.status, Status::ok);
}

TEST(Progress, TransientRollingWithFallingFriction) {
  auto falling = contact();
  falling.friction = FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 0.1});
  ExactOptions options{.mx = 10, .my = 10};
  options.friction_memory = {1e-3, 1e-3};
  EllipticContactSolver solver(options);
  const ExactMotion motion{.kind = ContactMotion::transient, .steps = 4};
  expect_heard([&](const Progress& progress) { return solver.solve(falling, motion, progress).report.status; });
}

TEST(Progress, OfDerivatives) {
  EllipticContactSolver solver({.mx = 16, .my = 16});
  expect_heard(
      [&](const Progress& progress) { return solver.differentiate(contact(), progress).solution.report.status; });
}

/// The contact above on a grid.
struct OnGrid {
  CombinedMaterial material{82e9, 0.28, 0};
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
      return problem.solve(bound, input).forces.status;
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
