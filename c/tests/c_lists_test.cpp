// The lists of numbers with names, by which programs find indices in arrays.

#include "c/tests/c_cases.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using NameAndUnit = std::pair<const char*, const char*>;

struct List {
  int list;
  std::vector<NameAndUnit> first; ///< what the first version of the binary interface had
};

/// Never to be changed: lists grow at their end.
const List lists_of_abi_2[] = {{MICROSLIP_CONTACT_QUANTITY,
                                {{"fx", "N"},
                                 {"fy", "N"},
                                 {"mz", "N m"},
                                 {"my", "N m"},
                                 {"creepage_longitudinal", "-"},
                                 {"creepage_lateral", "-"},
                                 {"spin", "1/m"},
                                 {"adhesion_area", "m^2"},
                                 {"slip_area", "m^2"},
                                 {"frictional_power", "W"},
                                 {"power_by_creepage", "W"},
                                 {"elastic_energy", "J"},
                                 {"approach", "m"},
                                 {"peak_pressure", "Pa"},
                                 {"peak_traction", "Pa"},
                                 {"highest_temperature", "deg C"},
                                 {"residual", "-"},
                                 {"newton_steps", "-"},
                                 {"products", "-"},
                                 {"estimated_error", "-"}}},
                               {MICROSLIP_CONTACT_FIELD,
                                {{"x", "m"},
                                 {"y", "m"},
                                 {"width", "m"},
                                 {"area", "m^2"},
                                 {"pressure", "Pa"},
                                 {"bound", "Pa"},
                                 {"px", "Pa"},
                                 {"py", "Pa"},
                                 {"sx", "-"},
                                 {"sy", "-"},
                                 {"ux", "m"},
                                 {"uy", "m"},
                                 {"gap", "m"},
                                 {"friction", "-"},
                                 {"temperature1", "deg C"},
                                 {"temperature2", "deg C"}}},
                               {MICROSLIP_WHEEL_STATE,
                                {{"lateral", "m"},
                                 {"vertical", "m"},
                                 {"roll", "rad"},
                                 {"yaw", "rad"},
                                 {"forward_velocity", "m/s"},
                                 {"lateral_velocity", "m/s"},
                                 {"vertical_velocity", "m/s"},
                                 {"roll_velocity", "rad/s"},
                                 {"pitch_velocity", "rad/s"},
                                 {"yaw_velocity", "rad/s"},
                                 {"curvature", "1/m"},
                                 {"deflection_longitudinal", "m"},
                                 {"deflection_lateral", "m"},
                                 {"deflection_vertical", "m"},
                                 {"deflection_roll", "rad"},
                                 {"deflection_yaw", "rad"},
                                 {"deflection_longitudinal_velocity", "m/s"},
                                 {"deflection_lateral_velocity", "m/s"},
                                 {"deflection_vertical_velocity", "m/s"},
                                 {"deflection_roll_velocity", "rad/s"},
                                 {"deflection_pitch_velocity", "rad/s"},
                                 {"deflection_yaw_velocity", "rad/s"},
                                 {"deviation_lateral", "m"},
                                 {"deviation_vertical", "m"},
                                 {"deviation_roll", "rad"},
                                 {"deviation_lateral_velocity", "m/s"},
                                 {"deviation_vertical_velocity", "m/s"},
                                 {"deviation_roll_velocity", "rad/s"},
                                 {"longitudinal", "m"},
                                 {"pitch", "rad"},
                                 {"vertical_force", "N"}}},
                               {MICROSLIP_WHEEL_RESULT,
                                {{"force_x", "N"},
                                 {"force_y", "N"},
                                 {"force_z", "N"},
                                 {"moment_x", "N m"},
                                 {"moment_y", "N m"},
                                 {"moment_z", "N m"},
                                 {"vertical", "m"},
                                 {"frictional_power", "W"},
                                 {"t_gamma", "N"},
                                 {"t_gamma_with_spin", "N"},
                                 {"residual", "-"},
                                 {"iterations", "-"},
                                 {"patch_count", "-"},
                                 {"y_over_q", "-"},
                                 {"nadal_limit", "-"},
                                 {"worn_mass_r8t", "kg/m"},
                                 {"worn_area", "m^2"},
                                 {"warning_code", "-"},
                                 {"at_profile_end", "-"}}},
                               {MICROSLIP_WHEEL_DERIVATIVE,
                                {{"force_x", "N"},
                                 {"force_y", "N"},
                                 {"force_z", "N"},
                                 {"moment_x", "N m"},
                                 {"moment_y", "N m"},
                                 {"moment_z", "N m"},
                                 {"vertical", "m"}}},
                               {MICROSLIP_WHEEL_PATCH,
                                {{"place_x", "m"},
                                 {"place_y", "m"},
                                 {"place_z", "m"},
                                 {"angle", "rad"},
                                 {"rail_y", "m"},
                                 {"wheel_y", "m"},
                                 {"rolling_radius", "m"},
                                 {"turn", "rad"},
                                 {"conformity", "-"},
                                 {"approach", "m"},
                                 {"rolling_speed", "m/s"},
                                 {"creepage_longitudinal", "-"},
                                 {"creepage_lateral", "-"},
                                 {"spin", "1/m"},
                                 {"normal_force", "N"},
                                 {"fx", "N"},
                                 {"fy", "N"},
                                 {"mz", "N m"},
                                 {"contact_area", "m^2"},
                                 {"slip_area", "m^2"},
                                 {"peak_pressure", "Pa"},
                                 {"frictional_power", "W"},
                                 {"t_gamma", "N"},
                                 {"t_gamma_with_spin", "N"},
                                 {"friction", "-"},
                                 {"traction_coefficient", "-"},
                                 {"t_gamma_per_area", "N/m^2"},
                                 {"worn_mass_r8t", "kg/m"},
                                 {"worn_area", "m^2"},
                                 {"wear_depth", "m"},
                                 {"fatigue_index", "-"},
                                 {"shakedown_load", "-"},
                                 {"shakedown_limit", "-"},
                                 {"nadal_limit", "-"},
                                 {"status", "-"}}},
                               {MICROSLIP_WHEELSET_CONTACT,
                                {{"lateral", "m"},
                                 {"roll", "rad"},
                                 {"vertical", "m"},
                                 {"rolling_radius_difference", "m"},
                                 {"contact_angle_difference", "rad"},
                                 {"left_rail_y", "m"},
                                 {"right_rail_y", "m"},
                                 {"left_wheel_y", "m"},
                                 {"right_wheel_y", "m"},
                                 {"left_rolling_radius", "m"},
                                 {"right_rolling_radius", "m"},
                                 {"left_contact_angle", "rad"},
                                 {"right_contact_angle", "rad"},
                                 {"left_place_x", "m"},
                                 {"right_place_x", "m"},
                                 {"left_place_y", "m"},
                                 {"right_place_y", "m"}}},
                               {MICROSLIP_WHEELSET_RESULT,
                                {{"force_x", "N"},
                                 {"force_y", "N"},
                                 {"force_z", "N"},
                                 {"moment_x", "N m"},
                                 {"moment_y", "N m"},
                                 {"moment_z", "N m"},
                                 {"vertical", "m"},
                                 {"roll", "rad"},
                                 {"pitch_velocity", "rad/s"},
                                 {"frictional_power", "W"},
                                 {"residual", "-"},
                                 {"iterations", "-"}}}};

microslip_quantity described(int list, std::size_t index) {
  microslip_quantity quantity = {};
  quantity.struct_size = sizeof quantity;
  EXPECT_EQ(microslip_describe(list, index, &quantity, nullptr), MICROSLIP_OK) << list << ' ' << index;
  return quantity;
}

TEST(CLists, BeginWithWhatTheFirstVersionHad) {
  EXPECT_EQ(MICROSLIP_ABI, 2);
  for (const auto& [list, first] : lists_of_abi_2) {
    ASSERT_GE(microslip_count(list), first.size()) << list;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const auto& [name, unit] = first[k];
      EXPECT_EQ(std::string(described(list, k).name), name) << list << ' ' << k;
      EXPECT_EQ(std::string(described(list, k).unit), unit) << list << ' ' << name;
      EXPECT_EQ(microslip_index(list, name, nullptr), static_cast<int>(k)) << list << ' ' << name;
    }
  }
}

TEST(CLists, EveryNumberIsFoundByItsName) {
  for (int list = MICROSLIP_CONTACT_QUANTITY; list <= MICROSLIP_WHEELSET_INPUT; ++list)
    for (std::size_t k = 0; k < microslip_count(list); ++k) {
      const microslip_quantity quantity = described(list, k);
      EXPECT_EQ(microslip_index(list, quantity.name, nullptr), static_cast<int>(k)) << quantity.name;
      EXPECT_GT(std::string(quantity.description).size(), 0U) << quantity.name;
      EXPECT_GT(std::string(quantity.shift_unit).size(), 0U) << quantity.name;
    }
}

TEST(CLists, DerivativesAreThoseOfResults) {
  for (std::size_t k = 0; k < microslip_count(MICROSLIP_WHEEL_DERIVATIVE); ++k) {
    const microslip_quantity row = described(MICROSLIP_WHEEL_DERIVATIVE, k);
    const int result = microslip_index(MICROSLIP_WHEEL_RESULT, row.name, nullptr);
    ASSERT_GE(result, 0) << row.name;
    EXPECT_EQ(row.description, described(MICROSLIP_WHEEL_RESULT, static_cast<std::size_t>(result)).description);
  }
}

TEST(CLists, TellTheNearestNameOfOneThatThereIsNot) {
  microslip_error error;
  EXPECT_LT(microslip_index(MICROSLIP_WHEEL_STATE, "laterel", &error), 0);
  EXPECT_EQ(std::string(error.text), "name = \"laterel\": is none of this list; did you mean lateral?");
  EXPECT_EQ(error.code, MICROSLIP_INVALID_OPTION);
  EXPECT_LT(microslip_index(MICROSLIP_WHEEL_RESULT, "lateral", nullptr), 0);
  EXPECT_EQ(microslip_index(MICROSLIP_WHEEL_STATE, "lateral", &error), 0);
  EXPECT_EQ(error.code, MICROSLIP_OK);
}

TEST(CLists, RefuseWhatThereIsNot) {
  microslip_error error;
  for (const int list : {-1, MICROSLIP_WHEELSET_INPUT + 1}) {
    EXPECT_EQ(microslip_count(list), 0U);
    EXPECT_LT(microslip_index(list, "lateral", &error), 0);
    EXPECT_EQ(std::string(error.text), "list = " + std::to_string(list) + " [-]: must be in [0, 10]");
  }
  EXPECT_LT(microslip_index(MICROSLIP_WHEEL_STATE, nullptr, &error), 0);
  EXPECT_EQ(error.code, MICROSLIP_NULL_POINTER);
  microslip_quantity quantity = {};
  EXPECT_EQ(microslip_describe(MICROSLIP_WHEEL_STATE, 0, &quantity, &error), MICROSLIP_WRONG_SIZE);
  quantity.struct_size = sizeof quantity;
  EXPECT_EQ(microslip_describe(MICROSLIP_WHEEL_STATE, microslip_count(MICROSLIP_WHEEL_STATE), &quantity, &error),
            MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(error.text), "index = 31: must be below 31");
  EXPECT_EQ(microslip_describe(MICROSLIP_WHEEL_STATE, 0, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(quantity.name, nullptr);
}

} // namespace
} // namespace microslip
