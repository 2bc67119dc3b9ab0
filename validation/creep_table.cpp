#include "validation/studies.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "microslip/table/creep_coordinates.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/clock.hpp"
#include "validation/exact_cases.hpp"
#include "validation/models/polach.hpp"
#include "validation/relative_forces.hpp"
#include "validation/report.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Contacts = std::vector<EllipticContact>;
using Results = std::vector<RelativeForces>;

/// Cases off the nodes: a/b and the direction of the scaled creepages uniform (the former in its logarithm), t from no
/// slip to nearly full sliding.
Contacts random_contacts(int count, double least, double largest, bool steel) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  Contacts contacts;
  for (int i = 0; i < count; ++i) {
    const double ratio = least * std::pow(largest / least, uniform(random)), c = 5e-3;
    const double t = 0.98 * uniform(random), x = normal(random), y = normal(random), z = normal(random);
    const double r = creep_coordinates::half_way * t / (1 - t) / std::sqrt(x * x + y * y + z * z);
    EllipticContact contact;
    contact.a = c * std::sqrt(ratio);
    contact.b = c / std::sqrt(ratio);
    contact.shear_modulus = 82e9;
    contact.poisson_ratio = steel ? 0.28 : 0.5 * uniform(random);
    contact.normal_force = 80e3;
    contact.friction = FrictionLaw::coulomb(0.3);
    const creep_coordinates::LinearTheory linear(
        creepage_coefficients(ratio, contact.poisson_ratio, CreepageTable::computed),
        creep_coordinates::spin_scale(ratio));
    const double g = contact.shear_modulus * c * c / (0.3 * contact.normal_force);
    contact.creepage = {x * r / (g * linear.x), y * r / (g * linear.y), z * r / (g * linear.z * c)};
    contacts.push_back(contact);
  }
  return contacts;
}

using Law = std::function<ContactForces(const EllipticContact&)>;

Results by(const Law& law, const Contacts& contacts) {
  Results results;
  for (const EllipticContact& contact : contacts) results.push_back(relative(law(contact), contact));
  return results;
}

/// By exact theory on some elements across, empty if it was stopped.
Results exactly(const Contacts& contacts, int elements, const StudyOptions& options, double begin, double end) {
  StudyOptions part = options;
  part.progress = part_of(options.progress, begin, end);
  const ExactMethod method = {.n = elements, .discretisation = Discretisation::second_order};
  Results results;
  for (const auto& found : solve_exactly(contacts, method, part))
    results.push_back(relative(found.forces, contacts[results.size()]));
  return results;
}

/// By exact theory, and the limit from these elements and half of them; where the two differ by more than 0.002, from
/// these elements and twice as many, as at the nodes of a table.
struct Exact {
  Results finest, limit;
};

Exact exactly(const Contacts& contacts, int elements, const StudyOptions& options) {
  const Results coarse = exactly(contacts, elements / 2, options, 0, 0.15);
  Exact exact = {.finest = exactly(contacts, elements, options, 0.15, 0.85), .limit = {}};
  if (coarse.size() != contacts.size() || exact.finest.size() != contacts.size()) return {};
  Contacts doubtful;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const RelativeForces &fine = exact.finest[i], limit = limit_of_second_order(coarse[i], fine);
    exact.limit.push_back(limit);
    if (std::max({std::abs(limit.fx - fine.fx), std::abs(limit.fy - fine.fy), std::abs(limit.mz - fine.mz)}) <= 0.002)
      continue;
    doubtful.push_back(contacts[i]);
    places.push_back(i);
  }
  const Results finer = exactly(doubtful, 2 * elements, options, 0.85, 1);
  if (finer.size() != doubtful.size()) return {};
  for (std::size_t k = 0; k < places.size(); ++k)
    exact.limit[places[k]] = limit_of_second_order(exact.finest[places[k]], finer[k]);
  return exact;
}

struct Errors {
  std::array<double, 3> rms = {}, worst = {};
};

Errors errors_of(const Results& results, const Results& reference) {
  constexpr std::array components = {&RelativeForces::fx, &RelativeForces::fy, &RelativeForces::mz};
  Errors errors;
  for (std::size_t c = 0; c < components.size(); ++c) {
    double squares = 0;
    for (const double d : differences(results, reference, components[c])) {
      squares += d * d;
      errors.worst[c] = std::max(errors.worst[c], d);
    }
    errors.rms[c] = std::sqrt(squares / double(results.size()));
  }
  return errors;
}

void print(Report& report, std::string_view name, const Errors& e) {
  report.line(fmt::format("  {:<34} {:8.5f} {:8.5f} {:8.5f}   {:7.4f} {:7.4f} {:7.4f}", name, e.rms[0], e.rms[1],
                          e.rms[2], e.worst[0], e.worst[1], e.worst[2]));
}

/// Upper limits of the errors of a set of cases.
struct Goal {
  double force_rms = 0, moment_rms = 0, worst = 0;
};

SimplifiedOptions flexibilities(FlexibilityModel model) {
  SimplifiedOptions options{.mx = 10, .my = 10};
  options.flexibility = model;
  options.creepage_table = CreepageTable::computed;
  return options;
}

bool compare(Report& report, std::string_view heading, const Contacts& contacts, const CreepForceTable& table,
             int elements, const Goal& goal, const StudyOptions& options) {
  const Exact exact = exactly(contacts, elements, options);
  if (exact.limit.empty()) return false;
  report.heading(
      fmt::format("{}: {} cases, errors against {} + {} elements", heading, contacts.size(), elements / 2, elements));
  report.line("                                       rms Fx       Fy       Mz     worst Fx  Fy      Mz");
  RowSolver three(MarchingScheme::fastsim2, flexibilities(FlexibilityModel::three)),
      blended(MarchingScheme::fastsim2, flexibilities(FlexibilityModel::blended));
  const Errors of_table = errors_of(by([&](const auto& c) { return table.solve(c); }, contacts), exact.limit);
  print(report, "table", of_table);
  print(report, fmt::format("exact theory, {0} x {0}", elements), errors_of(exact.finest, exact.limit));
  print(report, "FASTSIM2, three flexibilities",
        errors_of(by([&](const auto& c) { return three.solve(c); }, contacts), exact.limit));
  print(report, "FASTSIM2, blended flexibilities",
        errors_of(by([&](const auto& c) { return blended.solve(c); }, contacts), exact.limit));
  print(report, "Polach's formula (no moment)", errors_of(by(polach_forces, contacts), exact.limit));
  const double force = std::max(of_table.rms[0], of_table.rms[1]),
               worst = *std::max_element(of_table.worst.begin(), of_table.worst.end());
  report.bounded("rms of the table's forces", "{:.5f}", force, fmt::format("<= {:g}", goal.force_rms));
  report.bounded("and of its moment", "{:.5f}", of_table.rms[2], fmt::format("<= {:g}", goal.moment_rms));
  report.bounded("worst of all", "{:.4f}", worst, fmt::format("<= {:g}", goal.worst),
                 {.bound = "<= 0.0065", .page = "creep-force-tables.md"});
  return true;
}

/// A line through the creepages: the contact at a position from -1 to 1.
EllipticContact on_line(const EllipticContact& from, const EllipticContact& to, double place) {
  EllipticContact contact = from;
  contact.creepage.longitudinal += place * to.creepage.longitudinal;
  contact.creepage.lateral += place * to.creepage.lateral;
  contact.creepage.spin += place * to.creepage.spin;
  return contact;
}

/// The largest second difference of Fx and Fy over mu Fn on each of the lines; their median and largest.
std::pair<double, double> second_differences(const Contacts& lines, const Law& law) {
  constexpr int points = 200;
  std::vector<double> largest;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    std::vector<RelativeForces> forces;
    for (int k = 0; k <= points; ++k) {
      const auto contact = on_line(lines[i], lines[i + 1], 2.0 * k / points - 1);
      forces.push_back(relative(law(contact), contact));
    }
    double most = 0;
    for (std::size_t k = 1; k + 1 < forces.size(); ++k)
      for (const auto component : {&RelativeForces::fx, &RelativeForces::fy})
        most = std::max(most, std::abs(forces[k + 1].*component - 2 * forces[k].*component + forces[k - 1].*component));
    largest.push_back(most);
  }
  std::sort(largest.begin(), largest.end());
  return {largest[largest.size() / 2], largest.back()};
}

/// The largest deviation of the derivatives from central differences, in units of the largest of their row that linear
/// theory has.
double jacobian_error(const Contacts& contacts, const CreepForceTable& table) {
  double worst = 0;
  for (const EllipticContact& contact : contacts) {
    const auto found = table.differentiate(contact);
    const auto& k = contact;
    const double c = std::sqrt(k.a * k.b), stiffness = k.shear_modulus * k.a * k.b;
    const double units[] = {1, 1, 1 / c}, steps[] = {1e-9, 1e-9, 1e-9 / c};
    for (int n = 0; n < 3; ++n) {
      double Creepage::*const which[] = {&Creepage::longitudinal, &Creepage::lateral, &Creepage::spin};
      EllipticContact more = k, less = k;
      more.creepage.*which[n] += steps[n];
      less.creepage.*which[n] -= steps[n];
      const auto above = table.solve(more), below = table.solve(less);
      const double differences[] = {above.fx - below.fx, above.fy - below.fy, (above.mz - below.mz) / c};
      for (int m = 0; m < 3; ++m) {
        const double derivative = found.jacobian[m][n] / (m == 2 ? c : 1);
        worst = std::max(worst, std::abs(differences[m] / (2 * steps[n]) - derivative) / (stiffness * units[n]));
      }
    }
  }
  return worst;
}

/// Processor time of some work [ns], of which the shortest of a few times counts.
double nanoseconds(std::size_t items, const std::function<void()>& work) {
  double shortest = 1e300;
  for (int i = 0; i < 20; ++i) {
    const double begin = thread_time();
    work();
    shortest = std::min(shortest, 1e9 * (thread_time() - begin));
  }
  return shortest / double(items);
}

/// Friction that falls with the slip: the table has that of the rigid slip of the contact's centre, the exact theory
/// that of the slip of each element. With constant friction the difference is that of the elements of first order.
bool compare_falling_friction(Report& report, const CreepForceTable& table, const StudyOptions& options) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> uniform(0, 1);
  Contacts falling, constant;
  for (int i = 0; i < 100; ++i) {
    EllipticContact contact;
    const double ratio = 0.2 * std::pow(25, uniform(random)), c = 5e-3;
    contact.a = c * std::sqrt(ratio);
    contact.b = c / std::sqrt(ratio);
    contact.shear_modulus = 82e9;
    contact.poisson_ratio = 0.28;
    contact.normal_force = 80e3;
    contact.rolling_speed = 20;
    const double creep = 5e-4 * std::pow(60, uniform(random)), angle = 2 * std::numbers::pi * uniform(random);
    contact.creepage = {creep * std::cos(angle), creep * std::sin(angle), uniform(random) - 0.5};
    contact.friction = FrictionLaw::polach(0.4, 0.4, 0.6);
    falling.push_back(contact);
    contact.friction = FrictionLaw::coulomb(contact.friction.coefficient(creep * contact.rolling_speed));
    constant.push_back(contact);
  }
  report.heading("Friction that falls with the slip: 100 cases, errors against 24 x 24 elements of first order");
  report.line("                                       rms Fx       Fy       Mz     worst Fx  Fy      Mz");
  for (const auto& [name, contacts] : {std::pair("Polach's law", &falling), {"constant friction", &constant}}) {
    const auto exact = solve_exactly(*contacts, {.n = 24}, options);
    if (exact.size() != contacts->size()) return false;
    Results reference;
    for (std::size_t i = 0; i < exact.size(); ++i) reference.push_back(relative(exact[i].forces, (*contacts)[i]));
    print(report, name, errors_of(by([&](const auto& c) { return table.solve(c); }, *contacts), reference));
  }
  return true;
}

void report_times(Report& report, const Contacts& contacts, const CreepForceTable& table) {
  report.heading("Processor time for a contact [ns], random cases one after the other");
  std::vector<ContactForces> forces(contacts.size());
  std::vector<ContactDerivatives> derivatives(contacts.size());
  RowSolver fastsim2(MarchingScheme::fastsim2, flexibilities(FlexibilityModel::three));
  const auto line = [&](const char* name, const std::function<void()>& work) {
    report.line(fmt::format("  {:<40} {:8.0f}", name, nanoseconds(contacts.size(), work)));
  };
  line("table, a batch", [&] { table.solve(contacts, forces); });
  line("with derivatives, a batch", [&] { table.differentiate(contacts, derivatives); });
  line("table, one by one", [&] {
    for (std::size_t i = 0; i < contacts.size(); ++i) forces[i] = table.solve(contacts[i]);
  });
  line("with derivatives, one by one", [&] {
    for (std::size_t i = 0; i < contacts.size(); ++i) derivatives[i] = table.differentiate(contacts[i]);
  });
  line("FASTSIM2, 10 x 10, a batch", [&] { fastsim2.solve(contacts, forces); });
}

} // namespace

bool run_creep_table(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const CreepTableNodes nodes = io::read_creep_table(io::shipped_creep_table());
  const CreepForceTable table(nodes);
  const CreepTableOrigin& origin = nodes.origin;
  report.line(fmt::format("{} nodes from {} contacts on {} and {} elements, {} not converged",
                          nodes.axes.blocks() * nodes.axes.nodes(), origin.solved, origin.elements / 2, origin.elements,
                          origin.not_converged));
  report.line(
      fmt::format("estimated error of a node: rms {:.5f} {:.5f} {:.5f}, worst {:.4f} {:.4f} {:.4f} of Fx, Fy, Mz",
                  origin.error_rms[0], origin.error_rms[1], origin.error_rms[2], origin.error_worst[0],
                  origin.error_worst[1], origin.error_worst[2]));
  const int elements = options.thorough ? 48 : 24;
  struct Set {
    const char* name;
    Contacts contacts;
    Goal goal;
  };
  const Set sets[] = {
      {"a/b from 0.1 to 10, nu = 0.28", random_contacts(2500, 0.1, 10, true), {0.0004, 0.0006, 0.006}},
      {"a/b from 0.05 to 20, nu = 0.28", random_contacts(2500, 0.05, 20, true), {0.0004, 0.0006, 0.02}},
      {"a/b from 0.05 to 20, nu from 0 to 0.5", random_contacts(1000, 0.05, 20, false), {0.0004, 0.0006, 0.02}},
      {"the 3,220 cases", test_set_contacts(), {0.0004, 0.0006, 0.006}}};
  double begin = 0;
  for (const Set& set : sets) {
    StudyOptions part = options;
    part.progress = part_of(options.progress, begin, begin + 0.24);
    begin += 0.24;
    if (!compare(report, set.name, set.contacts, table, elements, set.goal, part)) return false;
  }

  report.heading("Smoothness");
  const Contacts lines = random_contacts(2000, 0.2, 5, true);
  RowSolver fastsim2(MarchingScheme::fastsim2, flexibilities(FlexibilityModel::three));
  const auto [median, largest] = second_differences(lines, [&](const auto& c) { return table.solve(c); });
  const auto [other_median, other_largest] =
      second_differences(lines, [&](const auto& c) { return fastsim2.solve(c); });
  report.line(
      "second differences of forces over mu Fn, 201 points on 1,000 lines: median of the lines' largest, largest");
  report.line(fmt::format("  {:<34} {:8.5f} {:8.5f}", "table", median, largest));
  report.line(fmt::format("  {:<34} {:8.5f} {:8.5f}", "FASTSIM2, 10 x 10", other_median, other_largest));
  const double error = jacobian_error({lines.begin(), lines.begin() + 500}, table);
  report.bounded("derivatives against differences, over G a b", "{:.1e}", error, "<= 1e-6");
  if (!compare_falling_friction(report, table, options)) return false;
  report_times(report, random_contacts(5000, 0.05, 20, true), table);
  return report.all_as_stated();
}

} // namespace microslip::validation
