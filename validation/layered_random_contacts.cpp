#include "validation/layered_random_contacts.hpp"

#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/draw.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr Material rigid = {std::numeric_limits<double>::infinity(), 0};
constexpr double length = 1e-3, radius = 0.1, speed = 1; // of the contact, about [m]; of the bodies [m]; [m/s]

PronySeries random_series(Draw& draw) {
  PronySeries series;
  const int terms = draw.count(0, 3);
  for (int n = 0; n < terms; ++n)
    series.push_back({draw.number(0.05, 0.9) / terms, draw.power(1e-2, 1e2) * length / speed});
  return series;
}

ViscoelasticMaterial random_material(Draw& draw, bool relaxes) {
  ViscoelasticMaterial m = {{draw.power(1e6, 1e10), draw.chance(0.2) ? 0.5 : draw.number(0, 0.5)}};
  if (!relaxes) return m;
  m.shear_relaxation = random_series(draw);
  if (draw.chance(0.2)) m.bulk_relaxation = random_series(draw);
  return m;
}

LayeredBody random_body(Draw& draw, bool relaxes) {
  LayeredBody body;
  const int layers = draw.chance(0.2) ? 0 : draw.count(1, 10);
  for (int n = 0; n < layers; ++n)
    body.layers.push_back({draw.power(0.01, 10) * length, random_material(draw, relaxes && draw.chance(0.3))});
  const bool has_rigid_core = layers > 0 && draw.chance(0.4);
  body.substrate = has_rigid_core ? ViscoelasticMaterial{rigid} : random_material(draw, relaxes && draw.chance(0.1));
  return body;
}

/// Balls, ellipsoids and rollers under a force that gives half-spaces of the surfaces a contact of about `length`.
RollingProblem random_problem(Draw& draw) {
  RollingProblem p;
  const bool relaxes = draw.chance(0.2), line = draw.chance(0.3);
  p.layered = LayeredBodies{random_body(draw, relaxes), random_body(draw, relaxes), speed};
  const double curvature = 0.5 / radius, a = draw.power(0.3, 3) * length;
  p.geometry = GapCurvatures{curvature, line ? 0 : curvature * draw.power(0.1, 10)};
  const CombinedMaterial surfaces = p.layered->surfaces();
  const double modulus = surfaces.shear_modulus / (1 - surfaces.poisson_ratio);
  p.load = {NormalLoad::Given::force,
            line ? std::numbers::pi * modulus * a * a * curvature : 8.0 / 3 * modulus * a * a * a * curvature};
  const double friction = draw.power(0.05, 1), creepage = draw.power(1e-2, 3) * friction * a / radius;
  p.friction.law = FrictionLaw::coulomb(friction);
  p.motion.creepage = {creepage * draw.number(-1, 1), creepage * draw.number(-1, 1), creepage / a * draw.number(-1, 1)};
  p.motion.rolling_speed = speed;
  return p;
}

} // namespace

void report_random_contacts(Report& report, const Progress& progress) {
  constexpr int contacts = 2000;
  report.heading("2000 random contacts in steady rolling: balls and rollers, up to 10 layers on each body");
  Draw draw(1);
  int solved = 0, refused = 0;
  double steps = 0, products = 0;
  for (int n = 0; n < contacts; ++n) {
    go_on(progress, static_cast<double>(n) / contacts);
    const RollingProblem problem = random_problem(draw);
    const Method method{.theory = Theory::exact, .mx = draw.count(12, 20), .my = draw.count(12, 20)};
    try {
      const ContactSolution s = Solver(method).solve(problem);
      steps += s.report.newton_steps, products += static_cast<double>(s.report.products);
      if (s.report.status == Status::ok)
        ++solved;
      else
        report.line(fmt::format("  contact {}: {}, residual {:.1e}", n, to_string(s.report.status), s.report.residual));
    } catch (const Error& error) {
      report.line(fmt::format("  contact {}: {}", n, error.what()));
      ++refused;
    }
  }
  report.count("solved, or refused with the reason", solved + refused, contacts);
  report.line(fmt::format("  of which refused {}", refused));
  report.line(
      fmt::format("  {:.1f} Newton steps and {:.0f} products in the mean", steps / contacts, products / contacts));
}

} // namespace microslip::validation
