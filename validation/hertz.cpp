#include "validation/studies.hpp"

#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array grids = {12, 24, 48, 96};
/// An error depends on how the elements fit the ellipse's edge; the root mean square of ten grids that are shifted by
/// parts of an element does so less.
constexpr int shifts = 10;
constexpr CombinedMaterial steel = {82e9, 0.28, 0};
constexpr double semi_axis_a = 5e-3, semi_axis_b = 8e-3, normal_force = 80e3;

/// Relative errors, with their sign.
struct Errors {
  double load, peak;    ///< with the approach given
  double approach;      ///< with the load given
  double peak_of_force; ///< the same
};

Errors errors_on(const HertzContact& contact, int n, int shift) {
  auto grid = ElementGrid::across_ellipse(contact.a, contact.b, n, 3);
  grid.x0 += grid.dx * shift / shifts;
  grid.y0 += grid.dy * (3 * shift % shifts) / shifts;
  NormalProblem problem(steel, grid);
  const std::vector<double> gap = hertzian_gap(contact.gap, grid);
  const NormalSolution by_approach = problem.solve(gap, {NormalLoad::Given::approach, contact.approach}, 1e-10);
  const NormalSolution by_force = problem.solve(gap, {NormalLoad::Given::force, contact.normal_force}, 1e-10);
  return {by_approach.normal_force / contact.normal_force - 1, by_approach.peak_pressure / contact.peak_pressure - 1,
          by_force.approach / contact.approach - 1, by_force.peak_pressure / contact.peak_pressure - 1};
}

struct Quantity {
  std::string_view name;
  double Errors::*error;
};
constexpr Quantity quantities[] = {
    {"load, approach given", &Errors::load},
    {"peak pressure, approach given", &Errors::peak},
    {"approach, load given", &Errors::approach},
    {"peak pressure, load given", &Errors::peak_of_force},
};

using Table = std::array<std::array<Errors, shifts>, grids.size()>;

double rms(const std::array<Errors, shifts>& row, double Errors::*error) {
  double sum = 0;
  for (const Errors& e : row) sum += e.*error * e.*error;
  return std::sqrt(sum / shifts);
}

void report_quantity(Report& report, const Quantity& quantity, const Table& table) {
  std::string single = fmt::format("{:<12}", "centred"), spread = fmt::format("{:<12}", "rms of ten");
  std::string ratios = fmt::format("{:<12}{:>11}", "ratios", "");
  double before = 0;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const double mean = rms(table[g], quantity.error);
    single += fmt::format(" {:>+10.2e}", table[g][0].*quantity.error);
    spread += fmt::format(" {:>10.2e}", mean);
    if (g > 0) ratios += fmt::format(" {:>10.2f}", before / mean);
    before = mean;
  }
  for (const auto& line : {single, spread, ratios}) report.line(line);
  const double halvings = std::log2(double(grids.back()) / grids.front());
  const double order = std::log2(rms(table[0], quantity.error) / before) / halvings;
  report.figure("mean order over the halvings", fmt::format("{:.2f}", order), "2", order >= 1.8);
}

/// Products that the normal problem takes to 1e-8 at some numbers of elements across, for ellipses of nine shapes, with
/// the load and with the approach given.
bool report_products(Report& report, const Progress& progress) {
  constexpr std::array sizes = {12, 17, 24, 33, 48, 67, 95, 131, 137, 201, 401};
  constexpr std::array ratios = {0.1, 0.2, 0.33, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0};
  constexpr long wanted = 40;
  report.heading("products with the matrix and its near inverse, ellipses of a/b = 0.1 to 10, load or approach given");
  long most = 0;
  int done = 0;
  for (const int n : sizes) {
    long least_here = std::numeric_limits<long>::max(), most_here = 0;
    for (const double ratio : ratios) {
      const HertzContact contact = hertz_from_ellipse(semi_axis_a, semi_axis_a / ratio, steel, normal_force);
      const auto grid = ElementGrid::across_ellipse(contact.a, contact.b, n, n, 3);
      NormalProblem problem(steel, grid);
      const std::vector<double> gap = hertzian_gap(contact.gap, grid);
      for (const NormalLoad& load : {NormalLoad{NormalLoad::Given::approach, contact.approach},
                                     NormalLoad{NormalLoad::Given::force, contact.normal_force}}) {
        const long products = problem.solve(gap, load).products;
        least_here = std::min(least_here, products);
        most_here = std::max(most_here, products);
      }
    }
    report.line(fmt::format("{:>5} elements across: {} to {}", n, least_here, most_here));
    most = std::max(most, most_here);
    if (progress && !progress(++done / double(sizes.size()))) return false;
  }
  report.figure("most products", std::to_string(most), fmt::format("<= {}", wanted), most <= wanted);
  return true;
}

} // namespace

bool run_hertz(const StudyOptions& options, std::ostream& out) {
  const HertzContact contact = hertz_from_ellipse(semi_axis_a, semi_axis_b, steel, normal_force);
  const Progress errors = part_of(options.progress, 0, 0.3);
  Table table{};
  int done = 0;
  for (std::size_t g = 0; g < grids.size(); ++g)
    for (int k = 0; k < shifts; ++k) {
      table[g][k] = errors_on(contact, grids[g], k);
      if (errors && !errors(++done / (shifts * double(grids.size())))) return false;
    }

  Report report(out, options.figures);
  report.line(fmt::format("a = {} mm, b = {} mm, Fn = {} kN, steel; relative errors on {}, {}, {}, {} elements across",
                          semi_axis_a * 1e3, semi_axis_b * 1e3, normal_force / 1e3, grids[0], grids[1], grids[2],
                          grids[3]));
  report.line("one centred grid, and the root mean square over ten shifted by parts of an element, which is judged");
  report.line("load and approach on a single grid depend on how its elements fit the edge, their ratios are uneven");
  for (const Quantity& quantity : quantities) {
    report.heading(quantity.name);
    report_quantity(report, quantity, table);
  }
  return report_products(report, part_of(options.progress, 0.3, 1)) && report.all_as_stated();
}

} // namespace microslip::validation
