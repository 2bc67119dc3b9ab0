#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/simplified/computed_coefficients.hpp"
#include "validation/report.hpp"
#include "validation/rolling_without_slip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr int numbers = 4;
using Numbers = std::array<double, numbers>;
constexpr std::array<std::string_view, numbers> names = {"C11", "C22", "C23", "C33"};

Numbers numbers_of(const LinearCoefficients& c) {
  return {c.c11, c.c22, c.c23, c.c33};
}
Numbers numbers_of(const CreepageCoefficients& c) {
  return {c.c11, c.c22, c.c23, c.c33};
}

/// Largest relative difference.
double difference(const Numbers& computed, const Numbers& expected) {
  double largest = 0;
  for (int n = 0; n < numbers; ++n) largest = std::max(largest, std::abs(computed[n] / expected[n] - 1));
  return largest;
}

// --- the solver, all elements in adhesion

constexpr std::array solver_ratios = {0.2, 0.5, 1.0, 2.0, 5.0};
constexpr std::array solver_materials = {0.0, 0.25, 0.5};
constexpr std::array solver_grids = {12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 36, 40, 44, 48, 56};

/// What the staircase of elements leaves open between itself and the ellipse's edge, in elements, less half a one:
/// means over the rows with their half-lengths as weights, and with the cubes of these.
struct Gaps {
  double leading = 0, trailing = 0, leading3 = 0, trailing3 = 0;
};

/// The elements with their centres in the ellipse: a bound that is never reached.
std::vector<double> unlimited_bound(const ElementGrid& grid, double a, double b, Gaps& gaps) {
  std::vector<double> bound(grid.count());
  double sum = 0, sum3 = 0;
  for (int j = 0; j < grid.my; ++j) {
    const double half2 = 1 - grid.y(j) * grid.y(j) / (b * b);
    if (half2 <= 0) continue;
    const double half = a * std::sqrt(half2), cube = half * half * half;
    int first = grid.mx, last = -1;
    for (int i = 0; i < grid.mx; ++i)
      if (std::abs(grid.x(i)) < half) {
        bound[static_cast<std::size_t>(j) * grid.mx + i] = 1e6;
        first = std::min(first, i);
        last = i;
      }
    if (last < 0) continue;
    const double leading = (half - grid.x(last)) / grid.dx - 1, trailing = (half + grid.x(first)) / grid.dx - 1;
    gaps.leading += half * leading, gaps.leading3 += cube * leading;
    gaps.trailing += half * trailing, gaps.trailing3 += cube * trailing;
    sum += half, sum3 += cube;
  }
  gaps.leading /= sum, gaps.trailing /= sum, gaps.leading3 /= sum3, gaps.trailing3 /= sum3;
  return bound;
}

/// Coefficients on a grid whose elements begin `shift` elements from the ellipse's edge; a b = 1, G = 1.
Numbers solve_without_slip(double a_over_b, double nu, int across, double shift, Gaps& gaps, bool& converged) {
  const double a = std::sqrt(a_over_b), b = 1 / a;
  auto grid = ElementGrid::across_ellipse(a, b, across, 3);
  grid.x0 += shift * grid.dx;
  const std::vector<double> bound = unlimited_bound(grid, a, b, gaps);
  TangentialProblem problem(CombinedMaterial{1, nu, 0}, grid);
  const auto forces = [&](const Creepage& creepage) {
    TangentialInput input;
    input.creepage = creepage;
    input.spin_offset = 0.5;
    input.tolerance = 1e-11;
    const ContactForces f = problem.solve(bound, input).forces();
    converged = converged && f.status == Status::ok && f.slip_area == 0;
    return f;
  };
  const ContactForces xi = forces({1, 0, 0}), eta = forces({0, 1, 0}), phi = forces({0, 0, 1});
  return {-xi.fx, -eta.fy, -phi.fy, -phi.mz};
}

/// The limit of coefficients on many grids: least squares of c0 + c1 h + c2 h^2 + h times the gaps, with the weights of
/// an error that falls as h^3/2.
class Extrapolation {
public:
  void add(int across, const Gaps& g, const Numbers& values) {
    const double h = 1.0 / across, weight = std::pow(h, -3);
    const std::array<double, terms> row = {1, h, h * h, h * g.leading, h * g.trailing, h * g.leading3, h * g.trailing3};
    for (int k = 0; k < terms; ++k) {
      for (int l = 0; l < terms; ++l) matrix_[k][l] += weight * row[k] * row[l];
      for (int n = 0; n < numbers; ++n) sides_[k][n] += weight * row[k] * values[n];
    }
  }

  /// Eliminates from the last term on, so that the constant ones are found first.
  Numbers limit() {
    for (int k = terms; k-- > 1;)
      for (int i = 0; i < k; ++i) {
        const double factor = matrix_[i][k] / matrix_[k][k];
        for (int l = 0; l <= k; ++l) matrix_[i][l] -= factor * matrix_[k][l];
        for (int n = 0; n < numbers; ++n) sides_[i][n] -= factor * sides_[k][n];
      }
    Numbers c;
    for (int n = 0; n < numbers; ++n) c[n] = sides_[0][n] / matrix_[0][0];
    return c;
  }

private:
  static constexpr int terms = 7;
  std::array<std::array<double, terms>, terms> matrix_{};
  std::array<Numbers, terms> sides_{};
};

bool report_solver(Report& report, const Progress& progress) {
  report.heading(
      fmt::format("The solver without slip on {} to {} elements across, extrapolated; relative difference to "
                  "the series",
                  solver_grids.front(), solver_grids.back()));
  report.line(fmt::format("{:>5} {:>5}  {:>8} {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8} {:>8}   as it is on {} elements",
                          "a/b", "nu", "C11", "C22", "C23", "C33", "C11", "C22", "C23", "C33", solver_grids.back()));
  double worst = 0;
  bool converged = true;
  int done = 0;
  for (const double ratio : solver_ratios)
    for (const double nu : solver_materials) {
      Extrapolation extrapolation;
      Numbers last{};
      for (const int across : solver_grids)
        for (const double shift : {0.25, 0.75}) {
          Gaps gaps;
          last = solve_without_slip(ratio, nu, across, shift, gaps, converged);
          extrapolation.add(across, gaps, last);
        }
      const Numbers limit = extrapolation.limit(), exact = numbers_of(rolling_without_slip(ratio, nu, 48));
      std::string line = fmt::format("{:>5} {:>5} ", ratio, nu);
      for (int n = 0; n < numbers; ++n) line += fmt::format(" {:+.1e}", limit[n] / exact[n] - 1);
      line += "  ";
      for (int n = 0; n < numbers; ++n) line += fmt::format(" {:+.1e}", last[n] / exact[n] - 1);
      report.line(line);
      worst = std::max(worst, difference(limit, exact));
      constexpr double cases = solver_ratios.size() * solver_materials.size();
      if (progress && !progress(++done / cases)) return false;
    }
  report.figure("all converge without slip", converged ? "yes" : "no", "yes", converged);
  report.bounded("largest difference", "{:.1e}", worst, "<= 3e-3");
  return true;
}

// --- Kalker's table

/// Half a unit of a printed number's last digit; it has three.
double rounding(double printed) {
  return 0.5 * std::pow(10, std::floor(std::log10(printed) + 1e-9) - 2);
}

bool report_kalker(Report& report, const Progress& progress) {
  report.heading("Kalker's table (1990, E.3): entries that differ from the series by more than their rounding");
  report.line("  a/b    nu        printed     series  difference");
  int entries = 0, differ = 0;
  Numbers worst{};
  for (int k = 1; k <= 19; ++k) {
    const double ratio = k <= 10 ? 0.1 * k : 1 / (0.1 * (20 - k));
    for (const double nu : {0.0, 0.25, 0.5}) {
      const Numbers printed = numbers_of(creepage_coefficients(ratio, nu));
      const Numbers series = numbers_of(rolling_without_slip(ratio, nu, 48));
      for (int n = 0; n < numbers; ++n) {
        ++entries;
        worst[n] = std::max(worst[n], std::abs(printed[n] / series[n] - 1));
        if (std::abs(printed[n] - series[n]) <= rounding(printed[n])) continue;
        ++differ;
        report.line(fmt::format("{:>5.3g} {:>5}   {}  {:>6.3g}  {:>9.5g}  {:>+8.2f} %", ratio, nu, names[n], printed[n],
                                series[n], 100 * (printed[n] / series[n] - 1)));
      }
    }
    if (progress && !progress(k / 19.0)) return false;
  }
  report.line(fmt::format("{} of {} entries", differ, entries));
  for (int n = 0; n < numbers; ++n)
    report.bounded(fmt::format("largest relative difference in {}", names[n]), "{:.1e}", worst[n], "<= 2e-2");
  return true;
}

// --- the computed table

constexpr int ratios = 25, materials = 5;
constexpr int degree = 96, lower_degree = 64;

double ratio_at(double k) {
  return computed_least_ratio * std::pow(computed_largest_ratio / computed_least_ratio, k / (ratios - 1));
}

/// Writes the table as it stands in the library: for C++ to include, and with // as comments for others to read.
bool write_table(Report& report, const StudyOptions& options, const Progress& progress) {
  std::string text = "// Creepage coefficients of linear theory, by microslip validate kalker-coefficients.\n"
                     "// a/b, nu, C11, C22, C23, C33; the largest relative difference to a lower degree is\n";
  std::string rows;
  double error = 0, reciprocity = 0, in_library = 0;
  for (int k = 0; k < ratios; ++k)
    for (int m = 0; m < materials; ++m) {
      const double ratio = ratio_at(k), nu = 0.5 * m / (materials - 1);
      const LinearCoefficients fine = rolling_without_slip(ratio, nu, degree);
      const Numbers c = numbers_of(fine);
      const double uncertainty = difference(numbers_of(rolling_without_slip(ratio, nu, lower_degree)), c);
      error = std::max(error, uncertainty);
      reciprocity = std::max(reciprocity, std::abs(fine.c32 / fine.c23 + 1));
      in_library = std::max(in_library, difference(numbers_of(computed_coefficients(ratio, nu)), c));
      rows += fmt::format("{:.9g}, {}, {:.8g}, {:.8g}, {:.8g}, {:.8g}, // {:.0e}\n", ratio, nu, c[0], c[1], c[2], c[3],
                          uncertainty);
      if (progress && !progress((k * materials + m + 1.0) / (ratios * materials))) return false;
    }
  io::create_folder(options.output);
  io::OutputFile file(options.output / "computed_coefficients.inc");
  file.write(text + "// the comment.\n" + rows);
  file.commit();
  report.heading(fmt::format("The computed table: {} ratios a/b from 0.05 to 20, {} values of nu; series of degree {}",
                             ratios, materials, degree));
  report.bounded(fmt::format("largest relative difference to degree {}", lower_degree), "{:.1e}", error, "<= 1e-5");
  report.bounded("largest difference of -C32 and C23", "{:.1e}", reciprocity, "<= 1e-5");
  report.bounded("table in the library to the one just computed", "{:.1e}", in_library, "<= 1e-7");
  return true;
}

/// Between the entries, where interpolation is worst, and beyond them.
bool report_interpolation(Report& report, const Progress& progress) {
  double worst = 0, kalker = 0;
  for (int k = 0; k < ratios - 1; ++k) {
    for (const double m : {0.5, 1.5, 2.5, 3.5}) {
      const double ratio = ratio_at(k + 0.5), nu = 0.5 * m / (materials - 1);
      const Numbers exact = numbers_of(rolling_without_slip(ratio, nu, lower_degree));
      worst = std::max(worst, difference(numbers_of(computed_coefficients(ratio, nu)), exact));
      kalker = std::max(kalker, difference(numbers_of(creepage_coefficients(ratio, nu)), exact));
    }
    if (progress && !progress((k + 1.0) / ratios)) return false;
  }
  report.bounded("midway between its entries", "{:.1e}", worst, "<= 1e-4");
  report.remark("the same of Kalker's table", fmt::format("{:.1e}", kalker), "", "not judged");
  for (const double ratio : {0.02, 50.0}) {
    double beyond = 0;
    for (const double nu : {0.0, 0.25, 0.5})
      beyond = std::max(beyond, difference(numbers_of(creepage_coefficients(ratio, nu, CreepageTable::computed)),
                                           numbers_of(rolling_without_slip(ratio, nu, degree))));
    report.remark(fmt::format("beyond it, a/b = {}", ratio), fmt::format("{:.1e}", beyond), "", "not judged");
  }
  return true;
}

} // namespace

bool run_kalker_coefficients(const StudyOptions& options, std::ostream& out) {
  io::require_writable_folder(options.output);
  Report report(out, options.figures);
  report.line("C11, C22, C23, C33 without slip, for vanishing creepages");
  const auto part = [&](double begin, double end) { return part_of(options.progress, begin, end); };
  if (!report_kalker(report, part(0, 0.02))) return false;
  if (!report_solver(report, part(0.02, 0.6))) return false;
  if (!write_table(report, options, part(0.6, 0.95))) return false;
  if (!report_interpolation(report, part(0.95, 1))) return false;
  return report.all_as_stated();
}

} // namespace microslip::validation
