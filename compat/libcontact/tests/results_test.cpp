// What calls that are refused leave in the arrays for results, for programs that look at no code: zeros, and one
// element where there is no potential contact.

#include "compat/libcontact/tests/library_test.hpp"

#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

constexpr double untouched = -12345;

class RefusedResults : public LibraryTest {
protected:
  /// Of functions that return numbers one by one.
  template <class... Places> void expect_zeros(int (*getter)(int*, int*, Places...), int ire, int icp) {
    Values values(sizeof...(Places), untouched);
    const auto call = [&]<std::size_t... k>(std::index_sequence<k...>) {
      return getter(&ire, &icp, &values[k]...);
    };
    EXPECT_LT(call(std::index_sequence_for<Places...>()), 0);
    EXPECT_EQ(values, Values(sizeof...(Places), 0));
  }
  /// Of functions that fill arrays; what lies behind the length stays.
  template <class... Places> void expect_zeros_in_arrays(int (*getter)(int*, int*, int*, Places...), int ire, int icp) {
    constexpr std::size_t count = sizeof...(Places);
    int length = 6;
    std::vector<Values> arrays(count, Values(7, untouched));
    const auto call = [&]<std::size_t... k>(std::index_sequence<k...>) {
      return getter(&ire, &icp, &length, arrays[k].data()...);
    };
    EXPECT_LT(call(std::index_sequence_for<Places...>()), 0);
    for (const Values& values : arrays) EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
  }

  void expect_nothing_of(int ire, int icp) {
    expect_zeros(cntc_getreferencevelocity, ire, icp);
    expect_zeros(cntc_getgriddiscretization, ire, icp);
    expect_zeros(cntc_getpenetration, ire, icp);
    expect_zeros(cntc_getcreepages, ire, icp);
    expect_zeros(cntc_getcontactforces, ire, icp);
    expect_zeros(cntc_getcontactpatchareas, ire, icp);
    expect_zeros(cntc_getmaximumpressure, ire, icp);
    expect_zeros(cntc_getmaximumtraction, ire, icp);
    expect_zeros(cntc_getmaximumtemperature, ire, icp);
    expect_zeros_in_arrays(cntc_gethertzcontact, ire, icp);
    expect_zeros_in_arrays(cntc_getglobalforces, ire, icp);
    expect_zeros_in_arrays(cntc_getcontactlocation, ire, icp);
    expect_zeros_in_arrays(cntc_gettractions, ire, icp);
    expect_zeros_in_arrays(cntc_getmicroslip, ire, icp);
    expect_zeros_in_arrays(cntc_getdisplacements, ire, icp);
    int mx = -1, my = -1, six = 6, task = 2, block = 1, x = 7, y = 7, z = 7, columns[2] = {7, 8}, two = 2, three = 3;
    EXPECT_LT(cntc_getnumelements(&ire, &icp, &mx, &my), 0);
    EXPECT_EQ(std::pair(mx, my), std::pair(1, 1)) << "programs divide by them";
    Values values(7, untouched);
    EXPECT_LT(cntc_getpotcontact(&ire, &icp, &six, values.data()), 0);
    EXPECT_EQ(values, (Values{1, 1, 0, 0, 0, 0, untouched}));
    values.assign(7, untouched);
    EXPECT_LT(cntc_getparameters(&ire, &icp, &task, &six, values.data()), 0);
    EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
    values.assign(7, untouched);
    task = CNTC_fld_pn;
    EXPECT_LT(cntc_getfielddata(&ire, &icp, &task, &six, values.data()), 0);
    EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
    std::vector<int> division(7, -1);
    EXPECT_LT(cntc_getelementdivision(&ire, &icp, &six, division.data()), 0);
    EXPECT_EQ(division, (std::vector<int>{0, 0, 0, 0, 0, 0, -1}));
    values.assign(7, untouched);
    EXPECT_LT(cntc_getsensitivities(&ire, &icp, &two, &three, values.data()), 0);
    EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
    EXPECT_LT(subs_getblocksize(&ire, &icp, &block, &x, &y, &z), 0);
    EXPECT_EQ((std::vector<int>{x, y, z}), std::vector<int>(3, -1)) << "as in CONTACT";
    values.assign(7, untouched);
    EXPECT_LT(subs_getresults(&ire, &icp, &block, &three, &two, columns, values.data()), 0);
    EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
  }
};

TEST_F(RefusedResults, OfNoElement) {
  expect_nothing_of(1000, 1);
  int ire = 1000, six = 6, patches = 7, code = CNTC_ic_tang, one = 1, value = 7;
  for (const auto getter : {cntc_getwheelsetposition, cntc_getwheelsetvelocity}) {
    Values values(7, untouched);
    EXPECT_LT(getter(&ire, &six, values.data()), 0);
    EXPECT_EQ(values, (Values{0, 0, 0, 0, 0, 0, untouched}));
  }
  EXPECT_LT(cntc_getnumcontactpatches(&ire, &patches), 0);
  EXPECT_EQ(patches, 0);
  EXPECT_LT(cntc_getflags(&ire, &one, &one, &code, &value), 0);
  EXPECT_EQ(value, 0);
  expect_zeros(cntc_getcalculationtime, 1000, 1);
  Values values(3, untouched);
  int task = 1, none = 0, two = 2;
  EXPECT_LT(cntc_getprofilevalues(&ire, &task, &none, nullptr, &none, nullptr, &two, values.data()), 0);
  EXPECT_EQ(values, (Values{0, 0, untouched}));
}

TEST_F(RefusedResults, BeforeThereIsASolution) {
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  expect_nothing_of(3, 1);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  expect_nothing_of(1, 1);
}

TEST_F(RefusedResults, AfterACalculationThatWasRefused) {
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set(cntc_setwheelsetposition, 1, 2, {0, 900, 0, 0, 0, 0}), 0);
  ASSERT_EQ(calculate(1), CNTC_err_search);
  expect_nothing_of(1, 1);
}

TEST_F(RefusedResults, OfLengthsThatNoArrayHas) {
  int ire = 3, icp = 1, length = std::numeric_limits<int>::max(), code = CNTC_fld_pn;
  double value = untouched;
  EXPECT_EQ(cntc_getfielddata(&ire, &icp, &code, &length, &value), CNTC_err_icp);
  EXPECT_EQ(value, untouched);
  Values values(11, untouched);
  EXPECT_EQ(cntc_gethertzcontact(&ire, &icp, &length, values.data()), CNTC_err_icp);
  EXPECT_EQ(values.back(), untouched) << "there are ten numbers";
  EXPECT_EQ(cntc_getsensitivities(&ire, &icp, &length, &length, &value), CNTC_err_icp);
  EXPECT_EQ(value, untouched);
}

TEST_F(RefusedResults, OfFlagsThatDoNotExist) {
  ASSERT_EQ(initialize(3, 3), 0);
  int ire = 3, icp = 1, three = 3, codes[3] = {1234, CNTC_ic_tang, 0}, values[3] = {7, 7, 7};
  EXPECT_EQ(cntc_getflags(&ire, &icp, &three, codes, values), CNTC_err_other);
  EXPECT_EQ(std::vector<int>(values, values + 3), (std::vector<int>{0, 3, 7})) << "a place that is not asked for";
}

/// A calculation that does not happen leaves the last one's results whole.
TEST_F(RefusedResults, LeaveTheLastSolution) {
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_sens, 2), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  const auto sensitivities = [] {
    int ire = 3, icp = 1, four = 4;
    Values values(16, untouched);
    EXPECT_EQ(cntc_getsensitivities(&ire, &icp, &four, &four, values.data()), 0);
    return values;
  };
  const Values wanted = sensitivities(), forces = scalars(cntc_getcontactforces, 3, 1);
  ASSERT_GT(wanted[0], 0);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_bound, 2), 0); // Hertz's pressure without Hertz's geometry
  ASSERT_EQ(calculate(3, 1), CNTC_err_discr);
  EXPECT_EQ(sensitivities(), wanted);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_bound, 0), 0);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_return, 3), 0);
  ASSERT_EQ(calculate(3, 1), 0) << "skipped";
  EXPECT_EQ(sensitivities(), wanted);
  EXPECT_EQ(scalars(cntc_getcontactforces, 3, 1), forces);
}

TEST_F(RefusedResults, WithNullPointersHaveCodes) {
  ASSERT_EQ(initialize(1, 1), 0);
  EXPECT_LT(cntc_calculate(nullptr, nullptr, nullptr), 0);
  EXPECT_LT(cntc_setflags(nullptr, nullptr, nullptr, nullptr, nullptr), 0);
  int one = 1, minus = -1;
  EXPECT_LT(cntc_setflags(&one, &minus, nullptr, nullptr, nullptr), 0);
  EXPECT_LT(cntc_setprofileinputfname(&one, nullptr, &one, nullptr, nullptr, nullptr, nullptr), 0);
  EXPECT_LT(cntc_getglobalforces(&one, &minus, &one, nullptr), 0);
  EXPECT_LT(cntc_getnumcontactpatches(&one, nullptr), 0);
  EXPECT_LT(cntc_setverticalforce(&one, nullptr), 0);
  EXPECT_LT(cntc_finalize(nullptr), 0);
  EXPECT_EQ(cntc_initializefirst(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr), 0)
      << "it has begun already";
}

} // namespace
} // namespace microslip::libcontact
