// Thresholds of profile reading and contact search are those that the documentation has beside CONTACT's.

#include "compat/contact/units.hpp"
#include "compat/contact/wheel_rail/profile_thresholds.hpp"
#include "compat/contact/wheel_rail/records.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "paths.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

using P = ProfileThresholds;
using S = SearchThresholds;

/// By the table's rules, but for those that are not in the headers.
const std::map<std::string, double> thresholds = {
    {"doubled points: distance from the last kept point, in the file's unit", P::spacing},
    {"least `point.dist.min` of a Simpack file, which replaces 1e-4", P::least_spacing},
    {"ZIGTHRS not given", P::zigzag},
    {"ZIGTHRS at least", P::least_zigzag},
    {"SCALE that counts as 1, at most", P::no_scale},
    {"z of a wheel: least z in the outer points, share", P::ends_of_wheel},
    {"z of a rail: outer points, share", P::ends_of_rail},
    {"z of a rail: change over the whole height that counts", P::change_of_rail},
    {"z of a rail: least height", P::least_height},
    {"length of the polygon at least", P::shortest},
    {"length of the polygon at most", P::longest},
    {"KINKHIGH not given", P::kink_high},
    {"KINKHIGH over KINKLOW not given", P::kink_ratio},
    {"KINKWID not given", P::kink_width},
    {"weight of the ends, ISMOOTH = 1, times", P::weight_of_ends},
    {"weight of kinks, times", P::weight_of_kinks},
    {"greatest spacing of samples across a slice", P::slice_spacing},
    {"step across the track over the locus, times DS", S::locus_step},
    {"locus jumps: turn with x at a tenth", S::jump_turn},
    {"locus jumps: side longer than", S::jump_length / mm},
    {"brute force, step along the track, times DX", S::step_along},
    {"brute force, the same of a wheel that is not round", S::step_along_varied},
    {"brute force, step across, times DS", S::step_across},
    {"brute force, the same with D = 6", S::step_across_steep},
    {"brute force, reach along the track, times the wheel's radius", S::reach},
    {"brute force, the same with D = 6 and of small wheels", S::reach_steep},
    {"brute force, small wheels: radius below", S::small_radius / mm},
    {"brute force, reach around a wheel that is not round, rad", S::reach_varied},
    {"minima: gaps of one plateau differ by less than", S::plateau / mm},
    {"least weight in the means of x, y and angle", S::least_weight / (mm * mm * mm)},
    {"wheel's radius at most", WheelsetDimensions::greatest_radius / mm},
    {"points across the track over the locus at most", S::most_on_line},
    {"points of brute force at most", S::most_on_grid},
    {"rows of brute force at least", S::least_rows},
    {"depth of the wheel in the rail, times its radius", S::deepest},
    {"weight with which parts act on each other, exponent", S::blending},
    {"element sizes are doubled until there are less than NPOT_MAX, from which on", S::least_limit},
    {"elements of a patch whose sizes are not doubled (T = 1, 2) at most", S::most_elements},
    {"element sizes are not doubled along sides of at most", S::few_elements},
    {"plane off vertical by at least, rad", S::off_vertical},
    {"D = 4: extent beyond the overlap, times its own", S::curved_share},
    {"D = 4: spare elements on either side", S::curved_spare},
    {"D = 4: elements beyond the last in the overlap", S::curved_beyond},
    {"D = 4: surfaces face each other, length of the mean normal above", S::facing},
    {"solutions at most", S::most_solutions},
    {"first height: Hertz's solution with a curvature across the track of at least, 1/mm", S::least_curvature / per_mm},
};

struct Row {
  std::string contact, ours, why;
};

std::string trimmed(const std::string& cell) {
  const auto first = cell.find_first_not_of(' ');
  return first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1);
}

std::map<std::string, Row> rows_of_the_page() {
  std::ifstream page(MICROSLIP_SOURCE_DIR "/docs/contact-thresholds.md");
  std::map<std::string, Row> rows;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| ")) continue;
    std::stringstream text(line.substr(1));
    std::vector<std::string> cells;
    for (std::string cell; std::getline(text, cell, '|');) cells.push_back(trimmed(cell));
    if (cells.size() == 4) rows[cells[0]] = {cells[1], cells[2], cells[3]};
  }
  return rows;
}

double number_of(const std::string& cell) {
  const double value = std::stod(cell);
  return cell.ends_with("°") ? value * std::numbers::pi / 180 : value;
}

TEST(Thresholds, AreThoseOfTheDocumentation) {
  const auto rows = rows_of_the_page();
  for (const auto& [rule, value] : thresholds) {
    const auto found = rows.find(rule);
    ASSERT_NE(found, rows.end()) << rule;
    EXPECT_NEAR(number_of(found->second.ours), value, 1e-12 * value) << rule;
  }
}

/// A row that says "equal" has the same number in both columns, or none.
TEST(Thresholds, ThatAreCalledEqualAreEqual) {
  const auto has_number = [](const std::string& cell) { return cell.find_first_of("0123456789") == 0; };
  for (const auto& [rule, row] : rows_of_the_page()) {
    if (!row.why.starts_with("equal") || !has_number(row.contact) || !has_number(row.ours)) continue;
    EXPECT_EQ(number_of(row.contact), number_of(row.ours)) << rule;
  }
}

} // namespace
} // namespace microslip::contact_program
