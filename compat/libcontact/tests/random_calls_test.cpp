// All functions with arguments by chance, null pointers among them: no crash, and the library works afterwards. More of
// it: --gtest_filter=RandomCalls* --gtest_shuffle --gtest_random_seed=N

#include "compat/libcontact/tests/calls.hpp"
#include "tests/temporary_folder.hpp"

#include <array>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

/// Arrays that are longer than any length among the arguments asks for.
class Arguments {
public:
  explicit Arguments(unsigned seed) : chance_(seed) {}

  int* get(int*) {
    if (is_null()) return nullptr;
    auto& array = ints_[next_++ % ints_.size()];
    for (int& value : array) value = flag();
    array[0] = small();
    return array.data();
  }
  double* get(double*) {
    if (is_null()) return nullptr;
    auto& array = doubles_[next_++ % doubles_.size()];
    for (double& value : array) value = number();
    return array.data();
  }
  const char* get(const char*) { return is_null() ? nullptr : letters_.data(); }

private:
  bool is_null() { return chance_() % 25 == 0; }
  /// What a length, a number of an element, a method or a count may be.
  int small() {
    constexpr int values[] = {-1, 1, 1, 1, 2, 3, 3, 0, -2, 4, 5, 6, 9, 11, 12, 21, 32, 60};
    return values[chance_() % std::size(values)];
  }
  int flag() { return chance_() % 3 == 0 ? small() : 1960 + static_cast<int>(chance_() % 70); }
  double number() {
    constexpr double values[] = {0,   1,   -1,   0.3, 0.28, 5, 14,  460,  82000, 0.5, 20.,  8.,
                                 1e3, 1e4, 1e-3, 2.5, 1435, 3, -70, 1360, 6.,    1.5, 1e30, -1e30};
    if (chance_() % 200 == 0) return std::numeric_limits<double>::quiet_NaN();
    return values[chance_() % std::size(values)];
  }

  std::mt19937 chance_;
  std::array<std::vector<int>, 8> ints_ = filled<int>();
  std::array<std::vector<double>, 8> doubles_ = filled<double>();
  std::string letters_ = std::string(200, 'x');
  std::size_t next_ = 0;

  template <class Value> static std::array<std::vector<Value>, 8> filled() {
    std::array<std::vector<Value>, 8> all;
    all.fill(std::vector<Value>(60 * 60 + 60));
    return all;
  }
};

template <class... Places> std::function<int(Arguments&)> with_arguments(int (*function)(Places...)) {
  return [function](Arguments& arguments) { return function(arguments.get(Places{})...); };
}

const std::vector<std::function<int(Arguments&)>> functions = {
    with_arguments(cntc_initialize),
    with_arguments(cntc_setfileunits),
    with_arguments(cntc_setglobalflags),
    with_arguments(cntc_getmaxnumthreads),
    with_arguments(cntc_readinpfile),
    with_arguments(cntc_setflags),
    with_arguments(cntc_getflags),
    with_arguments(cntc_setmetadata),
    with_arguments(cntc_setsolverflags),
    with_arguments(cntc_setmaterialparameters),
    with_arguments(cntc_setmaterialproperties),
    with_arguments(cntc_settemperaturedata),
    with_arguments(cntc_settimestep),
    with_arguments(cntc_setrollingstepsize),
    with_arguments(cntc_setfrictionmethod),
    with_arguments(cntc_setpotcontact),
    with_arguments(cntc_settangentialforces),
    with_arguments(cntc_setreferencevelocity),
    with_arguments(cntc_sethertzcontact),
    with_arguments(cntc_setpenetration),
    with_arguments(cntc_setnormalforce),
    with_arguments(cntc_setundeformeddistc),
    with_arguments(cntc_setcreepages),
    with_arguments(cntc_setextrarigidslip),
    with_arguments(cntc_setverticalforce),
    with_arguments(cntc_setprofileinputfname),
    with_arguments(cntc_setprofileinputvalues),
    with_arguments(cntc_settrackdimensions),
    with_arguments(cntc_setwheelsetdimensions),
    with_arguments(cntc_setwheelsetposition),
    with_arguments(cntc_setwheelsetvelocity),
    with_arguments(cntc_setwheelsetflexibility),
    with_arguments(cntc_calculate),
    with_arguments(cntc_getcalculationtime),
    with_arguments(cntc_resetcalculationtime),
    with_arguments(cntc_getprofilevalues),
    with_arguments(cntc_getwheelsetposition),
    with_arguments(cntc_getwheelsetvelocity),
    with_arguments(cntc_getnumcontactpatches),
    with_arguments(cntc_getcontactlocation),
    with_arguments(cntc_getglobalforces),
    with_arguments(cntc_getparameters),
    with_arguments(cntc_getreferencevelocity),
    with_arguments(cntc_gethertzcontact),
    with_arguments(cntc_getnumelements),
    with_arguments(cntc_getgriddiscretization),
    with_arguments(cntc_getpotcontact),
    with_arguments(cntc_getpenetration),
    with_arguments(cntc_getcreepages),
    with_arguments(cntc_getcontactforces),
    with_arguments(cntc_getcontactpatchareas),
    with_arguments(cntc_getelementdivision),
    with_arguments(cntc_getmaximumpressure),
    with_arguments(cntc_getmaximumtraction),
    with_arguments(cntc_getmaximumtemperature),
    with_arguments(cntc_getfielddata),
    with_arguments(cntc_gettractions),
    with_arguments(cntc_getmicroslip),
    with_arguments(cntc_getdisplacements),
    with_arguments(cntc_getsensitivities),
    with_arguments(subs_addblock),
    with_arguments(subs_calculate),
    with_arguments(subs_getblocksize),
    with_arguments(subs_getresults),
    with_arguments(cntc_finalize),
};

class RandomCalls : public ::testing::Test {
protected:
  TemporaryFolder folder_;
  Library library_{folder_.path()};
};

TEST_F(RandomCalls, WithNullPointersOnlyHaveCodes) {
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

TEST_F(RandomCalls, DoNotCrash) {
  constexpr int calls = 20000;
  const auto seed = static_cast<unsigned>(::testing::UnitTest::GetInstance()->random_seed());
  Arguments arguments(1 + seed);
  std::mt19937 chance(2 + seed);
  int refused = 0, done = 0;
  for (int k = 0; k < calls; ++k) {
    if (k % 500 == 0) { // so that some of the calls find something
      cntc_finalizelast();
      initialize(1, 1);
      initialize(3, 3);
      set_up_wheel(1, k % 1000 == 0);
      set_wheel_state(1, 3);
      set_up_sphere(3, 1);
      if (k % 2000 == 0) calculate(1);
      calculate(3, 1);
    }
    const std::size_t which = chance() % functions.size();
    if (which + 1 == functions.size() && k % 20 != 0) continue; // elements do not live long otherwise
    (functions[which](arguments) < 0 ? refused : done) += 1;
  }
  EXPECT_GT(refused, calls / 10);
  EXPECT_GT(done, calls / 50);
  cntc_finalizelast();
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  EXPECT_EQ(calculate(1), 0);
}

} // namespace
} // namespace microslip::libcontact
