#include "io/case_file.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "microslip/version.hpp"
#include "paths.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const std::string example = MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml";
const std::string example_table = MICROSLIP_SOURCE_DIR "/examples/contacts.csv";
const std::string header =
    "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n";

/// The lines of a table of results, without the header, split at commas.
std::vector<Names> rows_of(const fs::path& path) {
  std::vector<Names> rows;
  std::ifstream file(path);
  std::string line, field;
  std::getline(file, line);
  while (std::getline(file, line)) {
    rows.emplace_back();
    std::istringstream stream(line);
    while (std::getline(stream, field, ',')) rows.back().push_back(field);
  }
  return rows;
}

EllipticContact contact_of(const Names& row) {
  const auto number = [&](std::size_t column) { return std::stod(row.at(column)); };
  return {.a = number(0),
          .b = number(1),
          .shear_modulus = number(2),
          .poisson_ratio = number(3),
          .normal_force = number(5),
          .friction = FrictionLaw::coulomb(number(4)),
          .creepage = {number(6), number(7), number(8)}};
}

/// Expects a refusal that leaves the folder as it is.
void expect_refused(const TemporaryFolder& folder, const std::string& arguments, const std::string& message) {
  const auto before = folder.entries();
  const auto outcome = run_program(folder, arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.errors.rfind("microslip: ", 0), 0u) << outcome.errors;
  EXPECT_NE(outcome.errors.find(message), std::string::npos) << arguments << "\n" << outcome.errors;
  EXPECT_EQ(folder.entries(), before) << arguments;
}

TEST(Program, SolvesTheExample) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "solve " + example + " --no-pictures");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  for (const auto* text : {"normal force ",
                           " 80 kN\n",
                           "semi-axis a",
                           " mm\n",
                           "peak pressure",
                           " MPa\n",
                           "approach",
                           "exact     fastsim2\n",
                           "force fx",
                           " mu Fn\n",
                           "moment mz",
                           " N m\n",
                           "adhesion area",
                           " mm^2\n",
                           "slip area",
                           "frictional power",
                           " W\n",
                           "discretisation error",
                           "status",
                           " ok\n",
                           "results/hertzian_contact/result.h5\n"})
    EXPECT_NE(outcome.output.find(text), std::string::npos) << text << "\n" << outcome.output;
  EXPECT_EQ(folder.entries(), (Names{"results", "results/hertzian_contact", "results/hertzian_contact/result.h5"}));
}

TEST(Program, WritesWhatTheLibraryComputes) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "solve " + example + " -o out --no-pictures").exit_code, 0);
  const auto input = io::parse_case(io::read_case_text(example), example);
  const auto hertz = hertz_contact(input.problem);
  const auto expected =
      Fastsim2(simplified_options(input.method, RollingDirection::forward)).fields(elliptic_contact(input.problem));

  const Hdf5Reader reader(folder / "out/result.h5");
  const auto scalar = [&](const char* path) { return reader.values<double>(path, H5T_NATIVE_DOUBLE).at(0); };
  EXPECT_EQ(reader.attribute("/", "kind"), "rolling_contact");
  EXPECT_EQ(reader.attribute("/", "version"), build_info().version);
  EXPECT_EQ(reader.attribute("/", "case_text"), contents(example));
  EXPECT_NE(reader.attribute("/", "command_line").find("solve " + example + " -o out"), std::string::npos);
  EXPECT_EQ(scalar("inputs/body1/rolling_radius"), 0.46);
  EXPECT_EQ(reader.attribute("inputs/body1/rolling_radius", "unit"), "m");
  EXPECT_EQ(scalar("inputs/friction/coefficient"), 0.3);
  EXPECT_EQ(reader.text("inputs/solution/bound"), "parabolic");
  EXPECT_EQ(scalar("hertz/a"), hertz.a);
  EXPECT_EQ(scalar("hertz/peak_pressure"), hertz.peak_pressure);
  EXPECT_EQ(scalar("fastsim2/fx"), expected.totals.fx);
  EXPECT_EQ(scalar("fastsim2/mz"), expected.totals.mz);
  const auto exact = Solver(input.method).solve(input.problem);
  EXPECT_EQ(scalar("exact/fx"), exact.totals.fx);
  EXPECT_EQ(scalar("exact/products"), static_cast<double>(exact.report.products));
  EXPECT_EQ(reader.values<double>("exact/fields/px", H5T_NATIVE_DOUBLE), exact.fields.traction.x);
  EXPECT_EQ(reader.values<double>("exact/fields/gap", H5T_NATIVE_DOUBLE).size(), exact.fields.pressure.size());
  EXPECT_EQ(reader.text("exact/status"), "ok");
  EXPECT_GT(scalar("tolerances/exact/discretisation_error_fx"), 0);
  EXPECT_LT(scalar("tolerances/exact/discretisation_error_fx"), 0.02);
  EXPECT_EQ(reader.text("fastsim2/status"), "ok");
  EXPECT_EQ(reader.values<double>("fastsim2/fields/px", H5T_NATIVE_DOUBLE), expected.fields.traction.x);
  EXPECT_EQ(reader.shape("fastsim2/fields/state"), (std::vector<hsize_t>{40, 40}));
  EXPECT_GT(scalar("tolerances/fastsim2/discretisation_error_fx"), 0);
  EXPECT_LT(scalar("tolerances/fastsim2/discretisation_error_fx"), 1e-3);
}

TEST(Program, CreepCurvePassesThroughTheCase) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "solve " + example + " -o out --no-pictures").exit_code, 0);
  const Hdf5Reader reader(folder / "out/result.h5");
  EXPECT_EQ(reader.attribute("creep_curve", "variable"), "creepage_longitudinal");
  const auto point = reader.values<double>("inputs/motion/creepage_longitudinal", H5T_NATIVE_DOUBLE).at(0);
  EXPECT_EQ(point, 0.0018);
  for (const std::string theory : {"fastsim2", "exact"}) {
    const auto value = reader.values<double>("creep_curve/" + theory + "/value", H5T_NATIVE_DOUBLE);
    const auto fx = reader.values<double>("creep_curve/" + theory + "/fx", H5T_NATIVE_DOUBLE);
    EXPECT_EQ(value.front(), 0);
    EXPECT_GE(value.back(), 3 * point * (1 - 1e-15));
    for (std::size_t i = 0; i + 1 < value.size(); ++i) {
      EXPECT_LT(value[i], value[i + 1]);
      if (value[i] > point || value[i + 1] < point) continue;
      const auto point_fx = reader.values<double>(theory + "/fx", H5T_NATIVE_DOUBLE).at(0);
      const double off = theory == "exact" ? 40 : 0; // its curve is that of a coarser grid
      EXPECT_LE(point_fx, fx[i] + off);
      EXPECT_GE(point_fx, fx[i + 1] - off);
    }
  }
}

TEST(Program, ShiftsAndTransientRollingWithForcesGiven) {
  const TemporaryFolder folder;
  const auto solve = [&](const std::string& motion) {
    auto text = contents(example);
    const auto begin = text.find("[motion]"), end = text.find("[solution]");
    text.replace(begin, end - begin, "[motion]\n" + motion + "\n");
    save(folder / "c.toml", text);
    return run_program(folder, "solve c.toml -o out --no-pictures");
  };
  ASSERT_EQ(solve("kind = \"shift\"\nforce_longitudinal = -12e3\nshift_lateral = 1e-6\nrotation = 1e-5").exit_code, 0);
  {
    const Hdf5Reader reader(folder / "out/result.h5");
    EXPECT_NEAR(reader.values<double>("exact/fx", H5T_NATIVE_DOUBLE).at(0), -12e3, 0.1);
    EXPECT_GT(reader.values<double>("exact/creepage_longitudinal", H5T_NATIVE_DOUBLE).at(0), 0);
    EXPECT_FALSE(reader.has("inputs/motion/shift_longitudinal")); // the force is what was given
    EXPECT_EQ(reader.values<double>("inputs/motion/shift_lateral", H5T_NATIVE_DOUBLE).at(0), 1e-6);
    EXPECT_EQ(reader.text("inputs/motion/kind"), "shift");
  }
  ASSERT_EQ(solve("kind = \"transient\"\nforce_longitudinal = -12e3\nsteps = 4\nrolling_speed = 2").exit_code, 0);
  {
    const Hdf5Reader reader(folder / "out/result.h5");
    const auto fx = reader.values<double>("exact/history/fx", H5T_NATIVE_DOUBLE);
    const auto creep = reader.values<double>("exact/history/creepage_longitudinal", H5T_NATIVE_DOUBLE);
    ASSERT_EQ(fx.size(), 4u);
    for (const double force : fx) EXPECT_NEAR(force, -12e3, 0.1);
    EXPECT_EQ(creep.back(), reader.values<double>("exact/creepage_longitudinal", H5T_NATIVE_DOUBLE).at(0));
    EXPECT_NE(creep[0], creep[3]);
  }
  ASSERT_EQ(solve("force_longitudinal = -12e3\nspin = 0.2\nrolling_speed = 2").exit_code, 0);
  {
    const Hdf5Reader reader(folder / "out/result.h5");
    const auto number = [&](const char* path) { return reader.values<double>(path, H5T_NATIVE_DOUBLE).at(0); };
    EXPECT_FALSE(reader.has("inputs/motion/creepage_longitudinal"));
    EXPECT_EQ(number("inputs/motion/creepage_lateral"), 0);
    EXPECT_EQ(number("creep_curve/creepage_longitudinal"), number("exact/creepage_longitudinal"));
    EXPECT_EQ(number("creep_curve/spin"), number("inputs/motion/spin"));
  }
  const auto too_much = solve("force_longitudinal = -30e3\nrolling_speed = 2");
  EXPECT_EQ(too_much.exit_code, 1);
  EXPECT_NE(too_much.errors.find("prescribed force exceeds mu Fn"), std::string::npos);
}

/// Falling friction may have several solutions: a result says from which start it was found.
TEST(Program, SaysWhereFallingFrictionBegan) {
  const TemporaryFolder folder;
  for (const auto& [start, words] : {std::pair{"below", "from rest"}, std::pair{"above", "from full sliding"}}) {
    auto text = contents(example);
    const auto friction = text.find("law = \"coulomb\""), motion = text.find("[motion]");
    text.replace(friction, motion - friction,
                 "law = \"linear\"\nkinetic_coefficient = 0.2\ndrop = 0.1\nhalf_velocity = 1.0\n"
                 "memory_distance = 1e-6\n");
    text.replace(text.find("[solution]"), std::string::npos,
                 "[solution]\ntheory = \"exact\"\ndiscretisation = \"classical\"\ngrid = [12, 12]\n" +
                     ("slip_start = \"" + std::string(start)) + "\"\n");
    save(folder / "c.toml", text);
    const auto outcome = run_program(folder, "solve c.toml -o out --no-pictures");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find(words), std::string::npos) << outcome.output;
    EXPECT_EQ(Hdf5Reader(folder / "out/result.h5").text("inputs/solution/slip_start"), start);
  }
}

/// Hertz and FASTSIM2 stand beside the exact theory for simpler bodies than it has: the reader is told.
TEST(Program, SaysWhatHertzAndFastsim2Assume) {
  const TemporaryFolder folder;
  const auto solve = [&](const std::string& from, const std::string& to) {
    auto text = contents(example);
    for (const auto& [old, now] :
         {std::pair{from, to}, {"[40, 40]", "[9, 9]"}, {"= \"second_order\"", "= \"classical\""}})
      text.replace(text.find(old), old.size(), now);
    save(folder / "c.toml", text);
    return run_program(folder, "solve c.toml -o out --no-pictures").output;
  };
  const auto expect_attributes = [&](bool hertz, const std::string& fastsim2) {
    const Hdf5Reader reader(folder / "out/result.h5");
    EXPECT_EQ(reader.has_attribute("hertz", "assumes"), hertz);
    ASSERT_EQ(reader.has_attribute("fastsim2", "assumes"), !fastsim2.empty());
    if (!fastsim2.empty()) {
      EXPECT_EQ(reader.attribute("fastsim2", "assumes"), fastsim2);
    }
  };
  const auto plain = solve("[load]", "[load]");
  EXPECT_EQ(plain.find("assumes"), std::string::npos);
  EXPECT_NE(plain.find("\nHertz\n"), std::string::npos);
  expect_attributes(false, "");
  const auto viscoelastic = solve("[body2]", "creep_ratio = 0.5\ncreep_time = 1e-3\n\n[body2]");
  EXPECT_NE(viscoelastic.find("\nHertz, elastic bodies of K = 0 without friction\n"), std::string::npos)
      << viscoelastic;
  EXPECT_NE(viscoelastic.find("fastsim2 assumes"), std::string::npos) << viscoelastic;
  expect_attributes(true, "elastic bodies of K = 0");
  const auto layered = solve("[load]", "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\n\n[load]");
  EXPECT_NE(layered.find("\nHertz\n"), std::string::npos) << layered;
  expect_attributes(false, "no layer");
}

TEST(Program, SolvesEveryExampleWithPictures) {
  const std::map<std::string, Names> pictures = {
      {"hertzian_contact", {"areas.png", "creep_curve.png", "tractions.png"}},
      {"two_rollers", {"areas.png", "creep_curve.png", "friction_law.png", "tractions.png"}},
      {"rubber_roller", {"creep_curve.png", "nip.png"}},
      {"coated_roller", {"areas.png", "creep_curve.png", "nip.png", "tractions.png"}},
      {"starting_to_roll", {"areas.png", "history.png", "tractions.png"}}};
  const TemporaryFolder folder;
  for (const auto& [name, names] : pictures) {
    const auto outcome = run_program(folder, "solve " MICROSLIP_SOURCE_DIR "/examples/" + name + ".toml -o " + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    for (const std::string& picture : names) {
      EXPECT_GT(fs::file_size(folder / name / picture), 1000u);
      EXPECT_NE(outcome.output.find(name + "/" + picture + "\n"), std::string::npos);
    }
  }
}

TEST(Program, PlotDrawsWhatIsAskedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "solve " + example + " -o out --no-pictures").exit_code, 0);
  const auto outcome =
      run_program(folder, "plot out/result.h5 -o p --field pressure --field px --surface slip --cut=-1.5");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "p/field_pressure.png\np/field_px.png\np/surface_slip.png\np/cut.png\n");
  EXPECT_EQ(folder.entries(), (Names{"out", "out/result.h5", "p", "p/cut.png", "p/field_pressure.png", "p/field_px.png",
                                     "p/surface_slip.png"}));
  const auto unknown = run_program(folder, "plot out/result.h5 --field heat");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("field 'heat' is unknown, known: pressure"), std::string::npos);
  const auto missing = run_program(folder, "plot nowhere.h5");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.errors.find("nowhere.h5: no such file"), std::string::npos);
}

TEST(Program, WarnsWithoutPythonAndKeepsTheResult) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "solve " + example + " -o out", "export MICROSLIP_PYTHON=/none");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors.rfind("microslip: warning: pictures are missing: /none cannot be started", 0), 0u);
  EXPECT_NE(outcome.errors.find("install python3-h5py"), std::string::npos);
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
  EXPECT_EQ(folder.entries(), (Names{"out", "out/result.h5"}));
}

TEST(Program, InitWritesEveryExampleWithWhatItNeeds) {
  const std::filesystem::path originals = MICROSLIP_SOURCE_DIR "/examples";
  for (const std::string name :
       {"hertzian_contact", "two_rollers", "rubber_roller", "coated_roller", "twin_disc", "starting_to_roll",
        "friction_of_ones_own", "wheel_on_rail", "lateral_sweep", "wheelset_in_curve"}) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_program(folder, "init --example " + name + " a.toml").exit_code, 0) << name;
    EXPECT_EQ(contents(folder / "a.toml"), contents(originals / (name + ".toml")));
    const Outcome solved = run_program(folder, "solve a.toml --no-pictures");
    EXPECT_EQ(solved.exit_code, 0) << name << ": " << solved.errors;
  }
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder, "init --example wheel_rail_sample s.toml").output,
            "wheel_on_rail.toml\nprofiles/60e1.prr\nprofiles/s1002.prw\ns.toml\n");
  EXPECT_EQ(run_program(folder, "init --example wheel_on_rail r.toml").output, "r.toml\n"); // profiles are there
  save(folder / "profiles/60e1.prr", "mine");
  expect_refused(folder, "init --example lateral_sweep l.toml", "profiles/60e1.prr: is there already");
  EXPECT_FALSE(std::filesystem::exists(folder / "l.toml"));
  expect_refused(folder, "init --example wheel_rail x.toml", "did you mean wheel_on_rail?");
}

TEST(Program, InitWritesTheExampleOnce) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder, "init").output, "case.toml\n");
  EXPECT_EQ(contents(folder / "case.toml"), contents(example));
  EXPECT_EQ(run_program(folder, "solve case.toml --no-pictures").exit_code, 0);
  save(folder / "case.toml", "mine");
  expect_refused(folder, "init", "case.toml: is there already");
  EXPECT_EQ(contents(folder / "case.toml"), "mine");
  EXPECT_EQ(run_program(folder, "init case.toml --force").exit_code, 0);
  EXPECT_EQ(contents(folder / "case.toml"), contents(example));
  expect_refused(folder, "init case.toml/x", "cannot be written");
  expect_refused(folder, "init /proc/x", "cannot be written");
}

TEST(Program, HertzAgreesWithTheCaseFile) {
  const TemporaryFolder folder;
  const auto by_case = run_program(folder, "hertz " + example);
  const auto by_options =
      run_program(folder, "hertz --rolling-radius 0.46 inf --transverse-radius inf 0.3 --young-modulus 210e9 "
                          "--poisson-ratio 0.28 --normal-force 80e3");
  EXPECT_EQ(by_case.exit_code, 0) << by_case.errors;
  EXPECT_EQ(by_case.output, by_options.output);
  EXPECT_NE(by_case.output.find(" MPa\n"), std::string::npos);
}

TEST(Program, HertzRefusesBadOptions) {
  const TemporaryFolder folder;
  const std::string radii = "hertz --rolling-radius 0.46 inf --transverse-radius inf 0.3 ";
  const std::string good = radii + "--shear-modulus 82e9 --poisson-ratio 0.28 ";
  for (const auto* load : {"0", "-80e3", "inf", "nan"}) {
    expect_refused(folder, good + "--normal-force=" + load, "--normal-force = ");
    expect_refused(folder, good + "--approach=" + load, "--approach = ");
  }
  for (const auto* nu : {"-0.1", "0.51", "nan"})
    expect_refused(folder, radii + "--shear-modulus 82e9 --normal-force 1 --poisson-ratio=" + nu,
                   "must be in [0, 0.5]");
  for (const auto* modulus : {"0", "-1", "nan"})
    expect_refused(folder, radii + "--poisson-ratio 0.3 --normal-force 1 --shear-modulus=" + modulus,
                   "--shear-modulus = ");
  expect_refused(folder, radii + "--poisson-ratio 0.3 --normal-force 1 --shear-modulus=inf", "shear_modulus = inf");
  expect_refused(folder,
                 "hertz --rolling-radius 0 inf --transverse-radius inf 0.3 --shear-modulus 1 --poisson-ratio 0 "
                 "--normal-force 1",
                 "= 0 [m]: must be ");
  expect_refused(folder, good, "either --normal-force or --approach");
  expect_refused(folder, "hertz " + example + " --approach 1e-4", "not both");
}

TEST(Program, BatchGivesWhatTheLibraryComputes) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "batch " + example_table + " -o out.csv").exit_code, 0);
  ASSERT_EQ(run_program(folder, "batch " + example_table +
                                    " -o first.csv --theory fastsim --grid 7x5 --bound elliptic "
                                    "--flexibility blended")
                .exit_code,
            0);
  ASSERT_EQ(run_program(folder, "batch " + example_table + " -o strips.csv --theory fastrip --grid 7x5").exit_code, 0);
  EXPECT_EQ(contents(folder / "out.csv")
                .rfind(header.substr(0, header.size() - 1) + ",fx,fy,mz,adhesion_area,slip_area,status\n", 0),
            0u);
  Fastsim2 fastsim2;
  Fastsim fastsim({.mx = 7, .my = 5, .bound = TractionBound::elliptic, .flexibility = FlexibilityModel::blended});
  Fastrip fastrip({.mx = 7, .my = 5, .bound = TractionBound::elliptic, .flexibility = FlexibilityModel::blended});
  const auto expect_row = [](const Names& row, auto& solver) {
    const auto expected = solver.solve(contact_of(row));
    EXPECT_EQ(std::stod(row.at(9)), expected.fx);
    EXPECT_EQ(std::stod(row.at(10)), expected.fy);
    EXPECT_EQ(std::stod(row.at(11)), expected.mz);
    EXPECT_EQ(std::stod(row.at(12)), expected.adhesion_area);
    EXPECT_EQ(std::stod(row.at(13)), expected.slip_area);
    EXPECT_EQ(row.at(14), "ok");
  };
  const auto rows = rows_of(folder / "out.csv");
  ASSERT_EQ(rows.size(), 6u);
  for (const auto& row : rows) expect_row(row, fastsim2);
  for (const auto& row : rows_of(folder / "first.csv")) expect_row(row, fastsim);
  for (const auto& row : rows_of(folder / "strips.csv")) expect_row(row, fastrip);
}

TEST(Program, BatchWarnsOfImplausibleContacts) {
  const TemporaryFolder folder;
  save(folder / "in.csv", header + "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n"   // as it should be
                                   "6,5,82e9,0.28,0.3,80e3,0.001,0,0\n"           // mm
                                   "0.006,0.005,82e3,0.28,0.3,80e3,0.001,0,0\n"); // MPa
  const auto outcome = run_program(folder, "batch in.csv -o out.csv");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors,
            "microslip: warning: in.csv:4: peak pressure 1.27324e+09 Pa beside Young's modulus, 209920 Pa, is far "
            "beyond linear elasticity: check units, lengths in m, moduli in Pa, forces in N; 1 such row in all\n"
            "microslip: warning: in.csv:3: peak pressure 1273.24 Pa beside the shear modulus, 8.2e+10 Pa, is "
            "implausible: check units, lengths in m, moduli in Pa, forces in N; 1 such row in all\n"
            "microslip: warning: in.csv:4: Young's modulus of both bodies combined, 209920 Pa, is very small: is it in "
            "MPa? Numbers are in Pa; 1 such row in all\n");
}

TEST(Program, BatchDoesNotDependOnThreads) {
  const TemporaryFolder folder;
  std::string table = header;
  for (int i = 0; i < 20000; ++i) {
    const auto step = std::to_string(i);
    table += "0.006,0.005,82e9,0.28,0.3,8" + step + ",0.000" + step + ",-0.0003,0." + step + "\n";
  }
  save(folder / "in.csv", table);
  ASSERT_EQ(run_program(folder, "batch in.csv -o 1.csv --grid 3 --threads 1").exit_code, 0); // 3 for 3x3
  ASSERT_EQ(run_program(folder, "batch in.csv -o 5.csv --grid 3x3 --threads 5").exit_code, 0);
  const auto streamed = run_program(folder, "batch /dev/stdin -o /dev/stdout --grid 3x3 < in.csv");
  EXPECT_EQ(streamed.output, contents(folder / "1.csv"));
  EXPECT_EQ(rows_of(folder / "1.csv").size(), 20000u);
  EXPECT_EQ(contents(folder / "1.csv"), contents(folder / "5.csv"));
}

TEST(Program, BatchSolvesExtremeContacts) {
  const TemporaryFolder folder;
  std::string table = header;
  const Names ellipses = {"0.005,0.005", "5e-6,5", "5,5e-6"};
  const Names creepages = {"0,0,0", "1e-12,0,0", "0,1e-12,0", "0,0,1e-12", "1e3,0,0", "0,-1e3,0", "1e3,-1e3,1e3"};
  for (const auto& ellipse : ellipses)
    for (const auto& creepage : creepages) table += ellipse + ",82e9,0.28,0.3,80e3," + creepage + "\n";
  save(folder / "in.csv", table);
  for (const auto* options : {"--grid 10x10", "--grid 1x1", "--grid 10000x1", "--grid 1x10000", "--theory fastsim",
                              "--flexibility one", "--flexibility blended", "--bound elliptic"}) {
    const auto outcome = run_program(folder, "batch in.csv -o out.csv " + std::string(options));
    EXPECT_EQ(outcome.exit_code, 0) << options << outcome.errors;
    for (const auto& row : rows_of(folder / "out.csv")) {
      const auto contact = contact_of(row);
      const auto force = std::hypot(std::stod(row.at(9)), std::stod(row.at(10))), limit = 24e3;
      const auto& creepage = contact.creepage;
      const auto translation = std::hypot(creepage.longitudinal, creepage.lateral);
      EXPECT_LE(force, limit * (1 + 1e-12)) << options;
      EXPECT_NEAR(std::stod(row.at(12)) + std::stod(row.at(13)), std::numbers::pi * contact.a * contact.b, 1e-18);
      const bool spins = creepage.spin != 0;
      if (translation == 0 && !spins) {
        EXPECT_EQ(force, 0) << options;
      } else if (translation > 1 && !spins) {
        EXPECT_NEAR(force, limit, limit * 1e-12) << options;
      }
    }
  }
}

TEST(Program, BatchFollowsLinearTheoryAtVanishingCreepage) {
  const TemporaryFolder folder;
  save(folder / "in.csv", header + "0.005,0.004,82e9,0.28,0.3,80e3,1e-12,0,0\n");
  ASSERT_EQ(run_program(folder, "batch in.csv -o out.csv --grid 400x400").exit_code, 0);
  const auto linear = -82e9 * 0.005 * 0.004 * creepage_coefficients(1.25, 0.28).c11 * 1e-12;
  EXPECT_NEAR(std::stod(rows_of(folder / "out.csv").at(0).at(9)), linear, std::abs(linear) * 1e-4);
}

TEST(Program, BatchByTheExactTheory) {
  const TemporaryFolder folder;
  std::string rows = header;
  for (const auto* creepages : {"0.001,0.0005,0.2", "0,0,0", "1,0,0", "0,0,3", "1e-9,0,0"})
    for (const auto* axes : {"0.006,0.005", "0.002,0.009"})
      rows += axes + std::string(",82e9,0.28,0.3,80e3,") + creepages + "\n";
  rows += "1e200,1e200,82e9,0.28,0.3,80e3,0.001,0,0\n"; // does not stop the others
  rows += "0.006,0.005,82e9,0.28,0,80e3,0.001,0,0\n";
  save(folder / "in.csv", rows);
  const auto one = run_program(folder, "batch in.csv -o one.csv --theory exact --grid 8x12 --threads 1");
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_NE(one.errors.find("microslip: warning: in.csv:12: peak pressure 0 Pa beside the shear modulus"),
            std::string::npos)
      << one.errors;
  EXPECT_NE(one.errors.find("microslip: warning: one.csv: 1 of 12 contacts are not solved, see their status\n"),
            std::string::npos);
  EXPECT_EQ(run_program(folder, "batch in.csv -o two.csv --theory exact --grid 8x12 --threads 2").exit_code, 1);
  EXPECT_EQ(contents(folder / "one.csv"), contents(folder / "two.csv"));
  EXPECT_NE(contents(folder / "one.csv").find("slip_area,status,residual,iterations\n"), std::string::npos);

  Solver solver({.mx = 8, .my = 12});
  const auto table = rows_of(folder / "one.csv");
  ASSERT_EQ(table.size(), 12u);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& row = table[i];
    EXPECT_EQ(row.at(14), i == 10 ? "invalid_input" : "ok");
    if (i == 10) continue;
    const auto expected = solver.solve(rolling_problem(contact_of(row)));
    EXPECT_EQ(std::stod(row.at(9)), expected.totals.fx);
    EXPECT_EQ(std::stod(row.at(11)), expected.totals.mz);
    EXPECT_EQ(std::stod(row.at(15)), expected.report.residual);
    EXPECT_LE(expected.report.residual, 1e-6);
    EXPECT_EQ(row.at(16), std::to_string(expected.report.newton_steps));
  }
  EXPECT_NE(run_program(folder, "batch in.csv -o x.csv --theory exact --grid 0x12").exit_code, 0);
}

TEST(Program, BatchOfDissimilarBodies) {
  const TemporaryFolder folder;
  const std::vector<double> dissimilarities = {0, 0.1, 0.1, -0.1, 0};
  std::string rows = "dissimilarity," + header;
  for (const double k : dissimilarities)
    rows += std::to_string(k) + ",0.006,0.005,82e9,0.28,0.3,80e3,0.001,0.0005,0.2\n";
  save(folder / "in.csv", rows);
  ASSERT_EQ(run_program(folder, "batch in.csv -o out.csv --theory exact --grid 8x8").exit_code, 0);
  const auto table = rows_of(folder / "out.csv");
  ASSERT_EQ(table.size(), dissimilarities.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Names without_k(table[i].begin() + 1, table[i].end());
    EllipticContact contact = contact_of(without_k);
    contact.dissimilarity = dissimilarities[i];
    const auto expected = Solver({.mx = 8, .my = 8}).solve(rolling_problem(contact));
    EXPECT_EQ(std::stod(table[i].at(10)), expected.totals.fx);
    EXPECT_EQ(std::stod(table[i].at(11)), expected.totals.fy);
  }
  EXPECT_NE(table[1].at(10), table[0].at(10));
  EXPECT_NE(table[1].at(10), table[3].at(10));
  const std::string column = "in.csv:3: column dissimilarity = 0.1 [-]: must be 0 ";
  expect_refused(folder, "batch in.csv -o x.csv", column + "unless --theory is exact");
  expect_refused(folder, "batch in.csv -o x.csv --theory exact --discretisation second_order",
                 column + "with --discretisation second_order");
}

TEST(Program, BatchTakesTheOptionsOfTheExactTheory) {
  const TemporaryFolder folder;
  const std::string row = "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0.0005,0.9\n";
  save(folder / "in.csv", header + row);
  const auto solved = [&](const std::string& options) {
    const auto outcome = run_program(folder, "batch in.csv -o out.csv --grid 8x8 " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return rows_of(folder / "out.csv").at(0);
  };
  const auto expect = [&](const Names& found, const Method& method,
                          RollingDirection direction = RollingDirection::forward) {
    const auto expected = Solver(method).solve(rolling_problem(contact_of(found), {.direction = direction}));
    EXPECT_EQ(std::stod(found.at(9)), expected.totals.fx);
    EXPECT_EQ(std::stod(found.at(15)), expected.report.residual);
  };
  expect(solved("--theory exact --tolerance 1e-9"), {.mx = 8, .my = 8, .tolerance = 1e-9});
  expect(solved("--theory exact --direction backward"), {.mx = 8, .my = 8}, RollingDirection::backward);
  expect(solved("--theory exact --discretisation classical --elements bilinear"),
         {.mx = 8, .my = 8, .discretisation = Discretisation::classical, .elements = ElementShape::bilinear});
  const auto backward = solved("--direction backward");
  Fastsim2 fastsim2({.mx = 8, .my = 8, .direction = RollingDirection::backward});
  EXPECT_EQ(std::stod(backward.at(9)), fastsim2.solve(contact_of(backward)).fx);
  const auto refused = [&](const std::string& options, const std::string& message) {
    expect_refused(folder, "batch in.csv -o x.csv " + options, message);
  };
  refused("--tolerance 1e-9", "--tolerance: needs --theory exact");
  refused("--elements bilinear", "--elements: needs --theory exact");
  refused("--discretisation classical", "--discretisation: needs --theory exact");
  refused("--theory exact --bound elliptic", "--bound: needs the simplified theory");
  refused("--theory exact --flexibility one", "--flexibility: needs the simplified theory");
  refused("--theory exact --coefficients computed", "--coefficients: needs the simplified theory");
  refused("--theory exact --elements bilinear", "--elements: bilinear ones need --discretisation classical");
  refused("--theory fastrip --bound parabolic", "--bound: must be elliptic with --theory fastrip");
  refused("--theory exact --tolerance 1", "--tolerance = 1 [-]: must be in [1e-14, 0.1]");
}

TEST(Program, MarksWhatCannotBeComputed) {
  const TemporaryFolder folder;
  save(folder / "in.csv",
       header + "1e200,1e200,82e9,0.28,0.3,80e3,0.001,0,0\n0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n");
  const auto batch = run_program(folder, "batch in.csv -o out.csv");
  EXPECT_EQ(batch.exit_code, 1);
  EXPECT_NE(batch.errors.find("microslip: warning: out.csv: 1 of 2 contacts are not solved"), std::string::npos);
  const auto rows = rows_of(folder / "out.csv");
  EXPECT_EQ(rows.at(0).at(9), "nan");
  EXPECT_EQ(rows.at(0).at(14), "invalid_input");
  EXPECT_EQ(rows.at(1).at(14), "ok");

  auto text = contents(example);
  text.replace(text.find("\"80 kN\""), 7, "1e300").replace(text.find("0.0018"), 6, "1e300");
  save(folder / "w.toml", text);
  const auto solve = run_program(folder, "solve w.toml -o out --no-pictures");
  EXPECT_EQ(solve.exit_code, 1);
  EXPECT_NE(solve.errors.find("microslip: warning: w.toml: overflow or underflow in the computation"),
            std::string::npos)
      << solve.errors;
  EXPECT_NE(Hdf5Reader(folder / "out/result.h5").text("exact/status"), "ok");
}

TEST(Program, BatchReadsStandardInputAndItsOwnOutput) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "batch " + example_table + " -o first.csv").exit_code, 0);
  ASSERT_EQ(run_program(folder, "batch first.csv -o second.csv").exit_code, 0);
  const auto streamed = run_program(folder, "batch - -o - < first.csv");
  EXPECT_EQ(streamed.exit_code, 0) << streamed.errors;
  EXPECT_EQ(contents(folder / "second.csv"), contents(folder / "first.csv"));
  EXPECT_EQ(streamed.output, contents(folder / "first.csv"));
  expect_refused(folder, "batch - -o out.csv < /dev/null", "standard input: is empty");
}

TEST(Program, BatchNeverReplacesItsInput) {
  const TemporaryFolder folder;
  const std::string text = contents(example_table);
  save(folder / "in.csv", text);
  std::filesystem::create_symlink("in.csv", folder / "link.csv");
  for (const auto* files : {"in.csv -o in.csv", "in.csv -o ./link.csv", "link.csv -o in.csv", "- -o in.csv < in.csv",
                            "in.csv -o out.csv --errors in.csv"}) {
    expect_refused(folder, std::string("batch ") + files, "is the input, which the output would replace");
    EXPECT_EQ(contents(folder / "in.csv"), text);
  }
  std::filesystem::create_symlink("same.csv", folder / "same_link.csv");
  std::filesystem::create_symlink("new.csv", folder / "new_link.csv");
  std::filesystem::create_directory_symlink(".", folder / "here");
  save(folder / "same.csv", "old\n");
  for (const auto* files : {"out.csv --errors out.csv", "out.csv --errors ./out.csv", "here/out.csv --errors out.csv",
                            "same.csv --errors same_link.csv", "new.csv --errors new_link.csv"})
    expect_refused(folder, std::string("batch in.csv -o ") + files, "must be different files");
  EXPECT_EQ(contents(folder / "same.csv"), "old\n");
  EXPECT_EQ(run_program(folder, "batch in.csv -o /dev/null --errors /dev/stdout").exit_code, 0);
  expect_refused(folder, "batch in.csv -o - --json", "--json needs a file for --output");
}

TEST(Program, BatchListsAndSkipsBadRows) {
  const TemporaryFolder folder;
  const std::string row = "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n";
  std::string good = header, mixed = header, list = "line,error\n";
  for (int i = 0; i < 3000; ++i) {
    good += row;
    mixed += row;
    if (i % 1000 != 0) continue;
    mixed += "0.006,0.005,82e9,0.7,0.3,80e3,0.001,0,0\n";
    list += std::to_string(i + 3 + i / 1000) + ",\"column poisson_ratio = 0.7 [-]: must be in [0, 0.5]\"\n";
  }
  save(folder / "good.csv", good);
  save(folder / "in.csv", mixed);
  ASSERT_EQ(run_program(folder, "batch good.csv -o good_out.csv").exit_code, 0);
  const auto listed = run_program(folder, "batch in.csv -o out.csv --errors errors.csv");
  EXPECT_EQ(listed.exit_code, 2);
  EXPECT_EQ(listed.errors,
            "microslip: in.csv:3: column poisson_ratio = 0.7 [-]: must be in [0, 0.5]; 3 bad rows in all, "
            "listed in errors.csv\n");
  EXPECT_EQ(contents(folder / "errors.csv"), list);
  EXPECT_FALSE(std::filesystem::exists(folder / "out.csv"));
  for (const auto* theory : {"", " --theory exact --grid 3x3"}) {
    ASSERT_EQ(run_program(folder, std::string("batch good.csv -o good_out.csv") + theory).exit_code, 0);
    const auto skipped =
        run_program(folder, std::string("batch in.csv -o out.csv --skip-bad --errors errors.csv") + theory);
    EXPECT_EQ(skipped.exit_code, 1);
    EXPECT_EQ(skipped.errors,
              "microslip: warning: out.csv: left out: in.csv:3: column poisson_ratio = 0.7 [-]: must be "
              "in [0, 0.5]; 3 bad rows in all, listed in errors.csv\n");
    EXPECT_EQ(contents(folder / "out.csv"), contents(folder / "good_out.csv"));
    EXPECT_EQ(contents(folder / "errors.csv"), list);
  }
  const auto none = run_program(folder, "batch good.csv -o out.csv --errors errors.csv");
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_EQ(contents(folder / "errors.csv"), "line,error\n");
}

TEST(Program, BatchRefusesBadTables) {
  const TemporaryFolder folder;
  const std::string row = "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n";
  std::string many = header, binary;
  for (int i = 0; i < 3000; ++i) many += row;
  for (unsigned i = 0; i < 100000; ++i) binary += static_cast<char>((i * 7919) >> 3);
  save(folder / "empty.csv", "");
  save(folder / "binary.csv", binary);
  save(folder / "missing.csv",
       "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral\n");
  save(folder / "truncated.csv", many + row.substr(0, 20));
  save(folder / "bad.csv", many + "0.006,0.005,82e9,0.7,0.3,80e3,0.001,0,0\n" + row);
  save(folder / "late.csv", many + many.substr(header.size()) + "x\n");
  save(folder / "out.csv", "old");
  for (const auto* threads : {" -o out.csv --threads 1", " -o out.csv --threads 3", " -o new.csv"}) {
    const auto refused = [&](const std::string& name, const std::string& message) {
      expect_refused(folder, "batch " + name + threads, message);
    };
    refused("empty.csv", "microslip: empty.csv: is empty");
    refused("binary.csv", "microslip: binary.csv: is UTF-16 or no text; it must be UTF-8 or ASCII");
    refused("missing.csv", "microslip: missing.csv:1: column spin: is missing");
    refused("truncated.csv", "truncated.csv:3002: 4 fields, not 9; the file ends in the middle of a line");
    refused("bad.csv", "bad.csv:3002: column poisson_ratio = 0.7 [-]: must be in [0, 0.5]");
    refused("late.csv", "late.csv:6002: 1 field, not 9");
    refused("none.csv", "none.csv: cannot be read: No such file or directory");
    refused(".", ".: cannot be read: it is a folder");
  }
  EXPECT_EQ(contents(folder / "out.csv"), "old");
}

TEST(Program, BatchRefusesBadOptions) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& options, const std::string& message) {
    expect_refused(folder, "batch " + example_table + " -o out.csv " + options, message);
  };
  for (const auto* grid : {"0x10", "10x0", "-1x10", "10001x10", "10x10001"})
    refused(std::string("--grid=") + grid, "[-]: must be in [1, 10000]");
  for (const auto* grid : {"ten", "10x", "x10", "10x10x10", "axb", "10,10", "99999999999x1"})
    refused(std::string("--grid=") + grid, "must be one or two whole numbers, e.g. 10 or 10x20");
  refused("--theory fastsim3", "did you mean fastsim?");
  refused("--theory table --grid 10", "--grid: cannot be combined with --theory table");
  refused("--bound parabolik", "did you mean parabolic?");
  refused("--flexibility two", "must be three, one or blended");
  refused("--threads 0", "--threads = 0 [-]: must be in [1, 1024]");
  refused("--threads many", "microslip: --threads = many: must be a number; see microslip batch --help");
  refused("--gird 10x10", "unknown option \"--gird\"; did you mean --grid?");
}

TEST(Program, LeavesNothingInAFolderThatCannotBeWritten) {
  const TemporaryFolder folder;
  save(folder / "file", "x");
  for (const auto* place : {"file/out", "/proc/out"}) {
    expect_refused(folder, "solve " + example + " -o " + place, place + std::string(": cannot be"));
    expect_refused(folder, "batch " + example_table + " -o " + place, place + std::string(": cannot be written"));
  }
  expect_refused(folder, "batch " + example_table + " -o none/out.csv", "none/out.csv: cannot be written");
}

TEST(Program, LeavesNothingOnAFullDisk) {
  const TemporaryFolder folder;
  std::string table = header;
  for (int i = 0; i < 3000; ++i) table += "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n";
  save(folder / "in.csv", table);
  const auto outcome = run_program(folder, "batch in.csv -o out.csv", "ulimit -f 8 && trap '' XFSZ");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "microslip: out.csv: cannot be written: File too large\n");
  EXPECT_EQ(folder.entries(), Names{"in.csv"});
}

TEST(Program, SaysWhenItsOutputIsLost) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, "init wheel.toml").exit_code, 0);
  ASSERT_EQ(run_program(folder, "solve wheel.toml -o out --no-pictures").exit_code, 0);
  const std::string inp = MICROSLIP_SOURCE_DIR "/examples/sphere_on_plane.inp";
  for (const std::string& arguments :
       {std::string("--version"), std::string("--help"), std::string("solve wheel.toml --no-pictures"),
        std::string("solve wheel.toml --no-pictures --json"), std::string("hertz wheel.toml"),
        std::string("hertz wheel.toml --json"), "batch '" + example_table + "' -o forces.csv --json",
        std::string("init other.toml"), "run '" + inp + "'", "run '" + inp + "' --json", "convert '" + inp + "'",
        "convert '" + inp + "' --json", std::string("plot out/result.h5 --cut 0"),
        std::string("plot out/result.h5 --cut 0 --json"), std::string("validate --list"),
        std::string("validate model-problem --no-pictures"), std::string("completion bash"), std::string("manual")}) {
    const auto outcome = run_program(folder, arguments, "true", "/dev/full");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.errors.find("microslip: standard output cannot be written\n"), std::string::npos)
        << arguments << "\n"
        << outcome.errors;
  }
}

TEST(Program, LeavesNothingAfterAnInterrupt) {
  const TemporaryFolder folder;
  const auto input = (folder / "in.csv").string(), output = (folder / "out.csv").string();
  ASSERT_EQ(mkfifo(input.c_str(), 0600), 0);
  const auto child = fork();
  if (child == 0) {
    execl(MICROSLIP_PROGRAM, "microslip", "batch", input.c_str(), "-o", output.c_str(), nullptr);
    _exit(127);
  }
  {
    std::ofstream pipe(input); // waits until the program reads
    pipe << header << "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n" << std::flush;
    std::signal(SIGPIPE, SIG_IGN);
    const std::string rows(std::size_t{40} * 1024, '\n');
    pipe << rows << std::flush; // more than one chunk, so that the header is read and the output is open
    while (folder.entries().size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(child, SIGINT);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.entries(), Names{"in.csv"});
}

TEST(Program, RefusesBadCaseFiles) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& message) {
    auto text = contents(example);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    save(folder / "w.toml", text.replace(at, from.size(), to));
    expect_refused(folder, "solve w.toml", "microslip: w.toml:");
    expect_refused(folder, "solve w.toml", message);
  };
  refused("normal_force", "normal_forse", "load.normal_forse: unknown key; did you mean normal_force?");
  for (const auto* value : {"0", "-80e3", "inf", "nan"}) refused("\"80 kN\"", value, "load.normal_force = ");
  refused("= \"460 mm\"", "= 0", "body1.rolling_radius = 0 [m]: must be ");
  refused("= \"460 mm\"", "= nan", "body1.rolling_radius = nan [m]: must be ");
  refused("= \"210 GPa\"", "= -1", "body1.young_modulus = -1 [Pa]: must be ");
  refused("= 0.28", "= 0.6", "body1.poisson_ratio = 0.6 [-]: must be in [0, 0.5]");
  refused("coefficient = 0.3", "coefficient = -0.3", "friction.coefficient = -0.3 [-]: must be in [0, 10]");
  refused("[40, 40]", "[0, 40]", "solution.grid = 0 [-]: must be in [1, 2000]");
  refused("[40, 40]", "[40, 10000]", "solution.grid = 10000 [-]: must be in [1, 2000]");
  refused("0.0018", "nan", "motion.creepage_longitudinal = nan [-]: must be finite");
  save(folder / "w.toml", std::string(1000, '\0'));
  expect_refused(folder, "solve w.toml", "w.toml: is UTF-16 or no text; it must be UTF-8 or ASCII");
  expect_refused(folder, "solve none.toml", "none.toml: cannot be read: No such file or directory");
}

TEST(Program, SolvesExtremeCases) {
  const TemporaryFolder folder;
  const auto solves = [&](const std::string& from, const std::string& to) {
    auto text = contents(example);
    save(folder / "w.toml", text.replace(text.find(from), from.size(), to));
    const auto outcome = run_program(folder, "solve w.toml -o out --no-pictures");
    EXPECT_EQ(outcome.exit_code, 0) << to << outcome.errors;
    EXPECT_EQ(outcome.output.find("nan"), std::string::npos) << to << outcome.output;
  };
  solves("[40, 40]", "[1, 1]");
  solves("[40, 40]", "[2000, 3]");
  solves("coefficient = 0.3", "coefficient = 0");
  for (const auto* creepage : {"0", "1e-12", "1e3"}) solves("0.0018", creepage);
  for (const auto* lateral : {"0", "1e-3"})
    solves("creepage_longitudinal = 0.0018", std::string("creepage_longitudinal = 0 # ") + lateral);
  solves("normal_force = \"80 kN\"", "normal_force = 1e-6");
}

TEST(Program, ExplainsItself) {
  const TemporaryFolder folder;
  for (const auto* command : {"", "solve ", "hertz ", "batch ", "init ", "run ", "plot ", "profile ", "conicity ",
                              "convert ", "explore ", "report ", "validate ", "bench ", "completion ", "manual "}) {
    const auto outcome = run_program(folder, command + std::string("--help"));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.output.find("\nExample:\n  "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("microslip " + std::string(command)), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(folder.entries(), Names{});
  }
  const auto version = run_program(folder, "--version");
  EXPECT_EQ(version.exit_code, 0);
  const auto build = build_info();
  for (const auto part : {build.version, build.commit, build.compiler})
    EXPECT_NE(version.output.find(part), std::string::npos);
}

TEST(Program, HelpNamesUnitsAndDefaults) {
  const TemporaryFolder folder;
  const auto help = [&](const std::string& command) { return run_program(folder, command + " --help").output; };
  const auto expect_text = [&](const std::string& command, const std::vector<std::string>& texts) {
    const auto output = help(command);
    for (const auto& text : texts) EXPECT_NE(output.find(text), std::string::npos) << text << "\n" << output;
  };
  expect_text("solve", {"in units that fit", "(SI)", "default: results/NAME"});
  expect_text("hertz", {"R1 R2", "[m]", "[Pa]", "[-]", "[N]"});
  expect_text("batch", {"fastsim|fastsim_half_step|fastsim2|exact|fastrip", "default: fastsim2", "default: 10x10",
                        "default: kalker", "default: second_order", "normal_force [N]", "spin [1/m]", "; required"});
  expect_text("init", {"default: case.toml", "default: hertzian_contact", "wheel_rail_sample"});
  expect_text("run", {"default: results"});
  expect_text("plot", {"[mm]", "[1/m]", "default: beside RESULT.h5", "pressure|bound|"});
  expect_text("profile", {"[m]", "[mm]", "rail|wheel", "default: 0.014"});
  expect_text("conicity", {"[m]", "[rad]", "equilibrium|none", "default: 1.435", "default: 0.001 0.007 0.0001"});
  expect_text("convert", {"default: results"});
  expect_text("validate", {"default: results", "default: all", "1 to 1024"});
}

TEST(Program, EndsWithTheExitCode) {
  const TemporaryFolder folder;
  save(folder / "new.inp", contents(MICROSLIP_SOURCE_DIR "/examples/sphere_on_plane.inp"));
  const auto single = contents(folder / "new.inp");
  const auto second = single.find(" 3  MODULE", single.find(" 3  MODULE") + 1);
  save(folder / "one.inp", single.substr(0, second) + " 0  MODULE\n");
  save(folder / "broken.inp", single.substr(0, second - 40));
  save(folder / "bad.toml", "[load]\nnormal_forse = 1\n");
  const std::pair<std::string, int> runs[] = {
      {"init wheel.toml", 0},
      {"init wheel.toml", 2},
      {"solve wheel.toml -o out --no-pictures", 0},
      {"solve bad.toml", 2},
      {"hertz wheel.toml", 0},
      {"hertz bad.toml", 2},
      {"batch '" + example_table + "' -o forces.csv", 0},
      {"batch '" + example_table + "' -o forces.csv --grid 0x1", 2},
      {"run one.inp", 0},
      {"run broken.inp", 2},
      {"convert one.inp", 0},
      {"convert new.inp", 1}, // some cases go on from others
      {"convert broken.inp", 2},
      {"plot out/result.h5 --cut 0", 0},
      {"plot wheel.toml", 2},
      {"validate --list", 0},
      {"validate model-problem --no-pictures", 0},
      {"validate model-problem --threads 0", 2},
      {"completion bash", 0},
      {"completion tcsh", 2},
      {"manual", 0},
      {"manual extra", 2},
  };
  for (const auto& [arguments, exit_code] : runs) {
    const auto outcome = run_program(folder, arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.errors;
    EXPECT_EQ(outcome.errors.empty(), exit_code == 0) << arguments << "\n" << outcome.errors;
  }
}

TEST(Program, RefusesWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  expect_refused(folder, "", "see microslip --help");
  expect_refused(folder, "slove " + example, "unknown command \"slove\"; did you mean solve?");
  expect_refused(folder, "solve " + example + " --no-picture", "did you mean --no-pictures?");
  expect_refused(folder, "solve " + example + " extra", "unexpected argument \"extra\"");
  expect_refused(folder, "solve", "CASE.toml");
}

} // namespace
} // namespace microslip
