#include "compat/contact/wheel_rail/out_wheel.hpp"

#include "compat/contact/fortran.hpp"
#include "compat/contact/out_sections.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/wheel_rail/left_wheel.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

constexpr double least = 1e-13; ///< deviations below it [m], [rad] are none, and not printed

std::string digits_text(const Case& c) {
  const Digits& d = c.digits;
  const WheelRailDigits& own = c.wheel_rail->digits;
  const auto n = [](auto digit) { return number(digit); };
  return fmt::format(" CPBTNFS.  CONFIG{:2}, PVTIME{:2}, BOUND {:2}, TANG  {:2}, NORM  {:2}, FORCE {:2}, STRESS{:2}\n"
                     " VLDCMZE.  VARFRC{:2}, FRCLAW{:2}, DISCNS{:2}, INFLCF{:2}, MATER {:2}, ZTRACK{:2}, EWHEEL{:2}\n"
                     " HGIAOWR.  HEAT  {:2}, GAUSEI{:2}, IESTIM{:2}, MATFIL{:2}, OUTPUT{:2}, FLOW  {:2}, RETURN{:2}\n",
                     n(own.config), n(d.pvtime), n(d.bound), n(d.tang), n(d.norm), n(own.force), n(d.stress),
                     n(own.varfrc), n(d.frclaw), n(own.discns), n(d.inflcf), n(d.mater), n(own.ztrack), n(own.ewheel),
                     n(d.heat), n(d.gausei), n(d.iestim), n(d.matfil), n(d.output), n(d.flow), n(d.solve));
}

std::string problems(const Case& c) {
  const Digits& d = c.digits;
  const char* solution = d.bound == PressureModel::kik_piotrowski ? "APPROXIMATE KPEC"
                         : d.bound == PressureModel::analyn       ? "APPROXIMATE ANALYN"
                                                                  : "FULL";
  std::string text = fmt::format(" VERTICAL PROBLEM WITH PRESCRIBED {}, {} SOLUTION\n",
                                 d.norm == Normal::force ? "VERTICAL FORCE" : "POSITION", solution);
  if (!d.has_friction()) return text;
  constexpr const char* motions[] = {"", "SHIFT TRANSIENT", "TRANSIENT ROLLING", "STEADY STATE ROLLING"};
  const bool by_force = c.wheel_rail->digits.force == TotalForce::force_x;
  const char* given = by_force ? "X-FORCE" : d.tang == Tangential::shift ? "SHIFT" : "CREEPAGE";
  const std::string motion = d.is_simplified()
                                 ? fmt::format("STEADY STATE ROLLING, \"{} APPROACH\"", simplified_name(d.mater))
                                 : motions[number(d.tang)];
  return text + fmt::format(" {}, {} PRESCRIBED\n", motion, given) + out_outer_iteration(c);
}

std::string material(const Case& c) {
  if (!c.digits.reads_material()) return "";
  const MaterialData& m = *c.material;
  const CombinedMaterial combined = combined_material(c);
  std::string text = "\n MATERIAL CONSTANTS\n     NU          G           AK          EPS\n  " +
                     general(combined.poisson_ratio, 12, 4) + significant(combined.shear_modulus * per_pa) +
                     general(combined.dissimilarity, 12, 4) + significant(c.solver.eps) +
                     "\n\n    POISS(R)    POISS(W)     GG(R)       GG(W)\n  " +
                     general({m.poisson1, m.poisson2}, 12, 4) + significant({m.shear1 * per_pa, m.shear2 * per_pa}) +
                     "\n";
  const auto add = [&](const std::string& section) {
    if (!section.empty()) text += "\n" + section;
  };
  add(out_damping(c));
  add(out_heat(c));
  add(out_viscoelastic(c, "RW"));
  if (!c.digits.has_friction()) return text;
  const auto& v = m.model_data;
  if (c.digits.mater == Bulk::fastsim_one)
    add(" SIMPLIFIED THEORY MATERIAL CONSTANTS\n     FLX\n" + columns({v[0] / mm3_per_newton}));
  if (c.digits.is_simplified() && v.size() >= 3)
    add(fmt::format(" MODIFIED {} SLOPE REDUCTION PARAMETERS\n     K0_MF       ALFAMF      BETAMF\n",
                    simplified_name(c.digits.mater)) +
        columns({v[v.size() - 3], v[v.size() - 2], v[v.size() - 1]}));
  add(out_layer(c));
  return text;
}

std::string discretisation(const Case& c) {
  const WheelRailData& d = *c.wheel_rail;
  if (!d.digits.reads_grid()) return "";
  const PatchRules& g = d.grid;
  const bool turns = std::abs(g.d_turn - (2 * g.d_sep - g.d_comb)) > 1e-9;
  std::string text =
      "\n DISCRETISATION PARAMETERS\n     DX          DS          DQREL       A_SEP       D_SEP       D_COMB";
  text += turns ? "      D_TURN\n  " : "\n  ";
  text += general({g.dx / mm, g.ds / mm, g.dqrel, g.a_sep, g.d_sep / mm, g.d_comb / mm}, 12, 4);
  return text + (turns ? general(g.d_turn / mm, 12, 4) : "") + "\n";
}

std::string profile(const Case& c, const char* body, const ProfileRecord& p) {
  std::string text = fmt::format("\n {} PROFILE \"{}\"\n   MIRRORY     MIRRORZ     ISMOOTH      {}\n", body, p.name,
                                 p.smoothing == 0 ? "LAMBDA" : "L_FILT");
  text += fmt::format("{:7}{:12}{:12}   {}\n", p.mirror_y, p.mirror_z, p.smoothing, decimal(p.smooth, 12, 4));
  if (!prints(c, 3)) return text;
  return text + "\n   ZIGTHRS     KINKHIG     KINKLOW      KINKWID     MAXOMIT\n" +
         columns({p.zigzag, p.kink_high, p.kink_low, p.kink_width, p.most_omitted});
}

bool any_of(std::initializer_list<double> values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::abs(value) > least; });
}

std::string track(const Case& c, const WheelOutcome& wheel) {
  const WheelRailData& d = *c.wheel_rail;
  const TrackDimensions& t = d.track;
  std::string text;
  if (d.digits.ztrack == TrackSource::all) text += profile(c, d.digits.is_roller() ? "ROLLER" : "RAIL", d.rail);
  if (d.digits.reads_dimensions()) {
    text += "\n TRACK DIMENSIONS AND RAIL POSITION\n    GAUGHT      ";
    text += t.by_gauge() ? "GAUGWD        " : "RAILY0      RAILZ0        ";
    text += "CANT        CURV\n" + decimal(t.gauge_height / mm, 10, 3);
    text += t.by_gauge() ? decimal(t.gauge_width / mm, 12, 3)
                         : decimal(t.rail_y0 / mm, 12, 4) + decimal(t.rail_z0 / mm, 12, 4);
    text += decimal(t.cant, 12, 4) + significant(t.curvature / per_mm) +
            "\n"; // of rollers too, where NOMRADR is not printed
  }
  const RailPosition& p = d.rail_position;
  if (any_of({p.dy, p.dz, p.roll, p.vy, p.vz, p.vroll}))
    text += "\n RAIL IRREGULARITY\n     DYRAIL      DZRAIL      DROLLR      VYRAIL      VZRAIL      VROLLR\n  " +
            decimal(p.dy / mm, 12, 4) + decimal(p.dz / mm, 12, 4) + decimal(p.roll, 12, 4) +
            significant({p.vy / mm, p.vz / mm, p.vroll}) + "\n";
  if (d.digits.force != TotalForce::rail_deflection) return text;
  const RailSupport& s = d.support;
  return text +
         "\n MASSLESS RAIL DEFLECTION\n     KY_RAIL     DY_DEFL     FY_RAIL     KZ_RAIL     DZ_DEFL     FZ_RAIL\n  " +
         decimal(s.ky / per_mm, 12, 4) + decimal(wheel.dy_rail / mm, 12, 4) + significant(s.fy) +
         decimal(s.kz / per_mm, 12, 4) + decimal(wheel.dz_rail / mm, 12, 4) + significant(s.fz) + "\n";
}

std::string wheelset(const Case& c, const WheelOutcome& wheel) {
  const WheelRailData& d = *c.wheel_rail;
  const WheelsetPosition& p = d.position;
  const WheelsetVelocity& v = d.velocity;
  std::string text;
  const bool has_profile = number(d.digits.ewheel) >= number(WheelsetSource::all);
  if (has_profile) text += profile(c, "WHEEL", d.wheel);
  if (d.digits.ewheel == WheelsetSource::keep) return text + "\n";
  text += fmt::format(
      "\n WHEEL-SET POSITION AND VELOCITY\n     {}_WS        Y_WS        Z_WS        ROLL_WS     YAW_WS      "
      "PITCH_WS\n  ",
      d.digits.is_roller() ? 'X' : 'S');
  text += significant({p.s / mm, p.y / mm}) + decimal(wheel.z / mm, 12, 4) + significant({p.roll, p.yaw, p.pitch}) +
          "\n\n  ";
  text += d.digits.is_roller() ? "  VPITCH_ROL" : "   VX_WS    ";
  text += "   VY_WS       VZ_WS       VROLL_WS    VYAW_WS     VPITCH_WS\n  ";
  text += d.digits.is_roller() ? decimal(v.vs, 12, 7) : significant(v.vs / mm);
  text += significant({v.vy / mm, v.vz / mm, v.vroll, v.vyaw}) + decimal(wheel.vpitch, 12, 7) + "\n\n";
  const WheelDeflection& f = d.deflection;
  if (any_of({f.dx, f.dy, f.dz, f.droll, f.dyaw, f.dpitch, f.vx, f.vy, f.vz, f.vroll, f.vyaw, f.vpitch}))
    text +=
        " FLEXIBLE WHEEL-SET DEVIATIONS\n     DXWHL       DYWHL       DZWHL       DROLLW      DYAWW       DPITCHW\n  " +
        significant({f.dx / mm, f.dy / mm, f.dz / mm, f.droll, f.dyaw, f.dpitch}) +
        "\n     VXWHL       VYWHL       VZWHL       VROLLW      VYAWW       VPITCHW\n  " +
        significant({f.vx / mm, f.vy / mm, f.vz / mm, f.vroll, f.vyaw, f.vpitch}) + "\n\n";
  return text;
}

std::string total_forces(const Case& c, const WheelOutcome& wheel) {
  const char* body = c.wheel_rail->digits.is_roller() ? "ROLLER" : "RAIL";
  std::string text;
  if (wheel.patches.empty()) text += " ----- NO CONTACT FOUND FOR THIS WHEEL / WHEEL-SET -----\n";
  const bool moments = prints(c, 4);
  if (prints(c, 2)) text += fmt::format(" \n TOTAL FORCES{}ON {}\n", moments ? " AND MOMENTS " : " ", body);
  const auto row = [](const Vec3<double>& a, const Vec3<double>& b) {
    return significant({a.x, a.y, a.z, b.x, b.y, b.z}) + "\n";
  };
  text += "     FX(TR)      FY(TR)      FZ(TR)      FX(WS)      FY(WS)      FZ(WS)\n" +
          row(wheel.track.force, wheel.wheelset.force);
  if (moments)
    text += "\n     MX@R(TR)    MY@R(TR)    MZ@R(TR)    MX@W(WS)    MY@W(WS)    MZ@W(WS)\n" +
            row(per_m * wheel.track.moment, per_m * wheel.wheelset.moment);
  return text;
}

std::string location(const PatchLocation& l) {
  std::string text =
      "\n CONTACT REFERENCE LOCATION\n     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)\n";
  for (const double value : {l.track.x / mm, l.track.y / mm, l.track.z / mm, l.angle, l.rail.y / mm, l.rail.z / mm})
    text += decimal(value, 12, 4);
  text += "\n\n     XCP(W)      YCP(W)      ZCP(W)\n";
  for (const double value : {l.wheel.x, l.wheel.y, l.wheel.z}) text += decimal(value / mm, 12, 4);
  return text + "\n\n";
}

std::string kinematics(const Case& patch, const Outcome& o, bool is_left) {
  const bool shifts = patch.digits.tang == Tangential::shift;
  const double dq = shifts ? 1 : o.step.motion.step * per_m;
  std::string text = " KINEMATIC CONSTANTS\n     CHI         DQ          VELOC       CKSI        CETA        CPHI\n  " +
                     general({(is_left ? -1 : 1) * patch.rolling->chi, dq}, 12, 4) +
                     significant({patch.rolling->veloc / mm, in_file(patch.x, patch.digits),
                                  in_file(patch.y, patch.digits), patch.phi / unit_of_spin(patch.digits)}) +
                     "\n\n";
  const double spin_y = (is_left ? -1 : 1) * patch.spin_y;
  if (any_of({patch.spin_x, patch.spin_y}))
    text += "     SPINXO      SPINYO\n" + columns({patch.spin_x / mm, spin_y / mm}) + "\n";
  return text;
}

/// Patches of the case before that this one goes on from.
std::string origin(const Case& c, const WheelPatch& patch) {
  if (c.digits.pvtime == Continuation::nothing) return "";
  if (patch.previous.empty()) return " (NEW PATCH)";
  std::string text = " (PREV";
  const char* separator = "";
  for (const int number : patch.previous) {
    text += fmt::format("{}{:3}", separator, number);
    separator = ",";
  }
  return text + ")";
}

std::string patch_text(const Case& c, const WheelPatch& patch, int number) {
  const Outcome& o = *patch.solution;
  const WheelRailDigits& own = c.wheel_rail->digits;
  const bool slides = c.digits.has_friction(), left = own.is_left();
  std::string text;
  if (prints(c, 1)) text += fmt::format("\n ----- DATA FOR CONTACT PATCH{:3}{} -----\n", number, origin(c, patch));
  if (prints(c, 2)) {
    text += location(patch.location);
    if (slides && own.varfrc != FrictionStations::one) text += out_friction(patch.contact, "") + "\n";
    if (o.springs) {
      text += c.digits.mater == Bulk::fastsim_one ? "" : out_flexibilities(o) + "\n";
      text += fmt::format(" MODIFIED {} SLOPE REDUCTION PARAMETERS\n     K0_EFF\n", simplified_name(c.digits.mater)) +
              columns({o.springs->slope}) + "\n";
    }
    if (slides) text += kinematics(patch.contact, o, left);
    text += " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n";
  }
  if (prints(c, 1)) text += out_totals(patch.contact, o, true);
  if (prints(c, 2)) text += out_statistics(o, true);
  const Outcome& drawn = left ? mirrored(o) : o; // CONTACT has the elements of the mirror image
  if (prints(c, 3)) text += out_form(patch.contact, drawn);
  if (prints(c, 5)) text += "\n" + out_elements(patch.contact, drawn);
  return text + out_interior(patch.contact, o);
}

} // namespace

std::string out_wheel(const Case& c, const Outcome& outcome) {
  const WheelOutcome& wheel = *outcome.wheel;
  const WheelRailDigits& own = c.wheel_rail->digits;
  std::string text;
  if (prints(c, 2)) {
    text += fmt::format("\n WHEEL-{} CONTACT, {} WHEEL,{:3} CONTACT {}\n\n", own.is_roller() ? "ROLLER" : "RAIL",
                        own.is_left() ? "LEFT" : "RIGHT", wheel.patches.size(),
                        wheel.patches.size() == 1 ? "PATCH" : "PATCHES");
    text += digits_text(c) + problems(c) + material(c);
    if (c.digits.has_friction() && c.digits.frclaw != Law::keep)
      text += "\n" + out_friction(c, own.varfrc == FrictionStations::along_track ? "SVF" : "ALPHA");
    text += discretisation(c) + track(c, wheel) + wheelset(c, wheel);
  }
  if (prints(c, 1)) text += total_forces(c, wheel);
  int number = 0;
  for (const WheelPatch& patch : wheel.patches) text += patch_text(c, patch, ++number);
  return text;
}

} // namespace microslip::contact_program
