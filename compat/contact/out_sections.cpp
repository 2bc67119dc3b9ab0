#include "compat/contact/out_sections.hpp"

#include "compat/contact/records.hpp"
#include "compat/contact/set_up.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

/// Names of a law's numbers; those of its memory are not printed.
std::string names_of(Law law) {
  constexpr const char* falling = "   FKIN        {0}1       SABSH1      {0}2       SABSH2\n";
  switch (law) {
  case Law::linear:
    return fmt::format(falling, "FLIN");
  case Law::rational:
    return fmt::format(falling, "FRAT");
  case Law::exponential:
    return fmt::format(falling, "FEXP");
  case Law::thermal:
    return "   FREF        TREF        DFHEAT      DTHEAT\n";
  default:
    return "   FSTAT       FKIN\n";
  }
}

std::string numbers_of(Law law, const std::vector<double>& set) {
  const std::size_t count = law == Law::coulomb ? 2 : law == Law::thermal ? 4 : 5;
  std::string text;
  const UnitList units = units_of_friction(law);
  for (std::size_t k = 0; k < count; ++k) text += general(set[k] / units[k].value(), 12, 4);
  return text + "\n";
}

/// Forces that are what the solver leaves.
double noise_level(const Case& c) {
  return 0.5 * c.solver.eps;
}

double limit_of(const Case& c, const Outcome& o) {
  return c.friction.by_row || o.step.friction.empty() ? 1 : o.step.friction[0].static_coefficient();
}

std::size_t element(const ElementGrid& grid, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.mx) + static_cast<std::size_t>(i);
}

/// The part of an axis that is drawn: what is in contact and one more on either side; all where that is nearly all.
struct Window {
  int first = 0, last = 0;

  int count() const { return last - first + 1; }
  static Window of(int low, int high, int count) {
    constexpr int near_border = 4, half_of_nothing = 5;
    if (low > high)
      return {std::max(0, count / 2 - half_of_nothing - 1), std::min(count, count / 2 + half_of_nothing) - 1};
    if (low <= near_border && high >= count - 1 - near_border) return {0, count - 1};
    return {std::max(0, low - 1), std::min(count - 1, high + 1)};
  }
};

struct Windows {
  Window x, y;

  explicit Windows(const Outcome& o) {
    const int mx = o.step.grid.mx, my = o.step.grid.my;
    int i0 = mx, i1 = -1, j0 = my, j1 = -1;
    for (int j = 0; j < my; ++j)
      for (int i = 0; i < mx; ++i) {
        if (element_state(o, element(o.step.grid, i, j)) == 0) continue;
        i0 = std::min(i0, i), i1 = std::max(i1, i);
        j0 = std::min(j0, j), j1 = std::max(j1, j);
      }
    x = Window::of(i0, i1, mx);
    y = Window::of(j0, j1, my);
  }
};

/// The numbers of columns below the picture: their last digits, tens and hundreds.
std::string column_numbers(const Window& window, const std::string& gap) {
  std::string text;
  for (const int unit : {100, 10, 1}) {
    if (window.count() < (unit == 100 ? 200 : unit)) continue;
    text += "        ";
    for (int i = window.first + 1; i <= window.last + 1; ++i)
      text += gap + (i % unit == 0 ? std::to_string(i / unit % 10) : " ");
    text += "\n";
  }
  return text;
}

/// The rigid slip [-], of a shift [mm], at an element.
struct RigidSlip {
  double x = 0, y = 0;

  RigidSlip(const Case& c, const Outcome& o, double at_x, double at_y, std::size_t k) {
    const bool shifts = c.digits.tang == Tangential::shift;
    const double unit = shifts ? per_m : 1;
    const Creepage& w = o.step.motion.creepage;
    const Creepage& found = o.solution.creepage;
    const double phi = shifts ? w.spin : w.spin / per_m;
    double ahead_x = 0, ahead_y = 0;
    if (!shifts) {
      const double way = c.rolling->facphi * o.step.motion.step * per_m;
      ahead_x = way * std::cos(c.rolling->chi), ahead_y = way * std::sin(c.rolling->chi);
    }
    const bool finds_x = o.step.force_x.has_value(), finds_y = o.step.force_y.has_value();
    const double eps = c.solver.eps;
    const double xi = finds_x ? without_noise(found.longitudinal, eps * std::abs(found.lateral)) : found.longitudinal;
    const double eta = finds_y ? without_noise(found.lateral, eps * std::abs(found.longitudinal)) : found.lateral;
    x = unit * xi - (c.extra == ExtraSlip::without_spin_x ? 0 : phi * (at_y + ahead_y));
    y = unit * eta + (c.extra == ExtraSlip::without_spin_y ? 0 : phi * (at_x + ahead_x));
    if (c.extra != ExtraSlip::by_element || o.step.extra_slip_x.empty()) return;
    x += unit * o.step.extra_slip_x[k];
    y += unit * o.step.extra_slip_y[k];
  }
};

std::string element_line(const Case& c, const Outcome& o, int i, int j) {
  const std::size_t k = element(o.step.grid, i, j);
  const double x = o.step.grid.x(i) * per_m, y = o.step.grid.y(j) * per_m;
  const SurfaceFields& f = o.solution.fields;
  const double pressure = f.pressure[k] * per_pa;
  const double distance = (o.step.gap.empty() ? 0 : o.step.gap[k] - o.solution.normal.approach) * per_m;
  const double px = o.step.frictionless ? 0 : f.traction.x[k] * per_pa;
  constexpr double rounding = 1e-10; // of the other component
  const double py = o.step.frictionless ? 0 : without_noise(f.traction.y[k] * per_pa, rounding * std::abs(px));
  const double argument = std::atan2(py, px) * 180 / std::numbers::pi;
  std::string line = " " + general(x, 12, 4);
  if (o.step.frictionless)
    return line + general({distance, pressure, std::hypot(px, py)}, 12, 4) + decimal(argument, 10, 1) + "\n";
  const double unit = c.digits.tang == Tangential::shift ? per_m : 1;
  line += general({distance, pressure, f.bound[k] * per_pa, std::hypot(px, py)}, 11, 3);
  line += decimal(argument, 10, 1) + "  ";
  const RigidSlip w(c, o, x, y, k);
  const bool slides = f.state[k] == CellState::slip;
  line += general({slides ? unit * std::hypot(f.slip.x[k], f.slip.y[k]) : 0, w.x, w.y}, 11, 3);
  if (o.has_temperatures()) line += general({f.temperature1[k], f.temperature2[k]}, 11, 4);
  return line + "\n";
}

std::string element_head(const Case& c, const Outcome& o) {
  std::string text = "\n QUANTITIES DISTRIBUTED OVER THE CONTACT AREA:\n"
                     " \"H-PEN\" IS THE UNDEFORMED DISTANCE WITH THE APPROACH TAKEN INTO ACCOUNT.\n"
                     " PN IS THE NORMAL PRESSURE, PT ";
  constexpr const char* table = "     X         H-PEN        PN      TRCBND    ABS(PT)     ARG(PT;-S)  ABS(S)      ";
  if (!c.digits.has_friction())
    return text + "IS THE TANGENTIAL TRACTION (2-VECTOR).\n"
                  " X, H AND PEN ARE IN MM, PN AND PT ARE IN N/MM^2, AND ARGUMENTS ARE IN DEGREES.\n\n"
                  "     X          H-PEN        PN       ABS(PT)        ARG(PT)\n";
  text += "THE TANGENTIAL TRACTION (2-VECTOR).\n";
  if (!c.digits.rolls())
    return text +
           " S IS THE SLIP DISTANCE PER STEP, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION.\n"
           " RIGID SHIFT(X, Y) ARE THE (X, Y) COMPONENTS OF THE RIGID SHIFT DISTANCE W.\n"
           " X, H, PEN, S AND W ARE IN MM, PN AND PT ARE IN N/MM^2, AND ARGUMENTS ARE IN DEGREES.\n\n\n" +
           table + "RIGID SHIFT(X, Y)\n";
  text += " S IS THE RELATIVE SLIP VELOCITY, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION.\n"
          " RIGID SLIP(X, Y) ARE THE (X, Y) COMPONENTS OF THE RELATIVE RIGID SLIP VELOCITY W.\n"
          " X, H AND PEN ARE IN MM, PN AND PT ARE IN N/MM^2, S AND W ARE DIMENSIONLESS, ARGUMENT IS IN DEGREES.\n\n";
  return text + table + "RIGID SLIP(X, Y)" + (o.has_temperatures() ? "        TEMP1      TEMP2\n" : "\n");
}

} // namespace

std::string out_outer_iteration(const Case& c) {
  if (c.solver.maxout == 1) return " JOHNSON\"S METHOD IS USED FOR THE FRICTIONAL STRESS\n";
  return fmt::format(" PANAGIOTOPOULOS\" METHOD IS USED FOR THE FRICTIONAL STRESS. MAXOUT={:3}\n", c.solver.maxout);
}

std::string out_damping(const Case& c) {
  if (c.digits.damping != Damping::read) return "";
  const auto& [normal, tangential, normal_limit, tangential_limit] = *c.damping;
  return "    CDAMPN      CDAMPT       DFNMAX      DFTMAX\n  " +
         significant({normal, tangential, normal_limit, tangential_limit}) + "\n";
}

std::string out_heat(const Case& c) {
  if (c.digits.heat == Heat::none) return "";
  std::string text = "     BKTEMP      HEATCP      LAMBDA      DENSITY\n";
  for (const auto& body : {c.heat->body1, c.heat->body2}) {
    const auto b = in_file({body.begin(), body.end()}, units_of_heat);
    text += columns({b[0], b[1], b[2], b[3]});
  }
  return text;
}

std::string out_viscoelastic(const Case& c, const char* bodies) {
  if (c.digits.mater != Bulk::viscoelastic) return "";
  const MaterialData& m = *c.material;
  const auto& v = m.model_data; // FG1, FG2, TC1, TC2
  const CombinedMaterial relaxed = combine({m.shear1 / (1 + v[0]), m.poisson1}, {m.shear2 / (1 + v[1]), m.poisson2});
  const double speed = c.rolling ? c.rolling->veloc * per_m : 0;
  // Without time to creep bodies are relaxed from the start; else CONTACT prints what they begin with.
  const CombinedMaterial quick = combine({m.shear1, m.poisson1}, {m.shear2, m.poisson2});
  const CombinedMaterial& shown = v[2] == 0 && v[3] == 0 ? relaxed : quick;
  const auto heading = [&](const char* name) {
    return fmt::format("   {0}({1})       {0}({2})    ", name, bodies[0], bodies[1]);
  };
  return " VISCOELASTIC MATERIAL CONSTANTS\n     NUV         GV          AKV\n" +
         columns({shown.poisson_ratio, shown.shear_modulus * per_pa, shown.dissimilarity}) + "\n  " + heading("FG") +
         heading("TC") + heading("VT") + "\n  " + general({v[0], v[1]}, 12, 4) +
         significant({v[2], v[3], speed * v[2], speed * v[3]}) + "\n";
}

std::string out_layer(const Case& c) {
  if (c.digits.mater != Bulk::layer) return "";
  const auto v = in_file(c.material->model_data, units_of_model(Bulk::layer)); // GG3, LAYTHK, TAU_C0, K_TAU
  return " INTERFACIAL LAYER PARAMETERS\n     GG3         LAYTHK      TAU_C0      K_TAU\n" +
         columns({v[0], v[1], v[2], v[3]});
}

std::string out_friction(const Case& c, const char* station) {
  const FrictionData& f = c.friction;
  std::string text = " FRICTION LAW PARAMETERS\n  ";
  if (!f.by_row && f.stations.empty()) return text + names_of(f.law) + "  " + numbers_of(f.law, f.sets[0]);
  text += (f.by_row ? "    IY      " : fmt::format("   {:<9}", station)) + names_of(f.law);
  constexpr int all_rows = 4;
  const bool along = c.wheel_rail && c.wheel_rail->digits.varfrc == FrictionStations::along_track;
  const double unit_of_station = along ? mm : 1;
  const std::size_t count = f.sets.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_inside = f.by_row && !prints(c, all_rows) && k > 1 && k + 2 < count;
    if (is_inside && k == 2) text += "                      ...\n";
    if (is_inside) continue;
    text += f.by_row ? fmt::format("  {:8}    ", k + 1) : "  " + general(f.stations[k] / unit_of_station, 12, 4);
    text += numbers_of(f.law, f.sets[k]);
  }
  return text;
}

const char* simplified_name(Bulk model) {
  return model == Bulk::fastsim_one || model == Bulk::fastsim ? "FASTSIM" : "FASTRIP";
}

std::string out_flexibilities(const Outcome& outcome) {
  if (!outcome.springs) return "";
  const auto& [l, k] = *outcome.springs;
  return " SIMPLIFIED THEORY MATERIAL CONSTANTS\n     FLX1        FLX2        FLX3\n" + columns({l[0], l[1], l[2]});
}

std::string out_totals(const Case& c, const Outcome& o, bool is_patch) {
  const PrintedTotals& t = o.totals;
  const double noise = noise_level(c), limit = limit_of(c, o) * t.fn;
  const char* across = is_patch ? "S" : "Y";
  const bool is_curved = is_patch && t.integral_fn; // then the forces are sums in the axes of the reference
  std::string text = is_curved
                         ? "     BAR_FN      BAR_FX      BAR_FS      MN         ELAST.EN.   FRIC.POWER\n"
                         : fmt::format("     FN          FX          F{}          M{}         ELAST.EN.   FRIC.{}\n",
                                       across, is_patch ? "N" : "Z", is_patch || c.digits.rolls() ? "POWER" : "WORK");
  const double least_moment = is_patch ? 0 : noise * limit;
  constexpr double rounding = 1e-12; // where nothing slides, of what would be lost if all did
  const double speed = c.digits.rolls() ? c.rolling->veloc : 0;
  const double least_power = rounding * (limit * speed + std::abs(t.elastic_energy));
  text += "  " +
          significant({t.fn, without_noise(t.fx, noise * limit), without_noise(t.fy, noise * limit),
                       without_noise(t.mz, least_moment), t.elastic_energy, without_noise(t.friction, least_power)}) +
          "\n";
  std::string x_name = t.x_name, y_name = t.y_name;
  if (is_patch) y_name.replace(y_name.find('Y'), 1, "S");
  const auto name = [](std::string label) {
    if (label.ends_with(" X") || label.ends_with(" Y")) label.insert(0, " ");
    if (label.ends_with("/FN") && label.size() < 8) label.insert(0, "  ");
    label.resize(12, ' ');
    return label;
  };
  text += (is_curved ? "     TILDE_FN  " : "     FN/G      ") + name(x_name) + (is_patch ? "" : " ") + name(y_name) +
          (is_patch ? "  " : " ") + "APPROACH     PMAX    " + (t.temperature ? "  MAX(T1,T2)\n" : "\n");
  const bool by_force = o.step.force_x.has_value(), both = o.step.force_y.has_value();
  const double x = without_noise(t.x, by_force ? std::abs(t.y) * c.solver.eps * both : noise);
  const double y = without_noise(t.y, both ? std::abs(t.x) * c.solver.eps : noise);
  text += "  " + significant({is_curved ? *t.integral_fn : t.fn_over_g, x, y}) + significant(t.approach, 12, 6, 4) +
          significant(t.peak_pressure);
  if (t.temperature) text += significant(*t.temperature);
  return text + "\n";
}

std::string out_statistics(const Outcome& o, bool is_patch) {
  const PrintedTotals& t = o.totals;
  std::vector<int> counts = {t.potential, t.contact, t.adhesion, t.slip};
  if (t.plastic) counts.push_back(*t.plastic);
  const int rounds = std::max(1, o.solution.alternations);
  const bool is_given = o.step.given && o.step.given->displacement.empty();
  counts.insert(counts.end(), {is_given ? 0 : rounds, o.step.frictionless ? 0 : rounds});
  std::string text = std::string("\n CONTACT STATISTICS\n"
                                 " N: NUMBER OF ELEMENTS IN REGION,  I: NUMBER OF ITERATIONS,\n"
                                 " POT: POTENTIAL CONTACT AREA,  CON: CONTACT,  ADH: ADHESION\n"
                                 "    NPOT   NCON   NADH  NSLIP") +
                     (t.plastic ? "  NPLAST" : " ") + " INORM  ITANG\n" + (is_patch ? "" : " ");
  for (const int count : counts) fmt::format_to(std::back_inserter(text), "{:7}", count);
  return text + "\n";
}

std::string out_form(const Case& c, const Outcome& outcome) {
  constexpr char letters[] = {'.', '*', 'S', '|'};
  constexpr int most_with_gaps = 45;
  const auto& [x, y] = Windows(outcome);
  const std::string gap = x.count() <= most_with_gaps ? " " : "";
  std::string text = "\n FORM OF THE CONTACT, ADHESION AND SLIP-AREA`S:\n";
  for (int j = y.last; j >= y.first; --j) {
    fmt::format_to(std::back_inserter(text), "{:6}  ", j + 1);
    for (int i = x.first; i <= x.last; ++i) {
      const int state = element_state(outcome, element(outcome.step.grid, i, j));
      const bool is_corner = (i == x.first || i == x.last) && (j == y.first || j == y.last);
      text += gap;
      text += state == 0 && is_corner ? 'o' : letters[state];
    }
    text += "\n";
  }
  text += column_numbers(x, gap) + "     X  -->";
  if (c.digits.rolls()) text += "        Chi=" + decimal(c.rolling->chi * 180 / std::numbers::pi, 6, 2) + " degrees";
  return text + "\n";
}

std::string out_elements(const Case& c, const Outcome& outcome) {
  constexpr int all = 6;
  constexpr double rounding = 1e-12; // [mm], of the middle row
  const ElementGrid& grid = outcome.step.grid;
  std::string text = element_head(c, outcome);
  for (int j = 0; j < grid.my; ++j) {
    bool is_first = true;
    for (int i = 0; i < grid.mx; ++i) {
      if (!prints(c, all) && element_state(outcome, element(grid, i, j)) == 0) continue;
      if (is_first)
        text += fmt::format("\n Y = {} ROW{:3} OF THE POTENTIAL CONTACT\n\n",
                            general(without_noise(grid.y(j) * per_m, rounding), 12, 4), j + 1);
      is_first = false;
      text += element_line(c, outcome, i, j);
    }
  }
  return text;
}

std::string out_interior(const Case& c, const Outcome& outcome) {
  constexpr int all_points = 4;
  static const std::map<std::string, const char*> names = {
      {"sigma_hyd", "ABSMAX SIGHYD"}, {"von_mises", "MAX     SIGVM"}, {"tresca", "MAX     SIGTR"},
      {"sigma_1", "MAX    SIGMA1"},   {"sigma_3", "MIN    SIGMA3"},   {"sigma_xx", "ABSMAX  SIGXX"},
      {"sigma_yy", "ABSMAX  SIGYY"},  {"sigma_zz", "ABSMAX  SIGZZ"}};
  if (c.interior_level < 1) return "";
  const auto coordinate = [](double metres) { return decimal(without_noise(metres * per_m, 1e-9), 8, 3); };
  std::string text;
  int block = 0;
  for (const auto& [points, states] : outcome.interior) {
    text += fmt::format("\n SUBSURFACE STRESSES BLOCK{:3}:\n \n", ++block);
    for (const auto& [name, value, at] : interior_extremes(states))
      text += fmt::format(" {} ={} AT (X,Y,Z) = ({},{},{})\n", names.at(name), decimal(value * per_pa, 10, 3),
                          coordinate(points.x_of(at)), coordinate(points.y_of(at)), coordinate(points.z_of(at)));
    if (c.interior_level < all_points) continue;
    text += " \n";
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto& [ux, uy, uz, s] = states[k];
      const double table[3][4] = {{ux, s.xx, s.xy, s.xz}, {uy, s.xy, s.yy, s.yz}, {uz, s.xz, s.yz, s.zz}};
      text += " Position (X,Y,Z):" +
              general({points.x_of(k) * per_m, points.y_of(k) * per_m, points.z_of(k) * per_m}, 12, 4);
      text += "\n I,Displacement(I); Stress(I,J),J = 1,3\n";
      for (int i = 0; i < 3; ++i)
        text += fmt::format("{:3}  {}; {}\n", i + 1, general(table[i][0] * per_m, 12, 4),
                            general({table[i][1] * per_pa, table[i][2] * per_pa, table[i][3] * per_pa}, 12, 4));
      text += "  SigHyd = " + general(hydrostatic(s) * per_pa, 12, 4) +
              ", SigVM = " + general(von_mises(s) * per_pa, 12, 4) + "\n\n";
    }
  }
  return text;
}

} // namespace microslip::contact_program
