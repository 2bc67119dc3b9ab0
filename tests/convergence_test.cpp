#include "microslip/simplified/row_solver.hpp"
#include "tests/test_cases.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::vector<ContactForces> solve(MarchingScheme scheme, SimplifiedOptions options, int n,
                                 const std::vector<EllipticContact>& contacts) {
  options.mx = options.my = n;
  RowSolver solver(scheme, options);
  std::vector<ContactForces> forces(contacts.size());
  solver.solve(contacts, forces);
  return forces;
}

/// Test cases that are partly in adhesion and partly in slip.
std::vector<EllipticContact> partial_slip_cases() {
  const auto cases = every_nth_case(11);
  const auto forces = solve(MarchingScheme::fastsim2, {}, 40, cases);
  std::vector<EllipticContact> partial;
  for (std::size_t k = 0; k < cases.size(); ++k)
    if (forces[k].slip_area > 0 && forces[k].adhesion_area > 0) partial.push_back(cases[k]);
  return partial;
}

/// Roots of the mean square errors of Fx, Fy over mu Fn and Mz over mu Fn c.
using Errors = std::array<double, 3>;
Errors rms(const std::vector<ContactForces>& forces, const std::vector<ContactForces>& reference,
           const std::vector<EllipticContact>& contacts) {
  Errors sum{};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double force = friction_force(contacts[k]), moment = friction_moment(contacts[k]);
    sum[0] += std::pow((forces[k].fx - reference[k].fx) / force, 2);
    sum[1] += std::pow((forces[k].fy - reference[k].fy) / force, 2);
    sum[2] += std::pow((forces[k].mz - reference[k].mz) / moment, 2);
  }
  for (double& error : sum) error = std::sqrt(error / static_cast<double>(contacts.size()));
  return sum;
}

/// Mean factors by which the errors fall when cells are halved, from 20 x 20 to 160 x 160.
Errors mean_ratios(MarchingScheme scheme, const SimplifiedOptions& options,
                   const std::vector<EllipticContact>& contacts, const std::vector<ContactForces>& reference) {
  const Errors coarse = rms(solve(scheme, options, 20, contacts), reference, contacts);
  const Errors fine = rms(solve(scheme, options, 160, contacts), reference, contacts);
  Errors ratios{};
  for (int n = 0; n < 3; ++n) ratios[n] = std::cbrt(coarse[n] / fine[n]);
  return ratios;
}

/// Order 2 for FASTSIM2 under the parabolic bound. The elliptic one, whose slope is infinite at the edges, leaves
/// between 3/2 and 2.
TEST(Convergence, HasTheOrderOfTheScheme) {
  struct Range {
    double low, high;
  };
  const auto contacts = partial_slip_cases();
  ASSERT_GT(contacts.size(), 100U);
  for (const auto bound : all_bounds)
    for (const auto model : all_flexibility_models) {
      const SimplifiedOptions options{.bound = bound, .flexibility = model};
      const auto reference = solve(MarchingScheme::fastsim2, options, 640, contacts);
      for (const auto scheme : all_schemes) {
        SCOPED_TRACE(describe(RowSolver(scheme, options)));
        const Range second_order = bound == TractionBound::parabolic ? Range{3.5, 4.5} : Range{2.6, 4};
        const auto& [low, high] = scheme == MarchingScheme::fastsim2 ? second_order : Range{1.7, 2.1};
        for (const double ratio : mean_ratios(scheme, options, contacts, reference)) {
          EXPECT_GT(ratio, low);
          EXPECT_LT(ratio, high);
        }
      }
    }
}

/// Half a first step, with the rigid slip in the middle of the steps, at least halves FASTSIM's error. FASTSIM2 on
/// 10 x 10 cells is better than FASTSIM on 80 x 80.
TEST(Convergence, BetterSchemesHaveSmallerErrors) {
  const auto contacts = partial_slip_cases();
  const SimplifiedOptions options;
  const auto reference = solve(MarchingScheme::fastsim2, options, 640, contacts);
  const auto error = [&](MarchingScheme scheme, int n) {
    return rms(solve(scheme, options, n, contacts), reference, contacts);
  };
  for (const int n : {5, 10, 20, 40, 80}) {
    const Errors full = error(MarchingScheme::fastsim, n), half = error(MarchingScheme::fastsim_half_step, n);
    for (int k = 0; k < 3; ++k) EXPECT_LT(half[k], 0.5 * full[k]) << n << " x " << n;
  }
  const Errors tracked = error(MarchingScheme::fastsim2, 10), fine = error(MarchingScheme::fastsim, 80);
  for (int k = 0; k < 3; ++k) EXPECT_LT(tracked[k], fine[k]);
}

TEST(Convergence, SchemesTendToTheSameForces) {
  const auto contacts = partial_slip_cases();
  for (const auto model : all_flexibility_models) {
    const SimplifiedOptions options{.flexibility = model};
    const auto reference = solve(MarchingScheme::fastsim2, options, 320, contacts);
    for (const auto scheme : {MarchingScheme::fastsim, MarchingScheme::fastsim_half_step})
      for (const double error : rms(solve(scheme, options, 320, contacts), reference, contacts))
        EXPECT_LT(error, 0.002);
  }
}

} // namespace
} // namespace microslip
