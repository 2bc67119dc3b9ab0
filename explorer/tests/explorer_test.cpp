#include "explorer/core/explorer.hpp"

#include "cases/case_document.hpp"
#include "cases/wheel_rail_result.hpp"
#include "io/toml_section.hpp"
#include "io/units.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace microslip::explorer {
namespace {

namespace fs = std::filesystem;

const fs::path examples = MICROSLIP_SOURCE_DIR "/examples";

std::string ellipse_case() {
  return with(contents(examples / "hertzian_contact.toml"), "grid = [40, 40]", "grid = [16, 16]");
}
std::string starting_case() {
  return contents(examples / "starting_to_roll.toml");
}
/// The example's rollers with a crown.
std::string nip_case() {
  const std::string steel = "\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.28\n\n[[body2.layers]]";
  const std::string text = contents(examples / "rubber_roller.toml");
  return with(with(with(text, "inf" + steel, "20" + steel), "\"10 kN\"", "\"4 kN\""), "grid = 80", "grid = [16, 8]");
}
std::string wheel_case() {
  std::string text = with(contents(examples / "wheel_on_rail.toml"), "profiles/60e1.prr", "60e1.prr");
  return with(with(text, "profiles/s1002.prw", "s1002.prw"), "grid = 60", "grid = 16");
}
io::Json profiles() {
  return {{"60e1.prr", contents(examples / "profiles/60e1.prr")},
          {"s1002.prw", contents(examples / "profiles/s1002.prw")}};
}

class ExplorerTest : public testing::Test {
protected:
  ExplorerTest()
      : folder_(fs::temp_directory_path() / ("microslip_explorer_" + std::to_string(::getpid()))), made_(make(folder_)),
        explorer_(folder_) {}
  ~ExplorerTest() override { fs::remove_all(folder_); }

  io::Json answer(const io::Json& request) { return io::Json::parse(explorer_.answer(request.dump())); }
  io::Json result(const io::Json& request) {
    io::Json reply = answer(request);
    EXPECT_FALSE(reply.contains("error")) << reply.dump();
    EXPECT_GE(reply.value("time", -1.0), 0.0);
    return reply.value("result", io::Json::object());
  }
  std::string refusal(const io::Json& request) {
    const io::Json reply = answer(request);
    EXPECT_FALSE(reply.contains("result"));
    return reply.contains("error") ? reply["error"]["message"].get<std::string>() : "";
  }

  fs::path folder_;

private:
  static bool make(const fs::path& folder) { return fs::create_directories(folder); }

  bool made_;

protected:
  Explorer explorer_;
};

TEST_F(ExplorerTest, RefusesWhatIsNoRequest) {
  const auto words = [&](const char* text) {
    return io::Json::parse(explorer_.answer(text))["error"]["message"].get<std::string>();
  };
  EXPECT_EQ(words(""), "request: must be a JSON object");
  EXPECT_EQ(words("[1]"), "request: must be a JSON object");
  EXPECT_EQ(words("{\"call\": \"solve\""), "request: must be a JSON object");
  EXPECT_EQ(words("{}"), "request.call: is missing");
  EXPECT_EQ(words("{\"call\": 3}"), "request.call: must be a text");
  EXPECT_EQ(words("{\"call\": \"sovle\"}"), "request.call = \"sovle\": must be solve, inputs, radii, creep_curve, "
                                            "transient, nip, nip_curve, profile, conicity, description or "
                                            "version; did you mean solve?");
  EXPECT_EQ(words("{\"call\": \"solve\"}"), "request.case: is missing");
  EXPECT_EQ(words("{\"call\": \"solve\", \"kase\": \"\"}"), "request.kase: unknown member; did you mean case?");
  EXPECT_EQ(words("{\"call\": \"solve\", \"case\": \"\", \"fields\": 1}"), "request.fields: must be true or false");
  EXPECT_EQ(words("{\"call\": \"solve\", \"case\": \"\", \"files\": {\"../a\": \"\"}}"),
            "file \"../a\": must be a name without a folder");
}

/// Every text has an answer: a result, or an error with words.
TEST_F(ExplorerTest, AnswersDamagedRequests) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string quick = with(starting_case(), "theory = \"exact\"\ngrid = [24, 24]", "grid = [6, 6]");
  const std::string whole =
      io::Json({{"call", "solve"}, {"case", with(with(quick, "\"transient\"", "\"steady\""), "steps = 60", "")}})
          .dump();
  int results = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string text = whole;
    for (std::size_t changes = below(3); changes > 0; --changes) {
      const std::size_t at = below(text.size());
      switch (below(3)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      default:
        text.insert(at, text.substr(below(text.size()), 1 + below(20)));
      }
    }
    const io::Json reply = io::Json::parse(explorer_.answer(text));
    ASSERT_NE(reply.contains("result"), reply.contains("error")) << text;
    results += reply.contains("result");
    if (reply.contains("error")) {
      ASSERT_FALSE(reply["error"]["message"].get<std::string>().empty()) << text;
    }
  }
  EXPECT_GT(results, 600);
  EXPECT_LT(results, 1900);
}

TEST_F(ExplorerTest, RefusesCasesInTheReadersWords) {
  const std::string name = (folder_ / "case.toml").string();
  const auto words = [&](const std::string& text) { return refusal({{"call", "solve"}, {"case", text}}); };
  const auto readers = [&](const std::string& text) -> std::string {
    try {
      io::parse_case(text, name);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  for (const auto& [from, to] : {std::pair{"coefficient = 0.3 ", "coefficient = -0.3 "},
                                 {"normal_force =", "normal_forse ="},
                                 {"\"80 kN\"", "\"80 mm\""},
                                 {"grid = [16, 16]", "grid = [16"}}) {
    const std::string text = with(ellipse_case(), from, to);
    EXPECT_EQ(words(text), readers(text));
    EXPECT_TRUE(words(text).starts_with(name + ":")) << words(text);
  }
  EXPECT_EQ(refusal({{"call", "solve"}, {"case", wheel_case()}, {"files", {{"s1002.prw", "x"}}}}),
            name + ": rail.profile = \"60e1.prr\": not here; such a file goes along with the case");
}

/// Of the paths of profiles their ends count.
TEST_F(ExplorerTest, TakesProfilesWithoutTheirFolders) {
  const std::string text = with(wheel_case(), "\"60e1.prr\"", "\"../rails/60e1.prr\"");
  const io::Json plain = result({{"call", "solve"}, {"case", wheel_case()}, {"files", profiles()}});
  EXPECT_EQ(result({{"call", "solve"}, {"case", text}})["wheel"], plain["wheel"]);
  EXPECT_EQ(refusal({{"call", "solve"}, {"case", with(text, "\"s1002.prw\"", "\"worn\\\\s1002.txt\"")}}),
            (folder_ / "case.toml").string() +
                ": wheelset.profile = \"worn\\s1002.txt\": not here; such a file goes along with the case");
  const std::string alike = refusal({{"call", "solve"}, {"case", with(text, "\"s1002.prw\"", "\"60e1.prr\"")}});
  EXPECT_NE(alike.find("wheelset.profile: \"60e1.prr\" and \"../rails/60e1.prr\" have one name"), std::string::npos)
      << alike;
}

/// The keys of a table's values, "load.normal_force".
void add_keys(const toml::table& table, const std::string& before, std::set<std::string>& keys) {
  for (const auto& [key, value] : table) {
    const std::string name = before + std::string(key.str());
    const auto* list = value.as_array();
    if (value.is_table())
      add_keys(*value.as_table(), name + ".", keys);
    else if (list != nullptr && list->is_homogeneous<toml::table>())
      for (std::size_t k = 0; k < list->size(); ++k)
        add_keys(*list->get(k)->as_table(), name + "." + std::to_string(k + 1) + ".", keys);
    else
      keys.insert(name);
  }
}

TEST_F(ExplorerTest, TellsAllThatAnExampleSays) {
  std::size_t count = 0;
  for (const auto& [example, kind] : {std::pair{"hertzian_contact.toml", "rolling_contact"},
                                      {"two_rollers.toml", "rolling_contact"},
                                      {"twin_disc.toml", "rolling_contact"},
                                      {"rubber_roller.toml", "rolling_contact"},
                                      {"starting_to_roll.toml", "rolling_contact"},
                                      {"wheel_on_rail.toml", "wheel_rail"},
                                      {"lateral_sweep.toml", "wheel_rail"},
                                      {"wheelset_in_curve.toml", "wheelset"}}) {
    const std::string text = contents(examples / example);
    const io::Json found = result({{"call", "inputs"}, {"case", text}, {"files", profiles()}});
    EXPECT_EQ(found["kind"], kind);
    std::set<std::string> keys;
    add_keys(io::parse_toml(text, example), "", keys);
    EXPECT_EQ(found["given"].get<std::set<std::string>>(), keys) << example;
    for (const std::string& key : keys) EXPECT_TRUE(found["inputs"].contains(key)) << key;
    count += keys.size();
  }
  EXPECT_GT(count, 100u);
}

TEST_F(ExplorerTest, TellsInputsInSiWithTheirDefaults) {
  const io::Json found = result({{"call", "inputs"}, {"case", contents(examples / "two_rollers.toml")}});
  const io::Json& inputs = found["inputs"];
  EXPECT_EQ(inputs["body1.rolling_radius"], 0.05);
  EXPECT_EQ(inputs["body2.transverse_radius"], "inf");
  EXPECT_EQ(inputs["friction.half_velocity"], 0.05);
  EXPECT_EQ(inputs["friction.law"], "exponential");
  EXPECT_EQ(inputs["solution.grid"], io::Json({60, 30}));
  EXPECT_EQ(inputs["motion.creepage_longitudinal"], 0); // the default
  EXPECT_EQ(inputs["motion.kind"], "steady");
  EXPECT_EQ(found["units"]["friction.half_velocity"], "m/s");
  EXPECT_FALSE(found["units"].contains("friction.law"));
  const io::Json wheel = result({{"call", "inputs"}, {"case", wheel_case()}, {"files", profiles()}});
  EXPECT_EQ(wheel["inputs"]["rail.profile"], "60e1.prr");
  EXPECT_EQ(wheel["inputs"]["rail.scale"], 1);
  EXPECT_FALSE(wheel["inputs"].contains("rail.smoothing_length")); // left out: by the noise
  EXPECT_EQ(wheel["inputs"]["solution.grid"], 16);
  EXPECT_EQ(wheel["inputs"]["wheel.yaw"], 0.002);
  EXPECT_EQ(refusal({{"call", "inputs"}, {"case", with(ellipse_case(), "spin =", "spinn =")}}),
            refusal({{"call", "solve"}, {"case", with(ellipse_case(), "spin =", "spinn =")}}));
}

TEST_F(ExplorerTest, SolvesAnEllipseAsTheProgramDoes) {
  const std::string text = ellipse_case();
  const io::RollingCase input = io::parse_case(text, "case.toml");
  io::Json expected =
      cases::case_document(input, cases::solve_case(input), {.kind = "rolling_contact", .title = input.title});
  io::Json found = result({{"call", "solve"}, {"case", text}});
  for (const char* changing : {"created", "case_text", "command_line"}) expected.erase(changing), found.erase(changing);
  EXPECT_EQ(found, expected);
}

/// The contact of the radii has the ellipse that was asked for.
TEST_F(ExplorerTest, FindsRadiiOfAnEllipse) {
  for (const double ratio : {0.02, 0.5, 1.0, 30.0}) {
    const double b = 4e-3, a = ratio * b;
    const io::Json radii = result({{"call", "radii"}, {"case", ellipse_case()}, {"a", a}, {"b", b}});
    constexpr double flat = std::numeric_limits<double>::infinity();
    RollingProblem problem = io::parse_case(ellipse_case(), "case.toml").problem;
    problem.geometry =
        gap_curvatures({radii["rolling_radius"].get<double>(), flat, radii["transverse_radius"].get<double>(), flat});
    const HertzContact hertz = hertz_contact(problem);
    EXPECT_NEAR(hertz.a, a, 1e-10 * a);
    EXPECT_NEAR(hertz.b, b, 1e-10 * b);
  }
  const auto refused = [&](double a) {
    return refusal({{"call", "radii"}, {"case", ellipse_case()}, {"a", a}, {"b", 4e-3}});
  };
  EXPECT_TRUE(refused(-1e-3).starts_with("a = -0.001 [m]: ")) << refused(-1e-3);
  EXPECT_TRUE(refused(1e4).starts_with("a/b = ")) << refused(1e4);
}

/// The totals are the sums of the fields.
TEST_F(ExplorerTest, GivesFieldsInOneOrder) {
  const io::Json found =
      result({{"call", "solve"}, {"case", ellipse_case()}, {"fields", true}, {"extent", "solution"}});
  for (const char* theory : {"exact", "fastsim2"}) {
    const io::Json& fields = found[theory]["fields"];
    const auto area = fields["area"].get<std::vector<double>>(), px = fields["px"].get<std::vector<double>>(),
               y = fields["y"].get<std::vector<double>>();
    const double fx = std::inner_product(px.begin(), px.end(), area.begin(), 0.0);
    EXPECT_NEAR(fx, found[theory]["fx"].get<double>(), 1e-9 * std::abs(fx)) << theory;
    EXPECT_TRUE(std::is_sorted(y.begin(), y.end()));
    const auto shape = found["shapes"][std::string(theory) + "/fields/px"].get<std::vector<std::size_t>>();
    EXPECT_EQ(shape.at(0) * shape.at(1), px.size());
  }
  EXPECT_FALSE(found["creep_curve"].contains("exact"));
}

TEST_F(ExplorerTest, CreepCurvesPassThroughTheContact) {
  const std::string text = ellipse_case();
  const io::Json found = result({{"call", "solve"}, {"case", text}, {"extent", "solution"}});
  const double creepage = found["exact"]["creepage_longitudinal"].get<double>();
  const io::Json curve = result({{"call", "creep_curve"},
                                 {"case", text},
                                 {"variable", "creepage_longitudinal"},
                                 {"from", -creepage},
                                 {"to", creepage},
                                 {"count", 3}});
  EXPECT_EQ(curve["theory"], "exact");
  EXPECT_EQ(curve["value"], io::Json({-creepage, 0, creepage}));
  const double fx = found["exact"]["fx"].get<double>();
  EXPECT_NEAR(curve["fx"][2].get<double>(), fx, 1e-5 * std::abs(fx));
  EXPECT_EQ(
      refusal({{"call", "creep_curve"}, {"case", text}, {"variable", "spinn"}, {"from", 0}, {"to", 1}, {"count", 3}}),
      "request.variable = \"spinn\": must be creepage_longitudinal, creepage_lateral or spin; did you mean spin?");
}

/// Cattaneo (1938), Mindlin (1949): under a force of Fx the stick area of two spheres has the radius
/// a (1 - Fx/(mu Fn))^(1/3); rolled on under it, the bodies come to Carter's steady state, whose creepage the steady
/// solution has.
TEST_F(ExplorerTest, RollsFromAShiftToTheSteadyState) {
  std::string text = with(starting_case(), "creepage_longitudinal = 0.0015", "force_longitudinal = -12e3");
  text = with(with(text, "creepage_lateral = 0.0005", "spin = 0.0"), "transverse_radius = \"300 mm\"",
              "transverse_radius = inf");
  text = with(with(text, "transverse_radius = inf", "transverse_radius = 0.460"), "steps = 60", "steps = 80");
  const io::Json found = result({{"call", "transient"}, {"case", text}});
  EXPECT_EQ(found["status"], "ok");
  ASSERT_EQ(found["frames"].size(), 81u);
  const io::Json& shift = found["frames"][0];
  EXPECT_EQ(shift["distance"], 0);
  const auto state = shift["state"].get<std::vector<int>>();
  const double contact = static_cast<double>(std::count_if(state.begin(), state.end(), [](int s) { return s > 0; }));
  const double adhesion = static_cast<double>(std::count(state.begin(), state.end(), 1));
  EXPECT_NEAR(adhesion / contact, std::pow(1 - 12e3 / 24e3, 2. / 3), 0.05);
  for (const io::Json& frame : found["frames"]) EXPECT_NEAR(frame["fx"].get<double>(), -12e3, 1);
  text = with(with(text, "\"transient\"", "\"steady\""), "steps = 80", "");
  text = with(text, "theory = \"exact\"", "theory = \"exact\"\ndiscretisation = \"classical\"");
  const io::Json steady = result({{"call", "solve"}, {"case", text}, {"extent", "solution"}});
  const double creepage = steady["exact"]["creepage_longitudinal"].get<double>();
  EXPECT_NEAR(found["frames"][80]["creepage_longitudinal"].get<double>(), creepage, 0.02 * std::abs(creepage));
  EXPECT_NE(refusal({{"call", "transient"}, {"case", ellipse_case()}}).find("motion.kind"), std::string::npos);
}

/// With the creepage of the free roller the force is zero; the case itself is as the program has it.
TEST_F(ExplorerTest, FindsTheNipAsTheProgramDoesAndTheFreeRoller) {
  const io::Json found = result({{"call", "nip"}, {"case", nip_case()}});
  const io::Json whole = result({{"call", "solve"}, {"case", nip_case()}, {"fields", true}, {"extent", "solution"}});
  for (const char* name : {"fx", "my", "creepage_longitudinal", "approach", "peak_pressure", "frictional_power"})
    EXPECT_EQ(found["given"][name], whole["exact"][name]) << name;
  for (const char* name : {"x", "y", "pressure", "bound", "px", "py", "state"})
    EXPECT_EQ(found["fields"][name], whole["exact"]["fields"][name]) << name;
  const double creepage = found["free"]["creepage_longitudinal"];
  EXPECT_EQ(found["free"]["speed_ratio"].get<double>(), (2 - creepage) / (2 + creepage));
  EXPECT_GT(found["free"]["speed_ratio"].get<double>(), 1.01); // a cover that keeps its volume is longer in the nip
  const std::string given = "creepage_longitudinal = " + io::Json(creepage).dump();
  const io::Json free = result({{"call", "nip"}, {"case", with(nip_case(), "force_longitudinal = \"-400 N\"", given)}});
  EXPECT_NEAR(free["given"]["fx"].get<double>(), 0, 1e-5 * 0.6 * 4000);
  EXPECT_EQ(found["units"]["my"], "N m");
}

/// Moduli and hardness of the cover, each put in place of the others, are the same cover.
TEST_F(ExplorerTest, TellsTheStiffnessOfACoverInOtherWords) {
  const io::Json cover = result({{"call", "nip"}, {"case", nip_case()}})["cover"];
  EXPECT_NEAR(cover["hardness"].get<double>(), 60, 1e-9);
  for (const char* key : {"hardness", "young_modulus", "shear_modulus"}) {
    const std::string text = with(nip_case(), "hardness = \"60 ShoreA\"", std::string(key) + " = " + cover[key].dump());
    const io::Json same = result({{"call", "nip"}, {"case", text}})["cover"];
    for (const auto& [name, value] : cover.items())
      EXPECT_NEAR(same[name].get<double>(), value.get<double>(), 1e-12 * value.get<double>()) << key << ", " << name;
  }
  const std::string soft = with(nip_case(), "hardness = \"60 ShoreA\"", "young_modulus = 5e5");
  EXPECT_FALSE(result({{"call", "nip"}, {"case", soft}})["cover"].contains("hardness"));
}

/// The upper roller sees the same when rolling, force and axes are turned round.
TEST_F(ExplorerTest, FreeRollersHaveTheSameSpeedRatioInEitherDirection) {
  const std::string backward = with(with(nip_case(), "\"-400 N\"", "\"400 N\""), "rolling_speed = \"5 m/s\"",
                                    "rolling_speed = \"5 m/s\"\ndirection = \"backward\"");
  const io::Json one = result({{"call", "nip"}, {"case", nip_case()}}),
                 other = result({{"call", "nip"}, {"case", backward}});
  for (const char* column : {"given", "free"})
    EXPECT_NEAR(one[column]["speed_ratio"].get<double>(), other[column]["speed_ratio"].get<double>(), 1e-6) << column;
}

TEST_F(ExplorerTest, NipCurvesGoThroughFreeRollingToEitherSide) {
  const io::Json curve = result({{"call", "nip_curve"}, {"case", nip_case()}, {"count", 13}});
  const auto value = curve["value"].get<std::vector<double>>(), fx = curve["fx"].get<std::vector<double>>();
  ASSERT_EQ(fx.size(), 13u);
  EXPECT_TRUE(std::is_sorted(value.begin(), value.end()));
  EXPECT_TRUE(std::is_sorted(fx.rbegin(), fx.rend()));
  const double largest = 0.6 * 4000;
  EXPECT_NEAR(fx[6], 0, 1e-5 * largest);
  EXPECT_NEAR(fx[8], -0.5 * largest, 1e-5 * largest); // a third of the reach
  EXPECT_GT(fx.front(), 0.8 * largest);
  EXPECT_LT(fx.back(), -0.8 * largest);
  const double creepage = result({{"call", "nip"}, {"case", nip_case()}})["free"]["creepage_longitudinal"];
  EXPECT_NEAR(value[6], creepage, 1e-5);
}

/// What was solved before with the same elements leaves nothing behind.
TEST_F(ExplorerTest, KeepsElementsOfNipsWithoutTrace) {
  const auto ask = [](Explorer& explorer, const std::string& text) {
    const io::Json request = {{"call", "nip"}, {"case", text}};
    return io::Json::parse(explorer.answer(request.dump()))["result"]["given"];
  };
  const std::string other = with(nip_case(), "\"-400 N\"", "\"900 N\"");
  for (const std::string& text :
       {with(nip_case(), "thickness = \"15 mm\"", "thickness = \"10 mm\""), with(nip_case(), "\"4 kN\"", "\"3 kN\""),
        with(nip_case(), "\"5 m/s\"", "\"2 m/s\""), nip_case()}) {
    ask(explorer_, other);
    const io::Json kept = ask(explorer_, text);
    Explorer fresh(folder_);
    const io::Json anew = ask(fresh, text);
    for (const char* name : {"creepage_longitudinal", "approach", "my"})
      EXPECT_NEAR(kept[name].get<double>(), anew[name].get<double>(), 1e-5 * std::abs(anew[name].get<double>()))
          << name;
  }
}

/// Of cylinders the nip is one row of strips.
TEST_F(ExplorerTest, FindsTheNipOfCylinders) {
  const std::string text = with(contents(examples / "rubber_roller.toml"), "grid = 80", "grid = 20");
  const io::Json found = result({{"call", "nip"}, {"case", text}});
  EXPECT_EQ(found["fields"]["y"].get<std::set<double>>(), std::set<double>{0});
  EXPECT_NEAR(found["given"]["fx"].get<double>(), -400, 1e-5 * 0.6 * 10e3);
  const io::Json whole = result({{"call", "solve"}, {"case", text}});
  EXPECT_NEAR(found["free"]["speed_ratio"].get<double>(), whole["nip"]["speed_ratio1"].get<double>(), 1e-5);
}

TEST_F(ExplorerTest, RefusesWhatIsNoNip) {
  const auto words = [&](const std::string& text) { return refusal({{"call", "nip"}, {"case", text}}); };
  EXPECT_EQ(words(ellipse_case()), "nip: needs a case with layers and motion.kind = \"steady\"");
  EXPECT_EQ(words(with(nip_case(), "coefficient = 0.6", "coefficient = 0")),
            "friction.coefficient = 0 [-]: must be positive and finite");
  EXPECT_EQ(words(with(nip_case(), "\"-400 N\"", "\"-2.5 kN\"")),
            "motion.force_longitudinal = -2500 [N]: must be in [-2400, 2400]");
  EXPECT_EQ(refusal({{"call", "nip_curve"}, {"case", nip_case()}, {"count", 1}}),
            "request.count = 1 [-]: must be in [2, 1000]");
}

/// Whatever has been solved before, a state's answer is that of a new model.
TEST_F(ExplorerTest, KeepsModelsOfWheelsWithoutTrace) {
  const auto ask = [&](Explorer& explorer, const std::string& text) {
    io::Json request = {{"call", "solve"}, {"case", text}, {"files", profiles()}};
    return io::Json::parse(explorer.answer(request.dump()))["result"]["wheel"];
  };
  const std::string exact = wheel_case(), quick = with(with(exact, "theory = \"exact\"", "theory = \"fastsim2\""),
                                                       "shape = \"flat\"", "shape = \"curved\"");
  for (const std::string& text : {quick, exact}) {
    const std::string moved = with(text, "lateral = \"6.04 mm\"", "lateral = \"2 mm\"");
    ask(explorer_, text);
    ask(explorer_, with(moved, "\"2 mrad\"", "\"-3 mrad\""));
    const io::Json kept = ask(explorer_, moved);
    Explorer fresh(folder_);
    const io::Json anew = ask(fresh, moved);
    for (const char* name : {"force_x", "force_y", "force_z", "vertical"})
      EXPECT_NEAR(kept[name][0].get<double>(), anew[name][0].get<double>(), 1e-3) << name;
    EXPECT_NE(kept["force_y"], ask(explorer_, text)["force_y"]);
  }
}

TEST_F(ExplorerTest, SeesThatAFileHasChanged) {
  const io::Json before = result({{"call", "solve"}, {"case", wheel_case()}, {"files", profiles()}});
  io::Json files = profiles();
  files["s1002.prw"] = with(files["s1002.prw"].get<std::string>(), "units.len.f", "units.len.f ");
  EXPECT_EQ(result({{"call", "solve"}, {"case", wheel_case()}, {"files", files}})["wheel"], before["wheel"]);
  files["s1002.prw"] = "nothing";
  EXPECT_NE(refusal({{"call", "solve"}, {"case", wheel_case()}, {"files", files}}).find("s1002.prw:1"),
            std::string::npos);
}

TEST_F(ExplorerTest, ReadsProfiles) {
  const io::Json found = result({{"call", "profile"}, {"name", "s1002.prw"}, {"text", profiles()["s1002.prw"]}});
  EXPECT_EQ(found["role"], "wheel");
  EXPECT_EQ(found["file_format"], "Simpack");
  EXPECT_EQ(found["curve"]["y"].size(), found["curve"]["z"].size());
  EXPECT_EQ(found["measured"]["y"].size(), found["points_read"].get<std::size_t>());
  EXPECT_EQ(found["units"]["curve/y"], "m");
  EXPECT_EQ(refusal({{"call", "profile"}, {"name", "a.prw"}, {"text", "x y z"}}),
            "a.prw:1: \"x y z\" is neither KEY = VALUE nor a block's begin or end");
  EXPECT_EQ(refusal({{"call", "profile"}, {"name", "a.txt"}, {"text", "1 2"}, {"role", "weel"}}),
            "request.role = \"weel\": must be rail or wheel; did you mean wheel?");
}

TEST_F(ExplorerTest, ReadsHowAProfileIsReadWithinTheBoundsOfCaseFiles) {
  const auto words = [&](const char* member, double value) {
    return refusal({{"call", "profile"}, {"name", "a.prw"}, {"text", ""}, {member, value}});
  };
  EXPECT_EQ(words("section", 0), "request.section = 0 [-]: must be in [1, 10000]");
  EXPECT_EQ(words("section", 1.5), "request.section: must be a whole number");
  EXPECT_EQ(words("smoothing_length", 2), "request.smoothing_length = 2 [m]: must be in [0, 1]");
}

TEST_F(ExplorerTest, DescribesEveryInputAsTheTablesDo) {
  const io::Json all = result({{"call", "description"}})["inputs"];
  ASSERT_EQ(all.size(), description::case_kinds.size());
  for (const std::string_view kind : description::case_kinds) {
    const auto named = description::inputs_of(kind).named();
    EXPECT_EQ(all[std::string(kind)].size(), named.size());
    for (const auto& [path, input, range] : named) {
      const io::Json found = all[std::string(kind)][path];
      EXPECT_EQ(found["section"], input->section) << path;
      EXPECT_EQ(found.value("unit", ""), input->unit) << path;
      EXPECT_EQ(found.value("range", ""), input->bounds.text()) << path;
      EXPECT_EQ(found.contains("words"), !input->words.empty()) << path;
      EXPECT_EQ(found["text"], input->text) << path;
    }
  }
  EXPECT_EQ(all["bodies"]["friction.law"]["default"], "coulomb");
  EXPECT_EQ(all["bodies"]["friction.law"]["words"].size(), 6);
  EXPECT_EQ(all["bodies"]["body2.poisson_ratio"]["largest"], 0.5);
  EXPECT_FALSE(all["bodies"]["body2.rolling_radius"].contains("least"));
  EXPECT_EQ(all["wheel"]["rail.scale"]["default"], 1);
  EXPECT_FALSE(all["wheel"]["rail.smoothing_length"].contains("default"));
  EXPECT_EQ(all["wheel"]["rail.smoothing_length"]["section"], "profile");
  EXPECT_EQ(all["wheel"]["wheel.yaw"]["state"], true);
}

TEST_F(ExplorerTest, DescribesOutputsAndUnits) {
  const io::Json all = result({{"call", "description"}});
  EXPECT_EQ(all["outputs"]["bodies"].size(), quantities().size());
  EXPECT_EQ(all["outputs"]["fields"]["px"]["unit"], "Pa");
  EXPECT_EQ(all["outputs"]["bodies"]["fx"]["label"], quantity("fx").label);
  EXPECT_EQ(all["outputs"]["wheel"]["t_gamma"]["unit"], "N");
  EXPECT_EQ(all["outputs"]["patch"]["peak_pressure"]["unit"], "Pa");
  for (const auto& [unit, offered] : all["units"].items()) {
    EXPECT_FALSE(offered.empty()) << unit;
    for (const auto& [name, scale] : offered.items()) {
      const double si = 1435 * scale[0].get<double>() / scale[1].get<double>();
      EXPECT_EQ(si, io::number_in_unit("a", "1435 " + name, unit)) << name;
    }
  }
}

TEST_F(ExplorerTest, FindsConicity) {
  const io::Json found = result(
      {{"call", "conicity"}, {"case", wheel_case()}, {"files", profiles()}, {"amplitudes", {0.003, 0.003, 0.001}}});
  EXPECT_EQ(found["equivalent_conicity"].size(), 1u);
  for (const io::Json& at : found["over_lateral_displacement"]) {
    EXPECT_TRUE(at["left_rail_y"].is_number());
    if (at["lateral"] == 0) {
      EXPECT_NEAR(at["rolling_radius_difference"].get<double>(), 0, 1e-9);
    }
  }
  EXPECT_NE(refusal({{"call", "conicity"}, {"case", ellipse_case()}}).find("a wheel on a rail is wanted"),
            std::string::npos);
}

} // namespace
} // namespace microslip::explorer
