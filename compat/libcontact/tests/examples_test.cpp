// The Manchester benchmark in C, Fortran and Python: the same numbers, on the profiles of the examples; and those that
// CONTACT has stored, on its profiles.

#include "paths.hpp"
#include "tests/support/command_output.hpp"
#include "validation/contact_output.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

const std::string own_profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";
const fs::path stored = MICROSLIP_REFERENCE_DATA "/../contact-cases";

/// A line: its first word and whole numbers, and the numbers behind them.
using Lines = std::map<std::string, std::vector<double>>;

/// How many whole numbers follow the word.
std::size_t keys_of(const std::string& word) {
  return word == "sensitivities" ? 1 : word == "fields" ? 5 : 3;
}

Lines run(const std::string& command) {
  Lines lines;
  std::istringstream stream(command_output(command));
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key, next;
    words >> key;
    for (std::size_t k = keys_of(key); k > 0; --k) {
      words >> next;
      key += " " + next;
    }
    for (double number; words >> number;) lines[key].push_back(number);
  }
  return lines;
}

std::string profiles_of(const fs::path& folder, const std::string& rail, const std::string& wheel) {
  return " '" + (folder / rail).string() + "' '" + (folder / wheel).string() + "'";
}

Lines in_c(const std::string& profiles) {
  return run(LIBCONTACT_EXAMPLES "/libcontact_manchester_c" + profiles);
}

void expect_same(const Lines& found, const Lines& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [key, numbers] : wanted) {
    ASSERT_TRUE(found.count(key)) << key;
    ASSERT_EQ(found.at(key).size(), numbers.size()) << key;
    const double rounding = key[0] == 's' ? 1e-5 : 1e-8; // printed to six digits, and to nine
    for (std::size_t k = 0; k < numbers.size(); ++k)
      EXPECT_NEAR(found.at(key)[k], numbers[k], rounding * std::abs(numbers[k]) + 1e-30) << key << ", number " << k;
  }
}

class Examples : public ::testing::Test {
protected:
  std::string profiles_ = profiles_of(own_profiles, "60e1.prr", "s1002.prw");
};

TEST_F(Examples, InCWork) {
  const Lines lines = in_c(profiles_);
  ASSERT_EQ(lines.count("wheel 1 1 1"), 1u);
  int wheels = 0;
  for (const auto& [key, numbers] : lines) {
    if (key.rfind("wheel", 0) != 0) continue;
    ++wheels;
    EXPECT_NEAR(numbers[3], 10000, 0.11) << key << ": FZ to EPS";
  }
  EXPECT_EQ(wheels, 42);
}

TEST_F(Examples, InFortranAreTheSame) {
  const fs::path program = LIBCONTACT_EXAMPLES "/libcontact_manchester_fortran";
  if (!fs::exists(program)) GTEST_SKIP() << "no Fortran compiler";
  expect_same(run(program.string() + profiles_), in_c(profiles_));
}

TEST_F(Examples, InPythonAreTheSame) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "Python cannot load a sanitized library";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "Python cannot load a sanitized library";
#endif
#endif
  if (std::system("python3 -c 'import ctypes' 2>/dev/null") != 0) GTEST_SKIP() << "no Python";
  expect_same(run("python3 " MICROSLIP_SOURCE_DIR "/examples/libcontact/manchester.py " LIBCONTACT + profiles_),
              in_c(profiles_));
}

/// A number of ours beside what CONTACT has printed: to its digits, or to a share of itself or of what it is made of.
void expect_near(double found, const validation::PrintedNumbers& printed, const std::string& name, double share,
                 const std::string& where) {
  ASSERT_TRUE(printed.count(name)) << name;
  const auto& wanted = printed.at(name);
  EXPECT_NEAR(found, wanted.value, wanted.rounding + share) << where << ": " << name;
}

/// Where CONTACT's result is two merged patches whose coupling it damps (right, state 11), FX differs.
class Stored : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Results, Stored, ::testing::Values(1, 2),
                         [](const auto& wheel) { return wheel.param == 1 ? "Left" : "Right"; });

TEST_P(Stored, AreFound) {
  if (!fs::exists(stored)) GTEST_SKIP() << "no stored results";
  static const Lines lines = in_c(profiles_of(stored, "MBench_UIC60_v3.prr", "MBench_S1002_v3.prw"));
  std::ifstream file(stored / (GetParam() == 1 ? "mbench_a22_left.ref_out" : "mbench_a22_right.ref_out"));
  const auto printed = validation::read_contact_output(file);
  ASSERT_EQ(printed.size(), 21u);
  for (const validation::PrintedCase& wheel : printed) {
    const std::string where = std::to_string(GetParam()) + " " + std::to_string(wheel.number);
    ASSERT_EQ(wheel.patches.size(), 1u);
    ASSERT_EQ(lines.count("wheel " + where + " 1"), 1u) << where;
    const auto& totals = lines.at("wheel " + where + " 1");
    const auto& patch = lines.at("patch " + where + " 1");
    const double friction = 0.003 * 10e3; // 0.3 % of what friction bears
    expect_near(totals[0], wheel.totals, "Z_WS", 3e-4, where);
    expect_near(totals[1], wheel.totals, "FX(TR)", friction, where);
    expect_near(totals[2], wheel.totals, "FY(TR)", friction, where);
    expect_near(totals[3], wheel.totals, "FZ(TR)", 1, where);
    const auto& numbers = wheel.patches[0];
    expect_near(patch[0], numbers, "XCP(TR)", 5e-3, where);
    expect_near(patch[1], numbers, "YCP(TR)", 5e-3, where);
    expect_near(patch[3], numbers, "DELTCP(TR)", 2e-4, where);
    expect_near(patch[4], numbers, "YCP(R)", 5e-3, where);
    expect_near(patch[7], numbers, "APPROACH", 2e-5, where);
    expect_near(patch[8], numbers, "CKSI", 1e-6, where);
    expect_near(patch[9], numbers, "CETA", 1e-6, where);
    expect_near(patch[10], numbers, "CPHI", 1e-7, where);
    expect_near(patch[11], numbers, "FN", 10, where);
    expect_near(patch[16], numbers, "PMAX", 0.003 * patch[16], where);
  }
}

} // namespace
} // namespace microslip
