#include "validation/rollers.hpp"

#include "microslip/elasticity/layered_response.hpp"
#include "microslip/rolling/nip.hpp"
#include "validation/plane_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

const LayeredBody rigid_body = {{}, {{std::numeric_limits<double>::infinity(), 0}}};
constexpr RollerRadii radii = {0.1, HUGE_VAL};
constexpr double radius = 0.1, length = 1; // relative [m]; of the rollers [m]

/// A rigid roller on a cover bonded to a rigid plane core, `across` elements along 2 a and a margin.
RollingProblem roller_on(const LayeredBody& cover, double a, int across) {
  RollingProblem p;
  p.geometry = GapFormula{ElementGrid::across_line(a, across, across / 8, length),
                          [](double x, double) { return x * x / (2 * radius); }};
  p.layered = LayeredBodies{rigid_body, cover, 1};
  p.friction.law = FrictionLaw::coulomb(0);
  return p;
}

/// The solution by a method that is accurate enough; one that is not found is reported.
ContactSolution solve(Report& report, const RollingProblem& p) {
  ContactSolution s = Solver({.theory = Theory::exact, .tolerance = 1e-8}).solve(p);
  if (s.report.status != Status::ok) report.figure("  status", to_string(s.report.status), "ok", false);
  return s;
}

LayeredBody cover_of(double thickness, const ViscoelasticMaterial& material) {
  return {{{thickness, material}}, rigid_body.substrate};
}

double force_of(const ContactSolution& s) {
  double sum = 0;
  for (const double p : s.fields.pressure) sum += p;
  return sum * s.elements.grid.element_area();
}

/// The limit of no thickness by the last two of thicknesses that are halved, for a rest of the given order.
double without_thickness(double before, double here, int order) {
  const double ratio = std::exp2(order);
  return (ratio * here - before) / (ratio - 1);
}

struct ThinLayer {
  const char* name;
  Material material;
  double indentation;     ///< over a^2/R
  int order;              ///< of the rest in h/a
  double force, pressure; ///< over those of the closed form with G = h = 1 and a^2/R = a = 1
  int power;              ///< of a/h in both
};

/// Johnson (1985), section 5.8, bonded layers: a compressible one is a bed of springs, p = M (a^2 - x^2)/(2 R h) with M
/// = 2 G (1 - nu)/(1 - 2 nu), an incompressible one flows along, p = G (a^2 - x^2)^2/(8 R h^3).
void report_thin_layer(Report& report, const ThinLayer& layer) {
  constexpr double a = 4e-3;
  const double g = layer.material.shear_modulus;
  double force_before = 0, force = 0, pressure_before = 0, pressure = 0;
  for (const double ratio : {0.2, 0.1, 0.05}) {
    const double h = ratio * a;
    RollingProblem p = roller_on(cover_of(h, {layer.material}), a, 400);
    p.load = {NormalLoad::Given::approach, layer.indentation * a * a / radius};
    const ContactSolution s = solve(report, p);
    const double unit = g * a / radius * std::pow(1 / ratio, layer.power);
    force_before = std::exchange(force, force_of(s) / (layer.force * unit * a * length));
    pressure_before = std::exchange(pressure, s.totals.peak_pressure / (layer.pressure * unit));
    report.line(
        fmt::format("  {}, h = {:4} a: force {:.4f}, largest pressure {:.4f}", layer.name, ratio, force, pressure));
  }
  report.near("  of no thickness, extrapolated: force", "{:.4f}", without_thickness(force_before, force, layer.order),
              "1", 1e-2);
  report.near("    largest pressure", "{:.4f}", without_thickness(pressure_before, pressure, layer.order), "1", 1e-2);
}

void report_thin_layers(Report& report) {
  report.heading(
      "A rigid roller on thin layers on a rigid core, line contact: over the closed forms, Johnson 1985, 5.8");
  constexpr double nu = 0.3, m = 2 * (1 - nu) / (1 - 2 * nu);
  report_thin_layer(report, {"nu = 0.3", {1e6, nu}, 0.5, 1, 2.0 / 3 * m, 0.5 * m, 1});
  report_thin_layer(report, {"nu = 0.5", {1e6, 0.5}, 1.0 / 6, 2, 2.0 / 15, 1.0 / 8, 3});
}

struct FreeNip {
  Nip nip;
  double overdrive; ///< how much faster the rigid roller turns than the cover, to first order the creepage [-]
};

/// A rigid roller without torque on a driven cover.
FreeNip roll_freely(Report& report, const LayeredBody& cover, double a, double force, double friction) {
  Solver solver({.theory = Theory::exact, .tolerance = 1e-8});
  RollingProblem p = roller_on(cover, a, 200);
  p.load = {NormalLoad::Given::force, force * length};
  p.friction.law = FrictionLaw::coulomb(friction);
  const FreeRoller rigid = roll_without_torque(solver, p, radii, Roller::body1);
  const Status status = rigid.solution.report.status;
  if (status != Status::ok) report.figure("  status", to_string(status), "ok", false);
  return {nip_of(p, rigid.solution, radii), -rigid.creepage};
}

void report_covers(Report& report) {
  report.heading("A rigid roller on a cover on a rigid core, mu = 0.001 and 10: computed, plane-strain Fourier series");
  constexpr double a = 4e-3, g = 1e6, unit = a / radius;
  for (const double nu : {0.3, 0.5})
    for (const double ratio : {2.0, 1.0, 0.5, 0.25}) {
      const LayeredBody cover = cover_of(ratio * a, {{g, nu}});
      const PlaneNip exact = press({g, nu, ratio * a}, radius, a, 200);
      const auto [nip, overdrive] = roll_freely(report, cover, a, exact.force, 1e-3);
      const auto figure = [&](const char* name, double found, double expected) {
        report.near(name, "{:.4f}", found, "{:.4f}", expected, 2e-3 * std::max(1.0, std::abs(expected)));
      };
      report.near(fmt::format("nu = {}, h = {:4} a: half-width [a]", nu, ratio), "{:.3f}", nip.width / (2 * a), "1",
                  0.011);
      figure("  indentation [a^2/R]", nip.indentation / (a * unit), exact.approach / (a * unit));
      figure("  largest pressure [G a/R]", nip.peak_pressure / (g * unit), exact.pressure.front() / (g * unit));
      report.near("  overdrive of the rigid roller [a/R]", "{:+.4f}", overdrive / unit, "{:+.4f}",
                  exact.overdrive() / unit, 3e-3 * std::max(1.0, std::abs(exact.overdrive() / unit)));
      const StickingNip sticking = stick({g, nu, ratio * a}, radius, exact.force, a, 100);
      const FreeNip rough = roll_freely(report, cover, a, exact.force, 10);
      figure("  sticking, mu = 10: indentation [a^2/R]", rough.nip.indentation / (a * unit),
             sticking.approach / (a * unit));
      report.near("    overdrive [a/R]", "{:+.4f}", rough.overdrive / unit, "{:+.4f}", sticking.overdrive / unit, 0.01);
      const auto with = [&](double friction) {
        return roll_freely(report, cover, a, exact.force, friction).overdrive / unit;
      };
      report.line(fmt::format("    with mu = 0.1: {:+.4f}, 0.3: {:+.4f}, 1: {:+.4f}", with(0.1), with(0.3), with(1)));
    }
}

/// An incompressible cover, thin beside the nip, that slips all over: 1.144 times the indentation over the thickness,
/// by p = G (a^2 - x^2)^2/(8 R h^3) and the stretch 3 (a^2/3 - x^2)/(4 R h).
void report_thin_overdrive(Report& report) {
  report.heading("Overdrive by a thin incompressible cover over indentation/thickness, mu = 0.001");
  constexpr double a = 4e-3, g = 1e6;
  double before = 0, here = 0;
  for (const double ratio : {0.4, 0.2, 0.1}) {
    const double force = press({g, 0.5, ratio * a}, radius, a, 100).force;
    const auto [nip, overdrive] = roll_freely(report, cover_of(ratio * a, {{g, 0.5}}), a, force, 1e-3);
    before = std::exchange(here, overdrive / nip.body2.strain);
    report.line(fmt::format("  h = {} a: {:.4f}", ratio, here));
  }
  report.near("of no thickness, extrapolated", "{:.4f}", without_thickness(before, here, 2), "1.144", 0.01);
}

/// A thin viscoelastic layer as springs side by side with one relaxation, M(t)/h = k (1 - g (1 - exp(-t/tau))), l = V
/// tau, pressed in by a roller from x = a on.
struct Springs {
  double stiffness, share, length; ///< k [Pa/m]; g [-]; l [m]

  double pressure(double x, double a) const {
    const double l = length, pressed = (a * a - x * x) / 2,
                 remembered = l * (x + l) - l * (a + l) * std::exp(-(a - x) / l);
    return stiffness * ((1 - share) * pressed + share * remembered) / radius;
  }
};

struct Resultant {
  double force, moment; ///< [N/m]; about the middle [N]
};

/// The sum over the nip, behind whose end the layer has not yet come back.
Resultant resultant_of(const Springs& springs, double a) {
  constexpr int n = 100'000;
  const double d = 2 * a / n;
  Resultant sum{};
  for (int i = 0; i < n; ++i) {
    const double x = a - (i + 0.5) * d, p = springs.pressure(x, a);
    if (p <= 0) break;
    sum.force += p * d, sum.moment += p * x * d;
  }
  return sum;
}

void report_rolling_resistance(Report& report) {
  report.heading("Rolling resistance of thin viscoelastic layers, nu = 0.3, G relaxes by 0.6, over that of springs");
  constexpr double a = 4e-3, nu = 0.3, share = 0.6;
  for (const double time : {0.1, 1.0, 10.0}) { // V tau over a
    double force_before = 0, force = 0, resistance_before = 0, resistance = 0;
    for (const double ratio : {0.2, 0.1}) {
      const ViscoelasticMaterial material = {{1e9, nu}, {{share, time * a}}};
      const double modulus = material.instantaneous.shear_modulus * 2 * (1 - nu) / (1 - 2 * nu);
      const Resultant springs = resultant_of({modulus / (ratio * a), share, time * a}, a);
      RollingProblem p = roller_on(cover_of(ratio * a, material), a, 400);
      p.load = {NormalLoad::Given::approach, a * a / (2 * radius)};
      const ContactSolution s = solve(report, p);
      force_before = std::exchange(force, force_of(s) / (springs.force * length));
      resistance_before =
          std::exchange(resistance, nip_of(p, s, radii).rolling_resistance / (springs.moment / radius * length));
      report.line(
          fmt::format("  V tau = {} a, h = {} a: force {:.4f}, resistance {:.4f}", time, ratio, force, resistance));
    }
    report.near("  of no thickness, extrapolated: force", "{:.4f}", without_thickness(force_before, force, 1), "1",
                1e-2);
    report.near("    rolling resistance", "{:.4f}", without_thickness(resistance_before, resistance, 1), "1", 1e-2);
  }
}

/// Wang & Knothe's cylinders as CONTACT's guide has them, section 5.4: creep with f = 1, whose relaxation has g = f/(1
/// + f) and the relaxation time T/(1 + f).
struct Cylinders {
  double time; ///< T [s]
  double peak, creepage, power;
  int contact, adhesion;
};
constexpr std::array cylinders = {
    Cylinders{0.009, 78.74, 1.365e-2, 913.7, 62, 37},
    Cylinders{0.045, 84.72, 1.152e-2, 952.0, 57, 36},
    Cylinders{2, 85.31, 9.932e-3, 1010, 56, 35},
};

RollingProblem rolling_of(const Cylinders& c) {
  const LayeredBody polymer = {{}, {{1143e6, 0.4}, {{0.5, 0.5 * c.time}}}};
  ElementGrid grid = {99, 1, -7.92e-3, 0, 0.16e-3, length};
  grid.line = true;
  RollingProblem p;
  p.geometry = GapFormula{grid, [](double x, double) { return 10 * x * x; }};
  p.layered = LayeredBodies{polymer, polymer, 1};
  p.load = {NormalLoad::Given::force, 600e3 * length};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.force_x = -0.6 * 0.3 * p.load.value;
  return p;
}

/// -V sum of p s dx dy, the power as CONTACT sums it.
double power_over_elements(const ContactSolution& s) {
  double sum = 0;
  for (std::size_t k = 0; k < s.elements.size(); ++k)
    sum -= s.fields.traction.x[k] * s.fields.slip.x[k] * s.elements.area[k];
  return sum;
}

void report_cylinders(Report& report) {
  report.heading("Wang and Knothe's cylinders by relaxation, 99 x 1 elements, 1 m/s: computed, CONTACT");
  for (const Cylinders& c : cylinders) {
    const RollingProblem p = rolling_of(c);
    const ContactSolution s = solve(report, p);
    const Nip nip = nip_of(p, s, {0.1, 0.1});
    report.near(fmt::format("T = {} s: peak pressure [N/mm2]", c.time), "{:.2f}", s.totals.peak_pressure * 1e-6,
                "{:.2f}", c.peak, 0.015);
    report.near("  creepage", "{:.4e}", s.creepage.longitudinal, "{:.3e}", c.creepage, 2e-3 * c.creepage);
    report.near("  frictional power over the elements [W]", "{:.1f}", power_over_elements(s), "{:.1f}", c.power,
                2e-3 * c.power);
    report.count("  elements in contact", std::lround(nip.width / s.elements.grid.dx), c.contact);
    report.count("    in adhesion", std::count(s.fields.state.begin(), s.fields.state.end(), CellState::adhesion),
                 c.adhesion);
    report.line(fmt::format("  rolling resistance {:.0f} N, drives {:.0f} and {:.0f} N", nip.rolling_resistance,
                            nip.body1.drive, nip.body2.drive));
  }
}

} // namespace

void report_rollers(Report& report) {
  report_thin_layers(report);
  report_covers(report);
  report_thin_overdrive(report);
  report_rolling_resistance(report);
  report_cylinders(report);
}

} // namespace microslip::validation
