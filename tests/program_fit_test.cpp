// `microslip fit`: the document, the case file that it writes, and what is refused.

#include "paths.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_document.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string points = MICROSLIP_SOURCE_DIR "/examples/creep_curve.csv";
const std::string example = points + " --case " MICROSLIP_SOURCE_DIR "/examples/creep_curve.toml";

TEST(ProgramFit, WritesTheDocumentAndACaseThatRuns) {
  const TemporaryFolder folder;
  const auto json = program_document(folder, "fit " + example + " --model reduced_slope -o fitted --no-pictures");
  EXPECT_EQ(json.at("kind"), "creep_curve_fit");
  EXPECT_EQ(json.at("model"), "reduced_slope");
  EXPECT_EQ(json.at("points"), 72);
  EXPECT_NEAR(json.at("rms").get<double>(), 0.0183, 3e-4);
  const auto& slope = json.at("parameters").at("solution.slope_reduction.initial");
  EXPECT_LT(slope.at("interval")[0].get<double>(), slope.at("value").get<double>());
  EXPECT_GT(slope.at("interval")[1].get<double>(), slope.at("value").get<double>());
  EXPECT_TRUE(json.at("parameters").contains("friction.static_coefficient of evening"));
  EXPECT_EQ(json.at("curves").size(), 2U);
  EXPECT_NEAR(json.at("rms_of_case").get<double>(), json.at("rms").get<double>(), 1e-6); // FASTSIM2 has its own cells
  const auto& correlations = json.at("correlations").at("friction.decay");
  EXPECT_NEAR(correlations.at("friction.decay").get<double>(), 1, 1e-12);
  EXPECT_LE(std::abs(correlations.at("friction.static_coefficient of evening").get<double>()), 1);
  EXPECT_TRUE(std::filesystem::exists(folder / "fitted/result.h5"));
  const auto solved = program_document(folder, "solve fitted/case.toml --no-pictures");
  EXPECT_EQ(solved.at("status"), "ok");
  const std::string text = contents(folder / "fitted/case.toml");
  EXPECT_NE(text.find("[solution.slope_reduction]"), std::string::npos) << text;
}

TEST(ProgramFit, WritesNoCaseOfAFormula) {
  const TemporaryFolder folder;
  const auto json = program_document(folder, "fit " + example + " --model polach_formula -o fitted --no-pictures");
  EXPECT_EQ(json.at("files").size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(folder / "fitted/case.toml"));
}

/// The curve of a fit with one run misses its points as the fit says.
TEST(ProgramFit, SolveComparesWithThePoints) {
  const TemporaryFolder folder;
  std::ofstream file(folder / "points.csv");
  file << "creepage_longitudinal [%],adhesion_coefficient\n";
  for (const auto point :
       {"0.1,0.14", "0.2,0.2", "0.4,0.26", "0.8,0.29", "1.6,0.3", "3.2,0.31", "6.4,0.28", "12.8,0.2"})
    file << point << "\n";
  file.close();
  const std::string of = " --case " MICROSLIP_SOURCE_DIR "/examples/creep_curve.toml";
  const auto fitted = program_document(folder, "fit points.csv" + of + " --model polach -o fitted --no-pictures");
  const auto solved = program_document(folder, "solve fitted/case.toml --points points.csv -o solved --no-pictures");
  const auto& comparison = solved.at("measured_points");
  EXPECT_EQ(comparison.at("points"), 8);
  EXPECT_NEAR(comparison.at("rms").get<double>(), fitted.at("rms").get<double>(), 1e-6);
  EXPECT_NEAR(comparison.at("bias").get<double>(), fitted.at("bias").get<double>(), 1e-6);
  EXPECT_TRUE(std::filesystem::exists(folder / "solved/measured_points.h5"));
  const auto drawn = program_document(folder, "plot solved/result.h5 --points points.csv -o drawn");
  EXPECT_EQ(drawn.at("measured_points"), comparison);
  EXPECT_EQ(run_program(folder, "plot solved/measured_points.h5 --points points.csv").exit_code, 2);
  const std::string wheel = MICROSLIP_SOURCE_DIR "/examples/wheel_on_rail.toml";
  const Outcome of_wheel = run_program(folder, "solve " + wheel + " --points points.csv");
  EXPECT_EQ(of_wheel.exit_code, 2);
  EXPECT_NE(of_wheel.errors.find("[ellipse] of a patch's area"), std::string::npos) << of_wheel.errors;
}

/// Points that exceed the forces of a sweep's cases by 0.01 have that bias for the combination that they are from.
TEST(ProgramFit, SweepsAreComparedWithPoints) {
  const TemporaryFolder folder;
  std::ofstream(folder / "sweep.toml")
      << "case = \"" MICROSLIP_SOURCE_DIR "/examples/creep_curve.toml\"\n[grid]\nmotion.spin = [0.0, 0.3]\n"
      << "motion.creepage_longitudinal = { from = 1e-3, to = 0.1, count = 9, scale = \"logarithmic\" }\n";
  program_document(folder, "sweep sweep.toml -o a.h5");
  const Hdf5Reader file(folder / "a.h5");
  const auto creepage = file.values<double>("parameters/motion.creepage_longitudinal", H5T_NATIVE_DOUBLE);
  const auto force = file.values<double>("contact/fx", H5T_NATIVE_DOUBLE);
  std::ofstream measured(folder / "points.csv");
  measured << "creepage_longitudinal,force\n";
  for (std::size_t i = 9; i < 18; ++i) measured << fmt::format("{},{}\n", creepage[i], -force[i] + 0.01 * 100e3);
  measured.close();
  const auto printed = program_document(folder, "sweep sweep.toml -o a.h5 --points points.csv").at("measured_points");
  ASSERT_EQ(printed.size(), 2U);
  EXPECT_EQ(printed[1].at("name"), "motion.spin = 0.3");
  EXPECT_EQ(printed[1].at("points"), 9);
  EXPECT_NEAR(printed[1].at("bias").get<double>(), -0.01, 1e-9);
  EXPECT_NEAR(printed[1].at("rms").get<double>(), 0.01, 1e-9);
  EXPECT_GT(std::abs(printed[0].at("rms").get<double>() - 0.01), 1e-6);
  const auto drawn = program_document(folder, "plot a.h5 --points points.csv -o drawn");
  EXPECT_EQ(drawn.at("measured_points"), printed);
  EXPECT_TRUE(std::filesystem::exists(folder / "drawn/measured_points.h5"));
}

/// The curve of a wheel over its speed of rotation goes through what its patches have.
TEST(ProgramFit, SweepsOfAWheelAreComparedWithPoints) {
  const TemporaryFolder folder;
  std::string wheel = contents(MICROSLIP_SOURCE_DIR "/examples/wheel_on_rail.toml");
  const std::string profiles = "\"profiles/";
  for (auto at = wheel.find(profiles); at != std::string::npos; at = wheel.find(profiles, at + 1))
    wheel.insert(at + 1, MICROSLIP_SOURCE_DIR "/examples/");
  wheel.replace(wheel.find("theory = \"exact\""), 16, "theory = \"fastsim2\"");
  std::ofstream(folder / "wheel.toml") << wheel;
  std::ofstream(folder / "sweep.toml")
      << "case = \"wheel.toml\"\n[grid]\nwheel.pitch_velocity = { from = 64, to = 65, count = 5 }\n";
  program_document(folder, "sweep sweep.toml -o a.h5");
  const Hdf5Reader file(folder / "a.h5");
  const auto of = [&](const std::string& name, std::size_t patch) {
    return file.values<double>(fmt::format("patches/{}/{}", patch, name), H5T_NATIVE_DOUBLE).at(2);
  };
  const double loads[] = {of("normal_force", 0), of("normal_force", 1)}, load = loads[0] + loads[1];
  const double creepage =
      (of("creepage_longitudinal", 0) * loads[0] + of("creepage_longitudinal", 1) * loads[1]) / load;
  const double coefficient = -(of("fx", 0) + of("fx", 1)) / load;
  ASSERT_GT(creepage, 0);
  std::ofstream(folder / "points.csv") << fmt::format("creepage_longitudinal,adhesion_coefficient\n{},{}\n", creepage,
                                                      coefficient - 0.02);
  const auto printed = program_document(folder, "sweep sweep.toml -o a.h5 --points points.csv").at("measured_points");
  EXPECT_NEAR(printed.at(0).at("bias").get<double>(), 0.02, 1e-9);
  std::ofstream(folder / "points.csv") << "creepage_longitudinal,adhesion_coefficient\n0.9,0.3\n";
  EXPECT_NE(run_program(folder, "plot a.h5 --points points.csv").errors.find("beyond those of the sweep"),
            std::string::npos);
  std::ofstream(folder / "points.csv") << "creepage_lateral,adhesion_coefficient\n0.001,0.3\n";
  EXPECT_NE(run_program(folder, "plot a.h5 --points points.csv").errors.find("nothing varies that makes the lateral"),
            std::string::npos);
}

/// A case and a sweep of it go through points that the sweep computed; one with more friction has its bias.
TEST(ProgramFit, SeveralResultsAreComparedWithPoints) {
  const TemporaryFolder folder;
  const std::string example_case = MICROSLIP_SOURCE_DIR "/examples/creep_curve.toml";
  std::string slippery = contents(example_case);
  const std::string coefficient = "static_coefficient = 0.3\n";
  slippery.replace(slippery.find(coefficient), coefficient.size(), "static_coefficient = 0.2\n");
  std::ofstream(folder / "slippery.toml") << slippery;
  std::ofstream(folder / "sweep.toml")
      << "title = \"Sweep\"\ncase = \"" + example_case + "\"\n[grid]\n"
      << "motion.creepage_longitudinal = { from = 1e-3, to = 0.1, count = 9, scale = \"logarithmic\" }\n";
  program_document(folder, "sweep sweep.toml -o sweep.h5");
  program_document(folder, "solve " + example_case + " -o case --no-pictures");
  program_document(folder, "solve slippery.toml -o slippery --no-pictures");
  const Hdf5Reader file(folder / "sweep.h5");
  const auto creepage = file.values<double>("parameters/motion.creepage_longitudinal", H5T_NATIVE_DOUBLE);
  const auto force = file.values<double>("contact/fx", H5T_NATIVE_DOUBLE);
  std::ofstream measured(folder / "points.csv");
  measured << "creepage_longitudinal,force\n";
  for (std::size_t i = 0; i < force.size(); ++i) measured << fmt::format("{},{}\n", creepage[i], -force[i]);
  measured.close();
  const auto drawn = program_document(folder, "plot case/result.h5 --compare sweep.h5 --compare slippery/result.h5 "
                                              "--points points.csv --style paper --format svg -o drawn");
  const auto& curves = drawn.at("measured_points");
  ASSERT_EQ(curves.size(), 3U);
  const std::string names[] = {"case", "sweep.h5", "slippery"}; // two have the same title
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(curves[k].at("name"), names[k]);
  EXPECT_LT(curves[0].at("rms").get<double>(), 1e-9);
  EXPECT_LT(curves[1].at("rms").get<double>(), 1e-9);
  EXPECT_LT(curves[2].at("bias").get<double>(), -0.01);
  EXPECT_TRUE(std::filesystem::exists(folder / "drawn/measured_points.svg"));
  const Hdf5Reader written(folder / "drawn/measured_points.h5");
  const auto fine = written.values<double>("curve_0/creepage", H5T_NATIVE_DOUBLE);
  EXPECT_NEAR(fine.front(), 1e-3, 1e-15);
  EXPECT_NEAR(fine.back(), 0.1, 1e-12);
  EXPECT_GT(fine.size(), force.size());

  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = run_program(folder, "plot case/result.h5 " + arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
  };
  refused("--compare sweep.h5 --points points.csv --field px", "--points: goes with --compare");
  refused("--compare sweep.h5", "with --points POINTS.csv results of `solve` of two bodies and of `sweep` are drawn");
  program_document(folder, "solve " MICROSLIP_SOURCE_DIR "/examples/wheel_on_rail.toml -o wheel --no-pictures");
  refused("--compare wheel/result.h5 --points points.csv", "[ellipse] of a patch's area");
}

TEST(ProgramFit, RefusesWithTheNearestWord) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = run_program(folder, "fit " + arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
  };
  refused(example + " --model reduced_slop", "did you mean reduced_slope?");
  refused(example + " --start polach_wett", "did you mean polach_wet?");
  refused(points + " --case " MICROSLIP_SOURCE_DIR "/examples/wheel_on_rail.toml", "needs a case of two bodies");
  std::ofstream(folder / "few.csv") << "creepage_longitudinal,adhesion_coefficient\n0.01,0.2\n";
  refused("few.csv --case " MICROSLIP_SOURCE_DIR "/examples/creep_curve.toml", "too few points");
}

} // namespace
} // namespace microslip
