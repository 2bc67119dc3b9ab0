#include "cases/wheel_rail_result.hpp"

#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

io::WheelsetCase parse_with(const std::string& part, const std::string& replacement) {
  return io::parse_wheelset_case(with(wheelset_text, part, replacement), "w.toml");
}

std::string message_with(const std::string& part, const std::string& replacement) {
  return error_of([&] { parse_with(part, replacement); });
}

TEST(WheelsetCase, IsToldApartFromOneWheel) {
  EXPECT_TRUE(io::is_wheelset_case(wheelset_text, "w.toml"));
  EXPECT_TRUE(io::is_wheel_rail_case(wheelset_text, "w.toml"));
  EXPECT_FALSE(io::is_wheelset_case(wheel_rail_text, "w.toml"));
}

TEST(WheelsetCase, RollsFreelyUnlessItIsToldOtherwise) {
  const io::LoadedWheelsetState state = io::parse_wheelset_case(wheelset_text, "w.toml").states.at(0);
  EXPECT_EQ(state.state.left.lateral, 0.003);
  EXPECT_EQ(std::get<AxleLoad>(*state.load.vertical).vertical_force, 120e3);
  EXPECT_EQ(std::get<AxleLoad>(*state.load.vertical).roll_moment, 0);
  EXPECT_EQ(state.load.axle_torque, 0.0);
  EXPECT_EQ(parse_with("lateral", "axle_torque = 500\nlateral").states[0].load.axle_torque, 500);
  const auto turning = parse_with("lateral", "pitch_velocity = 60\nlateral").states[0];
  EXPECT_FALSE(turning.load.axle_torque);
  EXPECT_EQ(turning.state.left.pitch_velocity, 60);
}

TEST(WheelsetCase, ReadsLoadsAndWhatConcernsOneWheel) {
  const auto loads = parse_with("vertical_force = 120e3", "vertical_force_left = 70e3\nvertical_force_right = 50e3");
  EXPECT_EQ(std::get<WheelLoads>(*loads.states[0].load.vertical).right, 50e3);
  const auto moment = parse_with("lateral", "roll_moment = -1e3\nlateral").states[0].load;
  EXPECT_EQ(std::get<AxleLoad>(*moment.vertical).roll_moment, -1e3);
  const auto uneven = parse_with("[wheelset]", "right_deviation_vertical = 0.002\n[wheelset]").states[0].state;
  EXPECT_EQ(uneven.right_rail.vertical, 0.002);
  EXPECT_EQ(uneven.left.rail.vertical, 0);
  EXPECT_EQ(parse_with("lateral", "left_deflection_yaw = 0.001\nlateral").states[0].state.left.deflection.yaw, 0.001);
}

TEST(WheelsetCase, SweepsStateAndLoads) {
  const auto input = parse_with("[material]", "[sweep]\nright_deviation_lateral = [0, 1e-3]\n"
                                              "roll_moment = [1e3, 2e3]\npitch_velocity = [60, 61]\n[material]");
  ASSERT_EQ(input.states.size(), 2u);
  EXPECT_EQ(input.states[1].state.right_rail.lateral, 1e-3);
  EXPECT_EQ(std::get<AxleLoad>(*input.states[1].load.vertical).roll_moment, 2e3);
  EXPECT_EQ(input.states[1].state.left.pitch_velocity, 61);
  EXPECT_FALSE(input.states[1].load.axle_torque);
}

TEST(WheelsetQuantities, NamesAndMembersAreUnique) {
  std::set<std::string> names;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities()) {
    EXPECT_TRUE(names.insert(q.name).second) << q.name;
    WheelsetState state;
    q.set(state, 0.25);
    for (const WheelsetStateQuantity& other : wheelset_state_quantities())
      EXPECT_EQ(other.value(state), other.name == q.name ? 0.25 : 0) << q.name << ", " << other.name;
  }
  for (const PrescribedForce& f : prescribed_forces()) EXPECT_TRUE(names.insert(std::string(f.name)).second);
}

TEST(WheelsetCase, MessagesNameLineKeyAndReason) {
  const std::pair<std::pair<std::string, std::string>, std::string> cases[] = {
      {{"lateral", "roll = 0.001\nlateral"}, "w.toml:13: wheel.roll: is found from the load of both wheels"},
      {{"vertical_force = 120e3", "vertical = 0.001"}, "w.toml:14: wheel.vertical: is found from the load"},
      {{"vertical_force = 120e3\n", ""}, "w.toml:11: [wheel] needs vertical_force, or vertical_force_left and vert"},
      {{"vertical_force =", "vertical_force_left ="},
       "w.toml:11: vertical_force_left, vertical_force_right: only both"},
      {{"vertical_force = 120e3", "vertical_force = 0.0"}, "w.toml:14: wheel.vertical_force = 0 [N]: must be in"},
      {{"lateral", "pitch_velocity = 60\naxle_torque = 0\nlateral"},
       "w.toml:16: [wheel] takes either pitch_velocity or axle_torque"},
      {{"lateral", "deflection_yaw = 0\nlateral"}, "w.toml:13: wheel.deflection_yaw: unknown key; did you mean left_"},
      {{"[material]", "[interior]\nx = [0]\ny = [0]\nz = [1e-3]\n[material]"},
       "w.toml:16: interior: of a wheel alone, with side = \"left\" or \"right\""},
      {{"lateral", "axle_torqe = 0\nlateral"}, "w.toml:13: wheel.axle_torqe: unknown key; did you mean axle_torque?"},
  };
  for (const auto& [change, message] : cases)
    EXPECT_EQ(message_with(change.first, change.second).rfind(message, 0), 0u)
        << message_with(change.first, change.second) << "\nexpected: " << message;
}

TEST(WheelsetResult, IsWhatTheLibraryFindsAndSaysSo) {
  const auto text = with(wheelset_text, "[material]", "[sweep]\nlateral = [0, 0.003]\n[material]");
  const io::WheelsetCase input = io::parse_wheelset_case(text, "w.toml");
  EXPECT_EQ(input.varied, std::vector<std::string_view>{"lateral"});
  const cases::WheelsetResult result = cases::solve_case(input);
  ASSERT_EQ(result.status, Status::ok);
  WheelsetOnTrack solver = io::solver_of(input, input.method);
  const WheelsetSolution expected = solver.solve(input.states[1].state, input.states[1].load);
  const io::Json document = cases::case_document(input, result, {.kind = cases::kind_of(input)});
  EXPECT_EQ(document["kind"], "wheelset");
  EXPECT_EQ(document["states"]["vertical_force"], io::Json({120e3, 120e3}));
  for (const WheelsetQuantity& q : wheelset_quantities())
    EXPECT_EQ(document["wheelset"][std::string(q.name)][1].get<double>(), q.value(expected)) << q.name;
  EXPECT_EQ(document["left"]["wheel"]["force_y"][1].get<double>(), expected.left.force.y);
  EXPECT_EQ(document["right"]["patches"]["state"], io::Json({0, 1}));
  EXPECT_EQ(document["units"]["wheelset/roll"], "rad");
  EXPECT_NEAR(document["wheelset"]["moment_x"][1].get<double>(), 0, 1);
}

TEST(WheelsetResult, HasWearAndFieldsOfBothWheels) {
  const auto document_of = [](const std::string& text) {
    const io::WheelsetCase input = io::parse_wheelset_case(text, "w.toml");
    return cases::case_document(input, cases::solve_case(input), {.kind = cases::kind_of(input)});
  };
  const std::string turned = with(wheelset_text, "lateral = 0.003", "lateral = 0.003\nyaw = 4e-3");
  const io::Json without = document_of(turned),
                 hard = document_of(with(turned, "[friction]", "hardness = 2.7e9\n[friction]"));
  for (const auto* side : {"left", "right"}) {
    EXPECT_FALSE(without[side]["wheel"].contains("worn_area"));
    EXPECT_FALSE(without[side]["patches"].contains("worn_area"));
    double worn = 0;
    for (const io::Json& of_patch : hard[side]["patches"]["worn_area"]) worn += of_patch.get<double>();
    EXPECT_GT(worn, 0);
    EXPECT_DOUBLE_EQ(hard[side]["wheel"]["worn_area"][0].get<double>(), worn);
    EXPECT_EQ(hard[side]["wheel"]["force_z"], without[side]["wheel"]["force_z"]);
  }
  EXPECT_EQ(hard["inputs"]["material"]["hardness"], 2.7e9);
  const io::WheelsetCase input = io::parse_wheelset_case(wheelset_text, "w.toml");
  const WheelsetSolution solution = cases::solve_case(input).solutions.at(0);
  EXPECT_EQ(solution.left.fields.size(), solution.left.patches.size());
  EXPECT_EQ(solution.right.fields.size(), solution.right.patches.size());
}

TEST(WheelsetResult, HasAReasonForWhatIsNotSolved) {
  const cases::WheelsetResult off = cases::solve_case(parse_with("lateral = 0.003", "lateral = 0.3"));
  EXPECT_EQ(off.status, Status::no_contact);
  EXPECT_EQ(off.reason, "a wheel is not above its rail");
  const cases::WheelsetResult torn = cases::solve_case(parse_with("lateral", "axle_torque = 1e5\nlateral"));
  EXPECT_EQ(torn.status, Status::no_solution);
}

} // namespace
} // namespace microslip
