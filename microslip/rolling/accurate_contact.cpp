#include "microslip/rolling/accurate_contact.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/contact/loaded_part.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr int coarsest = 4; // elements across
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Method with_tolerance_for_accuracy(Method method) {
  const double accuracy = method.accuracy.value_or(nan);
  require_between("accuracy", accuracy, "-", smallest_accuracy, largest_accuracy);
  method.tolerance = std::min(method.tolerance, accuracy / 100);
  return method;
}

/// How errors fall from one grid to the next, with twice as many elements in each direction.
struct Convergence {
  double (*limit)(double coarse, double fine);
  double fall;           ///< of errors
  double safety;         ///< times which the estimate is the largest change
  std::size_t estimated; ///< changes from one grid to the next that the estimate is made of
  int finest;            ///< elements across
  int grids;             ///< of one size, over which forces are averaged
};

Convergence convergence_of(const RollingProblem& problem, const Method& method) {
  if (discretisation_of(problem, method) == Discretisation::second_order)
    return {limit_of_second_order, 4, 1, 2, 512, 1};
  if (problem.layered && is_line_contact(problem)) return {limit_of_first_order, 2, 1.5, 3, 4096, 4};
  return {limit_of_first_order, 2, 1.5, 3, 256, problem.layered ? 2 : 1};
}

/// The mean over grids of one size.
struct Mean {
  ContactSolution first; ///< on the first of them
  ContactForces forces;  ///< its areas; the status is that of any that is not ok
  Creepage creepage;
  double power = 0;  ///< by friction [W]
  long products = 0; ///< on all of them
};

/// `solve` finds the solution on elements that are moved by a part of their length.
Mean mean_of(int grids, const std::function<ContactSolution(double moved)>& solve) {
  const double share = 1.0 / grids;
  Mean mean;
  for (int n = 0; n < grids; ++n) {
    ContactSolution s = solve(n * share);
    mean.products += s.report.products;
    mean.power += share * s.totals.frictional_power;
    const ContactForces forces = s.forces();
    if (n == 0) {
      mean.first = std::move(s);
      mean.creepage = mean.first.creepage;
      mean.forces = forces;
      mean.forces.fx *= share, mean.forces.fy *= share, mean.forces.mz *= share;
      mean.creepage.longitudinal *= share, mean.creepage.lateral *= share;
      continue;
    }
    if (forces.status != Status::ok) mean.forces.status = forces.status;
    mean.forces.fx += share * forces.fx, mean.forces.fy += share * forces.fy, mean.forces.mz += share * forces.mz;
    mean.creepage.longitudinal += share * s.creepage.longitudinal;
    mean.creepage.lateral += share * s.creepage.lateral;
  }
  return mean;
}

/// What differences count by: mu Fn [N], the contact's length [m], and forces per creepage without slip [N].
struct Units {
  double force = 0, length = 1;
  Vec2 stiffness = {};
};

Units units_of(const EllipticContact& contact) {
  const auto c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const double stiffness = contact.shear_modulus * contact.a * contact.b;
  return {contact.friction.peak_coefficient() * contact.normal_force,
          std::sqrt(contact.a * contact.b),
          {stiffness * c.c11, stiffness * c.c22}};
}

/// Of the contact that was found.
Units units_of(const RollingProblem& problem, const ContactSolution& found) {
  const ElementGrid& grid = found.elements.grid;
  const std::optional<LoadedPart> part = loaded_part(grid, found.fields.pressure);
  if (!part) return {};
  const double a = 0.5 * part->x.count() * grid.dx, b = 0.5 * part->y.count() * grid.dy;
  return {problem.friction.law.peak_coefficient() * normal_force(grid, found.fields.pressure),
          grid.line ? a : std::sqrt(a * b)};
}

/// The problem with a creepage of both directions, and without slip but for next to the trailing edge.
RollingProblem sticking(RollingProblem problem, double creepage) {
  problem.friction.law = FrictionLaw::coulomb(FrictionLaw::largest_coefficient);
  problem.motion.creepage = {creepage, creepage, 0};
  problem.motion.force_x = problem.motion.force_y = std::nullopt;
  return problem;
}

/// The largest difference of two results, as a fraction of mu Fn.
double difference(const Units& units, const Mean& a, const Mean& b) {
  if (!(units.force > 0)) return 0;
  const ContactForces &f = a.forces, &g = b.forces;
  return std::max({std::abs(f.fx - g.fx), std::abs(f.fy - g.fy), std::abs(f.mz - g.mz) / units.length,
                   units.stiffness.x * std::abs(a.creepage.longitudinal - b.creepage.longitudinal),
                   units.stiffness.y * std::abs(a.creepage.lateral - b.creepage.lateral)}) /
         units.force;
}

/// The largest of the changes, the last one first, each as small as it would be at the last one.
double largest_as_of_last(const std::vector<double>& changes, double fall) {
  double largest = 0, factor = 1;
  for (const double change : changes) largest = std::max(largest, factor * change), factor /= fall;
  return largest;
}

AccurateContact extrapolate(const Mean& coarse, Mean fine, double (*limit)(double, double)) {
  AccurateContact out;
  const ContactForces f = coarse.forces, g = fine.forces;
  out.coarser = f;
  out.coarser_power = coarse.power;
  out.forces = g;
  out.forces.fx = limit(f.fx, g.fx);
  out.forces.fy = limit(f.fy, g.fy);
  out.forces.mz = limit(f.mz, g.mz);
  out.creepage = fine.creepage;
  out.creepage.longitudinal = limit(coarse.creepage.longitudinal, fine.creepage.longitudinal);
  out.creepage.lateral = limit(coarse.creepage.lateral, fine.creepage.lateral);
  out.finest = std::move(fine.first);
  return out;
}

} // namespace

double limit_of_second_order(double coarse, double fine) {
  return fine + (fine - coarse) / 4;
}

double limit_of_first_order(double coarse, double fine) {
  return fine + 0.8 * (fine - coarse);
}

AccurateContactSolver::AccurateContactSolver(const Method& method)
    : method_(with_tolerance_for_accuracy(method)), layered_(method_) {}

ContactSolution AccurateContactSolver::solve_on(int elements, double moved, const RollingProblem& problem,
                                                const Progress& progress) {
  if (problem.layered) return solve_layered(elements, moved, problem, progress);
  Method on_grid = method_;
  on_grid.mx = on_grid.my = elements;
  on_grid.accuracy.reset();
  return solvers_.try_emplace(elements, on_grid).first->second.solve(problem, progress);
}

ContactSolution AccurateContactSolver::solve_layered(int elements, double moved, const RollingProblem& problem,
                                                     const Progress& progress) {
  try {
    ContactSolution solution = layered_.solve(problem, elements, moved, progress);
    conclude(solution, method_.tolerance);
    return solution;
  } catch (const Stopped& stopped) {
    return solution_without_result(Status::not_converged, stopped.what());
  }
}

/// Forces per creepage of layered bodies by what a creepage adds that strains the contact much less than its pressure.
Vec2 AccurateContactSolver::layered_stiffness(const RollingProblem& problem, const ContactSolution& found,
                                              double length, const Progress& progress) {
  constexpr int elements = 16;
  const double creepage = 0.01 * std::abs(found.approach) / length;
  if (!(creepage > 0)) return {};
  const ContactSolution moved = solve_on(elements, 0, sticking(problem, creepage), progress),
                        free = solve_on(elements, 0, sticking(problem, 0), progress);
  return {std::abs(moved.totals.fx - free.totals.fx) / creepage, std::abs(moved.totals.fy - free.totals.fy) / creepage};
}

AccurateContact AccurateContactSolver::solve(const RollingProblem& problem, const Progress& progress) {
  require_compatible(problem, method_);
  const Convergence convergence = convergence_of(problem, method_);
  AccurateContact out;
  out.forces = {nan, nan, nan, nan, nan, Status::not_converged};
  double done = 0;
  bool stopped = false;
  const Progress on_grid = [&](double) {
    stopped = stopped || (progress && !progress(done));
    return !stopped;
  };
  const auto solve_with = [&](int elements) {
    return mean_of(convergence.grids, [&](double moved) { return solve_on(elements, moved, problem, on_grid); });
  };
  Units units;
  if (!problem.layered) units = units_of(elliptic_contact(problem));
  Mean coarse = solve_with(coarsest);
  long products = coarse.products;
  std::vector<double> changes; // from one grid to the next, the last one first
  for (int elements = 2 * coarsest;; elements *= 2) {
    Mean fine = solve_with(elements);
    products += fine.products;
    if (problem.layered && !stopped) {
      const Vec2 stiffness = units.stiffness;
      units = units_of(problem, fine.first);
      units.stiffness = stiffness;
      if (changes.empty() && (problem.motion.force_x || problem.motion.force_y))
        units.stiffness = layered_stiffness(problem, fine.first, units.length, on_grid);
    }
    if (stopped) {
      out.forces.status = Status::not_converged;
      return out;
    }
    changes.insert(changes.begin(), difference(units, coarse, fine));
    const bool is_estimated = changes.size() >= convergence.estimated;
    if (is_estimated) {
      changes.resize(convergence.estimated);
      const bool solved = coarse.forces.status == Status::ok && fine.forces.status == Status::ok;
      out = extrapolate(coarse, fine, convergence.limit);
      out.error = convergence.safety * largest_as_of_last(changes, convergence.fall);
      out.elements = elements;
      out.products = products;
      if (!solved || out.error <= *method_.accuracy) return out;
      done = std::min(1.0, *method_.accuracy / out.error); // the error falls to the accuracy
    }
    if (elements == convergence.finest || !on_grid(1)) {
      out.forces.status = Status::not_converged;
      return out;
    }
    coarse = std::move(fine);
  }
}

} // namespace microslip
