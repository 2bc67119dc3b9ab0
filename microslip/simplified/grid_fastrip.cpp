#include "microslip/simplified/grid_fastrip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip {
namespace {

/// All tractions at their bound, in the direction that FASTSIM has found.
void slide_all(const StripRow& row) {
  for (std::size_t k = 0; k < row.px.size(); ++k) {
    const double size = std::hypot(row.px[k], row.py[k]);
    if (!(size > 0)) continue;
    row.px[k] *= row.bound[k] / size;
    row.py[k] *= row.bound[k] / size;
    row.state[k] = CellState::slip;
  }
}

/// Strip theory in a run of elements.
void take_strips(const ElementGrid& grid, FastripForm form, const EllipticContact& ellipse, double friction,
                 const GridRolling& rolling, const ElementRun& run, SurfaceFields& f) {
  std::vector<double> x;
  x.reserve(static_cast<std::size_t>(run.count));
  for (int n = 0; n < run.count; ++n) x.push_back(grid.x(run.first + n) - rolling.spin_centre.x);
  const auto part = [&](auto& field) {
    return std::span(field).subspan(static_cast<std::size_t>(run.row) * grid.mx + run.first, x.size());
  };
  const double y = grid.y(run.row), length = x.back() - x.front() + grid.dx;
  const double half_length =
      form == FastripForm::modified ? length / 2 : ellipse.a * std::sqrt(std::max(0.0, 1 - std::pow(y / ellipse.b, 2)));
  const StripRow row = {y - rolling.spin_centre.y,
                        (x.front() + x.back()) / 2,
                        half_length,
                        x,
                        part(f.bound),
                        part(f.traction.x),
                        part(f.traction.y),
                        part(f.slip.x),
                        part(f.slip.y),
                        part(f.state)};
  const StripTheory theory(ellipse, friction, rolling.direction);
  const bool all_slides = form == FastripForm::first_bounded && std::abs(theory.scaled_spin()) >= 1;
  all_slides ? slide_all(row) : theory.solve(row);
}

/// Factor of the forces.
double force_factor(FastripForm form, const EllipticContact& ellipse, double friction, const Totals& totals) {
  const double ratio = ellipse.a / ellipse.b;
  if (form == FastripForm::modified || !(ratio < 1)) return 1;
  const double factor = 1 + std::pow(1 - ratio, 4);
  const double limit = friction * ellipse.normal_force, force = std::hypot(totals.fx, totals.fy);
  return form == FastripForm::first ? factor : std::clamp(limit / force, 1.0, factor);
}

} // namespace

ContactSolution solve_fastrip(const GridFastsim& fastsim, FastripForm form, const EllipticContact& ellipse,
                              const Flexibilities& flexibilities, std::span<const double> friction,
                              const GridRolling& rolling) {
  ContactSolution s = fastsim.solve(flexibilities, friction, rolling);
  for (const ElementRun& run : fastsim.runs()) {
    const double mu = friction.size() == 1 ? friction[0] : friction[run.row];
    if (mu > 0) take_strips(fastsim.grid(), form, ellipse, mu, rolling, run, s.fields);
  }
  find_totals(flexibilities, rolling, s);
  const double mean = std::accumulate(friction.begin(), friction.end(), 0.0) / static_cast<double>(friction.size());
  const double factor = force_factor(form, ellipse, mean, s.totals);
  for (double* total : {&s.totals.fx, &s.totals.fy, &s.totals.mz, &s.totals.power_by_creepage}) *total *= factor;
  return s;
}

} // namespace microslip
