// The same problem in CONTACT's, Simpack's and SI units.

#include "compat/libcontact/tests/calls.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

constexpr double mm = 1e-3, newton_per_mm2 = 1e6;

void expect_scaled(const Values& found, const Values& wanted, const Values& factors) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], wanted[k] * factors[k], 1e-6 * std::abs(wanted[k] * factors[k]) + 1e-15) << k;
}

class InUnits : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override { ASSERT_EQ(library_.code, 0); }
  double body() const { return GetParam() == CNTC_un_spck ? -1 : 1; }

  TemporaryFolder folder_;
  Library library_{folder_.path()};
};

INSTANTIATE_TEST_SUITE_P(Of, InUnits, ::testing::Values(CNTC_un_spck, CNTC_un_si),
                         [](const auto& unit) { return unit.param == CNTC_un_spck ? "Simpack" : "Si"; });

TEST_P(InUnits, ContactsAreTheSame) {
  for (const int ire : {1, 2}) ASSERT_EQ(initialize(ire, 3), 0);
  ASSERT_EQ(set_up_sphere(1, 1), 0);
  ASSERT_EQ(set_flag(2, 1, CNTC_if_units, GetParam()), 0);
  ASSERT_EQ(set_flag(2, 1, CNTC_ic_tang, 3), 0);
  ASSERT_EQ(set(cntc_setmaterialparameters, 2, 1, 0, {0.28, 0.28, 82e9, 82e9}), 0);
  ASSERT_EQ(set(cntc_setfrictionmethod, 2, 1, 4, {0.2, 0.1, 0.05, 0, 1, 1e-6, 1e-2}), 0);
  ASSERT_EQ(set(cntc_setfrictionmethod, 1, 1, 4, {0.2, 0.1, 50, 0, 1000, 1e-3, 10}), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 2, 1, 1, {21, 21, -1.05 * mm, -1.05 * mm, 0.1 * mm, 0.1 * mm}), 0);
  ASSERT_EQ(set(cntc_setundeformeddistc, 2, 1, 1, {0.005 / mm, 0, 0.005 / mm, 0, 0, 0}), 0);
  ASSERT_EQ(set(cntc_setreferencevelocity, 2, 1, 1), 0);
  ASSERT_EQ(set(cntc_setrollingstepsize, 2, 1, 0, 0.2 * mm), 0);
  ASSERT_EQ(set(cntc_setnormalforce, 2, 1, 1000), 0);
  ASSERT_EQ(set(cntc_setcreepages, 2, 1, 1e-3, -5e-4, 1e-4 / mm), 0);
  for (const int element : {1, 2}) {
    ASSERT_EQ(set_flag(element, 1, CNTC_ic_sens, 2), 0);
    ASSERT_EQ(calculate(element, 1), 0) << library_.log();
  }
  const double b = body();
  const auto compare = [&](auto getter, const Values& factors) {
    expect_scaled(scalars(getter, 2, 1), scalars(getter, 1, 1), factors);
  };
  compare(cntc_getcontactforces, {1, b, b, b * mm});
  compare(cntc_getcreepages, {b, b, b / mm});
  compare(cntc_getpenetration, {mm});
  compare(cntc_getcontactpatchareas, {mm * mm, mm * mm, mm * mm});
  compare(cntc_getmaximumpressure, {newton_per_mm2});
  compare(cntc_getreferencevelocity, {mm});
  for (const auto& [code, factor] : {std::pair{int(CNTC_fld_pn), newton_per_mm2},
                                     {int(CNTC_fld_px), b * newton_per_mm2},
                                     {int(CNTC_fld_h), mm},
                                     {int(CNTC_fld_ux), mm},
                                     {int(CNTC_fld_sx), b},
                                     {int(CNTC_fld_mu), 1.0}})
    expect_scaled(field(2, 1, code, 441), field(1, 1, code, 441), Values(441, factor));
  int one = 1, two = 2;
  double of_one = 0, of_two = 0;
  ASSERT_EQ(cntc_getsensitivities(&one, &one, &one, &one, &of_one), 0);
  ASSERT_EQ(cntc_getsensitivities(&two, &one, &one, &one, &of_two), 0);
  EXPECT_NEAR(of_two, of_one / mm, 1e-4 * of_two);
}

TEST_P(InUnits, WheelsAreTheSame) {
  for (const int ire : {1, 2}) {
    ASSERT_EQ(initialize(ire, 1), 0);
    ASSERT_EQ(set_up_wheel(ire, true), 0);
  }
  ASSERT_EQ(set_flag(2, whole, CNTC_if_units, GetParam()), 0);
  ASSERT_EQ(set(cntc_setmaterialparameters, 2, whole, 0, {0.28, 0.28, 82e9, 82e9}), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 2, whole, -1, {0.5 * mm, 0.5 * mm, 1.5707963267948966, 8 * mm, 4 * mm}), 0);
  ASSERT_EQ(set(cntc_settrackdimensions, 2, 3, {14 * mm, 0, 1435 * mm, 0.05, 0, 0, 0, 0, 0, 0, 0}), 0);
  ASSERT_EQ(set(cntc_setwheelsetdimensions, 2, 3, {1360 * mm, -70 * mm, 460 * mm}), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(set(cntc_setwheelsetposition, 2, 2, {0, 3 * mm, 0, -3e-4, 6e-3, 0}), 0);
  ASSERT_EQ(set(cntc_setwheelsetvelocity, 2, 2, {30, 0, 0, 0, 0, -30e3 / 460.3}), 0);
  for (const int ire : {1, 2}) ASSERT_EQ(calculate(ire), 0) << library_.log();
  const double b = body();
  Values factors;
  for (int axes = 0; axes < 4; ++axes) factors.insert(factors.end(), {b, b, b, b * mm, b * mm, b * mm});
  expect_scaled(list(cntc_getglobalforces, 2, whole, 24), list(cntc_getglobalforces, 1, whole, 24), factors);
  const Values there = list(cntc_getcontactlocation, 2, 1, 38), here = list(cntc_getcontactlocation, 1, 1, 38);
  EXPECT_NEAR(there[1], here[1] * mm, 1e-9);
  EXPECT_NEAR(there[3], here[3], 1e-9) << "angles are the same";
}

} // namespace
} // namespace microslip::libcontact
