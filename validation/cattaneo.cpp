#include "validation/studies.hpp"

#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array grids = {15, 31, 63, 127};
constexpr double shear_modulus = 200e6, poisson_ratio = 0.42, friction = 0.4;
constexpr double radius = 1e-3, normal_force = 9.1954, force_share = 0.875;
/// c = a (1 - F/(mu Fn))^(1/3) of the adhesion area.
constexpr double adhesion_radius = 0.5e-3;

/// Mindlin's shift of two equal bodies, 3 mu Fn (2 - nu)/(8 G a) (1 - (1 - F/(mu Fn))^(2/3)) (Johnson 1985,
/// section 7.2).
double mindlin_shift(double nu) {
  return 3 * friction * normal_force * (2 - nu) / (8 * shear_modulus * radius) *
         (1 - std::pow(1 - force_share, 2.0 / 3));
}

/// Cattaneo's tractions: mu p0 sqrt(1 - (r/a)^2), less mu p0 c/a sqrt(1 - (r/c)^2) within c.
double cattaneo_traction(double r, double peak_pressure) {
  const auto hemisphere = [r](double c) { return r < c ? std::sqrt(1 - r * r / (c * c)) : 0.0; };
  return friction * peak_pressure * (hemisphere(radius) - adhesion_radius / radius * hemisphere(adhesion_radius));
}

struct Outcome {
  NormalSolution normal;
  ContactSolution shifted;
  double adhesion; ///< radius of the adhesion area over that of the contact area
  double turning;  ///< rms of the slip across the force over rms of the slip along it
};

/// Shifts by the force in steps of equal size.
Outcome shift(int n, double nu, int steps = 1) {
  const CombinedMaterial material = {shear_modulus, nu, 0};
  const GapCurvatures gap = hertz_from_ellipse(radius, radius, material, normal_force).gap;
  HertzianSolve contact(material, ElementGrid::across_ellipse(radius, radius, n, 2), gap, normal_force);
  ContactSolution s;
  double total = 0;
  for (int k = 1; k <= steps; ++k) {
    TangentialInput input;
    input.motion = ContactMotion::shift;
    input.force_x = -force_share * friction * normal_force * k / steps;
    input.tolerance = 1e-9;
    const VectorField before = s.fields.traction;
    input.previous = &before;
    input.start = before.x.empty() ? nullptr : &before;
    s = contact.solve(friction, input);
    total += s.creepage.longitudinal;
  }
  s.creepage.longitudinal = total;
  const double adhesion = std::sqrt(double(count(s, CellState::adhesion)) / contact.normal().contact_elements);
  double along = 0, across = 0;
  const auto& [sx, sy] = s.fields.slip;
  for (std::size_t k = 0; k < sx.size(); ++k) along += sx[k] * sx[k], across += sy[k] * sy[k];
  return {contact.normal(), std::move(s), adhesion, std::sqrt(across / along)};
}

/// What Cattaneo's tractions do where they should.
struct ClosedFormCheck {
  double shift;   ///< mean of -ux in the adhesion area [m]
  double spread;  ///< largest difference from it there, of both components, over it
  double turning; ///< in the slip area: rms of the slip across the tractions over rms of that along them
};

ClosedFormCheck check_closed_form(int n) {
  const CombinedMaterial material = {shear_modulus, poisson_ratio, 0};
  const double peak = hertz_from_ellipse(radius, radius, material, normal_force).peak_pressure;
  const auto grid = ElementGrid::across_ellipse(radius, radius, n);
  std::vector<double> px(grid.count()), py(grid.count()), ux(grid.count()), uy(grid.count()), r(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      r[k] = std::hypot(grid.x(i), grid.y(j));
      px[k] = -cattaneo_traction(r[k], peak);
    }
  TangentialOperator::displacement(material, grid).apply(px, py, ux, uy);
  double sum = 0, inside = 0;
  for (std::size_t k = 0; k < r.size(); ++k)
    if (r[k] < adhesion_radius) sum -= ux[k], ++inside;
  ClosedFormCheck check{sum / inside, 0, 0};
  double along = 0, across = 0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    const double sx = ux[k] + check.shift, sy = uy[k];
    if (r[k] < adhesion_radius)
      check.spread = std::max(check.spread, std::hypot(sx, sy) / check.shift);
    else if (r[k] < radius)
      along += sx * sx, across += sy * sy;
  }
  check.turning = std::sqrt(across / along);
  return check;
}

std::string millimetres(double length) {
  return fmt::format("{:.5e}", length * 1e3);
}

void report_first_grid(Report& report, const Outcome& o) {
  report.heading("15 elements across: computed, CONTACT");
  const int contact = o.normal.contact_elements, adhering = count(o.shifted, CellState::adhesion);
  const double peak = o.normal.peak_pressure * 1e-6, shift_mm = o.shifted.creepage.longitudinal * 1e3;
  report.count("elements in contact", contact, 177);
  report.count("elements in adhesion", adhering, 45);
  report.near("peak pressure [N/mm2]", "{:.4f}", peak, "4.393", 5e-4);
  report.near("approach [mm]", "{:.5f}", o.normal.approach * 1e3, "0.01998", 5e-6);
  report.near("shift [mm]", "{:.4e}", shift_mm, "8.155e-3", 5e-7);
  const double work = o.shifted.totals.frictional_power;
  report.near("frictional work [J]", "{:.4e}", work, "2.750e-6", 5e-10);
}

void report_closed_form(Report& report, const std::array<Outcome, grids.size()>& outcomes, const Outcome& isotropic) {
  report.heading("Elements across, peak pressure [N/mm2], approach [mm], shift [mm], adhesion radius over a");
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const Outcome& o = outcomes[g];
    report.line(fmt::format("{:>4}  {:.4f}  {:.6f}  {:.5e}  {:.4f}", grids[g], o.normal.peak_pressure * 1e-6,
                            o.normal.approach * 1e3, o.shifted.creepage.longitudinal * 1e3, o.adhesion));
  }
  const Outcome& fine = outcomes.back();
  const HertzContact hertz = hertz_from_ellipse(radius, radius, {shear_modulus, poisson_ratio, 0}, normal_force);
  const double peak = hertz.peak_pressure * 1e-6, fine_peak = fine.normal.peak_pressure * 1e-6;
  report.figure("peak pressure [N/mm2], closed form", fmt::format("{:.4f}", fine_peak), fmt::format("{:.4f}", peak),
                std::abs(fine_peak / peak - 1) <= 1e-3);
  report.figure("approach [mm], closed form", fmt::format("{:.6f}", fine.normal.approach * 1e3),
                fmt::format("{:.6f}", hertz.approach * 1e3),
                std::abs(fine.normal.approach / hertz.approach - 1) <= 1e-4);
  report.near("adhesion radius over a, nu = 0, closed form", "{:.4f}", isotropic.adhesion, "0.5", 0.002);
  report.remark("the same, nu = 0.42", fmt::format("{:.4f}", fine.adhesion), "0.5", "the closed form is not exact");
}

double shift_limit(const Outcome& coarse, const Outcome& fine) {
  return limit(coarse.shifted.creepage.longitudinal, grids[grids.size() - 2], fine.shifted.creepage.longitudinal,
               grids.back(), 2);
}

void report_shift(Report& report, double computed, double isotropic, double in_steps, double turning) {
  report.heading("Shift [mm], extrapolated from the last two grids: computed, Mindlin's closed form");
  const double without = mindlin_shift(0), with = mindlin_shift(poisson_ratio);
  report.figure("nu = 0, where the closed form is exact", millimetres(isotropic), millimetres(without),
                std::abs(isotropic / without - 1) <= 2e-4);
  report.remark("nu = 0.42", millimetres(computed), millimetres(with),
                fmt::format("{:+.2f} %, not exact there", 100 * (computed / with - 1)));
  const ClosedFormCheck check = check_closed_form(grids.back());
  report.line("Cattaneo's tractions, applied as they are with nu = 0.42:");
  report.figure("  shift in their adhesion area", millimetres(check.shift), millimetres(with),
                std::abs(check.shift / with - 1) <= 1e-3);
  report.figure("  largest deviation from it there, relative", fmt::format("{:.1e}", check.spread), "0",
                check.spread <= 2e-3);
  report.remark("  slip across the tractions over slip along them, rms", fmt::format("{:.3f}", check.turning), "0",
                "not 0: no solution of the problem with friction");
  report.remark("slip across the force over slip along it, computed", fmt::format("{:.3f}", turning), "",
                "tractions follow it");
  report.remark("the force put on in 8 steps, 127 elements", millimetres(in_steps), millimetres(computed),
                "beside the limit in one step");
}

} // namespace

bool run_cattaneo(const StudyOptions& options, std::ostream& out) {
  const auto stopped = [&](double fraction) { return options.progress && !options.progress(fraction); };
  std::array<Outcome, grids.size()> outcomes, isotropic;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    outcomes[g] = shift(grids[g], poisson_ratio);
    isotropic[g] = shift(grids[g], 0);
    if (stopped(0.6 * double(g + 1) / double(grids.size()))) return false;
  }
  const double in_steps = shift(grids.back(), poisson_ratio, 8).shifted.creepage.longitudinal;
  if (stopped(1)) return false;

  const std::size_t last = grids.size() - 1;
  const double computed = shift_limit(outcomes[last - 1], outcomes[last]);
  Report report(out, options.figures);
  report_first_grid(report, outcomes[0]);
  report_closed_form(report, outcomes, isotropic[last]);
  report_shift(report, computed, shift_limit(isotropic[last - 1], isotropic[last]), in_steps, outcomes[last].turning);
  return report.all_as_stated();
}

} // namespace microslip::validation
