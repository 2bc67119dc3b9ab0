// FaStrip on the rows of a grid, against linear theory, full sliding and FaStrip on the rows of an ellipse.

#include "microslip/simplified/grid_fastrip.hpp"

#include "microslip/friction/traction_bound.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

ContactSolution solve(const EllipticContact& contact, FastripForm form, int elements,
                      RollingDirection direction = RollingDirection::forward) {
  const ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, elements);
  const Field pressure = over_grid(grid, [&](double x, double y) {
    return traction_bound(TractionBound::elliptic, contact.a, contact.b, contact.normal_force, 1, x, y);
  });
  const Flexibilities l = flexibilities(FlexibilityModel::blended, {}, contact);
  return solve_fastrip(GridFastsim(grid, pressure), form, contact, l, std::vector{0.3},
                       {.creepage = contact.creepage, .direction = direction});
}

TEST(GridFastrip, TendsToFastripOnAnEllipse) {
  for (const Creepage& c : {Creepage{6e-4, -8e-4, 0.2}, {2e-4, 0, 0}, {-1e-3, 1e-4, 0.1}}) {
    const EllipticContact contact = steel_contact(6e-3, 4e-3, 8e4, c);
    SimplifiedOptions options;
    options.mx = options.my = 200;
    options.bound = TractionBound::elliptic;
    options.flexibility = FlexibilityModel::blended;
    const ContactForces own = Fastrip(options).solve(contact);
    const ContactSolution s = solve(contact, FastripForm::first, 200);
    EXPECT_NEAR(s.totals.fx / 2.4e4, own.fx / 2.4e4, 5e-3);
    EXPECT_NEAR(s.totals.fy / 2.4e4, own.fy / 2.4e4, 5e-3);
    const ContactSolution modified = solve(contact, FastripForm::modified, 200);
    EXPECT_NEAR(modified.totals.fx / 2.4e4, own.fx / 2.4e4, 5e-3);
    EXPECT_NEAR(modified.totals.fy / 2.4e4, own.fy / 2.4e4, 5e-3);
  }
}

/// Fx = -G ab C11 xi.
TEST(GridFastrip, LinearTheory) {
  const EllipticContact contact = steel_contact(6e-3, 4e-3, 8e4, {1e-8, 0, 0});
  const double linear = -82e9 * 24e-6 * creepage_coefficients(1.5, 0.28).c11 * 1e-8;
  EXPECT_NEAR(solve(contact, FastripForm::modified, 200).totals.fx / linear, 1, 0.035); // first order in the elements
}

/// Rolling in the opposite direction is the mirror image: xi and phi turn, and so do Fx and Mz.
TEST(GridFastrip, RollingBackwardsIsTheMirror) {
  for (const auto form : {FastripForm::modified, FastripForm::first, FastripForm::first_bounded}) {
    const ContactSolution s = solve(steel_contact(4e-3, 6e-3, 8e4, {6e-4, -8e-4, 0.2}), form, 20);
    const ContactSolution back =
        solve(steel_contact(4e-3, 6e-3, 8e4, {-6e-4, -8e-4, -0.2}), form, 20, RollingDirection::backward);
    expect_forces(back.forces(), {-s.totals.fx, s.totals.fy, -s.totals.mz}, 1e-8);
  }
}

/// Sliding, for a < b: the first form raises the forces by 1 + (1 - a/b)^4, the bounded one to friction at most.
TEST(GridFastrip, FirstFormsRaiseForces) {
  const EllipticContact contact = steel_contact(4e-3, 6e-3, 8e4, {0.05, 0, 0});
  const double sliding = solve(contact, FastripForm::modified, 60).totals.fx;
  const double factor = 1 + std::pow(1 - 2.0 / 3, 4);
  EXPECT_NEAR(solve(contact, FastripForm::first, 60).totals.fx / sliding, factor, 1e-12);
  EXPECT_NEAR(solve(contact, FastripForm::first_bounded, 60).totals.fx, std::min(sliding, -2.4e4), 1e-8);
}

/// With phi' >= 1 nothing adheres in the bounded form.
TEST(GridFastrip, LargeSpinSlidesInTheBoundedForm) {
  const EllipticContact contact = steel_contact(6e-3, 4e-3, 8e4, {0, 0, 20});
  ASSERT_GT(std::abs(StripTheory(contact, 0.3, RollingDirection::forward).scaled_spin()), 1);
  const ContactSolution s = solve(contact, FastripForm::first_bounded, 40);
  EXPECT_EQ(s.totals.adhesion_area, 0);
  for (std::size_t k = 0; k < s.fields.traction.x.size(); ++k)
    EXPECT_NEAR(std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]), s.fields.bound[k], 1e-4);
}

} // namespace
} // namespace microslip
