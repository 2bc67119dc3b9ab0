#include "validation/studies.hpp"

#include "io/creep_table_file.hpp"
#include "io/profile_file.hpp"
#include "microslip/exact/fitted/contact_edges.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/rows/row_look_up.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_coordinates.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel{82e9, 0.28, 0};
constexpr double friction = 0.3, speed = 2;

/// A patch about the centre of its load.
struct Patch {
  ElementGrid grid;
  std::vector<double> pressure;
  double load = 0;
  std::vector<LoadedRow> rows;
  double a = 0, b = 0; ///< of the ellipse with the load's inertia across and the rows' squared half-lengths
  double skewness = 0, kurtosis = 0; ///< of the load across: 0 and 15/7 for an ellipse

  double c() const { return std::sqrt(a * b); }
  bool is_elliptic() const { return std::abs(skewness) < 0.2 && std::abs(kurtosis - 15.0 / 7) < 0.2; }
};

std::vector<LoadedRow> rows_of(const ElementGrid& grid, const std::vector<double>& pressure) {
  std::vector<LoadedRow> rows;
  for (const ContactRun& run : contact_runs(grid, pressure)) {
    LoadedRow row{.y = grid.y(run.row),
                  .width = grid.dy,
                  .centre = (run.low + run.high) / 2,
                  .half_length = (run.high - run.low) / 2,
                  .friction = friction};
    for (int i = run.first; i <= run.last; ++i)
      row.load += pressure[std::size_t(run.row) * grid.mx + i] * grid.element_area();
    row.joined = !rows.empty() && row.y - rows.back().y < 1.5 * grid.dy;
    rows.push_back(row);
  }
  return rows;
}

Patch patch_of(ElementGrid grid, const std::vector<double>& pressure) {
  Patch patch{.grid = grid, .pressure = pressure, .rows = {}};
  double x = 0, y = 0;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const double force = pressure[k] * grid.element_area();
    patch.load += force;
    x += force * grid.x(int(k % std::size_t(grid.mx))), y += force * grid.y(int(k / std::size_t(grid.mx)));
  }
  patch.grid.x0 -= x / patch.load, patch.grid.y0 -= y / patch.load;
  patch.rows = rows_of(patch.grid, pressure);
  std::array<double, 5> moments{};
  double squares = 0;
  for (const LoadedRow& row : patch.rows) {
    for (int n = 0; n < 5; ++n) moments[std::size_t(n)] += row.load / patch.load * std::pow(row.y, n);
    squares += row.width * row.half_length * row.half_length;
  }
  patch.b = std::sqrt(5 * moments[2]), patch.a = std::sqrt(0.75 * squares / patch.b);
  patch.skewness = moments[3] / std::pow(moments[2], 1.5), patch.kurtosis = moments[4] / (moments[2] * moments[2]);
  return patch;
}

/// The simple double-elliptical contact: two halves of ellipses with the semi-axis a along x, of the widths (1 - psi) b
/// and (1 + psi) b.
struct DoubleEllipse {
  double psi = 0, a = 1, b = 1;

  double left() const { return (1 + psi) * b; }
  double right() const { return (1 - psi) * b; }
  /// The load's moment about the common axis, of order n; a row has it in proportion to its squared length.
  double moment(int n) const {
    constexpr std::array half = {2.0 / 3, 1.0 / 4, 2.0 / 15, 1.0 / 12}; // integrals of t^n (1 - t^2) over 0 to 1
    return half[std::size_t(n)] * (std::pow(right(), n + 1) + (n % 2 == 0 ? 1 : -1) * std::pow(left(), n + 1));
  }
  double centre() const { return moment(1) / moment(0); }
  double variance() const { return moment(2) / moment(0) - centre() * centre(); }
  double skewness() const {
    const double c = centre();
    return (moment(3) / moment(0) - 3 * c * moment(2) / moment(0) + 2 * c * c * c) / std::pow(variance(), 1.5);
  }
  double half_length(double y) const {
    const double t = y > 0 ? y / right() : y / left();
    return a * std::sqrt(std::max(0.0, 1 - t * t));
  }
};

/// That with the load's skewness and inertia across and the squared half-lengths of a patch.
DoubleEllipse double_ellipse_of(const Patch& patch) {
  double low = -0.95, high = 0.95;
  DoubleEllipse shape;
  for (int k = 0; k < 50; ++k) {
    shape.psi = (low + high) / 2;
    (shape.skewness() > patch.skewness ? low : high) = shape.psi;
  }
  shape.b = std::sqrt(patch.b * patch.b / 5 / shape.variance());
  shape.a = patch.a * std::sqrt(patch.b / shape.b);
  return shape;
}

/// The pressure on elements, semi-elliptic along each row.
Patch patch_of(const DoubleEllipse& shape, double load, int elements) {
  constexpr int margin = 4;
  const double dx = 2 * shape.a / elements, dy = 2 * shape.b / elements;
  const int half = elements / 2 + margin;
  const ElementGrid grid{
      .mx = 2 * half + 1, .my = elements, .x0 = -half * dx, .y0 = -shape.left() + dy / 2, .dx = dx, .dy = dy};
  const auto integral = [](double t) {
    t = std::clamp(t, -1.0, 1.0);
    return t * std::sqrt(1 - t * t) + std::asin(t);
  };
  std::vector<double> pressure;
  for (int j = 0; j < grid.my; ++j) {
    const double length = shape.half_length(grid.y(j));
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i);
      pressure.push_back(length * length * (integral((x + dx / 2) / length) - integral((x - dx / 2) / length)));
    }
  }
  const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.element_area();
  for (double& p : pressure) p *= load / sum;
  return patch_of(grid, pressure);
}

using Forces = std::array<double, 3>; ///< over mu Fn, the moment over mu Fn c as well

/// The exact theory on a patch.
class Exactly {
public:
  explicit Exactly(const Patch& patch) : load_(patch.load), rolling_(steel, patch.grid, pressed(patch)) {}

  std::optional<Forces> operator()(const Creepage& creepage, double c) {
    PatchRollingMotion motion;
    motion.friction = friction, motion.creepage = creepage;
    const ContactSolution s = rolling_.solve(motion);
    if (s.report.status != Status::ok) return {};
    const double capacity = friction * load_;
    return Forces{s.totals.fx / capacity, s.totals.fy / capacity, s.totals.mz / (capacity * c)};
  }

private:
  static NormalSolution pressed(const Patch& patch) {
    NormalSolution normal;
    normal.pressure = patch.pressure, normal.normal_force = patch.load;
    normal.gap.assign(patch.pressure.size(), 0), normal.displacement = normal.gap;
    normal.contact_elements =
        int(std::count_if(patch.pressure.begin(), patch.pressure.end(), [](double p) { return p > 0; }));
    return normal;
  }

  double load_;
  PatchRolling rolling_;
};

/// Random creepages as of the study of the table: the direction and t, from no slip to nearly full sliding, uniform.
Creepage random_creepage(const Patch& patch, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const double ratio = patch.a / patch.b, t = 0.98 * uniform(random);
  const double x = normal(random), y = normal(random), z = normal(random);
  const double r = creep_coordinates::half_way * t / (1 - t) / std::sqrt(x * x + y * y + z * z);
  const creep_coordinates::LinearTheory linear(
      creepage_coefficients(ratio, steel.poisson_ratio, CreepageTable::computed), creep_coordinates::spin_scale(ratio));
  const double g = steel.shear_modulus * patch.a * patch.b / (friction * patch.load);
  return {x * r / (g * linear.x), y * r / (g * linear.y), z * r / (g * linear.z * patch.c())};
}

/// Sums of squares and extremes of the errors of one method for the forces.
struct Errors {
  const char* name;
  Forces squares = {}, worst = {};
  long count = 0;

  void add(const Forces& found, const Forces& wanted) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(found[k] - wanted[k]);
      squares[k] += error * error, worst[k] = std::max(worst[k], error);
    }
    ++count;
  }
  double rms(std::size_t k) const { return std::sqrt(squares[k] / double(count)); }
  double force_rms() const { return std::hypot(rms(0), rms(1)); }
};

struct Comparison {
  std::size_t patches = 0, unsolved = 0;
  std::array<Errors, 5> errors = {Errors{"theory table: ellipse and strips"}, Errors{"ellipse by moments, the table's"},
                                  Errors{"ellipse by area and extent"}, Errors{"exact theory on SDEC's shape"},
                                  Errors{"FASTSIM2 on the rows"}};

  void add(const Patch& patch, const CreepForceTable& table, const std::shared_ptr<const CreepForceTable>& shared,
           int elements, std::mt19937_64& random);
  void print(Report& report, const std::string& heading) const;
};

/// Of rows, about the origin.
Forces total(const std::vector<LoadedRow>& rows, const std::vector<RowForces>& forces, double capacity, double c) {
  Forces sum{};
  for (std::size_t k = 0; k < rows.size(); ++k)
    sum[0] += forces[k].fx, sum[1] += forces[k].fy, sum[2] += forces[k].mz - rows[k].y * forces[k].fx;
  return {sum[0] / capacity, sum[1] / capacity, sum[2] / (capacity * c)};
}

void Comparison::add(const Patch& patch, const CreepForceTable& table,
                     const std::shared_ptr<const CreepForceTable>& shared, int elements, std::mt19937_64& random) {
  constexpr int creepages = 12;
  const double capacity = friction * patch.load, c = patch.c();
  Exactly exact(patch), double_elliptic(patch_of(double_ellipse_of(patch), patch.load, elements));
  const auto look_up = [&](double a, double b, const Creepage& creepage) {
    const ContactForces f = table.solve({.a = a,
                                         .b = b,
                                         .shear_modulus = steel.shear_modulus,
                                         .poisson_ratio = steel.poisson_ratio,
                                         .normal_force = patch.load,
                                         .friction = FrictionLaw::coulomb(friction),
                                         .creepage = creepage});
    return Forces{f.fx / capacity, f.fy / capacity, f.mz / (capacity * c)};
  };
  double area = 0, longest = 0;
  for (const LoadedRow& row : patch.rows)
    area += 2 * row.width * row.half_length, longest = std::max(longest, row.half_length);
  const double width = (patch.rows.back().y - patch.rows.front().y + patch.grid.dy) / 2,
               scale = std::sqrt(area / (std::numbers::pi * longest * width));
  RowLookUp by_rows(shared, patch.rows.size());
  LoadedRowSolver fastsim2(10, int(patch.rows.size()));
  ++patches;
  for (int k = 0; k < creepages; ++k) {
    const Creepage w = random_creepage(patch, random);
    const auto wanted = exact(w, c), other = double_elliptic(w, c);
    if (!wanted || !other) {
      ++unsolved;
      continue;
    }
    std::vector<LoadedRow> rows = patch.rows;
    for (LoadedRow& row : rows) row.creepage = {w.longitudinal - w.spin * row.y, w.lateral, w.spin};
    std::vector<RowForces> forces(rows.size());
    by_rows.solve(steel, rows, 1, forces);
    errors[0].add(total(rows, forces, capacity, c), *wanted);
    errors[1].add(look_up(patch.a, patch.b, w), *wanted);
    errors[2].add(look_up(scale * longest, scale * width, w), *wanted);
    errors[3].add(*other, *wanted);
    fastsim2.solve(steel.shear_modulus, steel.poisson_ratio, rows, forces);
    errors[4].add(total(rows, forces, capacity, c), *wanted);
  }
}

void Comparison::print(Report& report, const std::string& heading) const {
  if (patches == 0) return;
  report.heading(fmt::format("{}: {} patches, {} creepages", heading, patches, errors[0].count));
  report.line("                                       rms Fx       Fy       Mz     worst Fx  Fy      Mz");
  for (const Errors& e : errors)
    report.line(fmt::format("  {:<34} {:8.5f} {:8.5f} {:8.5f}   {:7.4f} {:7.4f} {:7.4f}", e.name, e.rms(0), e.rms(1),
                            e.rms(2), e.worst[0], e.worst[1], e.worst[2]));
  if (unsolved > 0) report.line(fmt::format("  {} creepages were not solved", unsolved));
}

/// States of a right wheel: position, yaw, load.
struct State {
  double lateral, yaw, load;
};

/// Manchester's, and as many random ones.
std::vector<State> manchester_states() {
  std::vector<State> states;
  for (int k = 0; k <= 40; ++k) states.push_back({0.5e-3 * (k - 20), 2.4 * 0.5e-3 * (k - 20), 10e3});
  return states;
}
std::vector<State> random_states(int count, double largest_lateral, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<State> states;
  for (int k = 0; k < count; ++k) {
    const double lateral = largest_lateral * (2 * uniform(random) - 1), yaw = 0.02 * (2 * uniform(random) - 1);
    states.push_back({lateral, yaw, 20e3 + 100e3 * uniform(random)});
  }
  return states;
}

/// The patches of all states with two hundredths of the load or more.
std::vector<Patch> patches_of(const WheelRailBodies& bodies, const std::vector<State>& states, int elements) {
  WheelsetSearch search(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
  WheelRail exact(bodies, {.theory = Theory::exact, .elements = elements});
  std::vector<Patch> patches;
  for (const State& s : states) {
    WheelState<double> state;
    state.lateral = s.lateral, state.yaw = s.yaw;
    const WheelsetContact touching = search.solve(s.lateral, s.yaw);
    if (touching.status != Status::ok) continue;
    state.roll = touching.roll;
    state.forward_velocity = speed, state.pitch_velocity = speed / bodies.wheelset.nominal_radius;
    const WheelRailSolution solution = exact.solve(state, s.load);
    if (solution.status != Status::ok) continue;
    for (std::size_t k = 0; k < solution.patches.size(); ++k) {
      const ContactSolution& f = solution.fields[k];
      if (solution.patches[k].normal_force > 0.02 * s.load)
        patches.push_back(patch_of(f.elements.grid, f.fields.pressure));
    }
  }
  return patches;
}

struct Set {
  std::string name;
  std::vector<Patch> patches;
};

/// On the profiles that are there.
std::vector<Set> sets_of_patches(int elements) {
  namespace fs = std::filesystem;
  const fs::path examples = MICROSLIP_EXAMPLES "/profiles", measured = MICROSLIP_REFERENCE_DATA "/../contact-cases";
  const fs::path rail = measured / "MBench_UIC60_v3.prr", wheel = measured / "MBench_S1002_v3.prw",
                 worn = measured / "wheel-rail" / "profiles" / "worn_high_mileage.prw";
  std::mt19937_64 random(12);
  std::vector<Set> sets;
  const auto add = [&](const char* name, const fs::path& of_rail, const fs::path& of_wheel, double cant,
                       const std::vector<State>& states) {
    if (!fs::exists(of_rail) || !fs::exists(of_wheel)) return;
    WheelRailBodies bodies{io::read_profile(of_rail).profile,
                           io::read_profile(of_wheel).profile,
                           {},
                           {},
                           TrackSide::right,
                           steel,
                           {{0, friction}}};
    bodies.track.cant = cant;
    sets.push_back({name, patches_of(bodies, states, elements)});
  };
  add("Manchester", rail, wheel, 0, manchester_states());
  add("Manchester's profiles near the centre", rail, wheel, 0, random_states(80, 1.5e-3, random));
  add("S1002 on 60E1 1:40", examples / "60e1.prr", examples / "s1002.prw", 1.0 / 40, random_states(80, 6e-3, random));
  add("S1002 on 60E1 1:20", examples / "60e1.prr", examples / "s1002.prw", 1.0 / 20, random_states(80, 6e-3, random));
  add("worn wheel on UIC 60", rail, worn, 0, random_states(80, 6e-3, random));
  return sets;
}

} // namespace

bool run_creep_table_patches(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const int elements = options.thorough ? 48 : 24;
  const auto table =
      std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()), steel.poisson_ratio);
  const std::vector<Set> sets = sets_of_patches(elements);
  std::mt19937_64 random(7);
  Comparison all;
  double done = 0;
  for (const Set& set : sets) {
    Comparison elliptic, others;
    for (const Patch& patch : set.patches) {
      if (options.progress && !options.progress(done / double(sets.size()))) return false;
      (patch.is_elliptic() ? elliptic : others).add(patch, *table, table, elements, random);
    }
    ++done;
    elliptic.print(report, set.name + ", nearly elliptic");
    others.print(report, set.name + ", not elliptic");
    all.patches += others.patches, all.unsolved += others.unsolved;
    for (std::size_t k = 0; k < all.errors.size(); ++k) {
      Errors& to = all.errors[k];
      const Errors& from = others.errors[k];
      to.count += from.count;
      for (std::size_t n = 0; n < 3; ++n)
        to.squares[n] += from.squares[n], to.worst[n] = std::max(to.worst[n], from.worst[n]);
    }
  }
  all.print(report, "All that are not elliptic");
  const double force = all.errors[0].force_rms() / all.errors[1].force_rms(),
               moment = all.errors[0].rms(2) / all.errors[1].rms(2);
  report.bounded("rms of the force, over that of the ellipse", "{:.2f}", force, "<= 0.8");
  report.bounded("rms of the moment, over that of the ellipse", "{:.2f}", moment, "<= 0.6");
  return report.all_as_stated();
}

} // namespace microslip::validation
