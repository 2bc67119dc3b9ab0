// A wheel on a rail as an importer sees it: the library's numbers, profiles by their paths, words of refusals.

#include "fmi/tests/described_bodies.hpp"
#include "fmi/tests/importer.hpp"
#include "io/profile_file.hpp"
#include "microslip/description/input.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace microslip::fmi {
namespace {

namespace fs = std::filesystem;

const fs::path resources = MICROSLIP_UNPACKED_FMU "/resources";

WheelState<double> running(double lateral, double yaw = 2e-3) {
  WheelState<double> state;
  state.lateral = lateral, state.yaw = yaw;
  state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46 * 1.001;
  return state;
}

class WheelInstance : public Instance {
public:
  using Instance::Instance;

  void set_state(const WheelState<double>& state, double force) {
    for (const StateQuantity& q : state_quantities())
      EXPECT_EQ(set("state." + std::string(q.name), q.value(state)), fmi2OK) << messages.last;
    EXPECT_EQ(set("state.vertical_force", force), fmi2OK);
  }
  /// Expects equality; what is not given, as wear without a hardness, is NaN in both.
  static void expect_same(double got, double wanted, std::string_view name) {
    if (std::isnan(wanted))
      EXPECT_TRUE(std::isnan(got)) << name;
    else
      EXPECT_EQ(got, wanted) << name;
  }
  void expect(const WheelRailSolution& wanted) {
    EXPECT_EQ(get_integer("status"), static_cast<int>(wanted.status));
    EXPECT_EQ(get_integer("wheel.at_profile_end"), wanted.warnings.has(Warning::profile_end));
    EXPECT_EQ(get_integer("wheel.warning_code"), static_cast<int>(wanted.warnings.code));
    EXPECT_EQ(get("wheel.patch_count"), static_cast<double>(wanted.patches.size()));
    const auto got = [&](const std::string& name, bool is_code) { return is_code ? get_integer(name) : get(name); };
    for (const WheelQuantity& q : wheel_results())
      expect_same(got("wheel." + std::string(q.name), q.is_code), q.value(wanted), q.name);
    for (std::size_t k = 0; k < 8; ++k)
      for (const PatchQuantity& q : patch_results())
        expect_same(got("patch[" + std::to_string(k + 1) + "]." + std::string(q.name), q.is_code),
                    k < wanted.patches.size() ? q.value(wanted.patches[k]) : 0, q.name);
  }
  std::string failed_initialization() {
    EXPECT_EQ(FMI(fmi2EnterInitializationMode)(unit), fmi2OK);
    EXPECT_EQ(FMI(fmi2ExitInitializationMode)(unit), fmi2Error);
    EXPECT_EQ(messages.status, fmi2Error);
    return messages.last;
  }
};

TEST(WheelRailUnit, StartsWithTheValuesOfTheDescription) {
  WheelInstance instance;
  instance.initialize();
  for (const auto& [name, start] : description().starts) {
    const std::string& type = description().types.at(name);
    if (type == "String")
      EXPECT_EQ(instance.get_text(name), start) << name;
    else if (type == "Integer")
      EXPECT_EQ(instance.get_integer(name), std::stoi(start)) << name;
    else
      EXPECT_EQ(instance.get(name), std::stod(start)) << name;
  }
  EXPECT_EQ(description().starts.at("rail.profile"), "60e1.prr");
  EXPECT_EQ(instance.messages.count, 0) << instance.messages.last;
}

TEST(WheelRailUnit, HasAsOutputsWhatHasDerivatives) {
  std::vector<std::string> outputs;
  for (const auto& [name, causality] : description().causalities)
    if (causality == "output" && description().types.at(name) == "Real") outputs.push_back(name);
  const std::vector<std::string> wanted = {"wheel.force_x",  "wheel.force_y",  "wheel.force_z", "wheel.moment_x",
                                           "wheel.moment_y", "wheel.moment_z", "wheel.vertical"};
  EXPECT_EQ(outputs, wanted);
}

/// Texts of the table of inputs stand in the description.
TEST(WheelRailUnit, ParametersAreInputsOfCaseFiles) {
  std::size_t count = 0;
  for (const description::NamedInput& named : description::wheel_inputs().named()) {
    const auto start = fmi::description().starts.find(named.path);
    if (start == fmi::description().starts.end() || named.input->is_state) continue;
    ++count;
    EXPECT_EQ(fmi::description().causalities.at(named.path), "parameter");
    if (named.input->missing) {
      EXPECT_EQ(std::stod(start->second), *named.input->missing) << named.path;
    }
    if (!named.input->missing_word.empty()) {
      EXPECT_EQ(start->second, named.input->missing_word) << named.path;
    }
  }
  EXPECT_GE(count, 30U);
}

TEST(WheelRailUnit, StepsAsTheLibraryDoes) {
  WheelInstance instance;
  EXPECT_EQ(instance.set("track.cant", 0.05), fmi2OK);
  instance.initialize();
  WheelRailBodies canted = described_bodies();
  canted.track.cant = 0.05;
  WheelRail contact(canted);
  std::size_t most_patches = 0;
  for (int k = -20; k <= 20; ++k) {
    const WheelState<double> state = running(6.1e-3 * k / 20);
    const double force = k == 0 ? 0 : 80e3; // once lifted off
    instance.set_state(state, force);
    ASSERT_EQ(instance.step(k * 1e-3), fmi2OK) << instance.messages.last;
    contact.reset();
    const WheelRailSolution wanted = contact.solve(state, force > 0 ? std::optional(force) : std::nullopt);
    instance.expect(wanted);
    most_patches = std::max(most_patches, wanted.patches.size());
  }
  EXPECT_GE(most_patches, 2U);
}

TEST(WheelRailUnit, ParametersReachTheSolver) {
  WheelInstance instance;
  EXPECT_EQ(instance.set("track.gauge", 1.437), fmi2OK);
  EXPECT_EQ(instance.set("track.cant", 0.025), fmi2OK);
  EXPECT_EQ(instance.set("wheelset.nominal_radius", 0.45), fmi2OK);
  EXPECT_EQ(instance.set_text("wheel.side", "right"), fmi2OK);
  EXPECT_EQ(instance.set("friction.coefficient", 0.2), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
  EXPECT_EQ(instance.set("rail.scale", 1.001), fmi2OK);
  EXPECT_EQ(instance.set_text("solution.theory", "exact"), fmi2OK);
  EXPECT_EQ(instance.set_integer("solution.grid", 8), fmi2OK);
  instance.set_state(running(-2e-3), 60e3);
  WheelRailBodies wanted = described_bodies(TrackSide::right);
  wanted.rail = io::read_profile(resources / "60e1.prr", {.scale = 1.001}).profile;
  wanted.track.gauge = 1.437, wanted.track.cant = 0.025, wanted.wheelset.nominal_radius = 0.45;
  wanted.friction = {{0, 0.2}};
  WheelRail contact(wanted, {.theory = Theory::exact, .elements = 8});
  instance.expect(contact.solve(running(-2e-3), 60e3)); // follows the inputs already during initialization
}

TEST(WheelRailUnit, DirectionalDerivatives) {
  WheelInstance instance;
  const WheelState<double> state = running(2e-3);
  instance.set_state(state, 50e3);
  instance.initialize();
  WheelRail contact(described_bodies());
  WheelRailSolution found;
  WheelRailDerivatives d;
  contact.differentiate(state, 50e3, found, d);
  const auto& r = description().references;
  const fmi2ValueReference unknowns[] = {r.at("wheel.vertical"), r.at("wheel.force_y"), r.at("wheel.moment_z")};
  const fmi2ValueReference knowns[] = {r.at("state.lateral"), r.at("state.deviation_vertical"),
                                       r.at("state.vertical_force")};
  const double seed[] = {1e-6, 2e-6, 100};
  double changes[3];
  ASSERT_EQ(FMI(fmi2GetDirectionalDerivative)(instance.unit, unknowns, 3, knowns, 3, seed, changes), fmi2OK);
  const auto rail = static_cast<std::size_t>(WheelVariable::deviation_vertical);
  const auto along = [&](const auto& row) { return 1e-6 * row(0) + 2e-6 * row(rail) + 100 * row(state_numbers); };
  const double wanted[] = {along([&](std::size_t k) { return d.vertical(k); }),
                           along([&](std::size_t k) { return d.force(k).y; }),
                           along([&](std::size_t k) { return d.moment(k).z; })};
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(changes[k], wanted[k], 1e-12 * std::abs(wanted[k]));
  const fmi2ValueReference local = r.at("patch[1].fx");
  EXPECT_EQ(FMI(fmi2GetDirectionalDerivative)(instance.unit, &local, 1, knowns, 1, seed, changes), fmi2Error);
}

TEST(WheelRailUnit, ReadsEachProfileOnce) {
  const TemporaryFolder folder;
  const fs::path rail = folder.path() / "rail.prr";
  fs::copy_file(resources / "60e1.prr", rail);
  WheelInstance instance;
  EXPECT_EQ(instance.set_text("rail.profile", rail.string()), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
  instance.set_state(running(0), 50e3);
  WheelRail contact(described_bodies());
  contact.reset();
  instance.expect(contact.solve(running(0), 50e3));
  fs::remove(rail);
  EXPECT_EQ(instance.set("track.gauge", 1.44), fmi2OK); // another track, the same profiles
  EXPECT_EQ(FMI(fmi2ExitInitializationMode)(instance.unit), fmi2OK) << instance.messages.last;
  WheelRailBodies wider = described_bodies();
  wider.track.gauge = 1.44;
  WheelRail other(wider);
  other.reset();
  instance.expect(other.solve(running(0), 50e3));
  fmi2FMUstate saved = nullptr;
  ASSERT_EQ(FMI(fmi2GetFMUstate)(instance.unit, &saved), fmi2OK);
  instance.set_state(running(3e-3), 50e3);
  ASSERT_EQ(instance.step(0), fmi2OK);
  ASSERT_EQ(FMI(fmi2SetFMUstate)(instance.unit, saved), fmi2OK);
  other.reset();
  instance.expect(other.solve(running(0), 50e3));
  ASSERT_EQ(instance.step(0), fmi2OK);
  other.reset();
  instance.expect(other.solve(running(0), 50e3));
  EXPECT_EQ(FMI(fmi2FreeFMUstate)(instance.unit, &saved), fmi2OK);
}

TEST(WheelRailUnit, RelativePathsStartAtTheResources) {
  const TemporaryFolder folder;
  const fs::path own = folder.path() / "with space";
  fs::create_directory(own);
  fs::copy_file(resources / "60e1.prr", own / "60e1.prr");
  fs::copy_file(resources / "s1002.prw", own / "s1002.prw");
  for (const std::string host : {"", "//", "//localhost"}) {
    WheelInstance instance("wheel", description().guid, fmi2CoSimulation,
                           "file:" + host + folder.path().string() + "/with%20space");
    instance.initialize();
    EXPECT_EQ(instance.messages.count, 0) << instance.messages.last;
  }
}

TEST(WheelRailUnit, SaysWhatTheReadersOfProfilesSay) {
  WheelInstance missing;
  EXPECT_EQ(missing.set_text("rail.profile", "/no/such/rail.prr"), fmi2OK);
  const std::string text = missing.failed_initialization();
  EXPECT_NE(text.find("/no/such/rail.prr"), std::string::npos) << text;

  const TemporaryFolder folder;
  const fs::path broken = folder.path() / "broken.txt";
  std::ofstream(broken) << "0 0\n1 0.1\n2 nonsense\n";
  std::string wanted;
  try {
    io::read_profile(broken, {.role = ProfileRole::wheel});
  } catch (const std::exception& error) {
    wanted = error.what();
  }
  ASSERT_NE(wanted, "");
  WheelInstance instance;
  EXPECT_EQ(instance.set_text("wheelset.profile", broken.string()), fmi2OK);
  EXPECT_EQ(instance.failed_initialization(), (resources / "parameters").string() + ": wheelset.profile: " + wanted);
  EXPECT_EQ(instance.messages.category, "logStatusError");
  // Reset, it is as new.
  EXPECT_EQ(FMI(fmi2Reset)(instance.unit), fmi2OK);
  instance.initialize();
  EXPECT_EQ(instance.step(0), fmi2OK);
}

TEST(WheelRailUnit, PassesOnWhatIsConspicuousAboutAProfile) {
  const TemporaryFolder folder;
  const fs::path narrow = folder.path() / "narrow.txt"; // without a flange
  std::ofstream file(narrow);
  for (int k = -30; k <= 30; ++k) file << k << ' ' << 0.05 * k << '\n';
  file.close();
  WheelInstance instance;
  EXPECT_EQ(instance.set_text("wheelset.profile", narrow.string()), fmi2OK);
  EXPECT_EQ(instance.set_text("wheelset.unit", "mm"), fmi2OK);
  EXPECT_EQ(instance.set_text("wheelset.y_axis", "field"), fmi2OK);
  EXPECT_EQ(instance.set_text("wheelset.z_axis", "up"), fmi2OK);
  EXPECT_EQ(instance.set("wheelset.flange_back_position", -0.05), fmi2OK);
  instance.initialize();
  EXPECT_GE(instance.messages.count, 1);
  EXPECT_EQ(instance.messages.status, fmi2Warning);
  EXPECT_EQ(instance.messages.category, "logStatusWarning");
  EXPECT_NE(instance.messages.last.find("wheelset.profile: "), std::string::npos) << instance.messages.last;
}

TEST(WheelRailUnit, NamesWhatMakesNoSense) {
  const auto refused = [](const auto& set) {
    WheelInstance instance;
    EXPECT_EQ(set(instance), fmi2OK);
    return instance.failed_initialization();
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set_text("wheel.side", "lefft"); }), "wheel.side"));
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set_text("rail.unit", "km"); }), "rail.unit"));
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set("track.gauge", -1); }), "gauge = -1 [m]"));
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set("friction.coefficient", -1); }),
                       "friction.coefficient = -1 [-]: must be in [0, 10]"));
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set_integer("solution.grid", 0); }),
                       "solution.grid = 0 [-]: must be in [6, 1000]"));
  EXPECT_TRUE(
      contains(refused([](auto& i) { return i.set("state.vertical_force", -5); }), "state.vertical_force = -5"));
  EXPECT_TRUE(contains(refused([](auto& i) { return i.set("state.yaw", std::numeric_limits<double>::quiet_NaN()); }),
                       "state.yaw = nan [rad]: must be in [-1, 1]"));
  WheelInstance instance;
  instance.initialize();
  EXPECT_EQ(instance.set_text("rail.profile", "other.prr"), fmi2Error);
  EXPECT_NE(instance.messages.last.find("after initialization"), std::string::npos);
}

TEST(WheelRailUnit, NoContactIsAStatus) {
  WheelInstance instance;
  WheelState<double> high = running(0);
  high.vertical = 0.02;
  instance.set_state(high, 0);
  instance.initialize();
  EXPECT_EQ(instance.get_integer("status"), static_cast<int>(Status::no_contact));
  EXPECT_EQ(instance.get("wheel.force_z"), 0);
  EXPECT_EQ(instance.get("wheel.vertical"), 0.02);
  EXPECT_EQ(instance.get("patch[1].normal_force"), 0);
}

TEST(WheelRailUnit, TwoInstancesAtOnceAreIndependent) {
  WheelInstance left("left"), right("right");
  EXPECT_EQ(right.set_text("wheel.side", "right"), fmi2OK);
  left.initialize(), right.initialize();
  for (int k = 0; k < 10; ++k) {
    const WheelState<double> state = running(5e-4 * k);
    left.set_state(state, 50e3), right.set_state(state.mirrored(), 50e3);
    ASSERT_EQ(left.step(k), fmi2OK);
    ASSERT_EQ(right.step(k), fmi2OK);
    EXPECT_EQ(left.get("wheel.force_x"), right.get("wheel.force_x"));
    EXPECT_EQ(left.get("wheel.force_y"), -right.get("wheel.force_y"));
  }
}

} // namespace
} // namespace microslip::fmi
