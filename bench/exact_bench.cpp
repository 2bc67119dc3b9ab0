// Speed of the exact theory at second order, one thread (OMP_NUM_THREADS=1): the paper's test on growing grids, cases
// of the test set, forces given against creepages given, and derivatives with their accuracy. Prints tables of
// processor time, which other work on the machine changes less than elapsed time; what counts are ratios within one
// run.
//   exact_bench [elements across, largest grid; default 401]

#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/clock.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace microslip;
using validation::processor_time;

/// The most memory that was resident [MB]. Not getrusage's, which counts what the parent had before it started us.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

/// The test of the refinement paper, with the misprint in its creepage corrected.
EllipticContact papers_test() {
  return {.a = 5e-3,
          .b = 25e-3,
          .shear_modulus = 1e9,
          .poisson_ratio = 0.28,
          .normal_force = 1300,
          .friction = FrictionLaw::coulomb(0.3),
          .creepage = {0.000857, 0, 0}};
}

/// Seconds for one product with the matrix of a grid: the shortest of some.
double product_time(const EllipticContact& contact, int n) {
  const FittedContact fitted = fit_ellipse(contact.a, contact.b, n, n);
  FittedOperator response({contact.shear_modulus, contact.poisson_ratio, 0}, fitted);
  std::vector<double> px(fitted.elements.size(), 1), py(px), sx(px), sy(px);
  double shortest = 1e9;
  for (int i = 0; i < 7; ++i) {
    const auto start = processor_time();
    response.apply(px, py, sx, sy);
    shortest = std::min(shortest, (processor_time() - start));
  }
  return shortest;
}

void growing_grids(int largest) {
  std::printf("The paper's test, residual 1e-6, with all coarser grids and the making of the matrices\n"
              "%6s %9s %8s %9s %12s %14s %16s %10s\n",
              "grid", "Fx/mu Fn", "time [s]", "products", "product [ms]", "time/product", "bytes per element",
              "peak [MB]");
  const EllipticContact contact = papers_test();
  double first = 0, time = 0;
  int n = 0;
  for (const int size : {51, 101, 201, 401, 801, 1001}) {
    if (size > largest) break;
    const double product = product_time(contact, size), before = peak_megabytes();
    const auto start = processor_time();
    const ContactSolution result = Solver({.mx = size, .my = size}).solve(rolling_problem(contact));
    time = (processor_time() - start);
    n = size;
    if (size == 101) first = time;
    std::printf("%6d %9.5f %8.3f %9ld %12.2f %14.0f %16.0f %10.0f\n", size, result.totals.fx / 390, time,
                result.report.products, 1e3 * product, time / product,
                std::max(peak_megabytes() - before, 0.0) * 1048576 / size / size, peak_megabytes());
  }
  if (first > 0 && n > 101)
    std::printf("time grows like N^%.2f from 101 to %d elements across\n\n",
                std::log(time / first) / std::log(n * n / 10201.0), n);
}

void test_set(int n, double wanted) {
  Solver solver({.mx = n, .my = n});
  const auto contacts = validation::test_set_contacts();
  int unsolved = 0;
  long products = 0;
  const auto start = processor_time();
  for (const EllipticContact& contact : contacts) {
    const ContactSolution result = solver.solve(rolling_problem(contact));
    unsolved += result.report.status != Status::ok;
    products += result.report.products;
  }
  const double count = static_cast<double>(contacts.size());
  std::printf("3,220 cases at %d x %d: %.2f ms and %.1f products per case (wanted: <= %.0f ms), %d not solved\n", n, n,
              1e3 * (processor_time() - start) / count, static_cast<double>(products) / count, wanted, unsolved);
}

/// Largest differences between derivatives and central differences of precisely solved forces, over the size of a
/// derivative's column, of some cases: the median and nine tenths. Single cases have an element near a kink.
void derivative_errors(int n) {
  constexpr std::array members = {&Creepage::longitudinal, &Creepage::lateral, &Creepage::spin};
  Solver solver({.mx = n, .my = n}), precise({.mx = n, .my = n, .tolerance = 1e-11});
  const auto contacts = validation::test_set_contacts();
  std::vector<double> errors;
  for (std::size_t i = 0; i < contacts.size(); i += 63) {
    const EllipticContact& contact = contacts[i];
    const double length = std::sqrt(contact.a * contact.b);
    const ExactDerivatives d = solver.differentiate(rolling_problem(contact));
    const double limit = contact.friction.static_coefficient() * contact.normal_force;
    const double size = std::hypot(d.solution.totals.fx, d.solution.totals.fy);
    if (size < 1e-3 * limit || size > 0.99 * limit) continue;
    double worst = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const double step = 3e-8 / (k == 2 ? length : 1);
      const auto moved = [&](double by) {
        EllipticContact near = contact;
        near.creepage.*members[k] += by;
        return precise.differentiate(rolling_problem(near)).solution.forces();
      };
      const ContactForces plus = moved(step), minus = moved(-step);
      const double x = (plus.fx - minus.fx) / (2 * step) - d.jacobian[0][k];
      const double y = (plus.fy - minus.fy) / (2 * step) - d.jacobian[1][k];
      const double z = (plus.mz - minus.mz) / (2 * step) - d.jacobian[2][k];
      const double column = std::hypot(d.jacobian[0][k], d.jacobian[1][k], d.jacobian[2][k] / length);
      worst = std::max(worst, std::hypot(x, y, z / length) / column);
    }
    errors.push_back(worst);
  }
  std::sort(errors.begin(), errors.end());
  std::printf("%zu cases at %d x %d: derivatives less differences of forces, of a column's size:\n"
              "  median %.1e, 90 %% %.1e (wanted: <= 1e-5)\n",
              errors.size(), n, n, errors[errors.size() / 2], errors[errors.size() * 9 / 10]);
}

/// Every so many-th case that adheres and slides: forces given for creepages given, derivatives for forces.
void forces_and_derivatives(int n, std::size_t stride) {
  Solver solver({.mx = n, .my = n});
  const auto contacts = validation::test_set_contacts();
  double by_creepage = 0, by_force = 0, derivatives = 0;
  long products = 0, more_products = 0;
  int count = 0;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    const EllipticContact& contact = contacts[i];
    const double limit = contact.friction.static_coefficient() * contact.normal_force;
    auto start = processor_time();
    const ContactSolution solution = solver.solve(rolling_problem(contact));
    const ContactForces forces = solution.forces();
    const double time = (processor_time() - start), size = std::hypot(forces.fx, forces.fy);
    if (size < 1e-3 * limit || size > 0.99 * limit) continue;
    by_creepage += time;
    products += solution.report.products;
    start = processor_time();
    solver.solve(rolling_problem(contact, {.force_x = forces.fx, .force_y = forces.fy}));
    by_force += (processor_time() - start);
    start = processor_time();
    more_products += solver.differentiate(rolling_problem(contact)).products;
    derivatives += (processor_time() - start);
    ++count;
  }
  std::printf("%d cases at %d x %d: creepages given %.2f ms and %.1f products\n"
              "  forces given / creepages given %.2f (wanted: <= 1.5)\n"
              "  forces with derivatives / forces %.2f (wanted: <= 2), the three systems %.1f products\n",
              count, n, n, 1e3 * by_creepage / count, double(products) / count, by_force / by_creepage,
              derivatives / by_creepage, double(more_products) / count);
}

} // namespace

int main(int argc, char** argv) {
  growing_grids(argc > 1 ? std::atoi(argv[1]) : 401);
  test_set(12, 1);
  test_set(24, 5);
  for (const int n : {12, 24, 48}) forces_and_derivatives(n, 7);
  for (const int n : {96, 192}) forces_and_derivatives(n, 140);
  derivative_errors(16);
}
