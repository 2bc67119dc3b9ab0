#include "validation/rolling_orders.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array rolling_grids = {12, 24, 48, 96};
constexpr double friction = 0.3, poisson_ratio = 0.28, shear_modulus = 82e9, normal_force = 10e3;
constexpr double capacity = friction * normal_force, area = 9e-6; ///< mu Fn [N]; a b [m2]
constexpr CombinedMaterial similar{shear_modulus, poisson_ratio, 0};

/// Of similar bodies, with creepages in units of mu Fn/(G a b) and spin in those over sqrt(a b).
EllipticContact contact_of(double aspect_ratio, const Creepage& creepage) {
  constexpr double unit = capacity / (shear_modulus * area);
  return {.a = std::sqrt(area * aspect_ratio),
          .b = std::sqrt(area / aspect_ratio),
          .shear_modulus = shear_modulus,
          .poisson_ratio = poisson_ratio,
          .normal_force = normal_force,
          .friction = FrictionLaw::coulomb(friction),
          .creepage = {creepage.longitudinal * unit, creepage.lateral * unit, creepage.spin * unit / std::sqrt(area)}};
}

/// All of them with adhesion and slip.
std::vector<EllipticContact> contacts_with(std::initializer_list<Creepage> creepages) {
  std::vector<EllipticContact> contacts;
  for (const double aspect_ratio : {1.0 / 3, 1.0, 3.0})
    for (const Creepage& creepage : creepages) contacts.push_back(contact_of(aspect_ratio, creepage));
  return contacts;
}

/// (Fx, Fy) over mu Fn.
Vec2 relative(const ContactSolution& s, double bound) {
  if (s.report.status != Status::ok) throw Error("order of rolling: not converged");
  return {s.totals.fx / bound, s.totals.fy / bound};
}

/// How the contacts of a problem roll.
struct Rolling {
  ContactMotion motion = ContactMotion::steady;      ///< transient: over a semi-axis a, from rest
  std::optional<Discretisation> discretisation = {}; ///< none: second order where it is possible
};

/// On n elements along the rolling direction and as many across it, or `rows` of them.
Vec2 solve(int n, const EllipticContact& contact, const Rolling& rolling = {}, int rows = 0) {
  Solver solver({.mx = n, .my = rows > 0 ? rows : n, .discretisation = rolling.discretisation, .tolerance = 1e-8});
  return relative(solver.solve(rolling_problem(contact, {.kind = rolling.motion, .steps = n / 2})), capacity);
}

using Forces = std::vector<Vec2>;

/// What the order of a problem comes from: forces of its cases on n elements across, maybe with several positions of
/// the contact on the grid, and their limits.
struct Problem {
  std::string name;
  std::function<Forces(int n, std::size_t number)> forces; ///< of a case
  Forces limits;                                           ///< of each case
  std::size_t grids = rolling_grids.size();                ///< how many of the grids are used
};

/// The root of the mean square, over cases, positions and both components.
double error_on(int n, const Problem& problem) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < problem.limits.size(); ++k)
    for (const Vec2& f : problem.forces(n, k)) {
      sum += std::pow(f.x - problem.limits[k].x, 2) + std::pow(f.y - problem.limits[k].y, 2);
      count += 1;
    }
  return std::sqrt(sum / count);
}

void report_order(Report& report, const Problem& problem, double least) {
  std::string values;
  std::vector<double> errors;
  for (std::size_t g = 0; g < problem.grids; ++g) {
    errors.push_back(error_on(rolling_grids[g], problem));
    values += fmt::format("{:>9.1e}", errors[g]);
  }
  const double order =
      std::log(errors.front() / errors.back()) / std::log(double(rolling_grids[problem.grids - 1]) / rolling_grids[0]);
  report.bounded(fmt::format("{:<42}{:<36}", problem.name, values), "{:.2f}", order, fmt::format(">= {}", least));
}

/// The limits from two grids of errors of an order.
Forces limits_of(const std::vector<EllipticContact>& contacts, int coarse, int fine, int order,
                 const Rolling& rolling = {}) {
  Forces limits;
  for (const EllipticContact& c : contacts) {
    const Vec2 f = solve(coarse, c, rolling), g = solve(fine, c, rolling);
    limits.push_back({limit(f.x, coarse, g.x, fine, order), limit(f.y, coarse, g.y, fine, order)});
  }
  return limits;
}

Problem elliptic(const std::string& name, const std::vector<EllipticContact>& contacts, Forces limits,
                 const Rolling& rolling = {}) {
  return {name, [contacts, rolling](int n, std::size_t k) { return Forces{solve(n, contacts[k], rolling)}; },
          std::move(limits)};
}

/// The same contact, given by its gap, in three positions on the grid.
Forces solve_as_patch(int n, const EllipticContact& contact) {
  const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, similar, contact.normal_force);
  Forces forces;
  for (const auto& [x, y] : {Vec2{0, 0}, Vec2{0.3, 0.2}, Vec2{0.6, 0.65}}) {
    ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, n, 5);
    grid.x0 += x * grid.dx;
    grid.y0 += y * grid.dy;
    PatchRolling rolling(similar, grid, hertzian_gap(hertz.gap, grid),
                         {NormalLoad::Given::force, contact.normal_force});
    forces.push_back(
        relative(rolling.solve({.friction = friction, .creepage = contact.creepage, .tolerance = 1e-8}), capacity));
  }
  return forces;
}

constexpr double half_width = 1e-3, curvature = 1;           // of cylinders [m], [1/m]
constexpr std::array carter_adhesion = {0.2, 0.4, 0.6, 0.8}; // its share of the contact

/// Carter's contacts, given by the gap of cylinders, in five positions on the grid.
Problem cylinders() {
  Problem problem{"cylinders, given by their gap (Fx)", {}, {}};
  for (const double share : carter_adhesion) problem.limits.push_back({1 - share * share, 0});
  problem.forces = [](int n, std::size_t k) {
    const double load = line_contact_from_half_width(curvature, similar, half_width).force_per_length;
    const double creepage = 2 * curvature * friction * half_width * (1 - carter_adhesion[k]);
    Forces forces;
    for (const double position : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      ElementGrid grid = ElementGrid::across_line(half_width, n, 5);
      grid.x0 += position * grid.dx;
      PatchRolling rolling(similar, grid, hertzian_gap({curvature, 0}, grid), {NormalLoad::Given::force, load});
      forces.push_back(relative(rolling.solve({.friction = friction, .creepage = {-creepage, 0, 0}, .tolerance = 1e-8}),
                                friction * load));
    }
    return forces;
  };
  return problem;
}

/// (Fx, Fy) over mu Fn of cylinders, whose edges lie across the rolling direction, on n elements; with spin their slip
/// turns along the row.
Vec2 solve_line(int n, const Creepage& creepage) {
  SecondOrderRolling rolling(similar, fit_line(half_width, n));
  const FittedContact& contact = rolling.contact();
  const double load = line_contact_from_half_width(curvature, similar, half_width).force_per_length;
  std::vector<double> bound = contact.load_share;
  for (double& g : bound) g *= friction * load;
  SecondOrderInput input;
  input.creepage = creepage;
  input.tolerance = 1e-8;
  const SecondOrderSolution s = rolling.solve(bound, input);
  if (s.friction.report.status != Status::ok) throw Error("order of rolling: not converged");
  Vec2 force{0, 0};
  for (std::size_t k = 0; k < bound.size(); ++k) {
    const double share = contact.elements[k].width() / (friction * load);
    force.x += share * s.friction.traction.x[k];
    force.y += share * s.friction.traction.y[k];
  }
  return force;
}

/// Where the first order with spin comes from: not from slip that turns along a row, but from the rows across.
void report_spin(Report& report, const std::vector<EllipticContact>& contacts) {
  constexpr int fine = 192;
  const Forces limits = limits_of(contacts, 96, fine, 1);
  report_order(report, elliptic("with spin", contacts, limits), 1.5);
  const double unit = curvature * friction * half_width;
  std::vector<Creepage> on_a_line;
  for (const double longitudinal : {0.4, 0.8})
    for (const double spin : {0.5, 1.0, 1.5, 2.0})
      on_a_line.push_back({longitudinal * unit, 0.3 * unit, spin * unit / half_width});
  Problem line{"  in line contact", [&](int n, std::size_t k) { return Forces{solve_line(n, on_a_line[k])}; }, {}};
  for (const Creepage& creepage : on_a_line) {
    const Vec2 f = solve_line(fine, creepage), g = solve_line(2 * fine, creepage);
    line.limits.push_back({limit(f.x, fine, g.x, 2 * fine, 2), limit(f.y, fine, g.y, 2 * fine, 2)});
  }
  report_order(report, line, 1.8);
  const auto against = [&](const std::function<Vec2(int, const EllipticContact&)>& solve_on) {
    return [&contacts, solve_on](int n, std::size_t k) { return Forces{solve_on(n, contacts[k])}; };
  };
  report_order(report,
               {"  ellipses, 192 along, so many across",
                against([](int n, const EllipticContact& c) { return solve(fine, c, {}, n); }), limits},
               0.9);
  report_order(report,
               {"  ellipses, so many along, 192 across",
                against([](int n, const EllipticContact& c) { return solve(n, c, {}, fine); }), limits},
               1.5);
}

void report_steady(Report& report, const std::vector<EllipticContact>& contacts,
                   const std::vector<EllipticContact>& with_spin) {
  const Forces limits = limits_of(contacts, 96, 192, 2);
  report_order(report, elliptic("ellipses, a/b 1/3, 1, 3", contacts, limits), 1.8);
  report_order(
      report,
      {"the same, given by their gaps", [&](int n, std::size_t k) { return solve_as_patch(n, contacts[k]); }, limits},
      1.6);
  report_order(report, cylinders(), 1.5);
  report_spin(report, with_spin);
  std::vector<EllipticContact> dissimilar = contacts;
  for (EllipticContact& c : dissimilar) c.dissimilarity = 0.2;
  report_order(report,
               elliptic("different materials, K = 0.2 (classical)", dissimilar, limits_of(dissimilar, 48, 96, 1)), 0.8);
}

/// Up to 48 elements, for a step is one of them.
void report_transient(Report& report, const std::vector<EllipticContact>& contacts,
                      const std::vector<EllipticContact>& with_spin) {
  constexpr Rolling fitted{ContactMotion::transient, Discretisation::second_order},
      classical{ContactMotion::transient, Discretisation::classical};
  const auto report_to_48 = [&](Problem problem, double least) {
    problem.grids = 3;
    report_order(report, problem, least);
  };
  const Forces limits = limits_of(contacts, 48, 80, 2, fitted);
  report_to_48(elliptic("rolled over a from rest", contacts, limits, fitted), 1.6);
  report_to_48(elliptic("the same, classical", contacts, limits, classical), 0.9);
  report_to_48(elliptic("the same with spin, second order", with_spin, limits_of(with_spin, 48, 80, 2, fitted), fitted),
               1.5);
  const Forces of_classical = limits_of(contacts, 24, 48, 1, classical);
  double difference = 0;
  for (std::size_t k = 0; k < limits.size(); ++k)
    difference =
        std::max({difference, std::abs(limits[k].x - of_classical[k].x), std::abs(limits[k].y - of_classical[k].y)});
  report.bounded("  limit without spin less that of classical elements, at most", "{:.1e}", difference, "<= 2e-3");
}

} // namespace

void report_rolling_orders(Report& report) {
  std::string heads;
  for (const int n : rolling_grids) heads += fmt::format("{:>9}", n);
  report.heading("Other rolling: rms of the errors of Fx and Fy over mu Fn, elements across, mean order");
  report.line(fmt::format("{:<44}{}", "", heads));
  const auto contacts = contacts_with({{0.15, 0, 0}, {0.08, 0.12, 0}});
  const auto with_spin = contacts_with({{0, 0, 0.5}, {0.08, 0, 0.3}});
  report_steady(report, contacts, with_spin);
  report_transient(report, contacts, with_spin);
}

} // namespace microslip::validation
