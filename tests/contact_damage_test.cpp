// Wear and fatigue of two bodies in contact, as case files ask for them.

#include "cases/contact_damage.hpp"

#include "campaign/sweep.hpp"
#include "cases/case_document.hpp"
#include "cases/rolling_contact_result.hpp"
#include "microslip/damage/fatigue.hpp"

#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double friction = 0.45, hardness = 2.7e9, shear_yield = 300e6, normal_force = 1600;
/// Wear coefficient below 0.2 m/s, where all of these cases slide.
const double coefficient = WearMap().slow;

const std::string twin_disc = io::read_case_text(MICROSLIP_SOURCE_DIR "/examples/twin_disc.toml");

std::string moved(const std::string& motion, const std::string& theory = "exact", int elements = 24) {
  return with(twin_disc, {{"creepage_longitudinal = 0.02\n", motion + "\n"},
                          {"grid = 40", "grid = " + std::to_string(elements)},
                          {"theory = \"exact\"", "theory = \"" + theory + "\""}});
}

struct Solved {
  explicit Solved(const std::string& text)
      : input(io::parse_case(text, "w.toml")), result(cases::solve_case(input, {}, cases::ExactExtent::solution)),
        solution(result.exact ? result.exact->contact : result.simplified->solution),
        damage(input, result.hertz, solution) {
    EXPECT_EQ(result.status, Status::ok) << result.reason;
  }

  double operator()(std::string_view name) const { return damage(*find_damage_quantity(name)); }
  std::vector<double> field(std::string_view name) const { return damage(*find_damage_field(name)); }
  double integral(std::string_view name) const {
    const auto values = field(name);
    const auto& area = solution.elements.area;
    return std::inner_product(values.begin(), values.end(), area.begin(), 0.0);
  }

  io::RollingCase input;
  cases::RollingContactResult result;
  ContactSolution solution;
  cases::CaseDamage damage;
};

// Discs that slide as a whole: work is mu Fn s per metre rolled, and Archard's law is k s Fn/H. At the edge elastic
// slip turns the tractions by a little.
TEST(ContactDamage, OfDiscsThatSlideIsThatOfTheirNormalForce) {
  constexpr double slip = 0.15;
  for (const std::string theory : {"exact", "fastsim2"}) {
    const Solved s(moved("creepage_longitudinal = 0.15", theory));
    ASSERT_LT(s.solution.totals.adhesion_area, 1e-3 * s.solution.totals.slip_area);
    EXPECT_NEAR(s("t_gamma") / (friction * normal_force * slip), 1, 2e-5) << theory;
    EXPECT_NEAR(s("traction_coefficient"), friction, 1e-5) << theory;
    EXPECT_NEAR(s.integral("friction_work") / (friction * normal_force * slip), 1, 0.02) << theory;
    EXPECT_NEAR(s("worn_area") / (coefficient * slip * normal_force / hardness), 1, 0.02) << theory;
    EXPECT_NEAR(s("shakedown_load"), s.result.hertz.peak_pressure / shear_yield, 0.01 * s("shakedown_load"));
    EXPECT_NEAR(s("fatigue_index"), s("traction_coefficient") - 1 / s("shakedown_load"), 1e-9);
    EXPECT_EQ(s("shakedown_limit"), point_shakedown_limit(s("traction_coefficient")));
  }
}

// Where the discs stick in part, wear is the work of friction still, k/(mu H) of it by (D4), and that work is
// T-gamma.
TEST(ContactDamage, OfDiscsThatStickInPartIsTheirWorkOfFriction) {
  const double speed = io::parse_case(twin_disc, "w.toml").problem.motion.rolling_speed;
  for (const std::string motion : {"creepage_longitudinal = 0.002", "creepage_lateral = -0.003",
                                   "creepage_longitudinal = 0.0015\ncreepage_lateral = 0.001"}) {
    const Solved s(moved(motion));
    ASSERT_GT(s.solution.totals.adhesion_area, 0.1 * s.solution.totals.slip_area);
    EXPECT_NEAR(s("worn_area") / (coefficient / (friction * hardness) * s.integral("friction_work")), 1, 1e-5);
    EXPECT_NEAR(s("t_gamma") * speed / s.solution.totals.frictional_power, 1, 0.01) << motion;
    const Solved finer(moved(motion, "exact", 48)); // the slip between the last centres is missing
    const double missing = 1 - s.integral("friction_work") / s("t_gamma");
    EXPECT_LT(std::abs(missing), 0.07) << motion;
    EXPECT_LT(std::abs(1 - finer.integral("friction_work") / finer("t_gamma")), 0.75 * std::abs(missing)) << motion;
    const auto depth = row_sums(s.solution.elements, s.field("wear_depth"));
    EXPECT_EQ(*std::max_element(depth.begin(), depth.end()), s("wear_depth"));
    EXPECT_NEAR(std::accumulate(depth.begin(), depth.end(), 0.0) * s.solution.elements.grid.dy / s("worn_area"), 1,
                1e-12);
  }
}

// With a simplified solution, which has no pressures, go Hertz's. Its bound is lower than mu times these at the edge,
// so that wear is a little more than the work of friction says.
TEST(ContactDamage, OfTheSimplifiedTheoryIsNearThatOfTheExactOne) {
  const std::string motion = "creepage_longitudinal = 0.008";
  const Solved exact(moved(motion)), simplified(moved(motion, "fastsim2"));
  for (const auto* name : {"t_gamma", "worn_area", "wear_depth", "worn_mass_r8t", "fatigue_index"})
    EXPECT_NEAR(simplified(name) / exact(name), 1, 0.1) << name;
}

TEST(ContactDamage, IsTheSameInAMirror) {
  for (const std::string theory : {"exact", "fastsim2"}) {
    const auto motion = [](int side) {
      const std::string sign = side > 0 ? "" : "-";
      return "creepage_longitudinal = 0.001\ncreepage_lateral = " + sign + "0.002\nspin = " + sign + "3.0";
    };
    const Solved left(moved(motion(1), theory)), right(moved(motion(-1), theory));
    for (const DamageQuantity& q : damage_quantities())
      EXPECT_NEAR(left.damage(q), right.damage(q), 1e-5 * std::abs(left.damage(q))) << q.name;
    const auto one = row_sums(left.solution.elements, left.field("friction_work")),
               other = row_sums(right.solution.elements, right.field("friction_work"));
    const double largest = *std::max_element(one.begin(), one.end());
    for (std::size_t j = 0; j < one.size(); ++j) EXPECT_NEAR(one[j], other[one.size() - 1 - j], 1e-5 * largest);
  }
}

// What needs a strength that is not given is left out, and without [material] all of it.
TEST(ContactDamage, IsGivenWhereItsStrengthIs) {
  const auto document = [](const std::string& text) {
    const auto input = io::parse_case(text, "w.toml");
    return cases::case_document(input, cases::solve_case(input, {}, cases::ExactExtent::solution), {})["exact"];
  };
  const std::string text = moved("creepage_longitudinal = 0.004");
  const std::string hard = "hardness = \"2.7 GPa\" ", strong = "shear_yield_strength = \"300 MPa\" ";
  for (const bool is_hard : {false, true})
    for (const bool yields : {false, true}) {
      std::string given = text;
      if (!is_hard) given = with(given, hard, "# ");
      if (!yields) given = with(given, strong, "# ");
      const io::Json found = document(given);
      for (const auto* name : {"worn_area", "wear_depth"}) EXPECT_EQ(found.contains(name), is_hard) << name;
      for (const auto* name : {"fatigue_index", "shakedown_load"}) EXPECT_EQ(found.contains(name), yields) << name;
      for (const auto* name : {"t_gamma", "t_gamma_per_area", "worn_mass_r8t", "shakedown_limit"})
        EXPECT_TRUE(found.contains(name)) << name;
    }
  const std::string none = with(text, {{"\n[material] ", "\n# "}, {hard, "# "}, {strong, "# "}});
  for (const DamageQuantity& q : damage_quantities()) EXPECT_FALSE(document(none).contains(q.name)) << q.name;
  const auto input = io::parse_case(none, "w.toml");
  expect_words([&] { cases::CaseDamage(input, {}, {}); }, "[material]");
}

// Sweeps have the numbers as columns, where their case has [material].
TEST(ContactDamage, IsInSweeps) {
  const std::string text =
      "[grid]\nmaterial.hardness = [\"2 GPa\", \"4 GPa\"]\n" + in_sweep(with(moved("spin = 1.0"), "title", "# title"));
  const campaign::Sweep sweep(text, "s.toml");
  const auto column = [&](std::string_view path) {
    const auto& all = sweep.columns();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.path == path; });
    return static_cast<std::size_t>(found - all.begin());
  };
  const std::size_t worn = column("contact/worn_area"), t_gamma = column("contact/t_gamma_with_spin");
  ASSERT_LT(std::max(worn, t_gamma), sweep.columns().size());
  std::vector<double> soft(sweep.columns().size()), hard = soft;
  const auto worker = sweep.make_worker();
  EXPECT_EQ(worker(0, soft, {}) + worker(1, hard, {}), "");
  EXPECT_NEAR(soft[worn] / hard[worn], 2, 1e-12);
  EXPECT_EQ(soft[t_gamma], hard[t_gamma]);
  EXPECT_GT(soft[t_gamma], 0);
}

TEST(ContactDamage, IsRefusedOutOfRangeAndWithoutSteadyRolling) {
  const auto refused = [](const std::string& text, const std::string& words) {
    expect_words([&] { io::parse_case(text, "w.toml"); }, words);
  };
  refused(with(twin_disc, "\"2.7 GPa\"", "270.0"),
          "w.toml:18: material.hardness = 270 [Pa]: must be in [1e+05, 1e+12]");
  refused(with(twin_disc, "hardness = \"2.7", "hardnes = \"2.7"), "did you mean hardness?");
  const std::string shift =
      with(twin_disc, {{"creepage_longitudinal", "kind = \"shift\"\nshift_longitudinal"}, {"rolling_speed", "# "}});
  const std::string transient = with(twin_disc, "creepage_longitudinal", "kind = \"transient\"\ncreepage_longitudinal");
  for (const std::string& text : {shift, transient})
    refused(text, "[material]: wear and fatigue need motion.kind = \"steady\"");
}

} // namespace
} // namespace microslip
