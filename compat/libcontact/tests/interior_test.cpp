// Displacements and stresses inside the bodies.

#include "compat/libcontact/tests/library_test.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

int add_block(int ire, int icp, int number, int kind, Values x, Values y, Values z) {
  int nx = size_of(x), ny = size_of(y), nz = size_of(z);
  return subs_addblock(&ire, &icp, &number, &kind, &nx, &ny, &nz, x.data(), y.data(), z.data());
}
int calculate_interior(int ire, int icp) {
  int error = 1;
  return subs_calculate(&ire, &icp, &error);
}
/// Columns one behind the other.
Values results(int ire, int icp, int number, std::vector<int> columns, int length) {
  Values values(columns.size() * static_cast<std::size_t>(length), 12345);
  int count = size_of(columns);
  if (subs_getresults(&ire, &icp, &number, &length, &count, columns.data(), values.data()) < 0) return {};
  return values;
}

using Interiors = LibraryTest;

TEST_F(Interiors, BeginWithThePressure) {
  ASSERT_EQ(initialize(1, 3), 0);
  ASSERT_EQ(set_up_sphere(1, 1), 0);
  ASSERT_EQ(calculate(1, 1), 0);
  ASSERT_EQ(add_block(1, 1, 1, 9, {0}, {0}, {0.5, 1e-6, 40}), 0);
  ASSERT_EQ(calculate_interior(1, 1), 0) << library_.log();
  int ire = 1, number = 1, nx = 0, ny = 0, nz = 0;
  ASSERT_EQ(subs_getblocksize(&ire, &ire, &number, &nx, &ny, &nz), 0);
  EXPECT_EQ(nx * 100 + ny * 10 + nz, 113);
  const Values found = results(1, 1, 1, {3, 21, 8, 99}, 3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], (Values{1e-6, 0.5, 40})[k], 1e-12) << "depths are sorted";
  const double pressure = scalars(cntc_getmaximumpressure, 1, 1)[0];
  EXPECT_NEAR(found[3], -pressure, 1e-3 * pressure) << "sigma_zz at the surface";
  EXPECT_NEAR(found[5], -3 * 1000 / (2 * std::numbers::pi * 1600), 0.02 * 0.3) << "Boussinesq far below";
  EXPECT_GT(found[7], found[8]);
  EXPECT_EQ(found[9], -999) << "a column that does not exist";
}

/// What lies below a left wheel is the mirror image of what lies below a right one.
TEST_F(Interiors, AreMirroredBelowLeftWheels) {
  for (const bool is_right : {false, true}) {
    const int ire = is_right ? 2 : 1;
    ASSERT_EQ(initialize(ire, 1), 0);
    ASSERT_EQ(set_up_wheel(ire, is_right), 0);
    ASSERT_EQ(set(cntc_setwheelsetposition, ire, 2, {0, is_right ? 3.0 : -3.0, 0, 0, 0, 0}), 0);
    ASSERT_EQ(set(cntc_setwheelsetvelocity, ire, 2, {30e3, 0, 0, 0, 0, -65}), 0);
    ASSERT_EQ(calculate(ire), 0);
    ASSERT_EQ(add_block(ire, whole, 1, 9, {0, 1}, {is_right ? 0.7 : -0.7}, {0.5}), 0);
    ASSERT_EQ(add_block(ire, whole, 2, 1, {}, {}, {2, 0.1, 0.5}), 0);
    ASSERT_EQ(calculate_interior(ire, whole), 0) << library_.log();
  }
  const std::vector<int> columns = {2, 4, 5, 8, 16};
  const Values left = results(1, 1, 1, columns, 2), right = results(2, 1, 1, columns, 2);
  const double signs[] = {-1, 1, -1, 1, -1};
  for (std::size_t k = 0; k < left.size(); ++k)
    EXPECT_NEAR(left[k], signs[k / 2] * right[k], 1e-9 + 1e-6 * std::abs(right[k])) << k;
  int ire = 1, icp = 1, number = 2, nx = 0, ny = 0, nz = 0;
  ASSERT_EQ(subs_getblocksize(&ire, &icp, &number, &nx, &ny, &nz), 0);
  EXPECT_EQ(nx * ny, elements(1, 1));
  EXPECT_EQ(nz, 2);
}

TEST_F(Interiors, PatchesMayHavePointsOfTheirOwn) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  ASSERT_EQ(add_block(1, whole, 1, 9, {0}, {0}, {1}), 0);
  ASSERT_EQ(add_block(1, 1, 1, 9, {0}, {0}, {2}), 0);
  ASSERT_EQ(calculate_interior(1, 1), 0);
  EXPECT_EQ(results(1, 1, 1, {3}, 1), Values{2});
  ASSERT_EQ(add_block(1, 1, 0, 0, {}, {}, {}), 0) << "none any more";
  ASSERT_EQ(calculate_interior(1, 1), 0);
  EXPECT_EQ(results(1, 1, 1, {3}, 1), Values{1});
}

} // namespace
} // namespace microslip::libcontact
