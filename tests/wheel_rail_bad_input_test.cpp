// What should not be asked of a wheel on a rail: nothing of it crashes, hangs or gives a number that is none.

#include "io/wheel_rail_case.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip {
namespace {

const WheelRailMethod methods[] = {{}, {.theory = Theory::exact, .elements = 8}};

bool all_numbers(const WheelRailSolution& s) {
  double sum = s.force.x + s.force.y + s.force.z + s.moment.x + s.moment.y + s.moment.z + s.vertical + s.residual;
  // Wear and fatigue have no value without the material's strength.
  static const auto sound = WheelRail(s1002_on_60e1()).solve(running(1e-3), 50e3).patches;
  for (const WheelRailPatch& patch : s.patches)
    for (const PatchQuantity& quantity : patch_quantities())
      if (quantity.is_given(sound)) sum += quantity.value(patch);
  return std::isfinite(sum);
}

TEST(WheelRailBadInput, NumbersOfTheStateThatAreNoneAreInvalidInput) {
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const StateQuantity& quantity : state_quantities())
      for (const double bad : {nan, infinity, -infinity})
        for (const bool force_given : {true, false}) {
          WheelState<double> state = running(1e-3);
          quantity.of(state) = bad;
          if (force_given && quantity.name == "vertical") continue; // it is sought
          const auto s = contact.solve(state, force_given ? std::optional(50e3) : std::nullopt);
          EXPECT_EQ(s.status, Status::invalid_input) << quantity.name << " = " << bad;
          EXPECT_TRUE(s.patches.empty());
          EXPECT_TRUE(std::isnan(s.force.z));
        }
    EXPECT_EQ(contact.solve(running(1e-3), nan).status, Status::invalid_input);
    EXPECT_EQ(contact.solve(running(1e-3), infinity).status, Status::invalid_input);
    EXPECT_EQ(contact.solve(running(1e-3), 50e3).status, Status::ok) << "what was refused left something behind";
  }
}

TEST(WheelRailBadInput, NumbersOfTheBodiesThatAreNoneAreNamed) {
  const std::pair<const char*, std::function<void(WheelRailBodies&, double)>> fields[] = {
      {"gauge", [](WheelRailBodies& b, double v) { b.track.gauge = v; }},
      {"gauge_height", [](WheelRailBodies& b, double v) { b.track.gauge_height = v; }},
      {"cant", [](WheelRailBodies& b, double v) { b.track.cant = v; }},
      {"rail_origin y",
       [](WheelRailBodies& b, double v) {
         b.track.rail_origin = ProfilePoint{v, 0};
       }},
      {"rail_origin z",
       [](WheelRailBodies& b, double v) {
         b.track.rail_origin = ProfilePoint{0.75, v};
       }},
      {"flange_back_distance", [](WheelRailBodies& b, double v) { b.wheelset.flange_back_distance = v; }},
      {"flange_back_position", [](WheelRailBodies& b, double v) { b.wheelset.flange_back_position = v; }},
      {"nominal_radius", [](WheelRailBodies& b, double v) { b.wheelset.nominal_radius = v; }},
      {"tape_circle", [](WheelRailBodies& b, double v) { b.wheelset.tape_circle = v; }},
      {"shear_modulus", [](WheelRailBodies& b, double v) { b.material.shear_modulus = v; }},
      {"poisson_ratio", [](WheelRailBodies& b, double v) { b.material.poisson_ratio = v; }},
      {"friction", [](WheelRailBodies& b, double v) { b.friction[0].coefficient = v; }},
      {"friction angle", [](WheelRailBodies& b, double v) { b.friction[0].angle = v; }},
  };
  for (const auto& [name, set] : fields)
    for (const double bad : {nan, infinity}) {
      WheelRailBodies bodies = s1002_on_60e1();
      set(bodies, bad);
      SCOPED_TRACE(bad);
      expect_words([&] { WheelRail contact(bodies); }, name);
    }
}

/// The message for a case file with this line in a section, instead of the value of the key.
std::string message_with(std::string_view section, std::string_view key, const std::string& value) {
  std::string text = wheel_rail_text;
  const auto section_at = text.find("[" + std::string(section) + "]\n");
  const auto body = text.find('\n', section_at) + 1, end = std::min(text.find("\n[", body), text.size());
  if (const auto old = text.find("\n" + std::string(key) + " = ", body - 1); old < end)
    text.erase(old + 1, text.find('\n', old + 1) - old);
  text.insert(body, std::string(key) + " = " + value + "\n");
  return error_of([&] { io::parse_wheel_rail_case(text, "w.toml"); });
}

TEST(WheelRailBadInput, NumbersOfACaseFileThatAreNoneAreNamed) {
  std::vector<std::pair<std::string_view, std::string_view>> keys = {{"track", "gauge"},
                                                                     {"track", "gauge_height"},
                                                                     {"track", "cant"},
                                                                     {"rail", "scale"},
                                                                     {"rail", "smoothing_length"},
                                                                     {"wheelset", "nominal_radius"},
                                                                     {"wheelset", "flange_back_distance"},
                                                                     {"wheelset", "flange_back_position"},
                                                                     {"wheelset", "tape_circle"},
                                                                     {"wheel", "vertical_force"},
                                                                     {"material", "young_modulus"},
                                                                     {"material", "poisson_ratio"},
                                                                     {"friction", "coefficient"},
                                                                     {"solution", "tolerance"}};
  for (const StateQuantity& quantity : state_quantities())
    if (quantity.name != "vertical") keys.push_back({quantity.section, quantity.name}); // not beside vertical_force
  for (const auto& [section, key] : keys) {
    for (const char* bad : {"nan", "-nan", "inf", "-inf", "1e999", "\"1\"", "[]"}) {
      const std::string message = message_with(section, key, bad);
      EXPECT_NE(message.find("w.toml:"), std::string::npos) << key << " = " << bad << ": " << message;
      if (std::string(bad) != "1e999") { // is no number of TOML's
        EXPECT_NE(message.find(key), std::string::npos) << key << " = " << bad << ": " << message;
      }
    }
  }
}

TEST(WheelRailBadInput, AWheelBesideItsRailTouchesNothing) {
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const double lateral : {-0.75, -0.2, 0.2, 1.0}) { // between the rails, inside, outside
      WheelState<double> state = running(1e-3);
      state.lateral = lateral;
      EXPECT_EQ(contact.solve(state, 50e3).status, Status::no_contact) << lateral;
      EXPECT_EQ(contact.solve(state).status, Status::no_contact) << lateral;
    }
  }
}

TEST(WheelRailBadInput, AWheelOnTheEndOfARailSaysSo) {
  // The rail ends in the midst of the contact, the rest of it where it was.
  WheelRailBodies bodies = s1002_on_60e1();
  const Vec3<double> origin = place_rail(bodies.track, bodies.rail).origin;
  bodies.track.rail_origin = ProfilePoint{origin.y, origin.z};
  std::vector<ProfilePoint> points;
  for (const ProfilePiece& piece : bodies.rail.pieces())
    if (piece.c[0].y < 1e-3) points.push_back(piece.c[0]);
  bodies.rail = Profile(ProfileRole::rail, points);
  for (const WheelRailMethod& method : methods) {
    WheelRail whole(s1002_on_60e1(), method), cut(bodies, method);
    WheelState<double> state = running(1e-3);
    state.vertical = whole.solve(state, 50e3).vertical;
    const auto s = cut.solve(state);
    EXPECT_TRUE(s.warnings.has(Warning::profile_end));
    EXPECT_TRUE(all_numbers(s));
    EXPECT_LT(s.force.z, 50e3);
    EXPECT_FALSE(whole.solve(state).warnings.has(Warning::profile_end));
  }
}

TEST(WheelRailBadInput, ProfilesThatAreUpsideDownGiveNumbersOrAStatus) {
  const auto upside_down = [](const Profile& profile) {
    std::vector<ProfilePoint> points;
    for (const ProfilePiece& piece : profile.pieces()) points.push_back({piece.c[0].y, -piece.c[0].z});
    return Profile(profile.role(), points);
  };
  for (const bool wheel : {true, false}) {
    WheelRailBodies bodies = s1002_on_60e1();
    bodies.track.rail_origin = ProfilePoint{0.7541, 0}; // its gauge point is not where it should be
    (wheel ? bodies.wheel : bodies.rail) = upside_down(wheel ? bodies.wheel : bodies.rail);
    for (const WheelRailMethod& method : methods) {
      WheelRail contact(bodies, method);
      for (const double lateral : {-0.02, 0.0, 0.03})
        for (const double force : {1e3, 100e3}) {
          WheelState<double> state = running(1e-3);
          state.lateral = lateral;
          const auto s = contact.solve(state, force);
          EXPECT_TRUE(all_numbers(s));
          if (s.status == Status::ok) {
            EXPECT_NEAR(s.force.z, force, 1e-4 * force);
          }
        }
    }
  }
}

TEST(WheelRailBadInput, AtRestNothingIsTangential) {
  const WheelRailMethod planes{.theory = Theory::exact, .shape = PatchShape::flat, .elements = 8};
  for (const WheelRailMethod& method : {methods[0], methods[1], planes}) {
    WheelRail contact(s1002_on_60e1(), method);
    WheelState<double> state;
    state.lateral = 1e-3;
    const auto s = contact.solve(state, 50e3);
    ASSERT_EQ(s.status, Status::ok);
    for (const WheelRailPatch& patch : s.patches) {
      // Rows on the true surfaces have separate planes, whose normal forces do not quite add up along the frame's.
      EXPECT_NEAR(std::hypot(patch.fx, patch.fs), 0, method.surface() == PatchShape::flat ? 1e-9 : 2e-3 * 50e3);
      EXPECT_NEAR(patch.frictional_power, 0, 1e-9);
      EXPECT_EQ(patch.rolling_speed, 0);
    }
    // Wheels that spin on the spot and slide without turning have a rolling speed of half of it.
    for (const bool spins : {true, false}) {
      WheelState<double> one = state;
      (spins ? one.pitch_velocity : one.forward_velocity) = 5;
      const auto sliding = contact.solve(one, 50e3);
      ASSERT_EQ(sliding.status, Status::ok);
      EXPECT_NEAR(std::abs(sliding.force.x), 0.3 * 50e3, 0.02 * 50e3);
      EXPECT_EQ(sliding.force.x > 0, spins);
    }
  }
}

TEST(WheelRailBadInput, ForcesThatPullOrVanishAreInvalidInput) {
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const double force : {0.0, -50e3})
      EXPECT_EQ(contact.solve(running(1e-3), force).status, Status::invalid_input) << force;
    for (const double force : {1e-3, 1e9}) { // a gram, a hundred thousand tons
      const auto s = contact.solve(running(1e-3), force);
      EXPECT_TRUE(all_numbers(s)) << force;
      if (s.status == Status::ok) {
        EXPECT_NEAR(s.force.z / force, 1, 1e-4) << force;
      }
    }
  }
}

} // namespace
} // namespace microslip
