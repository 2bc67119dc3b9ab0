// A case file's text in, the result as JSON out: the numbers that the library finds for the same case.

#include "cases/case_document.hpp"
#include "microslip.h"
#include "tests/support/case_text.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string wheel_on_rail = "\ntitle = \"Wheel on rail\"\n" + two_bodies_text + R"(creepage_longitudinal = 0.0018
spin = 0.4
[solution]
theory = "exact"
grid = [10, 10]
[interior]
x = [0.0]
y = [0.0]
z = [0.001, 0.003]
)";

struct Answer {
  microslip_code code;
  std::string error;
  io::Json json; ///< null where there is none
};

Answer solve_in_c(const std::string& text) {
  char* json = nullptr;
  microslip_error error;
  const microslip_code code = microslip_solve_case(text.c_str(), "wheel.toml", &json, &error);
  Answer answer{code, error.text, json ? io::Json::parse(json) : io::Json()};
  microslip_free_text(json);
  return answer;
}

TEST(CSolveCase, HasTheDocumentOfTheProgram) {
  auto [code, error, json] = solve_in_c(wheel_on_rail);
  ASSERT_EQ(code, MICROSLIP_OK) << error;
  const io::RollingCase input = io::parse_case(wheel_on_rail, "wheel.toml");
  const cases::RollingContactResult result = cases::solve_case(input);
  io::Json wanted = cases::case_document(
      input, result,
      {.kind = "rolling_contact", .title = "Wheel on rail", .case_file = "wheel.toml", .case_text = wheel_on_rail});
  json.erase("created"); // when it was solved
  wanted.erase("created");
  EXPECT_EQ(json, wanted);
  EXPECT_EQ(json.at("exact").at("fx"), result.exact->contact.totals.fx);
  EXPECT_EQ(json.at("units").at("exact/fx"), "N");
  EXPECT_EQ(json.at("inputs").at("body2").at("rolling_radius"), "inf");
  EXPECT_FALSE(json.at("exact").contains("fields"));
  EXPECT_FALSE(json.contains("interior"));
  EXPECT_EQ(json.at("interior_extremes").at("von_mises").at("value"),
            std::max(von_mises(result.exact->interior[0].stress), von_mises(result.exact->interior[1].stress)));
  EXPECT_EQ(json.at("warnings"), io::Json::array());
}

TEST(CSolveCase, RefusesACaseInTheWordsOfTheFile) {
  const auto [code, error, json] = solve_in_c(with(wheel_on_rail, "normal_force", "normal_forse"));
  EXPECT_EQ(code, MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(error.find("wheel.toml:"), 0U) << error;
  EXPECT_NE(error.find("did you mean normal_force?"), std::string::npos) << error;
  EXPECT_TRUE(json.is_null());
  microslip_error refusal;
  EXPECT_EQ(microslip_solve_case("", "wheel.toml", nullptr, &refusal), MICROSLIP_NULL_POINTER);
}

TEST(CSolveCase, WarnsAndTellsWhy) {
  const Answer soft = solve_in_c(with(wheel_on_rail, {{"210e9", "210e3"}, {"210e9", "210e3"}})); // in MPa
  ASSERT_FALSE(soft.json.is_null()) << soft.error;
  ASSERT_FALSE(soft.json.at("warnings").empty());
  EXPECT_NE(soft.json.at("warnings").dump().find("contact ellipse"), std::string::npos);
  const Answer beyond = solve_in_c(with(wheel_on_rail, "creepage_longitudinal = 0.0018", "force_longitudinal = -30e3"));
  EXPECT_EQ(beyond.code, MICROSLIP_NO_SOLUTION);
  EXPECT_EQ(beyond.error, "prescribed force exceeds mu Fn; the result shown is full sliding");
  EXPECT_EQ(beyond.json.at("status"), "no_solution");
}

} // namespace
} // namespace microslip
