#include "validation/rolling_orders.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/elliptic_contact.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array grids = {12, 24, 48, 96};
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

Vec2 solve(int n, const EllipticContact& contact, const ExactMotion& motion = {}) {
  return relative(EllipticContactSolver({.mx = n, .my = n, .tolerance = 1e-8}).solve(contact, motion), capacity);
}

/// What the order of a problem comes from: forces of its cases on n elements across, maybe with several positions of
/// the contact on the grid, and their limits.
struct Problem {
  std::string name;
  std::size_t cases;
  std::function<std::vector<Vec2>(int n, std::size_t number)> forces;
  std::vector<Vec2> limits;
};

/// The root of the mean square, over cases, positions and both components.
double error_on(int n, const Problem& problem) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < problem.cases; ++k)
    for (const Vec2& f : problem.forces(n, k)) {
      sum += std::pow(f.x - problem.limits[k].x, 2) + std::pow(f.y - problem.limits[k].y, 2);
      count += 1;
    }
  return std::sqrt(sum / count);
}

void report_order(Report& report, const Problem& problem, double least) {
  std::string values;
  std::array<double, grids.size()> errors;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    errors[g] = error_on(grids[g], problem);
    values += fmt::format("{:>10.1e}", errors[g]);
  }
  const double order = std::log(errors.front() / errors.back()) / std::log(double(grids.back()) / grids.front());
  report.figure(fmt::format("{:<44}{}", problem.name, values), fmt::format("{:.2f}", order),
                fmt::format(">= {}", least), order >= least);
}

/// Of one value for each contact, with the limit from n and 2 n elements.
Problem elliptic(const std::string& name, const std::vector<EllipticContact>& contacts, int n, int order,
                 const ExactMotion& motion = {}) {
  Problem problem{name, contacts.size(), {}, {}};
  for (const EllipticContact& c : contacts) {
    const Vec2 coarse = solve(n, c, motion), fine = solve(2 * n, c, motion);
    problem.limits.push_back({limit(coarse.x, n, fine.x, 2 * n, order), limit(coarse.y, n, fine.y, 2 * n, order)});
  }
  problem.forces = [contacts, motion](int m, std::size_t k) { return std::vector{solve(m, contacts[k], motion)}; };
  return problem;
}

/// The same contact, given by its gap, in three positions on the grid.
std::vector<Vec2> solve_as_patch(int n, const EllipticContact& contact) {
  const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, similar, contact.normal_force);
  std::vector<Vec2> forces;
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
  Problem problem{"cylinders, given by their gap (Fx)", carter_adhesion.size(), {}, {}};
  for (const double share : carter_adhesion) problem.limits.push_back({1 - share * share, 0});
  problem.forces = [](int n, std::size_t k) {
    const double load = line_contact_from_half_width(curvature, similar, half_width).force_per_length;
    const double creepage = 2 * curvature * friction * half_width * (1 - carter_adhesion[k]);
    std::vector<Vec2> forces;
    for (const double position : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      ElementGrid grid = ElementGrid::across_line(half_width, n, 5);
      grid.x0 += position * grid.dx;
      PatchRolling rolling(similar, grid, hertzian_gap({curvature, 0}, grid), {NormalLoad::Given::force, load});
      forces.push_back(relative(
          rolling.solve({.friction = friction, .creepage = {-creepage, 0, 0}, .tolerance = 1e-8}), friction * load));
    }
    return forces;
  };
  return problem;
}

} // namespace

void report_rolling_orders(Report& report) {
  std::string heads;
  for (const int n : grids) heads += fmt::format("{:>10}", n);
  report.heading("Order of other rolling: rms of the errors of Fx and Fy over mu Fn, elements across, mean order");
  report.line(fmt::format("{:<46}{}", "", heads));
  const auto without_spin = contacts_with({{0.15, 0, 0}, {0.08, 0.12, 0}});
  Problem ellipses = elliptic("ellipses, a/b 1/3, 1, 3", without_spin, 96, 2);
  report_order(report, ellipses, 1.8);
  Problem patches = std::move(ellipses);
  patches.name = "the same, given by their gaps";
  patches.forces = [&](int n, std::size_t k) { return solve_as_patch(n, without_spin[k]); };
  report_order(report, patches, 1.6);
  report_order(report, cylinders(), 1.4);
  report_order(report, elliptic("ellipses with spin", contacts_with({{0, 0, 0.5}, {0.08, 0, 0.3}}), 96, 1), 1.5);

  std::vector<EllipticContact> dissimilar = without_spin;
  for (EllipticContact& c : dissimilar) c.dissimilarity = 0.2;
  report_order(report, elliptic("bodies of different materials, K = .2", dissimilar, 64, 1), 0.8);
}

} // namespace microslip::validation
