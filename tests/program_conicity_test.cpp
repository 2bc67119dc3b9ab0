// `microslip conicity`: the document, the result file, the options, and what is refused.

#include "paths.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_document.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string wheel = MICROSLIP_SOURCE_DIR "/examples/profiles/s1002.prw";
const std::string rail = MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr";

io::Json document(const TemporaryFolder& folder, const std::string& arguments) {
  return program_document(folder, "conicity " + arguments);
}

/// Columns in mm: a cone with the flange's back at y = -70 mm, z up, of which the words of the options may differ.
std::string cone_file(const TemporaryFolder& folder, const std::string& name, double inclination, double y_sense,
                      double z_sense) {
  std::ofstream file(folder / name);
  for (int k = 0; k <= 100; ++k) {
    const double y = -70 + 1.3 * k;
    file << y_sense * y << " " << z_sense * inclination * y << "\n";
  }
  return (folder / name).string();
}

TEST(ProgramConicity, OfConesIsTheirInclination) {
  const TemporaryFolder folder;
  const auto cone = cone_file(folder, "cone.dat", 0.05, 1, 1);
  const std::string words = " --wheel-y-axis field --wheel-z-axis up --wheel-unit mm";
  const auto json = document(folder, cone + " " + rail + words + " --roll none --cant 0.025");
  EXPECT_EQ(json.at("kind"), "conicity");
  const auto& pairs = json.at("equivalent_conicity");
  ASSERT_EQ(pairs.size(), 61U);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_NEAR(pairs[k][0].get<double>(), 1e-3 + 1e-4 * static_cast<double>(k), 1e-15);
    EXPECT_NEAR(pairs[k][1].get<double>(), 0.05, 1e-7);
  }
  EXPECT_NEAR(json.at("nonlinearity_parameter").get<double>(), 0, 1e-4);
  const auto rolling = document(folder, cone + " " + rail + words + " --cant 0.025 --amplitudes 0.003 0.003 0.001");
  ASSERT_EQ(rolling.at("equivalent_conicity").size(), 1U);
  EXPECT_GT(rolling.at("equivalent_conicity")[0][1].get<double>(), 0.0505);
}

TEST(ProgramConicity, SensesOfColumnsMirrorTheProfile) {
  const TemporaryFolder folder;
  const auto straight = cone_file(folder, "straight.dat", 0.05, 1, 1);
  const auto mirrored = cone_file(folder, "mirrored.dat", 0.05, -1, -1);
  const std::string rest = " " + rail + " --wheel-unit mm --roll none --amplitudes 0.002 0.003 0.001 --cant 0.025";
  const auto a = document(folder, straight + rest + " --wheel-y-axis field --wheel-z-axis up");
  const auto b = document(folder, mirrored + rest + " --wheel-y-axis gauge --wheel-z-axis down");
  EXPECT_EQ(a.at("equivalent_conicity"), b.at("equivalent_conicity"));
}

TEST(ProgramConicity, UnequalWheelsRunBesideTheMiddle) {
  const TemporaryFolder folder;
  const auto left = cone_file(folder, "left.dat", 0.04, 1, 1), right = cone_file(folder, "right.dat", 0.06, 1, 1);
  const auto json =
      document(folder, left + " " + rail + " --right-wheel " + right +
                           " --wheel-y-axis field --wheel-z-axis up --wheel-unit mm --roll none --cant 0.025"
                           " --amplitudes 0.002 0.003 0.001");
  for (const auto& pair : json.at("equivalent_conicity")) EXPECT_NEAR(pair[1].get<double>(), 0.05, 1e-6);
}

TEST(ProgramConicity, ResultFileAndMapOverTheGauge) {
  const TemporaryFolder folder;
  const auto arguments = wheel + " " + rail + " --cant 0.025 --roll none --amplitudes 0.001 0.003 0.001";
  const auto json = document(folder, arguments + " --gauge 1.432 1.435 -o out --no-pictures");
  ASSERT_EQ(json.at("gauges").size(), 2U);
  EXPECT_EQ(json.at("gauges")[0].at("equivalent_conicity"), json.at("equivalent_conicity"));
  EXPECT_EQ(json.at("gauges")[1].at("equivalent_conicity"), document(folder, arguments).at("equivalent_conicity"));
  const Hdf5Reader file(folder / "out/result.h5");
  const auto conicity = file.values<double>("gauge_1/conicity", H5T_NATIVE_DOUBLE);
  ASSERT_EQ(conicity.size(), 3U);
  EXPECT_EQ(conicity[2], json.at("gauges")[1].at("equivalent_conicity")[2][1].get<double>());
  // a narrow gauge makes the flanges touch earlier
  EXPECT_GT(json.at("gauges")[0].at("equivalent_conicity")[2][1].get<double>(), conicity[2]);
}

TEST(ProgramConicity, PrintsATable) {
  const TemporaryFolder folder;
  const auto printed = run_program(folder, "conicity " + wheel + " " + rail + " --cant 0.025 --curve-radius 500");
  EXPECT_EQ(printed.exit_code, 0) << printed.errors;
  for (const auto* text :
       {"Equivalent conicity", "amplitude 3 mm", "nonlinearity parameter", "radial steering index at 7 mm"})
    EXPECT_NE(printed.output.find(text), std::string::npos) << text << "\n" << printed.output;
}

TEST(ProgramConicity, RefusesBadInput) {
  const TemporaryFolder folder;
  const auto refuses = [&](const std::string& arguments, const std::string& text) {
    const auto outcome = run_program(folder, "conicity " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.errors.find(text), std::string::npos) << outcome.errors;
  };
  const auto both = wheel + " " + rail;
  refuses(both + " --gauge -1.435", "--gauge = -1.435");
  refuses(both + " --gauge 2", "no contact");
  refuses(both + " --nominal-radius 0", "--nominal-radius = 0 [m]: must be in [0.01, 10]");
  refuses(both + " --roll some", "--roll");
  refuses(both + " --amplitudes 0.002 0.001 0.001", "--amplitudes");
  refuses(both + " --contact-distance nan", "--contact-distance");
  refuses("nowhere.prw " + rail, "nowhere.prw");
}

} // namespace
} // namespace microslip
