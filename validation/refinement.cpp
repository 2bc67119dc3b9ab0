#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel = {82e9, 0.28, 0};
constexpr double a = 5e-3, b = 25e-3, normal_force = 1.3e-6 * steel.shear_modulus, friction = 0.3;
constexpr double creepage = 0.000857;
constexpr double scaled_per_creepage = 0.7 / creepage; ///< the paper's scaled creepage V_p of this one is 0.7
constexpr int margin = 3;

using Edge = std::optional<LeadingEdge>;
using Values = std::vector<double>;

const HertzContact& hertz() {
  static const HertzContact contact = hertz_from_ellipse(a, b, steel, normal_force);
  return contact;
}

constexpr std::array shapes = {ElementShape::constant, ElementShape::bilinear};

ElementGrid grid_of(int across, ElementShape shape) {
  ElementGrid grid = ElementGrid::across_ellipse(a, b, across, margin);
  grid.shape = shape;
  return grid;
}

HertzianSolve contact_on(int across, ElementShape shape = ElementShape::constant) {
  return HertzianSolve(steel, grid_of(across, shape), hertz().gap, normal_force);
}

/// Steady rolling, in steps of so many elements.
ContactSolution roll(HertzianSolve& contact, double xi, double step, const Edge& edge) {
  TangentialInput input;
  input.creepage.longitudinal = xi;
  input.step = step * contact.grid().dx;
  input.leading_edge = edge;
  ContactSolution s = contact.solve(friction, input);
  if (s.report.status != Status::ok) throw Error("the tangential problem does not converge");
  return s;
}

/// -Fx in units of mu Fn.
double force_of(const ContactSolution& s) {
  return -s.totals.fx / (friction * normal_force);
}

double order(double coarse, int coarse_elements, double fine, int fine_elements) {
  return std::log(std::abs(coarse / fine)) / std::log(double(fine_elements) / coarse_elements);
}

// --- Table 1, and the limit that all errors are measured from

constexpr std::array table_grids = {51, 101, 201, 401};
constexpr std::array paper_seconds = {12.0, 263.0, 6806.0, 163806.0};

struct Times {
  Values force, seconds;
  double limit = 0; ///< extrapolated from the last two
};

bool measure_times(Report& report, Times& times, const Progress& progress) {
  report.heading("Steady rolling with dq = dx, on one thread: times and the paper's Table 1 (one thread of 2.5 GHz)");
  report.line("across  elements   -Fx/(mu Fn)  steps  products    total [s]   paper [s]      ratio");
  for (std::size_t g = 0; g < table_grids.size(); ++g) {
    const auto start = std::chrono::steady_clock::now();
    HertzianSolve contact = contact_on(table_grids[g]);
    const ContactSolution s = roll(contact, creepage, 1, {});
    times.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    times.force.push_back(force_of(s));
    report.line(fmt::format("{:>6}  {:>8}  {:>12.5f}  {:>5}  {:>8}  {:>11.3f}  {:>10.0f}  {:>9.0f}", table_grids[g],
                            contact.normal().contact_elements, times.force[g], s.report.newton_steps, s.report.products,
                            times.seconds[g], paper_seconds[g], paper_seconds[g] / times.seconds[g]));
    if (progress && !progress(std::pow(10.0, double(g) - 3))) return false;
  }
  const Values& f = times.force;
  times.limit = limit(f[2], table_grids[2], f[3], table_grids[3]);
  report.figure("-Fx/(mu Fn) on the first grid", fmt::format("{:.4f}", f[0]), "0.71 to 0.725",
                f[0] >= 0.71 && f[0] <= 0.725);
  const double ratio = (f[0] - f[1]) / (f[1] - f[2]);
  report.figure("change from 51 to 101 over that from 101 to 201", fmt::format("{:.2f}", ratio), "2, order 1",
                ratio >= 1.5 && ratio <= 2.5);
  report.line(fmt::format("-Fx/(mu Fn) extrapolated from the last two: {:.4f}", times.limit));
  return true;
}

// --- Figure 1

struct Curve {
  Values scaled, exact, corrected, fastsim2;
};

bool find_curve(Report& report, Curve& curve, const Progress& progress) {
  constexpr int points = 25;
  HertzianSolve contact = contact_on(table_grids[0]);
  EllipticContact simplified;
  simplified.a = a;
  simplified.b = b;
  simplified.shear_modulus = steel.shear_modulus;
  simplified.poisson_ratio = steel.poisson_ratio;
  simplified.normal_force = normal_force;
  simplified.friction = FrictionLaw::coulomb(friction);
  Fastsim2 fastsim2({.mx = 50, .my = 50});
  for (int k = 0; k < points; ++k) {
    const double scaled = 2.4 * k / (points - 1), xi = scaled / scaled_per_creepage;
    simplified.creepage = {xi, 0, 0};
    curve.scaled.push_back(scaled);
    curve.exact.push_back(force_of(roll(contact, xi, 1, {})));
    curve.corrected.push_back(force_of(roll(contact, xi, 1, LeadingEdge{})));
    curve.fastsim2.push_back(-fastsim2.solve(simplified).fx / (friction * normal_force));
    if (progress && !progress((k + 1.0) / points)) return false;
  }
  const double printed = force_of(roll(contact, 10 * creepage, 1, {}));
  report.heading("Figure 1: creep curve on 51 elements across");
  report.figure("-Fx/(mu Fn) at the printed creepage 0.00857", fmt::format("{:.4f}", printed), "1: misprint",
                printed > 0.9999);
  return true;
}

// --- Figures 2 and 6

constexpr std::array step_grids = {25, 51, 101, 201};
constexpr std::array steps = {0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0};
constexpr std::size_t one_element = 2; ///< steps[one_element] is 1

/// -Fx/(mu Fn) by grid and step.
using StepTable = std::array<std::array<double, steps.size()>, step_grids.size()>;

bool find_step_table(StepTable& table, const Edge& edge, const Progress& progress) {
  for (std::size_t g = 0; g < step_grids.size(); ++g) {
    HertzianSolve contact = contact_on(step_grids[g]);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      table[g][k] = force_of(roll(contact, creepage, steps[k], edge));
      const double done = std::pow(8.0, double(g) - 3);
      if (progress && !progress(done * double(k + 1) / steps.size())) return false;
    }
  }
  return true;
}

double spread(const std::array<double, steps.size()>& row, std::size_t first) {
  const auto [least, most] = std::minmax_element(row.begin() + first, row.end());
  return *most - *least;
}

void report_steps(Report& report, const StepTable& plain, const StepTable& corrected, double exact) {
  for (const StepTable* table : {&plain, &corrected}) {
    report.heading(table == &plain ? "Figure 2: -Fx/(mu Fn) over dq/dx, without the leading edge's correction"
                                   : "Figure 6: the same with it, theta = 0.5");
    std::string head = "across";
    for (const double step : steps) head += fmt::format("  {:>6}", step);
    report.line(head);
    for (std::size_t g = 0; g < step_grids.size(); ++g) {
      std::string line = fmt::format("{:>6}", step_grids[g]);
      for (const double force : (*table)[g]) line += fmt::format("  {:.4f}", force);
      report.line(line);
    }
  }
  std::array<double, 5> limits{}; // for dq up to two elements
  for (std::size_t k = 0; k < limits.size(); ++k)
    limits[k] = limit(plain[2][k], step_grids[2], plain[3][k], step_grids[3]);
  const auto [least, most] = std::minmax_element(limits.begin(), limits.end());
  report.bounded("without: limits of dx = 0, dq = 0.5 to 2 dx, differ by", "{:.4f}", *most - *least, "<= 0.001");
  const double without = spread(plain[2], one_element), with = spread(corrected[2], one_element);
  report.figure("spread over dq = 1 to 5 dx on 101, with over without", fmt::format("{:.3f}", with / without), "<= 0.1",
                with <= 0.1 * without);
  const double less = 1 - std::abs((corrected[2][one_element] - exact) / (plain[2][one_element] - exact));
  report.figure("error less by the correction, dq = dx, on 101", fmt::format("{:.0f} %", 100 * less), "about 30 %",
                less >= 0.2 && less <= 0.5);
  const double p = order(corrected[0][one_element] - exact, 25, corrected[3][one_element] - exact, 201);
  report.near("order with the correction, 25 to 201", "{:.2f}", p, "1", 0.3);
}

// --- Figures 3 to 5

/// Along y = 0, and the states of all elements, for each of four cases.
struct Solution {
  std::string group;
  double step;
  Edge edge;
  Values px;                         ///< over mu p0
  std::vector<std::uint8_t> state{}; ///< as CellState
  int waves = 0, slip_ahead = 0;
};

struct Centreline {
  ElementGrid grid;
  Values bound; ///< over mu p0
  std::array<Solution, 4> solutions = {Solution{"plain_1", 1, {}, {}}, Solution{"plain_5", 5, {}, {}},
                                       Solution{"corrected_1", 1, LeadingEdge{}, {}},
                                       Solution{"corrected_5", 5, LeadingEdge{}, {}}};
};

/// Local maxima of the traction's magnitude along the row.
int count_maxima(const Values& px) {
  int maxima = 0;
  for (std::size_t i = 1; i + 1 < px.size(); ++i) maxima += px[i] < px[i - 1] && px[i] <= px[i + 1] && px[i] < 0;
  return maxima;
}

/// Elements of slip with adhesion behind them in their row.
int count_slip_ahead(const std::vector<CellState>& state, int mx) {
  int elements = 0;
  bool behind = false;
  for (std::size_t k = 0; k < state.size(); ++k) {
    if (k % mx == 0) behind = false;
    behind = behind || state[k] == CellState::adhesion;
    elements += state[k] == CellState::slip && behind;
  }
  return elements;
}

/// The shortest step, in elements, with waves along the middle row.
double first_step_with_waves(HertzianSolve& contact) {
  const int mx = contact.grid().mx, middle = contact.grid().my / 2;
  for (int tenths = 10; tenths <= 50; ++tenths) {
    const double step = 0.1 * tenths;
    const Values px = roll(contact, creepage, step, {}).fields.traction.x;
    const auto begin = px.begin() + std::ptrdiff_t(middle) * mx;
    if (count_maxima({begin, begin + mx}) > 1) return step;
  }
  return 0;
}

bool find_centreline(Report& report, Centreline& line, const Progress& progress) {
  HertzianSolve contact = contact_on(101);
  line.grid = contact.grid();
  const int mx = line.grid.mx, middle = line.grid.my / 2;
  const auto row = [&](const Values& field) {
    Values values(field.begin() + std::ptrdiff_t(middle) * mx, field.begin() + std::ptrdiff_t(middle + 1) * mx);
    for (double& v : values) v /= friction * hertz().peak_pressure;
    return values;
  };
  line.bound = row(contact.bound(friction));
  int done = 0;
  for (Solution& s : line.solutions) {
    const ContactSolution t = roll(contact, creepage, s.step, s.edge);
    s.px = row(t.fields.traction.x);
    s.waves = count_maxima(s.px);
    for (const CellState state : t.fields.state) s.state.push_back(static_cast<std::uint8_t>(state));
    s.slip_ahead = count_slip_ahead(t.fields.state, mx);
    if (progress && !progress(++done / 4.0)) return false;
  }
  const auto& s = line.solutions;
  report.heading("Figures 3 to 5: tractions along y = 0 and element divisions on 101 elements across");
  report.count("maxima of |px|: dq = dx", s[0].waves, 1);
  report.figure("  dq = 5 dx, waves", std::to_string(s[1].waves), ">= 3", s[1].waves >= 3);
  const double first = first_step_with_waves(contact);
  report.remark("  more than one from dq/dx on; by eye", fmt::format("{:.1f}", first), "about 1.9", "not judged");
  report.count("  dq = 5 dx with the correction, no waves", s[3].waves, 1);
  report.figure("slip ahead of adhesion, elements: with, without", std::to_string(s[2].slip_ahead),
                fmt::format("< {}", s[0].slip_ahead), s[2].slip_ahead < s[0].slip_ahead);
  return true;
}

// --- Figure 7

constexpr std::array load_grids = {6, 12, 25, 51, 101, 201};

/// Relative errors of Fn with the approach given.
struct LoadErrors {
  std::string group, name;
  ElementShape shape;
  bool shifted; ///< by half an element
  Values errors{};
};

std::vector<LoadErrors> load_variants() {
  return {{"tight", "constant, tight", ElementShape::constant, false},
          {"shifted", "constant, shifted", ElementShape::constant, true},
          {"bilinear_tight", "bilinear, tight", ElementShape::bilinear, false},
          {"bilinear_shifted", "bilinear, shifted", ElementShape::bilinear, true}};
}

double load_error(int across, const LoadErrors& v) {
  ElementGrid grid = grid_of(across, v.shape);
  if (v.shifted) grid.x0 += grid.dx / 2, grid.y0 += grid.dy / 2;
  const double load = NormalProblem(steel, grid)
                          .solve(hertzian_gap(hertz().gap, grid), {NormalLoad::Given::approach, hertz().approach})
                          .normal_force;
  return std::abs(load / normal_force - 1);
}

bool find_load_errors(Report& report, std::vector<LoadErrors>& variants, const Progress& progress) {
  for (LoadErrors& v : variants)
    for (const int across : load_grids) v.errors.push_back(load_error(across, v));
  if (progress && !progress(1)) return false;
  report.heading("Figure 7: errors of Fn, approach given, on tight grids and on ones shifted by half an element");
  std::string head = fmt::format("{:<18}", "across");
  for (const int across : load_grids) head += fmt::format("  {:>7}", across);
  report.line(head);
  for (const LoadErrors& v : variants) {
    std::string line = fmt::format("{:<18}", v.name);
    for (const double e : v.errors) line += fmt::format("  {:.1e}", e);
    report.line(line);
  }
  for (const LoadErrors& v : variants) {
    const double p = order(v.errors.front(), load_grids.front(), v.errors.back(), load_grids.back());
    if (v.shape == ElementShape::bilinear && v.shifted) // its error on the first grid is small by chance
      report.remark("order, " + v.name, fmt::format("{:.2f}", p), "2", "not judged");
    else
      report.near("order, " + v.name, "{:.2f}", p, "2", 0.35);
  }
  const double worse = variants[2].errors.back() / variants[0].errors.back();
  report.bounded("bilinear over constant, tight, 201", "{:.1f}", worse, "> 1");
  return true;
}

// --- Figure 8

constexpr std::array theta_grids = {13, 25, 51, 101, 201};

struct EdgeVariant {
  std::string group, name;
  ElementShape shape;
  Edge edge;
  Values force{};
};

/// The true edge for each row of a grid, where there is a row.
Values true_edge(const ElementGrid& grid) {
  Values edge(grid.my);
  for (int j = 0; j < grid.my; ++j) edge[j] = a * std::sqrt(std::max(0.0, 1 - std::pow(grid.y(j) / b, 2)));
  return edge;
}

std::vector<EdgeVariant> edge_variants() {
  std::vector<EdgeVariant> variants;
  for (const ElementShape shape : shapes) {
    const std::string prefix = shape == ElementShape::bilinear ? "bilinear_" : "";
    variants.push_back({prefix + "plain", "without", shape, {}});
    for (const double theta : {0.35, 0.5, 0.65, 0.8})
      variants.push_back({prefix + fmt::format("theta_{:.0f}", 100 * theta), fmt::format("theta = {:.2f}", theta),
                          shape, LeadingEdge{theta, {}}});
    variants.push_back({prefix + "true_edge", "true edge", shape, LeadingEdge{}});
  }
  return variants;
}

/// The same variant with the other shape.
const EdgeVariant& with_tents(const std::vector<EdgeVariant>& variants, const EdgeVariant& v) {
  return *std::find_if(variants.begin(), variants.end(),
                       [&](const EdgeVariant& other) { return other.group == "bilinear_" + v.group; });
}

bool find_theta(Report& report, std::vector<EdgeVariant>& variants, double exact, const Progress& progress) {
  for (std::size_t g = 0; g < theta_grids.size(); ++g)
    for (const ElementShape shape : shapes) {
      HertzianSolve contact = contact_on(theta_grids[g], shape);
      const Values edge = true_edge(contact.grid());
      for (EdgeVariant& v : variants) {
        if (v.shape != shape) continue;
        Edge used = v.edge;
        if (v.group.ends_with("true_edge")) used->true_edge = edge;
        v.force.push_back(force_of(roll(contact, creepage, 1, used)));
        if (progress && !progress(std::pow(8.0, double(g) - 4))) return false;
      }
    }
  for (const ElementShape shape : shapes) {
    report.heading(shape == ElementShape::constant
                       ? "Figure 8: errors of -Fx/(mu Fn) with dq = dx, and the order from 25 to 201"
                       : "Figure 8: the same with bilinear elements");
    std::string head = fmt::format("{:<14}", "across");
    for (const int across : theta_grids) head += fmt::format("  {:>8}", across);
    report.line(head);
    for (const EdgeVariant& v : variants) {
      if (v.shape != shape) continue;
      std::string line = fmt::format("{:<14}", v.name);
      for (const double force : v.force) line += fmt::format("  {:>+8.5f}", force - exact);
      const double p = order(v.force[1] - exact, theta_grids[1], v.force.back() - exact, theta_grids.back());
      report.line(line + fmt::format("  {:>6.2f}", p));
    }
  }
  double apart = 0, spread_by_theta = 0;
  for (const EdgeVariant& v : variants) {
    if (v.shape != ElementShape::constant) continue;
    apart = std::max(apart, std::abs(with_tents(variants, v).force.back() - v.force.back()));
    spread_by_theta = std::max(spread_by_theta, std::abs(v.force.back() - variants.front().force.back()));
  }
  report.figure("bilinear less constant, largest on 201, over what theta does",
                fmt::format("{:.2f}", apart / spread_by_theta), "comparable", apart <= 0.5 * spread_by_theta);
  return true;
}

// --- the result file

void write(const StudyOptions& options, const Times& times, const Curve& curve, const StepTable& plain,
           const StepTable& corrected, const Centreline& line, const std::vector<LoadErrors>& load,
           const std::vector<EdgeVariant>& variants) {
  io::create_folder(options.output);
  io::ResultFile file(options.output / "refinement.h5", {.kind = "refinement",
                                                         .title = "the test of the refinement paper",
                                                         .command_line = "microslip validate refinement"});
  const std::string force = "-Fx/(mu Fn)";
  const auto numbers = [&](const std::string& path, const auto& values, const std::string& what) {
    file.array(path, std::span<const double>(values.data(), values.size()), "-", what);
  };
  const auto counts = [&](const std::string& path, const auto& values) {
    file.array(path, std::span<const int>(values.data(), values.size()), "-", "elements across the ellipse");
  };
  file.scalar("limit", times.limit, "-", force + " extrapolated from the two finest grids");
  counts("times/grids", table_grids);
  numbers("times/force", times.force, force);
  file.array("times/seconds", times.seconds, "s", "wall time");
  numbers("creep_curve/scaled", curve.scaled, "scaled creepage, 0.7 at xi = 0.000857");
  numbers("creep_curve/plain", curve.exact, force);
  numbers("creep_curve/corrected", curve.corrected, force + " with the leading edge's correction");
  numbers("creep_curve/fastsim2", curve.fastsim2, force + " by FASTSIM2");
  counts("steps/grids", step_grids);
  numbers("steps/step", steps, "dq/dx");
  for (const auto& [name, table] : {std::pair{"plain", &plain}, std::pair{"corrected", &corrected}})
    file.array(std::string("steps/") + name,
               std::span<const double>(table->front().data(), step_grids.size() * steps.size()), "-", force,
               {step_grids.size(), steps.size()});
  Values x(line.grid.mx), y(line.grid.my);
  for (int i = 0; i < line.grid.mx; ++i) x[i] = line.grid.x(i);
  for (int j = 0; j < line.grid.my; ++j) y[j] = line.grid.y(j);
  file.array("fields/x", x, "m", "centres of the elements");
  file.array("fields/y", y, "m", "centres of the elements");
  numbers("fields/bound", line.bound, "g/(mu p0) along y = 0");
  for (const Solution& s : line.solutions) {
    numbers("fields/" + s.group + "/px", s.px, "px/(mu p0) along y = 0");
    file.array("fields/" + s.group + "/state", std::span<const std::uint8_t>(s.state), "-",
               "0 exterior, 1 adhesion, 2 slip", {y.size(), x.size()});
  }
  counts("load/grids", load_grids);
  for (const LoadErrors& v : load) numbers("load/" + v.group, v.errors, "relative error of Fn, elements: " + v.name);
  counts("edge/grids", theta_grids);
  for (const EdgeVariant& v : variants) {
    const char* const elements = v.shape == ElementShape::bilinear ? ", bilinear elements" : "";
    numbers("edge/" + v.group, v.force, force + ", " + v.name + elements);
  }
  file.commit();
}

} // namespace

bool run_refinement(const StudyOptions& options, std::ostream& out) {
  io::require_writable_folder(options.output);
  Report report(out, options.figures);
  report.line("a = 5 mm, a/b = 0.2, Fn/G = 1.3 mm2, mu = 0.3, nu = 0.28, longitudinal creepage 0.000857");
  const auto part = [&](double begin, double end) { return part_of(options.progress, begin, end); };
  Times times;
  Curve curve;
  StepTable plain{}, corrected{};
  Centreline line;
  std::vector<LoadErrors> load = load_variants();
  std::vector<EdgeVariant> variants = edge_variants();
  if (!measure_times(report, times, part(0, 0.15)) || !find_curve(report, curve, part(0.15, 0.2)) ||
      !find_step_table(plain, {}, part(0.2, 0.4)) || !find_step_table(corrected, LeadingEdge{}, part(0.4, 0.7)))
    return false;
  report_steps(report, plain, corrected, times.limit);
  if (!find_centreline(report, line, part(0.7, 0.75)) || !find_load_errors(report, load, part(0.75, 0.78)) ||
      !find_theta(report, variants, times.limit, part(0.78, 1)))
    return false;
  write(options, times, curve, plain, corrected, line, load, variants);
  return report.all_as_stated();
}

} // namespace microslip::validation
