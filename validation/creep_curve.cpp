#include "validation/studies.hpp"

#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel = {82e9, 0.28, 0};
constexpr double normal_force = 106.7e3, friction = 0.33, curvature_x = 0.8, axis_ratio = 0.5;
/// The grid of CONTACT's example is 1.1 times as long and wide as the ellipse.
constexpr int columns = 48, rows = 44;
constexpr double scale = 1.1;

struct Point {
  double creepage, published;
};
constexpr std::array curve = {Point{4e-4, .2588},  Point{8e-4, .4742},  Point{12e-4, .6482}, Point{16e-4, .7831},
                              Point{20e-4, .8816}, Point{28e-4, .9832}, Point{40e-4, .9993}};
using Curve = std::array<double, curve.size()>;

/// The ellipse with a/b and A given: its shape is that of any other load, and A a^3 grows with the load.
HertzContact ellipse() {
  const HertzContact unit = hertz_from_ellipse(axis_ratio, 1, steel, normal_force);
  return hertz_from_load({curvature_x, curvature_x * unit.gap.y / unit.gap.x}, steel, normal_force);
}

/// On a grid `refined` times finer.
HertzianSolve contact_on(const HertzContact& hertz, int refined) {
  ElementGrid grid;
  grid.mx = columns * refined;
  grid.my = rows * refined;
  grid.dx = 2 * scale * hertz.a / grid.mx;
  grid.dy = 2 * scale * hertz.b / grid.my;
  grid.x0 = -scale * hertz.a + grid.dx / 2;
  grid.y0 = -scale * hertz.b + grid.dy / 2;
  return HertzianSolve(steel, grid, hertz.gap, normal_force);
}

Curve forces(HertzianSolve& contact) {
  Curve f{};
  ContactSolution s;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    TangentialInput input;
    input.creepage.longitudinal = curve[k].creepage;
    const VectorField start = std::move(s.fields.traction);
    if (!start.x.empty()) input.start = &start;
    s = contact.solve(friction, input);
    f[k] = -s.totals.fx / (friction * normal_force);
  }
  return f;
}

} // namespace

bool run_creep_curve(const StudyOptions& options, std::ostream& out) {
  const HertzContact hertz = ellipse();
  Report report(out, options.figures);
  report.line(fmt::format("a = {:.4f} mm, b = {:.4f} mm, mu = 0.33; -Fx/(mu Fn)", hertz.a * 1e3, hertz.b * 1e3));
  HertzianSolve coarse = contact_on(hertz, 1), fine = contact_on(hertz, 2);
  const int elements = coarse.normal().contact_elements;
  report.count("elements in contact", elements, 1384);
  const double peak = coarse.normal().peak_pressure * 1e-6, approach = coarse.normal().approach * 1e3;
  report.near("peak pressure [N/mm2]", "{:.2f}", peak, "640.7", 0.1);
  report.near("approach [mm]", "{:.5f}", approach, "0.07651", 1e-5);
  const Curve f = forces(coarse);
  if (options.progress && !options.progress(0.15)) return false;
  const Curve f2 = forces(fine);

  report.heading("48 x 44 elements (40 across the ellipse's width): computed, CONTACT on the same grid");
  for (std::size_t k = 0; k < curve.size(); ++k)
    report.near(fmt::format("creepage {:.4f}", curve[k].creepage), "{:.5f}", f[k], "{:.4f}", curve[k].published, 1e-4);
  report.heading("Creepage, 48 x 44, 96 x 88, limit by extrapolation");
  for (std::size_t k = 0; k < curve.size(); ++k)
    report.line(
        fmt::format("{:.4f}  {:.5f}  {:.5f}  {:.5f}", curve[k].creepage, f[k], f2[k], limit(f[k], 1, f2[k], 2)));
  return report.all_as_stated();
}

} // namespace microslip::validation
