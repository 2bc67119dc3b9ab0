// Numbers that are none, through C: each field of a wheel's state makes that state invalid input and no other.

#include "c/tests/c_wheel_rows.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace microslip {
namespace {

TEST(CWheelRailBadInput, EachFieldMakesItsStateInvalidAndNoOther) {
  const CWheelRailCase pair;
  Rows state = first_states(pair.pointer);
  SolvedRows good(1);
  ASSERT_EQ(good.solve(pair.pointer, state), MICROSLIP_OK);
  const int vertical = microslip_index(MICROSLIP_WHEEL_STATE, "vertical", nullptr);
  for (std::size_t k = 0; k < state.width(); ++k)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Rows states = first_states(pair.pointer, 3);
      states.row(1)[k] = bad;
      if (static_cast<int>(k) == vertical) states.at(1, "vertical_force") = 0; // the height is taken then
      SolvedRows found(3);
      EXPECT_EQ(found.solve(pair.pointer, states), MICROSLIP_INVALID_INPUT) << k << ", " << bad;
      EXPECT_EQ(found.status[1], MICROSLIP_INVALID_INPUT) << k << ", " << bad;
      EXPECT_EQ(found.results.at(1, "patch_count"), 0);
      EXPECT_TRUE(std::isnan(found.results.at(1, "force_z")));
      for (const std::size_t other : {0, 2})
        EXPECT_EQ(found.results.at(other, "force_y"), good.results.at(0, "force_y"));
    }
}

TEST(CWheelRailBadInput, ForcesThatPullAreInvalidAndWheelsAtRestBearNothingTangential) {
  const CWheelRailCase pair;
  Rows pulled = first_states(pair.pointer), still = pulled;
  pulled.at(0, "vertical_force") = -1e3;
  SolvedRows found(1);
  EXPECT_EQ(found.solve(pair.pointer, pulled), MICROSLIP_INVALID_INPUT);
  still.at(0, "forward_velocity") = still.at(0, "pitch_velocity") = 0;
  ASSERT_EQ(found.solve(pair.pointer, still), MICROSLIP_OK);
  EXPECT_NEAR(found.results.at(0, "force_x"), 0, 1e-9);
  EXPECT_NEAR(found.results.at(0, "force_z"), 80e3, 8);
}

/// Results that nobody has written yet.
template <class Result> std::vector<Result> garbage(std::size_t count) {
  std::vector<Result> results(count);
  std::memset(static_cast<void*>(results.data()), 0xa5, count * sizeof(Result));
  return results;
}

/// Numbers that make sense for no field of a state.
std::vector<double> bad_numbers() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300, -1e300, 1e-320};
}

/// The first state with one field after the other made each of these numbers.
Rows bad_states(const microslip_wheel_rail* wheel_rail) {
  const std::size_t width = microslip_count(MICROSLIP_WHEEL_STATE), kinds = bad_numbers().size();
  Rows states = first_states(wheel_rail, width * kinds + 1);
  for (std::size_t k = 0; k < width * kinds; ++k) states.row(k)[k / kinds] = bad_numbers()[k % kinds];
  return states;
}

TEST(CWheelRailBadInput, EveryResultIsWrittenWhateverTheStatesAre) {
  constexpr double unwritten = 1.25e301;
  for (const char* theory : {"\"fastsim2\"", "\"table\"", "\"exact\"\ngrid = 6"}) {
    const CWheelRailCase pair(with(wheel_rail_text, "\"fastsim2\"", theory));
    Rows states = bad_states(pair.pointer);
    SolvedRows solved(states.count(), unwritten), differentiated(states.count(), unwritten);
    EXPECT_EQ(solved.solve(pair.pointer, states), MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(differentiated.differentiate(pair.pointer, states), MICROSLIP_INVALID_INPUT);
    for (SolvedRows* found : {&solved, &differentiated})
      for (std::size_t k = 0; k < states.count(); ++k) {
        EXPECT_TRUE(found->status[k] >= 0 && found->status[k] <= MICROSLIP_IMPLAUSIBLE) << theory << ' ' << k;
        for (std::size_t i = 0; i < found->results.width(); ++i)
          EXPECT_NE(found->results.row(k)[i], unwritten) << theory << ' ' << k << ' ' << i;
        const double sum = found->results.at(k, "force_y") + found->results.at(k, "moment_z");
        EXPECT_TRUE(found->status[k] != MICROSLIP_OK || std::isfinite(sum)) << theory << ' ' << k;
      }
    for (const double value : differentiated.jacobians) EXPECT_NE(value, unwritten) << theory;
    EXPECT_EQ(solved.status.back(), MICROSLIP_OK) << theory;
    EXPECT_EQ(differentiated.status.back(), MICROSLIP_OK) << theory;
  }
}

TEST(CWheelRailBadInput, EveryContactOfAWheelsetIsWritten) {
  const CWheelRailCase pair;
  std::vector<double> lateral = bad_numbers();
  lateral.push_back(0.003);
  constexpr double unwritten = 1.25e301;
  Rows contacts(MICROSLIP_WHEELSET_CONTACT, lateral.size(), unwritten);
  std::vector<int> status(lateral.size(), -1);
  microslip_error error = {};
  EXPECT_EQ(microslip_wheelset_contacts(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 0, lateral.size(), lateral.data(),
                                        contacts.width(), contacts.data(), status.data(), &error),
            MICROSLIP_INVALID_INPUT);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(status[k], MICROSLIP_INVALID_INPUT) << k;
  for (std::size_t k = 0; k < contacts.count(); ++k)
    for (std::size_t i = 0; i < contacts.width(); ++i) EXPECT_NE(contacts.row(k)[i], unwritten) << k << ' ' << i;
  for (const std::size_t good : {5, 6}) {
    EXPECT_EQ(status[good], MICROSLIP_OK);
    EXPECT_TRUE(std::isfinite(contacts.at(good, "left_contact_angle")));
  }
  EXPECT_EQ(microslip_wheelset_contacts(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1e300, 1, lateral.data(),
                                        contacts.width(), contacts.data(), status.data(), &error),
            MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(error.text), "yaw = 1e+300 [rad]: must be in [-1, 1]");
}

/// Contacts of a wheelset are searched for with one profile all along: the first of several slices would be another
/// rail.
TEST(CWheelRailBadInput, ProfilesThatVaryHaveNoContactsOfAWheelset) {
  const TemporaryFolder folder;
  const std::string rail = MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr";
  std::ofstream(folder / "rail.slcs") << "0 1000\n2\n0\n1\n-1 '" << rail << "'\n1 '" << rail << "'\n";
  const CWheelRailCase pair(with(wheel_rail_text, rail, (folder / "rail.slcs").string()));
  ASSERT_EQ(pair.code, MICROSLIP_OK) << pair.error.text;
  const double lateral = 0.003, amplitude = 0.003;
  Rows contacts(MICROSLIP_WHEELSET_CONTACT, 1);
  double conicity = 0;
  microslip_error error = {};
  EXPECT_EQ(microslip_wheelset_contacts(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 0, 1, &lateral, contacts.width(),
                                        contacts.data(), nullptr, &error),
            MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("needs the same profile all along"), std::string::npos) << error.text;
  EXPECT_EQ(
      microslip_equivalent_conicity(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1.5, 1, &amplitude, &conicity, &error),
      MICROSLIP_INVALID_OPTION);
}

TEST(CWheelRailBadInput, EveryConicityIsWritten) {
  const CWheelRailCase pair;
  const std::vector<double> amplitudes = {0.003, -1, 0, std::numeric_limits<double>::quiet_NaN(), 1e300, 0.002};
  auto conicity = garbage<double>(amplitudes.size());
  microslip_error error = {};
  EXPECT_EQ(microslip_equivalent_conicity(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1.5, amplitudes.size(),
                                          amplitudes.data(), conicity.data(), &error),
            MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(std::string(error.text), "amplitude = -1 [m]: must be above 0, up to 0.9");
  double alone = 0;
  ASSERT_EQ(microslip_equivalent_conicity(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1.5, 1, amplitudes.data(), &alone,
                                          &error),
            MICROSLIP_OK);
  EXPECT_EQ(conicity[0], alone);
  for (const std::size_t bad : {1, 2, 3, 4}) EXPECT_TRUE(std::isnan(conicity[bad])) << bad;
  EXPECT_GT(conicity[5], 0);
}

} // namespace
} // namespace microslip
