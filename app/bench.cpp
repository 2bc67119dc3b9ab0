#include "app/commands.hpp"

#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/machine.hpp"
#include "app/progress_bar.hpp"
#include "io/creep_table_file.hpp"
#include "io/nearest_word.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// Does its work once and returns how many contacts that were. Throws Error if a result is none.
using Work = std::function<std::size_t()>;

/// A line of the table: what is measured, and with what it is compared.
struct BenchRow {
  std::string_view name;
  Work work;
  std::string_view over = {}; ///< name of the row that its time is divided by
  double limit = 0;           ///< of this ratio, by design; 0: none
  double seconds = 0;         ///< a contact
};

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

/// The exact theory on n x n elements, with all memory there already.
BenchRow exact_row(std::string_view name, int n, int count, std::string_view over) {
  const auto solver = std::make_shared<Solver>(Method{.mx = n, .my = n});
  std::vector<EllipticContact> contacts = sample(count);
  for (auto& contact : contacts) contact.a = contact.b = 6e-3; // the same ellipse: set-up has a separate row
  return {name,
          [=] {
            for (const auto& contact : contacts) {
              const ContactSolution s = solver->solve(rolling_problem(contact));
              if (s.report.status != Status::ok) throw Error("bench: a contact was not solved: " + s.report.reason);
            }
            return contacts.size();
          },
          over};
}

/// Each contact has another ellipse, whose elements and influences are new.
BenchRow new_ellipse_row(std::string_view name, std::string_view over) {
  return {name,
          [contacts = sample(12)] {
            Solver solver;
            for (const auto& contact : contacts) {
              const ContactSolution s = solver.solve(rolling_problem(contact));
              if (s.report.status != Status::ok) throw Error("bench: a contact was not solved: " + s.report.reason);
            }
            return contacts.size();
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
BenchRow rail_row(std::string_view name, Theory theory, std::shared_ptr<const CreepForceTable> table,
                  std::string_view over) {
  WheelRailBodies bodies{profile_of(ProfileRole::rail, 0.036, head_height),
                         profile_of(ProfileRole::wheel, 0.06, [](double y) { return 0.05 * y; }),
                         {},
                         {},
                         TrackSide::left,
                         {82e9, 0.28, 0},
                         {{0, 0.3}}};
  WheelRailMethod method{.theory = theory};
  method.table = std::move(table);
  const auto wheel = std::make_shared<WheelRail>(std::move(bodies), method);
  return {name,
          [wheel, solution = WheelRailSolution()]() mutable {
            constexpr int count = 40;
            for (int k = 0; k < count; ++k) {
              WheelState<double> state;
              state.lateral = 4e-3 * (2.0 * k / (count - 1) - 1), state.yaw = 0.5 * state.lateral;
              state.forward_velocity = 30, state.pitch_velocity = 30 / 0.46;
              wheel->solve(state, 80e3, solution);
              if (solution.status != Status::ok) throw Error("bench: a wheel on a rail was not solved");
            }
            return std::size_t{count};
          },
          over};
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
  rows[3].over = rows[0].name;
  rows.push_back(exact_row("exact theory, 12 x 12", 12, 60, rows[0].name));
  rows.push_back(exact_row("exact theory, 24 x 24", 24, 30, "exact theory, 12 x 12"));
  rows.push_back(exact_row("exact theory, 51 x 51", 51, 8, "exact theory, 24 x 24"));
  rows.push_back(new_ellipse_row("exact theory, 24 x 24, new ellipse", "exact theory, 24 x 24"));
  rows.push_back(rail_row("wheel on rail, fastsim2", Theory::fastsim2, nullptr, "exact theory, 24 x 24"));
  rows.push_back(rail_row("wheel on rail, table", Theory::table, table, "wheel on rail, fastsim2"));
  rows.push_back(rail_row("wheel on rail, exact, 24 across", Theory::exact, nullptr, "exact theory, 24 x 24"));
  return rows;
}

/// Median over at least five runs and a second, after one to warm up.
double seconds_a_contact(const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> long_enough(1);
  work();
  std::vector<double> times;
  const auto begin = Clock::now();
  while (times.size() < 5 || Clock::now() - begin < long_enough) {
    const auto start = Clock::now();
    const auto count = static_cast<double>(work());
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count() / count);
    InterruptGuard::throw_if_interrupted();
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

const BenchRow* row_of(const std::vector<BenchRow>& rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &BenchRow::name);
  return found == rows.end() ? nullptr : &*found;
}

std::string time_text(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.0f} ns", seconds * 1e9);
  return seconds < 1e-3 ? fmt::format("{:.3g} us", seconds * 1e6) : fmt::format("{:.3g} ms", seconds * 1e3);
}

void print_rows(const std::vector<BenchRow>& rows) {
  const auto build = build_info();
  fmt::print("microslip {}, commit {}, {}, {}\n{}\n\n{:<38}{:>10}  {}\n", build.version, build.commit, build.compiler,
             build.build_type, machine(), "one core, median", "a contact", "ratio");
  for (const BenchRow& row : rows) {
    std::string ratio;
    if (const BenchRow* over = row_of(rows, row.over)) {
      ratio = fmt::format("{:.3g} x {}", row.seconds / over->seconds, over->name);
      if (row.limit > 0) ratio += fmt::format(", by design at most {:g}", row.limit);
    }
    fmt::print("{:<38}{:>10}  {}\n", row.name, time_text(row.seconds), ratio);
  }
}

io::Json document_of(const std::vector<BenchRow>& rows) {
  io::Json document = json_document("bench");
  document["machine"] = machine();
  document["rows"] = io::Json::array();
  for (const BenchRow& row : rows) {
    io::Json line = {{"name", row.name}, {"seconds", row.seconds}};
    if (const BenchRow* over = row_of(rows, row.over))
      line.update(io::Json{{"over", row.over}, {"ratio", row.seconds / over->seconds}});
    if (row.limit > 0) line["limit"] = row.limit;
    document["rows"].push_back(line);
  }
  return document;
}

void bench(bool json) {
  std::vector<BenchRow> rows = bench_rows();
  ProgressBar bar("bench");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].seconds = seconds_a_contact(rows[k].work);
    bar.update(static_cast<double>(k + 1) / static_cast<double>(rows.size()));
  }
  if (json)
    print_json(document_of(rows));
  else
    print_rows(rows);
}

constexpr const char* footer =
    R"(Each line is the median of runs for a second on one core, and its ratio to another line: times depend on
the machine and on what else it does, ratios hardly. docs/performance.md has more.

With the word vehicle: a wheelset, a bogie and a car over an irregular track, in times of real time, where
microslip was built with Simbody; docs/vehicle.md describes them.

Example:
  microslip bench)";

} // namespace

void add_bench_command(Command& program, int& exit_code, int (*vehicle)(bool json)) {
  Command command =
      program.add_subcommand("bench", "Print what a contact costs on this machine, within a minute", footer);
  const auto subject = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command.add_option("SUBJECT", *subject, "vehicle: a running vehicle in place of contacts");
  add_json_flag(command, *json);
  command.callback([=, &exit_code] {
    if (*subject == "vehicle")
      exit_code = vehicle(*json);
    else if (subject->empty())
      bench(*json);
    else
      throw Error("there is nothing called " + io::printable(*subject) + " to measure; did you mean vehicle?");
  });
}

} // namespace microslip::app
