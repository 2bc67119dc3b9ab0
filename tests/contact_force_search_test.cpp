// The search for the depth at which a wheel bears a force.

#include "compat/contact/wheel_rail/force_search.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// How many forces, over the depth in mm, are computed until they are met to `tolerance`; -1 if it gives up.
int steps_to(double target, double start, double tolerance, const std::function<double(double)>& force) {
  ForceSearch search(target, 0);
  constexpr double mm = 1e-3;
  double z = start * mm;
  for (int k = 1; k <= 60; ++k) {
    const double f = force(z / mm);
    if (std::abs(f - target) < tolerance * target) return k;
    search.add(z, f);
    const auto next = search.next();
    if (!next) return -1;
    z = *next;
  }
  return -1;
}

TEST(ContactForceSearch, HertzianForcesTakeTwoSteps) {
  for (const double start : {0.05, 0.5, 0.95, 1.1, 2.0})
    EXPECT_LE(steps_to(1e4, start, 1e-9, [](double z) { return z > 0 ? 1e4 * std::pow(z, 1.5) : 0; }), 4) << start;
}

TEST(ContactForceSearch, ASecondPatchThatComesInIsFound) {
  const auto force = [](double z) { return 1e4 * (std::pow(z, 1.5) + (z > 0.5 ? 9 * std::pow(z - 0.5, 1.5) : 0)); };
  for (const double start : {0.1, 0.45, 0.6, 1.5}) EXPECT_GT(steps_to(8e3, start, 1e-9, force), 0) << start;
}

TEST(ContactForceSearch, GivesUpAtAJump) {
  const auto force = [](double z) { return z < 0.3 ? 1.0 : 3.0; };
  EXPECT_EQ(steps_to(2, 0.1, 1e-9, force), -1);
}

} // namespace
} // namespace microslip::contact_program
