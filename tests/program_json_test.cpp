// The flag --json: one document on standard output, with the numbers and names of the result files.

#include "io/json.hpp"
#include "microslip/version.hpp"
#include "paths.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Names = std::vector<std::string>;

const std::string example = MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml";
const std::string contact_example = MICROSLIP_SOURCE_DIR "/examples/sphere_on_plane.inp";

/// The document that a run of the program prints. Fails if it prints anything else, or errors.
io::Json document(const TemporaryFolder& folder, const std::string& arguments, int exit_code = 0) {
  const auto outcome = run_program(folder, arguments + " --json");
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.errors;
  if (exit_code == 0) {
    EXPECT_EQ(outcome.errors, "");
  }
  const auto parsed = io::Json::parse(outcome.output, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << outcome.output;
  EXPECT_EQ(io::json_text(parsed), outcome.output);
  const auto build = build_info();
  EXPECT_EQ(parsed.at("version"), build.version);
  EXPECT_EQ(parsed.at("commit"), build.commit);
  EXPECT_EQ(parsed.at("build_type"), build.build_type);
  EXPECT_NE(parsed.at("command_line").get<std::string>().find(arguments + " --json"), std::string::npos);
  return parsed;
}

TEST(ProgramJson, SolveHasTheNumbersOfTheResultFile) {
  const TemporaryFolder folder;
  const auto json = document(folder, "solve " + example + " -o out --no-pictures");
  const Hdf5Reader file(folder / "out/result.h5");
  EXPECT_EQ(json.at("kind"), "rolling_contact");
  EXPECT_EQ(json.at("status"), "ok");
  EXPECT_EQ(json.at("case_text"), contents(example));
  EXPECT_EQ(json.at("files"), Names{"out/result.h5"});
  for (const std::string path :
       {"hertz/a", "inputs/load/normal_force", "inputs/solution/tolerance", "exact/fx", "exact/mz", "exact/residual",
        "fastsim2/fy", "tolerances/exact/discretisation_error_fx", "tolerances/fastsim2/discretisation_error_mz"}) {
    EXPECT_EQ(json.at(io::Json::json_pointer("/" + path)), file.values<double>(path, H5T_NATIVE_DOUBLE).at(0)) << path;
    EXPECT_EQ(json.at("units").at(path), file.attribute(path, "unit")) << path;
  }
  EXPECT_EQ(json.at("exact").at("status"), file.text("exact/status"));
  EXPECT_EQ(json.at("creep_curve").at("exact").at("fx").get<std::vector<double>>(),
            file.values<double>("creep_curve/exact/fx", H5T_NATIVE_DOUBLE));
  EXPECT_EQ(json.at("creep_curve").at("variable"), "creepage_longitudinal");
  EXPECT_FALSE(json.at("exact").contains("fields"));
  EXPECT_EQ(json.at("inputs").at("body2").at("rolling_radius"), "inf"); // a flat rail
}

TEST(ProgramJson, SolveNamesItsPicturesAndTheExtremesInside) {
  const TemporaryFolder folder;
  save(folder / "c.toml", contents(example) + "\n[interior]\nx = [0.0]\ny = [0.0]\nz = [0.001, 0.003]\n");
  const auto json = document(folder, "solve c.toml -o out");
  EXPECT_EQ(json.at("files"),
            (Names{"out/result.h5", "out/tractions.png", "out/areas.png", "out/creep_curve.png", "out/interior.png"}));
  const auto& extreme = json.at("interior_extremes").at("von_mises");
  const auto stresses = Hdf5Reader(folder / "out/result.h5").values<double>("interior/von_mises", H5T_NATIVE_DOUBLE);
  EXPECT_EQ(extreme.at("value"), std::max(stresses.at(0), stresses.at(1)));
  EXPECT_EQ(extreme.at("z"), stresses[0] > stresses[1] ? 0.001 : 0.003);
}

TEST(ProgramJson, NumbersThatAreNotFiniteAreWords) {
  const TemporaryFolder folder;
  auto text = contents(example);
  text.replace(text.find("\"80 kN\""), 7, "1e300").replace(text.find("0.0018"), 6, "1e300");
  save(folder / "c.toml", text);
  const auto json = document(folder, "solve c.toml -o out --no-pictures", 1);
  EXPECT_NE(json.at("status"), "ok");
  EXPECT_EQ(json.at("exact").at("fx"), "nan");
  EXPECT_EQ(json.at("inputs").at("motion").at("creepage_longitudinal"), 1e300);
}

/// A coarser grid than one element there is not.
TEST(ProgramJson, OneElementHasNoErrorEstimate) {
  const TemporaryFolder folder;
  auto text = contents(example);
  save(folder / "c.toml", text.replace(text.find("[40, 40]"), 8, "[1, 1]"));
  const auto json = document(folder, "solve c.toml -o out --no-pictures");
  for (const char* name : {"discretisation_error_fx", "discretisation_error_fy", "discretisation_error_mz"})
    EXPECT_EQ(json.at("tolerances").at("exact").at(name), "nan") << name;
  EXPECT_GT(json.at("tolerances").at("fastsim2").at("discretisation_error_fx").get<double>(), 0);
}

/// Moduli in MPa: the ellipse is larger than the wheel, and the reader is told what to check.
/// What is printed for people has no rounding errors; the numbers for programs are as they are.
TEST(ProgramJson, PrintedTablesHaveZerosForRoundingErrors) {
  const TemporaryFolder folder;
  auto text = contents(example);
  text.replace(text.find("[40, 40]"), 8, "[8, 8]").replace(text.find("0.0006"), 6, "0.0000");
  text.replace(text.find("\"0.4 1/m\""), 9, "0.0");
  save(folder / "c.toml", text);
  const auto table = run_program(folder, "solve c.toml -o out --no-pictures").output;
  EXPECT_EQ(table.find("e-1"), std::string::npos) << table;
  EXPECT_EQ(table.find("e-2"), std::string::npos) << table;
  EXPECT_NE(table.find("normal force                 80 kN\n"), std::string::npos) << table;
}

TEST(ProgramJson, WarnsOfOldPictures) {
  const TemporaryFolder folder;
  auto text = contents(example);
  save(folder / "c.toml", text.replace(text.find("[40, 40]"), 8, "[8, 8]"));
  std::filesystem::create_directory(folder / "out");
  save(folder / "out/history.png", "old");
  EXPECT_EQ(run_program(folder, "solve c.toml -o out --no-pictures").errors,
            "microslip: warning: out: older than result.h5: history.png\n");
}

TEST(ProgramJson, WarnsOfImplausibleContacts) {
  const TemporaryFolder folder;
  auto text = contents(example);
  text.replace(text.find("[40, 40]"), 8, "[8, 8]");
  for (auto at = text.find("210 GPa"); at != std::string::npos; at = text.find("210 GPa"))
    text.replace(at, 7, "210 kPa");
  save(folder / "c.toml", text);
  for (const std::string command : {"solve c.toml -o out --no-pictures", "hertz c.toml"}) {
    const auto outcome = run_program(folder, command + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    const auto warnings = io::Json::parse(outcome.output).at("warnings").get<Names>();
    ASSERT_FALSE(warnings.empty());
    for (const auto& warning : warnings) {
      EXPECT_NE(warning.find(warning.starts_with("Young's modulus") ? "is it in MPa? Numbers are in Pa"
                                                                    : "check units, lengths in m, moduli in Pa"),
                std::string::npos)
          << warning;
      EXPECT_NE(outcome.errors.find("microslip: warning: c.toml: " + warning + "\n"), std::string::npos);
    }
  }
  const auto stored = Hdf5Reader(folder / "out/result.h5").attribute("/", "warnings");
  EXPECT_NE(stored.find("rolling radius of body 1, 0.46 m"), std::string::npos) << stored;
  EXPECT_EQ(document(folder, "solve " + example + " -o out --no-pictures").at("warnings"), io::Json::array());
  EXPECT_FALSE(Hdf5Reader(folder / "out/result.h5").has_attribute("/", "warnings"));
}

TEST(ProgramJson, HertzAgreesWithSolve) {
  const TemporaryFolder folder;
  const auto solved = document(folder, "solve " + example + " -o out --no-pictures");
  const auto hertz = document(folder, "hertz " + example);
  EXPECT_EQ(nlohmann::json(hertz.at("hertz")), nlohmann::json(solved.at("hertz"))); // in any order
  for (const char* body : {"body1", "body2"})
    for (const char* key : {"rolling_radius", "transverse_radius", "poisson_ratio"}) {
      EXPECT_EQ(hertz.at("inputs").at(body).at(key), solved.at("inputs").at(body).at(key)) << body << key;
      EXPECT_NEAR(hertz.at("inputs").at(body).at("shear_modulus").get<double>(), 210e9 / 2.56, 1);
    }
  for (const auto& [path, unit] : hertz.at("units").items()) {
    if (path.ends_with("shear_modulus")) continue; // where Young's modulus is given
    EXPECT_EQ(unit, solved.at("units").at(path)) << path;
  }
  const auto by_options = document(folder, "hertz --rolling-radius 0.46 inf --transverse-radius inf 0.3 "
                                           "--young-modulus 210e9 --poisson-ratio 0.28 --normal-force 80e3");
  EXPECT_EQ(by_options.at("hertz"), hertz.at("hertz"));
  EXPECT_EQ(by_options.at("inputs"), hertz.at("inputs"));
}

TEST(ProgramJson, RunHasTheTotalsOfAllCases) {
  const TemporaryFolder folder;
  const auto json = document(folder, "run " + contact_example + " -o out --mat");
  const Hdf5Reader file(folder / "out/sphere_on_plane.h5");
  EXPECT_EQ(json.at("cases").at("fx").get<std::vector<double>>(), file.values<double>("cases/fx", H5T_NATIVE_DOUBLE));
  EXPECT_EQ(json.at("cases").at("motion").get<std::vector<int>>(), file.values<int>("cases/motion", H5T_NATIVE_INT));
  EXPECT_EQ(json.at("units").at("cases/mz"), "N m");
  EXPECT_FALSE(json.contains("elements"));
  EXPECT_EQ(json.at("cases_not_run"), io::Json::array());
  EXPECT_EQ(json.at("cases_not_solved"), io::Json::array());
  EXPECT_EQ(json.at("files").size(), 4u);
  for (const std::string name : json.at("files")) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

TEST(ProgramJson, RunNamesWhatIsNotRun) {
  const TemporaryFolder folder;
  auto text = contents(contact_example);
  const auto digits = text.find("200100");
  ASSERT_NE(digits, std::string::npos);
  save(folder / "a.inp", text.replace(digits, 6, "250100")); // B = 5
  const auto outcome = run_program(folder, "run a.inp --json");
  EXPECT_EQ(outcome.exit_code, 1);
  const auto json = io::Json::parse(outcome.output);
  ASSERT_FALSE(json.at("cases_not_run").empty()) << outcome.output;
  EXPECT_GT(json.at("cases_not_run").at(0).at("line"), 0);
  EXPECT_FALSE(json.at("cases_not_run").at(0).at("reasons").empty());
  EXPECT_NE(outcome.errors.find("cases are not run"), std::string::npos);
}

TEST(ProgramJson, BatchCountsContacts) {
  const TemporaryFolder folder;
  save(folder / "in.csv",
       "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n"
       "1e200,1e200,82e9,0.28,0.3,80e3,0.001,0,0\n0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n");
  const auto json = document(folder, "batch in.csv -o out.csv --grid 8x8", 1);
  EXPECT_EQ(json.at("contacts"), 2);
  EXPECT_EQ(json.at("contacts_unsolved"), 1);
  EXPECT_EQ(json.at("theory"), "fastsim2");
  EXPECT_EQ(json.at("grid"), "8x8");
  EXPECT_EQ(json.at("files"), Names{"out.csv"});
}

TEST(ProgramJson, PlotAndConvertNameTheirFiles) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "solve " + example + " -o out --no-pictures").exit_code, 0);
  EXPECT_EQ(document(folder, "plot out/result.h5 --cut 0 -o p").at("files"), Names{"p/cut.png"});
  const auto converted = document(folder, "convert " + contact_example + " -o out", 1);
  EXPECT_EQ(converted.at("files"), (Names{"out/sphere_on_plane.0001.toml", "out/sphere_on_plane.0004.toml"}));
  EXPECT_EQ(converted.at("cases_not_written").at(0).at("case"), 2);
  EXPECT_EQ(converted.at("cases_not_written").at(0).at("reason"), "P = 0 (it goes on from another case)");
}

TEST(ProgramJson, ValidateListsTheFiguresThatItPrints) {
  const TemporaryFolder folder;
  const auto json = document(folder, "validate model-problem --no-pictures");
  EXPECT_EQ(json.at("as_stated"), true);
  const auto& study = json.at("studies").at(0);
  EXPECT_EQ(study.at("name"), "model-problem");
  const auto printed = run_program(folder, "validate model-problem --no-pictures").output;
  std::size_t judged = 0, at = 0;
  for (const auto& figure : study.at("figures")) {
    at = printed.find(figure.at("name").get<std::string>(), at); // in the same order
    ASSERT_NE(at, std::string::npos) << figure;
    const auto line = printed.substr(at, printed.find('\n', at) - at);
    EXPECT_NE(line.find(figure.at("computed").get<std::string>()), std::string::npos) << line;
    if (!figure.contains("met")) continue;
    EXPECT_TRUE(line.ends_with(" ok")) << line;
    ++judged;
  }
  EXPECT_GT(judged, 5u);
}

TEST(ProgramJson, ErrorsStayText) {
  const TemporaryFolder folder;
  for (const auto* arguments :
       {"solve none.toml", "hertz none.toml", "run none.inp", "batch none.csv -o out.csv", "convert none.inp",
        "convert none.h5", "plot none.h5", "report none.toml -o r.html", "validate no-such-study"}) {
    const auto outcome = run_program(folder, std::string(arguments) + " --json");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.errors.rfind("microslip: ", 0), 0u) << outcome.errors;
    EXPECT_EQ(outcome.output, "") << arguments;
  }
}

} // namespace
} // namespace microslip
