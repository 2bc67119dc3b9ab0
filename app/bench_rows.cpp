#include "app/bench_rows.hpp"

#include "bench/four_patches.hpp"
#include "io/creep_table_file.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// Steel on steel, from adhesion to sliding, ellipses from 1/3 to 3.
std::vector<EllipticContact> sample(int count) {
  std::vector<EllipticContact> contacts;
  for (int k = 0; k < count; ++k) {
    const auto part = [k](double irrational) { return std::fmod((k + 0.5) * irrational, 1.0); }; // spread evenly
    const double root = std::pow(3, part(0.7548776662466927) - 0.5),
                 size = std::pow(10, 2 * part(0.5698402909980532) - 4);
    const double angle = 6.283185307179586 * part(0.6180339887498949);
    contacts.push_back(
        {.a = 6e-3 * root,
         .b = 6e-3 / root,
         .shear_modulus = 82e9,
         .poisson_ratio = 0.28,
         .normal_force = 80e3,
         .friction = FrictionLaw::coulomb(0.3),
         .creepage = {size * std::cos(angle), size * std::sin(angle), (part(0.3247179572447460) - 0.5) * size / 3e-3}});
  }
  return contacts;
}

void require_solved(const ContactForces& forces) {
  if (forces.status != Status::ok || !std::isfinite(forces.fx + forces.fy + forces.mz))
    throw Error("bench: a contact was not solved");
}

/// FASTSIM2, or the creep-force table: both have forces of one contact, of many, and derivatives.
template <class Solver>
void add_forces(std::vector<BenchRow>& rows, std::shared_ptr<Solver> solver, std::string_view batch,
                std::string_view single, std::string_view derivatives) {
  const auto contacts = std::make_shared<const std::vector<EllipticContact>>(sample(2000));
  const auto forces = std::make_shared<std::vector<ContactForces>>(contacts->size());
  const auto slopes = std::make_shared<std::vector<ContactDerivatives>>(contacts->size());
  const auto checked = [forces] {
    std::ranges::for_each(*forces, require_solved);
    return forces->size();
  };
  rows.push_back({batch, [=] {
                    solver->solve(*contacts, *forces);
                    return checked();
                  }});
  rows.push_back({single,
                  [=] {
                    std::ranges::transform(*contacts, forces->begin(), [&](const auto& c) { return solver->solve(c); });
                    return checked();
                  },
                  batch});
  rows.push_back({derivatives,
                  [=] {
                    solver->differentiate(*contacts, *slopes);
                    for (const auto& slope : *slopes) require_solved(slope.forces);
                    return slopes->size();
                  },
                  batch});
}

void require_solved(const SolverReport& report) {
  if (report.status != Status::ok) throw Error("bench: a contact was not solved: " + report.reason);
}

/// Problems by one solver, which keeps what does not change from one to the next.
BenchRow solver_row(std::string_view name, const Method& method, std::vector<RollingProblem> problems,
                    std::string_view over) {
  return {name,
          [solver = std::make_shared<Solver>(method), problems = std::move(problems)] {
            for (const RollingProblem& problem : problems) require_solved(solver->solve(problem).report);
            return problems.size();
          },
          over};
}

/// Contacts of the sample in one and the same circle: what depends on the ellipse alone has separate rows.
std::vector<EllipticContact> in_one_circle(int count) {
  std::vector<EllipticContact> contacts = sample(count);
  for (auto& contact : contacts) contact.a = contact.b = 6e-3;
  return contacts;
}

std::vector<RollingProblem> problems_of(const std::vector<EllipticContact>& contacts, const Motion& motion = {}) {
  std::vector<RollingProblem> problems;
  problems.reserve(contacts.size());
  for (const EllipticContact& contact : contacts) problems.push_back(rolling_problem(contact, motion));
  return problems;
}

/// The exact theory on n x n elements.
BenchRow exact_row(std::string_view name, int n, int count, std::string_view over) {
  return solver_row(name, {.mx = n, .my = n}, problems_of(in_one_circle(count)), over);
}

/// Each contact has another ellipse, whose elements and influences are new.
BenchRow new_ellipse_row(std::string_view name, int n, std::string_view over) {
  return {name,
          [n, contacts = sample(12)] {
            Solver solver({.mx = n, .my = n});
            for (const auto& contact : contacts) require_solved(solver.solve(rolling_problem(contact)).report);
            return contacts.size();
          },
          over};
}

constexpr const char *exact_12 = "exact theory, 12 x 12", *exact_24 = "exact theory, 24 x 24",
                     *exact_51 = "exact theory, 51 x 51";

/// More that the exact theory does with an ellipse on 24 x 24 elements.
void add_of_ellipses(std::vector<BenchRow>& rows) {
  const std::vector<EllipticContact> contacts = in_one_circle(12);
  const Method method;
  std::vector<RollingProblem> forces;
  Solver solver(method);
  for (const EllipticContact& contact : contacts) {
    const ContactForces found = solver.solve(rolling_problem(contact)).forces();
    if (std::hypot(found.fx, found.fy) < 0.9 * contact.friction.static_coefficient() * contact.normal_force)
      forces.push_back(rolling_problem(contact, {.force_x = found.fx, .force_y = found.fy}));
  }
  rows.push_back(solver_row("exact theory, forces given", method, forces, exact_24));
  const auto one = std::make_shared<Solver>(method);
  rows.push_back({"exact theory, with derivatives",
                  [one, contacts] {
                    for (const auto& contact : contacts)
                      require_solved(one->differentiate(rolling_problem(contact)).solution.report);
                    return contacts.size();
                  },
                  exact_24});
  rows.push_back({"exact theory, response at a wavelength",
                  [one, problem = rolling_problem(contacts[0])] {
                    const std::vector<double> wavenumbers = {100, 300};
                    require_solved(one->respond(problem, wavenumbers).solution.report);
                    return wavenumbers.size();
                  },
                  exact_24});
  rows.push_back(solver_row("exact theory, classical", {.discretisation = Discretisation::classical},
                            problems_of(contacts), exact_24));
  rows.push_back(
      solver_row("exact theory, to an accuracy of 0.001", {.accuracy = 1e-3}, problems_of(in_one_circle(4)), exact_24));
  rows.push_back(solver_row("exact theory, 24 transient steps", method,
                            problems_of(in_one_circle(3), {.kind = ContactMotion::transient, .steps = 24}), exact_24));
  std::vector<RollingProblem> shifts = problems_of(contacts, {.kind = ContactMotion::shift});
  for (RollingProblem& shift : shifts) {
    Creepage& by = shift.motion.creepage;
    by = {6e-3 * by.longitudinal, 6e-3 * by.lateral, 6e-3 * by.spin};
  }
  rows.push_back(solver_row("exact theory, shift", method, shifts, exact_24));
}

constexpr double semi_axis_x = 5e-3, semi_axis_y = 7e-3, load = 50e3, friction = 0.3;
constexpr CombinedMaterial steel{82e9, 0.28, 0};

/// The gap of an ellipse of steel, or one with an egg-shaped contact.
RollingProblem of_gap(int n, double skewness) {
  const HertzContact hertz = hertz_from_ellipse(semi_axis_x, semi_axis_y, steel, load);
  const auto gap = [hertz, skewness](double x, double y) {
    return hertz.gap.x * x * x * (1 + skewness * (x / semi_axis_x + y / semi_axis_y)) + hertz.gap.y * y * y;
  };
  RollingProblem problem;
  problem.geometry = GapFormula{ElementGrid::across_ellipse(semi_axis_x, semi_axis_y, n, 4 + int(skewness * n)), gap};
  problem.bodies = steel;
  problem.load = {NormalLoad::Given::force, load};
  problem.friction.law = FrictionLaw::coulomb(friction);
  problem.motion.creepage = {-6e-4, 4e-4, 0.1};
  return problem;
}

/// The same contact of other bodies, or with other friction: on elements of its ellipse, classically.
RollingProblem of_ellipse() {
  RollingProblem problem = of_gap(24, 0);
  problem.geometry = Ellipse{semi_axis_x, semi_axis_y};
  return problem;
}

/// Cases whose cost is of the order of one on 24 x 24 elements.
void add_of_gaps_and_bodies(std::vector<BenchRow>& rows) {
  const double peak = hertz_from_ellipse(semi_axis_x, semi_axis_y, steel, load).peak_pressure;
  const auto add = [&rows](std::string_view name, const Method& method, const RollingProblem& problem) {
    rows.push_back(solver_row(name, method, {problem}, exact_24));
  };
  const Method classical = {.discretisation = Discretisation::classical};
  add("gap of an ellipse, second order", {}, of_gap(24, 0));
  add("egg, second order", {}, of_gap(24, 0.15));
  add("egg, classical", classical, of_gap(24, 0.15));
  RollingProblem problem = of_ellipse();
  problem.bodies = combine(Material{82e9, 0.28}, Material{1e9, 0.4});
  add("dissimilar bodies", {}, problem);
  problem.bodies = viscoelastic({1e9, 0.4}, {1, 1e-3}, {1e9, 0.4}, {1, 1e-3}, problem.motion.rolling_speed);
  add("viscoelastic bodies", {}, problem);
  problem = of_ellipse();
  problem.bodies.layer = {.flexibility = 2.5e-14};
  add("elastic layer", {}, problem);
  problem.bodies.layer.yield_stress = 0.1 * friction * peak, problem.bodies.layer.hardening = 5e12;
  add("layer that yields, 24 x 24", {}, problem);
  add("layer that yields, 48 x 48", {.mx = 48, .my = 48}, problem);
  problem = of_ellipse();
  problem.friction.law = FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1});
  problem.motion.rolling_speed = 45;
  add("friction that falls with the slip", {}, problem);
  const ThermalBody thermal{20, 50, 7850, 450};
  problem.thermal = ThermalBodies{thermal, thermal};
  add("friction that falls, with temperatures", {}, problem);
}

/// Steps of a sequence, each of which goes on from the one before.
template <class Change>
BenchRow sequence_row(std::string_view name, ContactStep step, int steps, std::string_view over, const Change& change) {
  return {name,
          [step = std::move(step), steps, change]() mutable {
            ContactSequence sequence;
            for (int k = 0; k < steps; ++k) {
              step.start = k == 0 ? StepStart::fresh : StepStart::previous;
              change(step, k);
              require_solved(sequence.solve(step).report);
            }
            return static_cast<std::size_t>(steps);
          },
          over};
}

void add_sequences(std::vector<BenchRow>& rows) {
  ContactStep step = four_patches(128);
  rows.push_back(sequence_row("four patches, two forces, cold", step, 1, exact_51, [](ContactStep&, int) {}));
  step.frictionless = true, step.force_x = step.force_y = {};
  rows.push_back(sequence_row("four patches, pressures alone", step, 1, exact_51, [](ContactStep&, int) {}));

  const GapValues values = gap_values(of_gap(28, 0), {});
  step = {.grid = values.grid, .bodies = steel, .gap = values.gap};
  step.load = {NormalLoad::Given::force, load}, step.friction = {FrictionLaw::coulomb(friction)};
  step.force_x = -0.657 * friction;
  rows.push_back(sequence_row("onset of rolling, a step", step, 57, exact_24, [](ContactStep& s, int k) {
    s.motion.motion = k == 0 ? ContactMotion::shift : ContactMotion::transient;
  }));

  ContactStep soft;
  soft.grid = {.mx = 45, .my = 45, .x0 = -2.2e-3, .y0 = -2.2e-3, .dx = 0.1e-3, .dy = 0.1e-3};
  soft.bodies = combine(Material{0.5e6, 0}, Material{1e11, 0});
  for (int j = 0; j < soft.grid.my; ++j)
    for (int i = 0; i < soft.grid.mx; ++i)
      soft.gap.push_back(4.116 * (std::pow(soft.grid.x(i), 2) + std::pow(soft.grid.y(j), 2)));
  soft.friction = {FrictionLaw::coulomb(0.2986)};
  soft.motion.motion = ContactMotion::shift;
  rows.push_back(sequence_row("Spence's compression, a step", soft, 35, exact_51, [](ContactStep& s, int k) {
    s.load = {NormalLoad::Given::force, std::pow((k + 2) / 90.0, 3)};
  }));

  const double half_width = 4e-3, curvature = 1 / 0.92;
  ContactStep line;
  line.grid = ElementGrid::across_line(half_width, 82, 5);
  line.bodies = steel;
  for (int i = 0; i < line.grid.mx; ++i) line.gap.push_back(curvature * line.grid.x(i) * line.grid.x(i));
  line.load = {NormalLoad::Given::force, line_contact_from_half_width(curvature, steel, half_width).force_per_length};
  line.friction = {FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1})};
  line.motion.creepage = {-1e-3, 0, 0};
  line.motion.rolling_speed = 45, line.motion.step = 1e-4;
  rows.push_back(sequence_row("cylinder with falling friction, a step", line, 20, exact_24, [](ContactStep& s, int k) {
    s.motion.motion = k == 0 ? ContactMotion::steady : ContactMotion::transient;
  }));
}

/// Stresses below 45 x 45 loaded elements at 11 depths.
BenchRow interior_row(std::string_view name, std::string_view over) {
  const ElementGrid grid = ElementGrid::across_ellipse(semi_axis_x, semi_axis_y, 45);
  InteriorGrid points;
  for (int i = 0; i < grid.mx; ++i) points.x.push_back(grid.x(i)), points.y.push_back(grid.y(i));
  for (int k = 0; k < 11; ++k) points.z.push_back((0.5 + k) * grid.dx);
  return {name,
          [grid, points] {
            const std::vector<double> pressure(grid.count(), 1e9), traction(grid.count(), 2e8);
            InteriorSequence().states(Material{82e9, 0.28}, Material{82e9, 0.28}, grid, {traction, traction, pressure},
                                      points);
            return std::size_t{1};
          },
          over};
}

Profile profile_of(ProfileRole role, double half_width, const std::function<double(double)>& z) {
  std::vector<ProfilePoint> points;
  for (int k = -600; k <= 600; ++k) points.push_back({half_width * k / 600, z(half_width * k / 600)});
  return Profile(role, points);
}

/// A rail's head with an arc for its top and sides that fall ever steeper.
double head_height(double y) {
  constexpr double radius = 0.3, side = 0.024, depth = 0.016;
  const double beyond = std::max(std::abs(y) - side, 0.0) / (0.036 - side);
  return std::sqrt(radius * radius - y * y) - radius - depth * beyond * beyond * beyond;
}

/// A cone on such a head, in states from side to side.
BenchRow rail_row(std::string_view name, const WheelRailMethod& method, std::string_view over,
                  bool derivatives = false) {
  WheelRailBodies bodies{profile_of(ProfileRole::rail, 0.036, head_height),
                         profile_of(ProfileRole::wheel, 0.06, [](double y) { return 0.05 * y; }),
                         {},
                         {},
                         TrackSide::left,
                         {82e9, 0.28, 0},
                         {{0, 0.3}}};
  const auto wheel = std::make_shared<WheelRail>(std::move(bodies), method);
  const int count = method.theory == Theory::exact ? 20 : 40;
  return {name,
          [wheel, count, derivatives, solution = WheelRailSolution(), slopes = WheelRailDerivatives()]() mutable {
            for (int k = 0; k < count; ++k) {
              WheelState<double> state;
              state.lateral = 4e-3 * (2.0 * k / (count - 1) - 1), state.yaw = 0.5 * state.lateral;
              state.forward_velocity = 30, state.pitch_velocity = 30 / 0.46;
              if (derivatives)
                wheel->differentiate(state, 80e3, solution, slopes);
              else
                wheel->solve(state, 80e3, solution);
              if (solution.status != Status::ok) throw Error("bench: a wheel on a rail was not solved");
            }
            return static_cast<std::size_t>(count);
          },
          over};
}

} // namespace

std::string time_text(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.0f} ns", seconds * 1e9);
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  return seconds < 1 ? fmt::format("{:.3g} ms", seconds * 1e3) : fmt::format("{:.3g} s", seconds);
}

std::vector<BenchRow> bench_rows() {
  std::vector<BenchRow> rows;
  add_forces(rows, std::make_shared<Fastsim2>(), "FASTSIM2, 10 x 10, many at once", "FASTSIM2, one by one",
             "FASTSIM2, with derivatives");
  const CreepTableNodes nodes = io::read_creep_table(io::shipped_creep_table());
  const auto table = std::make_shared<const CreepForceTable>(nodes, 0.28);
  add_forces(rows, table, "creep-force table, many at once", "creep-force table, one by one",
             "creep-force table, with derivatives");
  rows[1].limit = 3, rows[2].limit = 4; // as docs/performance.md has them
  const std::string_view fastsim2 = rows[0].name;
  rows[3].over = fastsim2;
  rows.push_back(solver_row("FaStrip", {.theory = Theory::fastrip}, problems_of(sample(50)), fastsim2));
  rows.push_back(exact_row("exact theory, 8 x 8", 8, 60, fastsim2));
  rows.push_back(exact_row(exact_12, 12, 60, fastsim2));
  rows.push_back(exact_row(exact_24, 24, 30, exact_12));
  rows.push_back(exact_row(exact_51, 51, 8, exact_24));
  rows.push_back(exact_row("exact theory, 101 x 101", 101, 2, exact_51));
  rows.push_back(exact_row("exact theory, 201 x 201", 201, 1, exact_51));
  rows.push_back(new_ellipse_row("exact theory, 12 x 12, new ellipse", 12, exact_12));
  rows.push_back(new_ellipse_row("exact theory, 24 x 24, new ellipse", 24, exact_24));
  add_of_ellipses(rows);
  add_of_gaps_and_bodies(rows);
  add_sequences(rows);
  rows.push_back(interior_row("stresses inside, 11 depths", exact_51));
  const std::string_view rail = "wheel on rail, fastsim2", exact_rail = "wheel on rail, exact, 24 across";
  rows.push_back(rail_row(rail, {}, exact_24));
  rows.push_back(rail_row("wheel on rail, fastsim2, derivatives", {}, rail, true));
  rows.push_back(rail_row("wheel on rail, table", {.theory = Theory::table, .table = table}, rail));
  rows.push_back(rail_row(exact_rail, {.theory = Theory::exact}, exact_24));
  rows.push_back(rail_row("wheel on rail, exact, 12 across", {.theory = Theory::exact, .elements = 12}, exact_rail));
  rows.push_back(rail_row("wheel on rail, exact, 8 across", {.theory = Theory::exact, .elements = 8}, exact_rail));
  return rows;
}

} // namespace microslip::app
