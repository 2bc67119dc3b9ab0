#include "compat/contact/toml.hpp"

#include "compat/contact/fastsim.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/support.hpp"
#include "io/case_file.hpp"
#include "io/option_words.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw Error(why);
}

/// FaStrip in case files has Hertz's pressure, Coulomb's friction and no reduced slope.
bool is_plain(const Case& c) {
  const auto& data = c.material->model_data;
  return c.digits.bound == PressureModel::elliptic && c.friction.law == Law::coulomb && data[0] == 1 && data[1] == 1;
}

/// What no case file can say.
void check(const Case& c) {
  const Digits& d = c.digits;
  if (c.wheel_rail) refuse("MODULE = 1 (wheel on rail)");
  for (const std::string& reason : unsupported(c)) refuse(reason);
  if (d.is_simplified() && d.heat != Heat::none) refuse(written(d.heat) + " (temperatures with FASTSIM or FaStrip)");
  if (d.is_simplified() && d.mater != Bulk::fastsim && d.mater != Bulk::fastrip)
    refuse(written(d.mater) + " (a form of FASTSIM or FaStrip that case files do not have)");
  if (d.is_simplified() && d.is_fastrip() && !is_plain(c))
    refuse("M = 5 (FaStrip) with other than B = 2, L = 0, K0_MF = ALFAMF = 1");
  if (d.has_history() && (d.pvtime == Continuation::previous || d.pvtime == Continuation::repeated))
    refuse(written(d.pvtime) + " (it goes on from another case)");
  if (c.material->table) refuse("C = 9 (influence coefficients from a file)");
  if (c.material->coefficients == Coefficients::angle_corrected)
    refuse("C = 4 (influence coefficients corrected for angles)");
  if (c.extra != ExtraSlip::none) refuse(written(c.extra) + " (extra rigid slip)");
  if (d.rolls() && !rolls_along_x(c)) refuse("CHI (rolling at an angle to the x axis)");
  if (d.rolls() && !d.is_simplified() && contact_step(c).motion.leading_edge)
    refuse("DQ > DX (with the leading edge's correction of CONTACT)");
  if (d.varfrc == FrictionSets::by_row || c.friction.by_row) refuse("V = 3 (friction that differs from row to row)");
  if (d.bound != PressureModel::half_space && !d.is_simplified()) refuse(written(d.bound) + " (a given pressure)");
  const bool has_ellipse = d.bound == PressureModel::elliptic || d.bound == PressureModel::parabolic;
  if (d.is_simplified() && (d.tang != Tangential::steady || d.force != Prescribed::creepages || !has_ellipse))
    refuse("M = 3, 5 (FASTSIM, FaStrip) with other than T = 3, F = 0, B = 2 or 3");
  if (d.force != Prescribed::creepages && d.norm == Normal::approach)
    refuse("N = 0 with F > 0 (forces relative to a normal force that is not given)");
}

GapCurvatures curvatures(const Case& c) {
  const auto gap = gap_curvatures(c);
  if (!gap || !(gap->x > 0 && gap->y > 0)) refuse("a contact that is not an ellipse");
  return *gap;
}

/// Elements across the ellipse.
int across(double axis, double element) {
  return std::clamp(static_cast<int>(std::lround(2 * axis / element)), 1, most_field_cells);
}

/// A number that reads back as the same.
std::string number(double value) {
  const std::string text = std::isinf(value) ? "inf" : fmt::format("{}", value);
  return text.find_first_of(".ein") == std::string::npos ? text + ".0" : text;
}

std::string line(const char* key, double value) {
  return fmt::format("{} = {}\n", key, number(value));
}

std::string quoted_line(const char* key, std::string_view word) {
  return fmt::format("{} = \"{}\"\n", key, word);
}

/// Between the bodies.
std::string layer(const Case& c) {
  if (c.digits.mater != Bulk::layer) return "";
  const auto& v = c.material->model_data; // GG3, LAYTHK, TAU_C0, K_TAU
  std::string text = "\n[layer]\n" + line("shear_modulus", v[0]) + line("thickness", v[1]);
  if (v[2] > 0) text += line("yield_stress", v[2]);
  return text + line("hardening", v[3]);
}

/// What body 1 (0) or 2 (1) is for heat.
std::string thermal(const Case& c, std::size_t body) {
  const auto bodies = thermal_bodies(c);
  if (!bodies) return "";
  const ThermalBody& b = body == 0 ? bodies->body1 : bodies->body2;
  return line("bulk_temperature", b.bulk_temperature) + line("conductivity", b.conductivity) +
         line("density", b.density) + line("heat_capacity", b.heat_capacity);
}

/// The first body has all of the curvature, the second is flat.
std::string bodies(const Case& c, const GapCurvatures& gap) {
  const MaterialData& m = *c.material;
  const auto material = [&](std::size_t body, double shear, double poisson) {
    std::string text = line("shear_modulus", shear) + line("poisson_ratio", poisson) + thermal(c, body);
    if (c.digits.mater != Bulk::viscoelastic) return text; // else FG1, FG2, TC1, TC2
    return text + line("creep_ratio", m.model_data[body]) + line("creep_time", m.model_data[2 + body]);
  };
  return "[body1]\n" + line("rolling_radius", 1 / (2 * gap.x)) + line("transverse_radius", 1 / (2 * gap.y)) +
         material(0, m.shear1, m.poisson1) + "\n[body2]\nrolling_radius = inf\ntransverse_radius = inf\n" +
         material(1, m.shear2, m.poisson2) + layer(c);
}

const char* law_word(Law law) {
  return law == Law::linear ? "linear" : law == Law::rational ? "rational" : "exponential";
}

std::string friction(const Case& c) {
  const auto& set = c.friction.sets[0];
  if (!c.digits.has_friction()) return line("coefficient", 0);
  if (c.friction.law == Law::coulomb) return line("coefficient", set[0]);
  const std::string memory =
      c.digits.is_simplified() ? "" : line("memory_distance", set[set.size() - 2]) + line("memory_speed", set.back());
  if (c.friction.law == Law::thermal)
    return line("coefficient", set[0]) + line("thermal_change", set[2]) + line("thermal_begin", set[1]) +
           line("thermal_range", set[3]) + memory;
  std::string text = quoted_line("law", law_word(c.friction.law)) + line("kinetic_coefficient", set[0]) +
                     line("drop", set[1]) + line("half_velocity", set[2]);
  if (set[3] > 0) text += line("second_drop", set[3]) + line("second_half_velocity", set[4]);
  return text + memory;
}

std::string motion(const Case& c) {
  const ContactStep step = contact_step(c);
  const TangentialInput& m = step.motion;
  const bool shifts = c.digits.tang == Tangential::shift;
  const double force = step.load.value;
  std::string text = quoted_line("kind", io::to_word(m.motion));
  text += step.force_x ? line("force_longitudinal", *step.force_x * force)
                       : line(shifts ? "shift_longitudinal" : "creepage_longitudinal", m.creepage.longitudinal);
  text += step.force_y ? line("force_lateral", *step.force_y * force)
                       : line(shifts ? "shift_lateral" : "creepage_lateral", m.creepage.lateral);
  text += line(shifts ? "rotation" : "spin", m.creepage.spin);
  if (shifts) return text;
  text += line("rolling_speed", m.rolling_speed) + quoted_line("direction", io::to_word(m.direction));
  if (c.digits.rolls() && !c.digits.is_simplified()) text += line("step", m.step);
  return text;
}

std::string solution(const Case& c, const HertzContact& hertz) {
  const ElementGrid grid = contact_step(c).grid;
  const char* theory = !c.digits.is_simplified() ? "exact" : c.digits.is_fastrip() ? "fastrip" : "fastsim";
  std::string text = quoted_line("theory", theory) +
                     fmt::format("grid = [{}, {}]\n", across(hertz.a, grid.dx), across(hertz.b, grid.dy));
  const bool above = !c.digits.is_simplified() && contact_step(c).slip_start == SlipStart::above;
  if (above) text += quoted_line("slip_start", "above");
  if (!c.digits.is_simplified())
    return text + quoted_line("discretisation", "classical") + quoted_line("elements", io::to_word(grid.shape));
  const auto& data = c.material->model_data;
  text += quoted_line("bound", c.digits.bound == PressureModel::parabolic ? "parabolic" : "elliptic") +
          quoted_line("flexibility", "blended");
  if (data[0] == 1 && data[1] == 1) return text;
  return text + "\n[solution.slope_reduction]\n" + line("initial", data[0]) + line("at_infinity", data[1]) +
         line("decay", data[2]);
}

} // namespace

std::string to_toml(const Case& c, const std::string& title) {
  check(c);
  const GapCurvatures gap = curvatures(c);
  const bool by_force = c.load.given == NormalLoad::Given::force;
  const CombinedMaterial material = combined_material(c);
  const double load = c.load.value;
  const HertzContact hertz = by_force ? hertz_from_load(gap, material, load) : hertz_from_approach(gap, material, load);
  std::string text = "title = \"" + title + "\"\n\n" + bodies(c, gap) + "\n[load]\n" +
                     line(by_force ? "normal_force" : "approach", load) + "\n[friction]\n" + friction(c) +
                     "\n[motion]\n" + motion(c) + "\n[solution]\n" + solution(c, hertz);
  io::parse_case(text, "the case file"); // whatever else is out of the range of case files
  return text;
}

} // namespace microslip::contact_program
