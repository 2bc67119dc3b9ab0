#include "compat/contact/out.hpp"

#include "compat/contact/fortran.hpp"
#include "compat/contact/out_sections.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/wheel_rail/out_wheel.hpp"
#include "microslip/version.hpp"

#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

/// A line that names digits and their values.
std::string digit_line(std::string text, std::initializer_list<std::pair<const char*, int>> digits) {
  const char* separator = "";
  for (const auto& [name, value] : digits) {
    text += fmt::format("{}{:<6}{:2}", separator, name, value);
    separator = ", ";
  }
  return text + "\n";
}

std::string digits_text(const Digits& d) {
  const auto n = [](auto digit) { return number(digit); };
  std::string text = " \n";
  text += digit_line("  PBTNFS.            ", {{"PVTIME", n(d.pvtime)},
                                               {"BOUND", n(d.bound)},
                                               {"TANG", n(d.tang)},
                                               {"NORM", n(d.norm)},
                                               {"FORCE", n(d.force)},
                                               {"STRESS", n(d.stress)}});
  const bool varies = d.varfrc != FrictionSets::one;
  text += digit_line(varies ? fmt::format(" VLDCMZE.  VARFRC{:2}, ", n(d.varfrc)) : "  LDCMZE.            ",
                     {{"FRCLAW", n(d.frclaw)},
                      {"DISCNS", n(d.discns)},
                      {"INFLCF", n(d.inflcf)},
                      {"MATER", n(d.mater)},
                      {"RZNORM", n(d.rznorm)},
                      {"RZTANG", n(d.exrhs)}});
  return text + digit_line(" HGIAOWR.  ", {{"HEAT", n(d.heat)},
                                           {"GAUSEI", n(d.gausei)},
                                           {"IESTIM", n(d.iestim)},
                                           {"MATFIL", n(d.matfil)},
                                           {"OUTPUT", n(d.output)},
                                           {"FLOW", n(d.flow)},
                                           {"RETURN", n(d.solve)}});
}

std::string normal_problem(const Digits& d) {
  const std::string given = d.norm == Normal::force ? "NORMAL FORCE" : "APPROACH";
  const auto solved = [&](const char* how) {
    return " NORMAL PROBLEM WITH PRESCRIBED " + given + ", " + how + " SOLUTION\n";
  };
  switch (d.bound) {
  case PressureModel::half_space:
    return solved("FULL");
  case PressureModel::kik_piotrowski:
    return solved("APPROXIMATE KPEC");
  case PressureModel::analyn:
    return solved("APPROXIMATE ANALYN");
  case PressureModel::elliptic:
    return " NORMAL PROBLEM SKIPPED, ELLIPTICAL TRACTION BOUND\n";
  case PressureModel::parabolic:
    return " NORMAL PROBLEM SKIPPED, PARABOLICAL TRACTION BOUND\n";
  case PressureModel::half_ellipses:
    return " NORMAL PROBLEM SKIPPED, SDEC TRACTION BOUND\n";
  default:
    return "";
  }
}

std::string tangential_problem(const Case& c) {
  const Digits& d = c.digits;
  if (!d.has_friction()) return "";
  constexpr const char* motions[] = {"", " SHIFT TRANSIENT\n", " TRANSIENT ROLLING\n", " STEADY STATE ROLLING\n"};
  constexpr const char* given[] = {" CREEPAGE PRESCRIBED\n", " X-FORCE,  Y-CREEPAGE PRESCRIBED\n",
                                   " TANGENTIAL FORCE PRESCRIBED\n"};
  std::string text = motions[number(d.tang)];
  if (d.is_simplified()) text = fmt::format(" STEADY STATE ROLLING,  \"{} APPROACH\"\n", simplified_name(d.mater));
  return text + given[number(d.force)] + out_outer_iteration(c);
}

/// Hertz's solution, and what the grid follows from.
std::string hertzian_geometry(const Case& c, const Outcome& o) {
  const auto shape = hertzian_shape(c, o.step);
  if (!shape || c.digits.discns == GridSource::keep) return "";
  const PotentialContact& p = *c.potential;
  const bool halves = p.kind == Potential::half_ellipses;
  const double a = shape->a * per_m, b = shape->b * per_m, a1 = shape->gap.x / per_m, b1 = shape->gap.y / per_m;
  std::string text = fmt::format("\n {} GEOMETRY WITH PRESCRIBED {}\n",
                                 halves        ? "SDEC"
                                 : p.is_line() ? "2D HERTZIAN"
                                               : "3D HERTZIAN",
                                 c.digits.norm == Normal::force ? "NORMAL FORCE" : "APPROACH");
  const auto line = [&](std::string name, std::initializer_list<double> values) {
    name.resize(43, ' ');
    text += name + general(values, 12, 4) + "\n";
  };
  auto v = p.values;
  for (std::size_t k = 0; k < v.size(); ++k) v[k] /= unit_of_hertz(p.kind, k).value();
  switch (p.kind) {
  case Potential::curvatures:
    line(" CURVATURE PRESCRIBED, A1,B1: ", {v[0], v[1]});
    break;
  case Potential::curvature_and_ratio:
    line(" CURVATURE AND ELLIPTIC. PRESCRB, A1,AA/BB:", {v[0], v[1]});
    break;
  case Potential::line_curvature:
    line(" CURVATURE PRESCRIBED, A1,BB: ", {v[0], v[1]});
    break;
  case Potential::half_ellipses:
    line(" SEMIAXES PRESCRIBED, AA,BNEG,BPOS:", {v[0], v[1], v[2]});
    break;
  default:
    line(" SEMIAXES PRESCRIBED, AA,BB:  ", {v[0], v[1]});
  }
  if (!halves && p.kind != Potential::curvatures) line(" THE CURVATURES A1,B1 ARE:    ", {a1, b1});
  if (!halves && p.kind != Potential::semi_axes) line(" BASIC SEMIAXES AA,BB, RATIO  ", {a, b, a / b});
  const double radius = p.is_line() ? std::sqrt(4 * a * b / std::numbers::pi) : std::sqrt(a * b);
  if (!halves) line(" EFFECTIVE RAD.CURV RHO, SEMI-AXIS CP", {2 / (a1 + b1), radius});
  const ElementGrid& g = o.step.grid;
  line(" POTENTIAL CONTACT, SCALE:    ", {(g.x0 - g.dx / 2) * per_m, (g.y0 - g.dy / 2) * per_m, p.scale});
  text += fmt::format(" DISCRETISATION MX,MY, DX,DY:              {:6}{:6}", g.mx, g.my);
  return text + general({g.dx * per_m, g.dy * per_m}, 12, 4) + "\n";
}

std::string material(const Case& c, const Outcome& o) {
  if (!c.digits.reads_material()) return "";
  const MaterialData& m = *c.material;
  const CombinedMaterial combined = combined_material(c);
  std::string text =
      "\n MATERIAL CONSTANTS\n     NU          G           AK          EPS\n" +
      columns({combined.poisson_ratio, combined.shear_modulus * per_pa, combined.dissimilarity, c.solver.eps}) +
      "\n    POISS(1)    POISS(2)     GG(1)       GG(2)\n" +
      columns({m.poisson1, m.poisson2, m.shear1 * per_pa, m.shear2 * per_pa});
  const auto add = [&](const std::string& section) {
    if (!section.empty()) text += "\n" + section;
  };
  add(out_damping(c));
  add(out_heat(c));
  add(out_viscoelastic(c, "12"));
  const auto& v = m.model_data;
  if (c.digits.mater == Bulk::fastsim_one)
    add(" SIMPLIFIED THEORY MATERIAL CONSTANTS\n     FLX\n" + columns({v[0] / mm3_per_newton}));
  else
    add(out_flexibilities(o));
  if (o.springs && v.size() >= 3)
    add(fmt::format(" MODIFIED {} SLOPE REDUCTION PARAMETERS\n     K0_MF       ALFAMF      BETAMF      K_EFF\n",
                    simplified_name(c.digits.mater)) +
        columns({v[v.size() - 3], v[v.size() - 2], v[v.size() - 1], o.springs->slope}));
  add(out_layer(c));
  return text;
}

std::string kinematics(const Case& c, const Outcome& o) {
  const Digits& d = c.digits;
  const bool rolls = d.rolls();
  const std::string unit = c.friction.by_row ? "/FN      " : "/FSTAT/FN";
  const bool x_given = d.force != Prescribed::creepages, y_given = d.force == Prescribed::force_x_and_y;
  std::string text = "\n KINEMATIC CONSTANTS\n  ";
  text += rolls ? "   CHI         DQ          VELOC    " : "   DT          VELOC    ";
  text += x_given ? " FX" + unit : "   CKSI     ";
  text += y_given ? " FY" + unit : "   CETA     ";
  text += "   CPHI\n  ";
  text += rolls ? general({c.rolling->chi, o.step.motion.step * per_m}, 12, 4) + significant(c.rolling->veloc * per_m)
                : decimal(1, 8, 3) + "    " + significant(1);
  text += significant({in_file(c.x, d), in_file(c.y, d), c.phi / unit_of_spin(d)}) + "\n\n";
  if (c.spin_x != 0 || c.spin_y != 0)
    text += "     SPINXO      SPINYO\n" + columns({c.spin_x * per_m, c.spin_y * per_m}) + "\n";
  return text;
}

std::string sensitivities(const Case& c, const Outcome& o) {
  const Sensitivities table = o.sensitivities.value_or(Sensitivities{});
  if (!c.digits.has_friction())
    return "\n THE SENSITIVITIES.\n A ZERO MEANS THAT IT HAS NOT BEEN CALCULATED.\n  DFN/DPEN\n" +
           significant(table[0][0], 12, 3, 3) + "\n";
  std::string text = std::string("\n THE SENSITIVITIES. (FX,FY) MEANS: (FX,FY)/") +
                     (c.friction.by_row ? "FN.     " : "FN/FSTAT.") +
                     "\n A ZERO ENTRY MEANS THAT IT HAS NOT BEEN CALCULATED.\n"
                     "         DF/DPEN     DF/DKSI     DF/DETA     DF/DPHI\n";
  constexpr const char* forces[] = {"FN", "FX", "FY"};
  for (std::size_t k = 0; k < std::size(forces); ++k) {
    text += fmt::format("   {} ", forces[k]);
    for (const double slope : table[k]) text += significant(slope, 12, 3, 3);
    text += "\n";
  }
  return text;
}

std::string contact_text(const Case& c, const Outcome& o) {
  std::string text;
  if (prints(c, 2)) {
    text += digits_text(c.digits) + normal_problem(c.digits) + tangential_problem(c) + hertzian_geometry(c, o) +
            material(c, o);
    if (c.digits.frclaw != Law::keep) text += "\n" + out_friction(c, "");
    text += kinematics(c, o) + " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n";
  }
  if (prints(c, 1)) text += out_totals(c, o, false);
  if (prints(c, 2)) text += sensitivities(c, o) + out_statistics(o, false);
  if (prints(c, 3)) text += out_form(c, o);
  if (prints(c, 5)) text += out_elements(c, o);
  return text + out_interior(c, o);
}

} // namespace

std::string out_head() {
  const auto row = [](const std::string& text) { return fmt::format("   |{:<70}|\n", text); };
  const std::string rule = "   " + std::string(72, '-') + "\n";
  return rule + row("  microslip - detailed investigation of 3D frictional contact problems") +
         row(fmt::format("  Version: {} ({})", build_info().version, build_info().commit)) +
         row("  in the layout of CONTACT, revision 2707") + rule;
}

std::string out_text(const Case& c, const Outcome& outcome) {
  std::string text = fmt::format("\n Case{:6}", c.number_in_element);
  if (c.names_element) text += fmt::format(", result element{:4}", c.sequence.first);
  return text + "\n" + out_results(c, outcome);
}

std::string out_results(const Case& c, const Outcome& outcome) {
  // What reads these files looks for the word with a capital letter.
  if (outcome.kind == Outcome::Kind::skipped) return " Not run: " + written(c.digits.solve) + "\n";
  std::string text;
  for (const auto& reason : outcome.reasons) text += " ERROR: not run: " + reason + "\n";
  if (outcome.kind == Outcome::Kind::refused) return text;
  for (const auto& note : outcome.notes) text += " NOTE: " + note + "\n";
  if (outcome.solution.report.status != Status::ok)
    text += " ERROR: " + std::string(to_string(outcome.solution.report.status)) + "\n";
  return text + (outcome.wheel ? out_wheel(c, outcome) : contact_text(c, outcome));
}

std::string out_end() {
  return "\n The program ended succesfully.\n";
}

} // namespace microslip::contact_program
