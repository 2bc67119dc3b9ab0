#include "microslip/exact/fitted/fitted_problem.hpp"
#include "microslip/exact/fitted/transient_rolling.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/clock.hpp"
#include "validation/report.hpp"
#include "validation/studies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Complex = std::complex<double>;

constexpr int across = 24;
constexpr double tolerance = 1e-12;

/// Steel, with adhesion and slip.
EllipticContact contact() {
  EllipticContact c;
  c.a = 6e-3, c.b = 12e-3;
  c.shear_modulus = 82e9, c.poisson_ratio = 0.28;
  c.normal_force = 82e3, c.rolling_speed = 30;
  c.friction = FrictionLaw::coulomb(0.3);
  c.creepage = {0.6e-3, -0.7e-3, 0.04};
  return c;
}

Solver solver(int elements = across) {
  Method method;
  method.mx = method.my = elements;
  method.tolerance = tolerance;
  return Solver(method);
}

std::array<double, 3> forces_with(const Creepage& creepage) {
  EllipticContact c = contact();
  c.creepage = creepage;
  const Totals t = solver().solve(rolling_problem(c)).totals;
  return {t.fx, t.fy, t.mz};
}

/// The largest difference of the responses at k = 0 from central differences, over the row's largest number.
double error_of_limit() {
  constexpr double step = 1e-4; // of each creepage
  const ForceResponse r = solver().respond(rolling_problem(contact()), std::array{0.0}).at.at(0);
  double most = 0;
  std::array<std::array<double, 3>, 3> differences{};
  const auto number = [](Creepage& c, int of) -> double& {
    return of == 0 ? c.longitudinal : of == 1 ? c.lateral : c.spin;
  };
  for (int of = 0; of < 3; ++of) {
    Creepage less = contact().creepage, more = less;
    const double change = step * std::abs(number(less, of));
    number(less, of) -= change, number(more, of) += change;
    const auto before = forces_with(less), after = forces_with(more);
    for (int k = 0; k < 3; ++k) differences[k][of] = (after[k] - before[k]) / (2 * change);
  }
  for (int k = 0; k < 3; ++k) {
    double size = 0;
    for (int of = 0; of < 3; ++of) size = std::max(size, std::abs(r.by_creepage[k][of]));
    for (int of = 0; of < 3; ++of)
      most = std::max(most, std::abs(r.by_creepage[k][of].real() - differences[k][of]) / size);
  }
  return most;
}

/// Amplitude of Fx per unit of xi, which oscillates by 1e-3 of itself, in transient rolling: from +- the amplitude,
/// over waves of so many elements after three passages.
Complex transient_amplitude(int elements, int steps) {
  const EllipticContact c = contact();
  const FittedContact fitted = fit_ellipse(c.a, c.b, elements, elements, ContactMotion::transient);
  const std::vector<double> bound = friction_bound(fitted, c.friction.static_coefficient() * c.normal_force);
  const double angle = 2 * std::numbers::pi / steps, amplitude = 1e-3 * c.creepage.longitudinal;
  const Complex mean = (1.0 - std::polar(1.0, -angle)) / Complex(0, angle); // over a step
  const int settling = (3 * elements + steps - 1) / steps * steps;
  Complex out = 0;
  for (const double sign : {-1.0, 1.0}) {
    TransientRolling rolling({c.shear_modulus, c.poisson_ratio, 0}, fitted);
    for (int i = 0; i < settling + steps; ++i) {
      SecondOrderInput input;
      input.tolerance = 1e-10;
      input.creepage = c.creepage;
      input.creepage.longitudinal += sign * amplitude * (std::polar(1.0, angle * i) * mean).real();
      const SecondOrderSolution s = rolling.step(bound, input);
      if (i < settling) continue;
      double fx = 0;
      for (std::size_t e = 0; e < bound.size(); ++e)
        fx += fitted.elements[e].width() * fitted.grid.dy * s.friction.traction.x[e];
      out += sign * fx * std::polar(1.0, -angle * i) / (steps * amplitude);
    }
  }
  return out;
}

} // namespace

bool run_response(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      "a = 6 mm, b = 12 mm, steel, Fn = 82 kN, mu = 0.3, xi = 6e-4, eta = -7e-4, phi = 0.04 /m; 24 x 24 elements");
  constexpr int waves = 40;
  std::vector<double> wavenumbers;
  wavenumbers.reserve(waves);
  for (int k = 0; k < waves; ++k)
    wavenumbers.push_back(2 * std::numbers::pi / (10e-3 * std::pow(100.0, k / (waves - 1.0))));
  const double before = thread_time();
  const bool solved = solver().respond(rolling_problem(contact()), wavenumbers).at.size() == wavenumbers.size();
  const double taken = thread_time() - before;
  report.figure("40 wavelengths", solved ? "solved" : "not solved", "solved", solved);
  report.line(
      fmt::format("    {} (wanted: below 1 s)", taken < 1 ? "in less than 1 s" : fmt::format("in {:.2f} s", taken)));
  report.bounded("k = 0 from differences of the forces", "{:.0e}", error_of_limit(), "<= 1e-6");
  report.heading("Transient rolling with xi that oscillates by 1e-3, 48 elements across: Fx from the response");
  constexpr int fine = 48;
  const FittedContact fitted = fit_ellipse(contact().a, contact().b, fine, fine, ContactMotion::transient);
  constexpr std::array lengths = {0.5, 0.75, 1.0, 2.0, 4.0}; // of the contact
  for (const double length : lengths) {
    const int steps = static_cast<int>(std::lround(length * fine));
    const double k = 2 * std::numbers::pi / (steps * fitted.grid.dx);
    const Complex stepped = transient_amplitude(fine, steps);
    const Complex response = solver(fine).respond(rolling_problem(contact()), std::array{k}).at.at(0).by_creepage[0][0];
    report.bounded(fmt::format("waves of {:.2f} contact lengths", length), "{:.4f}",
                   std::abs(response - stepped) / std::abs(response), "<= 0.01");
    if (options.progress && !options.progress(length / lengths.back())) return false;
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
