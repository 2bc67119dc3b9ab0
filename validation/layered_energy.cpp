#include "validation/layered_energy.hpp"

#include "microslip/elasticity/layered_response.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/halfspace/layered_influence.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/numerics/gauss_legendre.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr Material rigid = {std::numeric_limits<double>::infinity(), 0};
const LayeredBody rigid_body = {{}, {rigid}};

using Field = std::vector<double>;
using Fields = std::array<Field, 3>; ///< along x, y and inwards

/// Powers [W] in steady rolling.
struct Powers {
  double creepage, pressure; ///< put in
  double friction, lost;     ///< lost: by differences over an element
};

/// Displacements on a grid with a column more on each side, which the tractions do not reach.
Fields displacements(const ContactStep& step, const LayeredBodies& bodies, const Fields& p) {
  ElementGrid wide = step.grid;
  wide.x0 -= wide.dx, wide.mx += 2;
  Fields on_wide, u;
  for (std::size_t c = 0; c < 3; ++c) {
    on_wide[c].resize(wide.count()), u[c].resize(wide.count());
    for (std::size_t k = 0; k < p[c].size(); ++k) {
      const std::size_t row = k / static_cast<std::size_t>(step.grid.mx);
      on_wide[c][k + 2 * row + 1] = p[c][k];
    }
  }
  ElementResponse response;
  response.table = layered_table(bodies, wide);
  CoupledOperator displacement = CoupledOperator::displacement(step.bodies, wide, {}, 1, {}, response);
  displacement.apply({on_wide[0], on_wide[1], on_wide[2]},
                     std::array{std::span(u[0]), std::span(u[1]), std::span(u[2])});
  return u;
}

/// The sum of p times the displacement `columns` further along x.
double work(const ContactStep& step, const Field& p, const Field& u, int columns) {
  double sum = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::size_t row = k / static_cast<std::size_t>(step.grid.mx);
    sum += p[k] * u[k + 2 * row + 1 + static_cast<std::size_t>(columns)];
  }
  return sum;
}

/// Friction is that of the slip, w + (u - u_ahead)/dx.
Powers powers_of(const ContactStep& step, const LayeredBodies& bodies, const ContactStepSolution& s) {
  const Fields p = {s.fields.traction.x, s.fields.traction.y, s.fields.pressure};
  const double rate = step.motion.rolling_speed * step.grid.element_area() / step.grid.dx;
  const Fields u = displacements(step, bodies, p);
  double second_difference = 0;
  for (std::size_t c = 0; c < 3; ++c)
    second_difference += work(step, p[c], u[c], 0) - (work(step, p[c], u[c], 1) + work(step, p[c], u[c], -1)) / 2;
  return {.creepage = s.totals.power_by_creepage,
          .pressure = rate * (work(step, p[2], u[2], 0) - work(step, p[2], u[2], 1)),
          .friction = s.totals.frictional_power,
          .lost = rate * second_difference};
}

/// A row of values as a sum of waves.
std::complex<double> transform(const ElementGrid& grid, const Field& values, double k) {
  std::complex<double> sum = 0;
  for (int i = 0; i < grid.mx; ++i) sum += values[static_cast<std::size_t>(i)] * std::polar(1.0, -k * grid.x(i));
  return sum;
}

/// Power [W] that body 2 turns into heat, with the tractions that its strips have: 2 V/pi times the integral of sin(k
/// dx) sin(k dx/2)/k^2 Im(p^H C p) over k, C its response at the frequency -V k. (The sines are those of differences
/// over two strips and of a strip.)
double hysteresis(const LayeredBody& body, double speed, const ElementGrid& grid, const ContactStepSolution& s) {
  static const GaussLegendre rule(16);
  const double width = 8 / (grid.mx * grid.dx), end = 200 / grid.dx;
  double sum = 0, k0 = 0;
  while (k0 < end) {
    const double k1 = k0 + std::clamp(k0, 1e-4 * width, width); // memories longer than the grid matter to long waves
    for (std::size_t n = 0; n < rule.count(); ++n) {
      const double k = rule.node(n, k0, k1);
      const auto c = response(stack_at(body, -speed * k), k);
      const auto px = transform(grid, s.fields.traction.x, k), py = transform(grid, s.fields.traction.y, k),
                 pn = transform(grid, s.fields.pressure, k);
      const double coupled = 2 * (std::conj(px) * pn).imag();
      const double loss = (c.nn * std::norm(pn) + c.ll * std::norm(px) + c.tt * std::norm(py) + c.ln * coupled).imag();
      sum += rule.weight(n, k0, k1) * loss * std::sin(k * grid.dx) * std::sin(k * grid.dx / 2) / (k * k);
    }
    k0 = k1;
  }
  return 2 * speed * grid.dy / std::numbers::pi * sum;
}

/// A ball or a roller of radius 0.1 m, rigid, on a layered body, with creepages.
ContactStep rolling_on(const LayeredBodies& bodies, const ElementGrid& grid) {
  constexpr double radius = 0.1, friction = 0.3, depth = 1e-5;
  ContactStep step;
  step.grid = grid;
  step.bodies = bodies.surfaces();
  step.response.table = layered_table(bodies, grid);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double y = grid.line ? 0 : grid.y(j);
      step.gap.push_back((grid.x(i) * grid.x(i) + y * y) / (2 * radius));
    }
  step.load = {NormalLoad::Given::approach, depth};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.motion.creepage = {2e-3, -1e-3, grid.line ? 0 : 0.5};
  step.motion.rolling_speed = bodies.speed;
  step.motion.spin_offset = 0; // so that the moment is about the middle
  step.motion.tolerance = 1e-9;
  return step;
}

struct Balance {
  double difference; ///< of what is put in and what is lost, over what is put in
  double lost, hysteresis;
};

/// Elastic bodies have no hysteresis; that of strips on viscoelastic ones is known.
Balance balance_of(Report& report, const LayeredBody& body, const ElementGrid& grid) {
  constexpr double speed = 1;
  const LayeredBodies bodies = {rigid_body, body, speed};
  const ContactStep step = rolling_on(bodies, grid);
  const ContactStepSolution s = ContactSequence().solve(step);
  if (s.report.status != Status::ok) report.figure("  status", to_string(s.report.status), "ok", false);
  const Powers powers = powers_of(step, bodies, s);
  const double in = powers.creepage + powers.pressure, heat = body.is_elastic() ? 0 : hysteresis(body, speed, grid, s);
  return {(in - powers.friction - powers.lost - heat) / in, powers.lost / in, heat / in};
}

} // namespace

void report_energy(Report& report) {
  report.heading("Power put in by creepages and the pressure's offset: its difference from what is lost, over it");
  constexpr double half = 2.8e-3, h = 1e-3;
  const ElementGrid square = ElementGrid::across_ellipse(half, half, 32);
  const Material rubber = {1e6, 0.5}, plastic = {1e9, 0.4};
  const PronySeries slow = {{0.4, 1e-3}, {0.2, 1e-2}}, quick = {{0.5, 2e-4}};
  const std::pair<const char*, LayeredBody> elastic[] = {
      {"a ball on rubber on a rigid core", {{{h, {rubber}}}, {rigid}}},
      {"a ball on three layers on steel",
       {{{h / 4, {{2e10, 0.3}}}, {h, {plastic}}, {h, {{1e8, 0.49}}}}, {{82e9, 0.28}}}},
  };
  for (const auto& [name, body] : elastic)
    report.bounded(name, "{:.1e}", std::abs(balance_of(report, body, square).difference), "<= 1e-10");
  const std::pair<const char*, LayeredBody> viscoelastic[] = {
      {"a roller on a relaxing cover on a rigid core", {{{h, {rubber, slow}}}, {rigid}}},
      {"  on two relaxing layers on steel",
       {{{h / 4, {plastic, slow}}, {h, {{2e8, 0.45}, quick, slow}}}, {{82e9, 0.28}}}},
  };
  for (const auto& [name, body] : viscoelastic) {
    const Balance balance = balance_of(report, body, ElementGrid::across_line(half, 96));
    report.bounded(name, "{:.1e}", std::abs(balance.difference), "<= 1e-6");
    report.line(fmt::format("    hysteresis, by the response to its waves, is {:.4f} of it", balance.hysteresis));
  }
  for (const int n : {64, 128, 256})
    report.line(fmt::format("    lost by differences over an element, {:3} strips: {:.4f} of it", n,
                            balance_of(report, viscoelastic[0].second, ElementGrid::across_line(half, n)).lost));
}

} // namespace microslip::validation
