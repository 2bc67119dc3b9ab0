#include "io/wheel_rail_case.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

io::WheelRailCase parse(const std::string& text) {
  return io::parse_wheel_rail_case(text, "w.toml");
}

io::WheelRailCase parse_with(const std::string& part, const std::string& replacement) {
  return parse(with(wheel_rail_text, part, replacement));
}

std::string message_with(const std::string& part, const std::string& replacement) {
  return error_of([&] { parse_with(part, replacement); });
}

TEST(WheelRailCase, ReadsTheShortestCase) {
  const io::WheelRailCase input = parse(wheel_rail_text);
  EXPECT_EQ(input.title, "t");
  EXPECT_EQ(input.track.gauge, 1.435);
  EXPECT_EQ(input.track.cant, 0.05);
  EXPECT_EQ(input.rail.profile.role(), ProfileRole::rail);
  EXPECT_EQ(input.wheel.profile.role(), ProfileRole::wheel);
  EXPECT_EQ(input.wheelset.flange_back_position, -0.07);
  EXPECT_EQ(input.side, TrackSide::left);
  EXPECT_DOUBLE_EQ(input.material.shear_modulus, 210e9 / 2.56);
  ASSERT_EQ(input.friction.size(), 1u);
  EXPECT_EQ(input.friction[0].coefficient, 0.3);
  EXPECT_EQ(input.method.theory, Theory::fastsim2);
  EXPECT_EQ(input.method.surface(), PatchShape::curved);
  ASSERT_EQ(input.states.size(), 1u);
  EXPECT_EQ(input.states[0].vertical_force, 80e3);
  EXPECT_EQ(input.states[0].state.lateral, 0.0061);
  EXPECT_EQ(input.states[0].state.yaw, 0);
  EXPECT_EQ(input.states[0].state.pitch_velocity, 30.0 / 0.46);
  EXPECT_TRUE(input.varied.empty());
}

TEST(WheelRailCase, TakesProfilesOfStandardsByName) {
  const std::string own = parse(wheel_rail_text).wheel.report.source; // a path with s1002.prw
  const auto named = [&](const std::string& keys) { return parse_with("\"" + own + "\"", keys).wheel; };
  const auto thickness = [](const Profile& wheel) { return wheel_dimensions(wheel, 0).flange_thickness.value(); };
  EXPECT_EQ(named("\"S1002\"").report.format, "EN 13715");
  EXPECT_NEAR(thickness(named("\"S1002\"").profile), thickness(parse(wheel_rail_text).wheel.profile), 1e-8);
  EXPECT_NEAR(thickness(named("\"S1002\"\nflange_thickness = \"30.5 mm\"").profile), 30.5e-3, 2e-7);
  EXPECT_NE(message_with("\"" + own + "\"", "\"S1002\"\nunit = \"mm\"").find("unit does not apply"), std::string::npos);
  EXPECT_NE(message_with("\"" + own + "\"", "\"60E1\"").find("of a rail, not of a wheel"), std::string::npos);
}

TEST(WheelRailCase, ReadsStrengthsAndPointsInsideWhereTheyAreGiven) {
  const io::WheelRailCase without = parse(wheel_rail_text);
  EXPECT_FALSE(without.strength.hardness || without.strength.shear_yield_strength);
  EXPECT_EQ(without.interior.count(), 0u);
  const io::WheelRailCase with =
      parse_with("[friction]", "hardness = 2.7e9\nshear_yield_strength = 300e6\n"
                               "[interior]\nx = [0]\ny = [0, 1e-3]\nz = [-2e-3]\n[friction]");
  EXPECT_EQ(with.strength.hardness, 2.7e9);
  EXPECT_EQ(with.strength.shear_yield_strength, 300e6);
  EXPECT_EQ(io::bodies_of(with).strength.hardness, 2.7e9);
  EXPECT_EQ(with.interior.y, (std::vector<double>{0, 1e-3}));
  EXPECT_NE(message_with("[friction]", "hardness = 270\n[friction]").find("material.hardness = 270 [Pa]"),
            std::string::npos);
  EXPECT_NE(message_with("[friction]", "hardnes = 1e9\n[friction]").find("did you mean hardness?"), std::string::npos);
  EXPECT_NE(message_with("[friction]", "[interior]\nx = [0]\ny = [nan]\nz = [0]\n[friction]").find("interior.y"),
            std::string::npos);
}

TEST(WheelRailCase, ReadsEveryNumberOfTheStateInItsSection) {
  for (const StateQuantity& q : state_quantities()) {
    if (q.name == "vertical") continue; // instead of the force
    const std::string name(q.name), head = "[" + std::string(q.section) + "]\n";
    std::string text = wheel_rail_text;
    if (const auto given = text.find("\n" + name + " ="); given != std::string::npos)
      text.erase(given, text.find('\n', given + 1) - given);
    const io::WheelRailCase input = parse(with(text, head, head + name + " = 0.015625\n"));
    EXPECT_EQ(q.value(input.states[0].state), 0.015625) << name;
  }
  const io::WheelRailCase input = parse_with("vertical_force = 80e3", "vertical = -0.0002");
  EXPECT_FALSE(input.states[0].vertical_force);
  EXPECT_EQ(input.states[0].state.vertical, -0.0002);
}

TEST(WheelRailCase, NamesOfNumbersAreUnique) {
  std::set<std::string_view> names;
  for (const StateQuantity& q : state_quantities()) EXPECT_TRUE(names.insert(q.name).second) << q.name;
  // And each is another member.
  WheelState<double> state;
  std::set<const double*> members;
  for (const StateQuantity& q : state_quantities()) EXPECT_TRUE(members.insert(&q.of(state)).second) << q.name;
}

TEST(WheelRailCase, ReadsTheRest) {
  const io::WheelRailCase placed = parse_with("gauge = 1.435", "rail_y = 0.7505\nrail_z = 0.001");
  ASSERT_TRUE(placed.track.rail_origin);
  EXPECT_EQ(placed.track.rail_origin->y, 0.7505);
  EXPECT_EQ(placed.track.rail_origin->z, 0.001);
  EXPECT_EQ(parse_with("side = \"left\"", "side = \"right\"").side, TrackSide::right);
  const auto method = parse_with("\"fastsim2\"", "\"exact\"\nshape = \"curved\"\ngrid = 30\ntolerance = 1e-8").method;
  EXPECT_EQ(method.theory, Theory::exact);
  EXPECT_EQ(method.shape, PatchShape::curved);
  EXPECT_EQ(method.elements, 30);
  EXPECT_EQ(method.tolerance, 1e-8);
  const auto look_up = parse_with("\"fastsim2\"", "\"table\"").method;
  EXPECT_EQ(look_up.theory, Theory::table);
  ASSERT_NE(look_up.table, nullptr);
  EXPECT_EQ(look_up.table->axes().poisson_ratios, std::vector<double>{0.28});
  const auto friction = parse_with("coefficient = 0.3", "coefficient = [0.1, 0.4]\nangle = [-1, 0]").friction;
  ASSERT_EQ(friction.size(), 2u);
  EXPECT_EQ(friction[0].angle, -1);
  EXPECT_EQ(friction[1].coefficient, 0.4);
  EXPECT_EQ(parse_with("nominal_radius", "tape_circle = 0.0\nnominal_radius").wheelset.tape_circle, 0);
}

TEST(WheelRailCase, ProfilesArePathsFromTheFilesFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "p");
  const std::string profile = MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr";
  std::filesystem::copy_file(profile, folder / "p/rail.prr");
  const auto text = with(wheel_rail_text, profile, "p/rail.prr");
  const auto input = io::parse_wheel_rail_case(text, (folder / "w.toml").string());
  EXPECT_EQ(input.rail.profile.length(), parse(wheel_rail_text).rail.profile.length());
  // What the file does not say, or is to be treated otherwise.
  const auto larger = io::parse_wheel_rail_case(with(text, "[rail]", "[rail]\nscale = 2.0"), (folder / "w").string());
  EXPECT_NEAR(larger.rail.profile.length(), 2 * input.rail.profile.length(), 1e-9);
  const auto cut =
      io::parse_wheel_rail_case(with(text, "[rail]", "[rail]\ntrim = [-0.1, 0.02]"), (folder / "w").string());
  EXPECT_LT(cut.rail.profile.at(cut.rail.profile.length()).value.y, 0.0201);
}

TEST(WheelRailCase, SweepsVaryNumbersTogether) {
  const auto input = parse_with("[material]", "[sweep]\nlateral = { from = 0.0, to = 0.008, count = 5 }\n"
                                              "yaw = [0, 1e-3, 2e-3, 3e-3, 5e-3]\n[material]");
  ASSERT_EQ(input.states.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_DOUBLE_EQ(input.states[k].state.lateral, 0.002 * static_cast<double>(k));
    EXPECT_EQ(input.states[k].vertical_force, 80e3);
  }
  EXPECT_EQ(input.states[4].state.yaw, 5e-3);
  EXPECT_EQ(input.varied, (std::vector<std::string_view>{"lateral", "yaw"}));

  const auto speeds = parse_with("forward_velocity = 30.0\n", "[sweep]\nforward_velocity = [10, 20]\n");
  EXPECT_EQ(speeds.states[1].state.pitch_velocity, 20 / 0.46) << "the default follows the velocity";
  const auto forces = parse_with("vertical_force = 80e3\nforward_velocity = 30.0\n",
                                 "forward_velocity = 30.0\n[sweep]\nvertical_force = [1e3, 2e3]\n");
  EXPECT_EQ(forces.states[1].vertical_force, 2e3);
}

TEST(WheelRailCase, MessagesNameLineKeyValueAndRange) {
  const std::pair<std::pair<std::string, std::string>, std::string> cases[] = {
      {{"gauge =", "gage ="}, "w.toml:3: track.gage: unknown key; did you mean gauge?"},
      {{"gauge = 1.435", "gauge = 1435"}, "w.toml:3: track.gauge = 1435 [m]: must be in [0.1, 6]"},
      {{"gauge = 1.435", "gauge = -1.435"}, "w.toml:3: track.gauge = -1.435 [m]: must be in [0.1, 6]"},
      {{"gauge = 1.435", "gauge = 1.435\nrail_y = 0.75"}, "w.toml:4: [track] needs either gauge or rail_y"},
      {{"60e1.prr", "60e9.prr"}, "w.toml:6: rail.profile: "},
      {{"profile = ", "# profile = "}, "w.toml:5: [rail]: profile is missing"},
      {{"[wheelset]", "[wheelsets]"}, "w.toml:7: wheelsets: unknown key; did you mean wheelset?"},
      {{"nominal_radius = 0.46", "nominal_radius = 460"}, "w.toml:9: wheelset.nominal_radius = 460 [m]: must be in"},
      {{"nominal_radius", "unit = \"cm\"\nnominal_radius"}, "w.toml:9: wheelset.unit = \"cm\": must be mm, m or in"},
      {{"\"left\"", "\"lefft\""}, "w.toml:12: wheel.side = \"lefft\": must be left, right or both; did you mean left?"},
      {{"lateral = 0.0061", "lateral = 6.1"}, "w.toml:13: wheel.lateral = 6.1 [m]: must be in [-1, 1]"},
      {{"lateral = 0.0061", "lateral = nan"}, "w.toml:13: wheel.lateral = nan [m]: must be in [-1, 1]"},
      {{"vertical_force = 80e3", "vertical_force = -80e3"}, "w.toml:14: wheel.vertical_force = -80000 [N]: must be"},
      {{"vertical_force = 80e3\n", ""}, "w.toml:11: [wheel] needs either vertical_force or vertical"},
      {{"forward_velocity = 30.0\n", ""}, "w.toml:11: [wheel]: forward_velocity is missing"},
      {{"coefficient = 0.3", "coefficient = [0.3, 0.2]\nangle = [1, 0]"},
       "w.toml:21: friction.angle: must be ascending"},
      {{"coefficient = 0.3", "law = \"linear\""}, "w.toml:20: friction.law = \"linear\": must be coulomb"},
      {{"\"fastsim2\"", "\"fastsim\""}, "w.toml:22: solution.theory = \"fastsim\": must be fastsim2, exact or table"},
      {{"\"fastsim2\"", "\"table\"\ntable = \"none.creep\""}, "w.toml:23: solution.table: "},
      {{"\"fastsim2\"", "\"fastsim2\"\ntable = \"a.creep\""},
       "w.toml:23: solution.table: needs solution.theory = \"table\""},
      {{"\"fastsim2\"", "\"table\"\nshape = \"flat\""}, "w.toml:23: solution.shape = \"flat\": the rows of table"},
      {{"\"fastsim2\"", "\"fastsim2\"\nshape = \"flat\""},
       "w.toml:23: solution.shape = \"flat\": the rows of fastsim2"},
      {{"[material]", "[sweep]\nlatteral = [1, 2]\n[material]"},
       "w.toml:17: sweep.latteral: unknown key; did you mean"},
      {{"[material]", "[sweep]\nlateral = { from = 0, to = 1 }\n[material]"},
       "w.toml:17: sweep.lateral: count is miss"},
      {{"[material]", "[sweep]\nlateral = { from = 0, to = 6, count = 3 }\n[material]"},
       "w.toml:17: sweep.lateral.to = 6 [m]: must be in [-1, 1]"},
      {{"[material]", "[sweep]\nlateral = [0, 0.001]\nyaw = [0]\n[material]"},
       "w.toml:18: sweep.yaw: has 1 numbers, sweep.lateral has 2; they vary together"},
      {{"[material]", "[sweep]\nvertical = [0, 0.001]\n[material]"},
       "w.toml:14: [wheel] and [sweep] need either vertical_force or vertical"},
  };
  for (const auto& [change, message] : cases) {
    EXPECT_EQ(message_with(change.first, change.second).rfind(message, 0), 0u)
        << message_with(change.first, change.second) << "\nexpected: " << message;
  }
}

TEST(WheelRailCase, ProfilesMustFitTheirRoles) {
  const auto message = message_with("60e1.prr", "s1002.prw");
  EXPECT_NE(message.find("w.toml:6: rail.profile: "), std::string::npos) << message;
  EXPECT_NE(message.find("wheel"), std::string::npos) << message;
}

TEST(WheelRailCase, IsToldApartFromOthers) {
  EXPECT_TRUE(io::is_wheel_rail_case(wheel_rail_text, "w.toml"));
  EXPECT_FALSE(io::is_wheel_rail_case("[body1]\n[body2]\n", "w.toml"));
  EXPECT_FALSE(io::is_wheel_rail_case("", "w.toml"));
  EXPECT_THROW(io::is_wheel_rail_case("[rail", "w.toml"), Error);
}

} // namespace
} // namespace microslip
