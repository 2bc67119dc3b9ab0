#include "microslip/rolling/accurate_contact.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr int coarsest = 4, finest = 512;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The largest difference of two results, as a fraction of mu Fn.
double difference(const EllipticContact& contact, const ContactSolution& a, const ContactSolution& b) {
  const double full = contact.friction.peak_coefficient() * contact.normal_force;
  if (!(full > 0)) return 0;
  const ContactForces f = a.forces(), g = b.forces();
  const auto c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const double stiffness = contact.shear_modulus * contact.a * contact.b;
  return std::max({std::abs(f.fx - g.fx), std::abs(f.fy - g.fy),
                   std::abs(f.mz - g.mz) / std::sqrt(contact.a * contact.b),
                   stiffness * c.c11 * std::abs(a.creepage.longitudinal - b.creepage.longitudinal),
                   stiffness * c.c22 * std::abs(a.creepage.lateral - b.creepage.lateral)}) /
         full;
}

AccurateContact extrapolate(const ContactSolution& coarse, ContactSolution fine) {
  AccurateContact out;
  const ContactForces f = coarse.forces(), g = fine.forces();
  out.coarser = f;
  out.coarser_power = coarse.totals.frictional_power;
  out.forces = g;
  out.forces.fx = limit_of_second_order(f.fx, g.fx);
  out.forces.fy = limit_of_second_order(f.fy, g.fy);
  out.forces.mz = limit_of_second_order(f.mz, g.mz);
  out.creepage = fine.creepage;
  out.creepage.longitudinal = limit_of_second_order(coarse.creepage.longitudinal, fine.creepage.longitudinal);
  out.creepage.lateral = limit_of_second_order(coarse.creepage.lateral, fine.creepage.lateral);
  out.finest = std::move(fine);
  return out;
}

} // namespace

double limit_of_second_order(double coarse, double fine) {
  return fine + (fine - coarse) / 4;
}

AccurateContactSolver::AccurateContactSolver(const Method& method) : method_(method) {
  const double accuracy = method.accuracy.value_or(nan);
  require_between("accuracy", accuracy, "-", smallest_accuracy, largest_accuracy);
  method_.tolerance = std::min(method.tolerance, accuracy / 100);
}

ContactSolution AccurateContactSolver::solve_on(int elements, const RollingProblem& problem, const Progress& progress) {
  Method on_grid = method_;
  on_grid.mx = on_grid.my = elements;
  on_grid.accuracy.reset();
  return solvers_.try_emplace(elements, on_grid).first->second.solve(problem, progress);
}

AccurateContact AccurateContactSolver::solve(const RollingProblem& problem, const Progress& progress) {
  require_compatible(problem, method_);
  const EllipticContact contact = elliptic_contact(problem);
  AccurateContact out;
  out.forces = {nan, nan, nan, nan, nan, Status::not_converged};
  double done = 0;
  bool stopped = false;
  const Progress on_grid = [&](double) {
    stopped = stopped || (progress && !progress(done));
    return !stopped;
  };
  const ContactSolution first = solve_on(coarsest, problem, on_grid);
  ContactSolution coarse = solve_on(2 * coarsest, problem, on_grid);
  double last_change = difference(contact, first, coarse);
  long products = first.report.products + coarse.report.products;
  for (int elements = 4 * coarsest;; elements *= 2) {
    ContactSolution fine = solve_on(elements, problem, on_grid);
    if (stopped) {
      out.forces.status = Status::not_converged;
      return out;
    }
    products += fine.report.products;
    const double change = difference(contact, coarse, fine), error = std::max(change, last_change / 4);
    last_change = change;
    out = extrapolate(coarse, fine);
    out.error = error;
    out.elements = elements;
    out.products = products;
    const bool solved = coarse.report.status == Status::ok && fine.report.status == Status::ok;
    if (!solved || error <= *method_.accuracy) return out;
    done = std::min(1.0, *method_.accuracy / error); // the error falls to the accuracy
    if (elements == finest || !on_grid(1)) {
      out.forces.status = Status::not_converged;
      return out;
    }
    coarse = std::move(fine);
  }
}

} // namespace microslip
