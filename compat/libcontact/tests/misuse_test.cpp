// Calls in the wrong order, with wrong numbers, null pointers and short arrays: a code each time, why in the log, and
// what was set stays.

#include "compat/libcontact/tests/library_test.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

class Misuse : public LibraryTest {
protected:
  void expect_in_log(const std::string& text) const {
    EXPECT_NE(library_.log().find(text), std::string::npos) << text << "\n" << library_.log();
  }
};

TEST_F(Misuse, OfElementsThatAreNotThere) {
  EXPECT_EQ(finalize(1), CNTC_err_icp);
  expect_in_log("cntc_finalize: there is no result element ire = 1");
  for (const int ire : {0, -1, 1000, std::numeric_limits<int>::min()}) {
    EXPECT_EQ(initialize(ire, 1), CNTC_err_icp);
    EXPECT_EQ(set_flag(ire, whole, CNTC_ic_tang, 3), CNTC_err_icp);
    EXPECT_EQ(calculate(ire), CNTC_err_icp);
  }
  expect_in_log("cntc_calculate(1000, -1): ire = 1000: must be in 1 to 999");
  EXPECT_EQ(initialize(1, 2), CNTC_err_other);
}

TEST_F(Misuse, OfElementsOfTheOtherModule) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(initialize(3, 3), 0);
  EXPECT_EQ(initialize(1, 1), 0) << "once more, as in CONTACT";
  EXPECT_EQ(initialize(1, 3), CNTC_err_icp);
  EXPECT_EQ(set_up_sphere(1, whole), CNTC_err_discr) << "a potential contact of module 3";
  EXPECT_EQ(set(cntc_setnormalforce, 1, 1, 1), CNTC_err_icp);
  EXPECT_EQ(set_force(3, 1), CNTC_err_icp);
  EXPECT_EQ(set_flag(3, 1, CNTC_ic_config, 1), CNTC_err_other);
  for (const int icp : {0, -1, -2, 10}) EXPECT_EQ(calculate(3, icp), CNTC_err_icp) << icp;
  for (const int icp : {0, 1, -2, 10}) EXPECT_EQ(calculate(1, icp), CNTC_err_icp) << icp;
}

TEST_F(Misuse, OfResultsBeforeThereAreAny) {
  ASSERT_EQ(initialize(1, 1), 0);
  EXPECT_EQ(patches(1), 0);
  int one = 1, count = 3, error = 0;
  double values[3] = {7, 7, 7};
  EXPECT_EQ(cntc_getcontactlocation(&one, &one, &count, values), CNTC_err_icp);
  EXPECT_EQ(values[0], 0) << "zeros, as in CONTACT";
  EXPECT_EQ(cntc_getmaximumpressure(&one, &one, values + 1), CNTC_err_icp);
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(subs_calculate(&one, &one, &error), CNTC_err_icp);
  EXPECT_EQ(error, CNTC_err_icp);
  EXPECT_EQ(calculate(1), CNTC_err_profil) << "no profiles";
  expect_in_log("there is no rail profile");
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  EXPECT_EQ(calculate(1), 0) << "nothing was spoilt";
  int nine = 9;
  EXPECT_EQ(cntc_getmaximumpressure(&one, &nine, values + 1), CNTC_err_icp) << "a patch that is not there";
}

TEST_F(Misuse, AfterTheEnd) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(initialize(2, 3), 0);
  ASSERT_EQ(finalize(1), 0);
  EXPECT_EQ(finalize(1), CNTC_err_icp);
  ASSERT_EQ(finalize(2), 0) << "the last one ends the library";
  EXPECT_EQ(finalize(2), CNTC_err_icp);
  EXPECT_EQ(cntc_finalizelast(), 0);
  EXPECT_EQ(initialize(1, 1), 0) << "and it begins again";
  EXPECT_EQ(set_up_wheel(1, true), 0);
}

TEST_F(Misuse, OfNumbersOfValues) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(initialize(3, 3), 0);
  const Values few = {1, 2};
  EXPECT_EQ(set(cntc_setmaterialparameters, 1, whole, 0, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setfrictionmethod, 1, whole, 4, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setpotcontact, 1, whole, -1, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setpotcontact, 3, 1, 1, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_sethertzcontact, 3, 1, -1, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setundeformeddistc, 3, 1, 2, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_settrackdimensions, 1, 3, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetposition, 1, 2, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetvelocity, 1, 2, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetflexibility, 1, 4, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetdimensions, 1, 3, few), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetdimensions, 1, 3, {1360, -70, 1e9}), CNTC_err_other);
  expect_in_log("NOMRAD = 1e+09 mm: must be in [0.001, 1e+06]");
  EXPECT_EQ(set(cntc_setundeformeddistc, 3, 1, 9, {1}), CNTC_err_discr) << "no potential contact yet";
  expect_in_log("rparam has 2 values: must be 4");
  int one = 1, icp = whole, none = -1;
  double values[4] = {0.28, 0.28, 1, 1};
  EXPECT_EQ(cntc_setmaterialparameters(&one, &icp, &none, &none, values), CNTC_err_other) << "a length of -1";
}

TEST_F(Misuse, OfCodesThatDoNotExist) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  EXPECT_EQ(set_flag(1, whole, 1234, 1), CNTC_err_other);
  expect_in_log("there is no flag 1234");
  for (const auto& [code, value] : {std::pair{int(CNTC_ic_tang), 4},
                                    {int(CNTC_ic_config), 2},
                                    {int(CNTC_ic_bound), 1},
                                    {int(CNTC_ic_mater), 1},
                                    {int(CNTC_if_units), int(CNTC_un_imper)},
                                    {int(CNTC_ic_norm), -1}})
    EXPECT_EQ(set_flag(1, whole, code, value), CNTC_err_other) << code;
  EXPECT_EQ(set(cntc_setmaterialparameters, 1, whole, 6, {1}), CNTC_err_other);
  EXPECT_EQ(set(cntc_setfrictionmethod, 1, whole, 30, {.3, .3}), CNTC_err_frclaw);
  EXPECT_EQ(set(cntc_setfrictionmethod, 1, whole, 7, {.3, .3}), CNTC_err_frclaw);
  EXPECT_EQ(set(cntc_settrackdimensions, 1, 7, {}), CNTC_err_other);
  EXPECT_EQ(set(cntc_setwheelsetposition, 1, 9, {}), CNTC_err_other);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0) << "all of these were refused as a whole";
  EXPECT_TRUE(field(1, 1, 99, 10).empty());
  EXPECT_TRUE(field(1, 1, CNTC_fld_temp1, 10).empty()) << "no temperatures";
  int one = 1, many = 3, codes[3] = {1234, CNTC_ic_tang, 0}, values[3] = {1, 0, 99}, icp = whole;
  EXPECT_EQ(cntc_setflags(&one, &icp, &many, codes, values), CNTC_err_other);
  values[1] = 7;
  EXPECT_EQ(cntc_getflags(&one, &icp, &many, codes, values), CNTC_err_other);
  EXPECT_EQ(values[1], 0) << "the flags that exist were set, and read";
}

TEST_F(Misuse, OfNumbersThatAreNone) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(set(cntc_setwheelsetposition, 1, 2, {0, wrong, 0, 0, 0, 0}), CNTC_err_other);
    EXPECT_EQ(set_force(1, wrong), CNTC_err_other);
  }
  for (const double force : {0.0, -1.0}) {
    EXPECT_EQ(set_force(1, force), 0);
    EXPECT_EQ(calculate(1), CNTC_err_ftot);
  }
}

/// Numbers that are finite, but not what is made of them.
TEST_F(Misuse, OfNumbersThatAreTooLarge) {
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  ASSERT_EQ(set(cntc_setcreepages, 3, 1, 1e300, 0, 0), 0);
  EXPECT_EQ(calculate(3, 1), CNTC_err_other);
  expect_in_log("the forces are no numbers");
  EXPECT_EQ(scalars(cntc_getcontactforces, 3, 1), Values()) << "nor is there a solution";
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  EXPECT_EQ(calculate(3, 1), 0) << "nothing was spoilt";
}

TEST_F(Misuse, OfProfiles) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  EXPECT_EQ(set_profile(1, "not there.prr", 0), CNTC_err_profil);
  EXPECT_EQ(calculate(1), CNTC_err_profil) << "there is no profile any more";
  EXPECT_EQ(set_profile(1, profiles + "s1002.prw", 0), CNTC_err_profil) << "a wheel's as the rail's";
  EXPECT_EQ(set_profile(1, profiles + "60e1.prr", 0), 0);
  int one = 1, points = 2, none = 0;
  double values[4] = {0, 0, 1, 0};
  EXPECT_EQ(cntc_setprofileinputvalues(&one, &points, values, &none, nullptr, &none, nullptr), CNTC_err_profil)
      << "1 mm long";
}

TEST_F(Misuse, OfPlacesWhereNothingTouches) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set(cntc_setwheelsetposition, 1, 2, {0, 900, 0, 0, 0, 0}), 0);
  EXPECT_EQ(calculate(1), CNTC_err_search);
  EXPECT_EQ(patches(1), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_norm, 0), 0);
  ASSERT_EQ(set(cntc_setwheelsetposition, 1, 2, {0, 0, -20, 0, 0, 0}), 0);
  EXPECT_EQ(calculate(1), 0) << "a wheel that is lifted";
  EXPECT_EQ(patches(1), 0);
  EXPECT_EQ(list(cntc_getglobalforces, 1, whole, 3), (Values{0, 0, 0}));
}

/// Shorter than what there is: the first values; longer: the rest stays.
TEST_F(Misuse, OfShortAndLongArrays) {
  ASSERT_EQ(initialize(3, 3), 0);
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  const Values all = field(3, 1, CNTC_fld_pn, 441), some = field(3, 1, CNTC_fld_pn, 5),
               more = field(3, 1, CNTC_fld_pn, 445);
  EXPECT_EQ(some, Values(all.begin(), all.begin() + 5));
  EXPECT_EQ(Values(more.begin(), more.begin() + 441), all);
  EXPECT_EQ(more[441], -12345);
  EXPECT_EQ(field(3, 1, CNTC_fld_pn, 0), Values());
  ASSERT_EQ(set(cntc_setpotcontact, 3, 1, 1, {11, 11, -1.1, -1.1, 0.2, 0.2}), 0);
  EXPECT_EQ(elements(3, 1), 441) << "the last solution's";
}

TEST_F(Misuse, OfElementsThatAreTooSmall) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 1, whole, -1, {1e-8, 1e-8, 1.57, 8, 4}), 0);
  EXPECT_EQ(calculate(1), CNTC_err_discr);
  ASSERT_EQ(set(cntc_setpotcontact, 1, whole, -1, {1e-3, 1e-3, 1.57, 8, 4}), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_discns, 5), 0);
  EXPECT_EQ(calculate(1), CNTC_err_discr) << "by brute force";
}

TEST_F(Misuse, IsToldOnce) {
  for (int k = 0; k < 100; ++k) EXPECT_EQ(calculate(5), CNTC_err_profil);
  const std::string log = library_.log(), line = "there is no rail profile";
  EXPECT_EQ(log.find(line), log.rfind(line));
}

TEST_F(Misuse, OfWhatIsNotSupported) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_discns, 7), 0);
  EXPECT_EQ(calculate(1), CNTC_err_other);
  expect_in_log("D = 7");
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_discns, 2), 0);
  EXPECT_EQ(calculate(1), 0);
}

TEST(LogFile, ThatCannotBeWrittenIsTold) {
  TemporaryFolder folder;
  const Library library(folder.path() / "no such folder");
  EXPECT_EQ(library.code, CNTC_err_other);
  EXPECT_EQ(initialize(1, 1), 0) << "all else works";
}

} // namespace
} // namespace microslip::libcontact
