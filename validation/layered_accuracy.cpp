#include "validation/layered_accuracy.hpp"

#include "microslip/contact/loaded_part.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "validation/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double length = 1e-3, radius = 0.1, speed = 1; // of the contact, about [m]; of the bodies [m]; [m/s]
constexpr int numbers = 6;
constexpr std::array<const char*, numbers> names = {"Fx", "Fy", "Mz", "frictional power", "approach", "peak pressure"};

/// Forces and moment over mu Fn, and mu Fn times half the width; power over mu Fn times creepage and speed; approach
/// and peak pressure over those of the finest grid.
using Numbers = std::array<double, numbers>;

Numbers combined(double f, const Numbers& a, double g, const Numbers& b) {
  Numbers out;
  for (int k = 0; k < numbers; ++k) out[k] = f * a[k] + g * b[k];
  return out;
}

/// A coat of 0.1 to 10 times the shear modulus of steel, a cover of rubber on steel or a rigid core, one that relaxes.
LayeredBodies random_bodies(Draw& draw, int kind) {
  const Material steel = Material::from_young(210e9, 0.28);
  LayeredBodies bodies{.body1 = {{}, {steel}}, .body2 = {{}, {steel}}, .speed = speed};
  const double thickness = draw.power(0.05, 3) * length;
  if (kind == 0) {
    bodies.body1.layers = {{thickness, {{steel.shear_modulus * draw.power(0.1, 10), draw.number(0.15, 0.35)}}}};
    return bodies;
  }
  ViscoelasticMaterial rubber = {{draw.power(1e6, 1e7), draw.number(0.4, 0.49)}};
  if (kind == 2) rubber.shear_relaxation = {{draw.number(0.1, 0.6), draw.power(0.03, 10) * length / speed}};
  bodies.body2.layers = {{thickness, rubber}};
  if (draw.chance(0.5)) bodies.body2.substrate = {{std::numeric_limits<double>::infinity(), 0}};
  return bodies;
}

/// Under a force that gives half-spaces of the surfaces a contact of about `length`.
RollingProblem random_problem(Draw& draw, int kind, bool line) {
  RollingProblem p;
  p.layered = random_bodies(draw, kind);
  const double curvature = 0.5 / radius, a = draw.power(0.5, 2) * length;
  p.geometry = GapCurvatures{curvature, line ? 0 : curvature * draw.power(0.2, 5)};
  const CombinedMaterial surfaces = p.layered->surfaces();
  const double modulus = surfaces.shear_modulus / (1 - surfaces.poisson_ratio);
  p.load = {NormalLoad::Given::force,
            line ? std::numbers::pi * modulus * a * a * curvature : 8.0 / 3 * modulus * a * a * a * curvature};
  const double friction = draw.power(0.05, 1), creepage = draw.power(0.03, 2) * friction * a / radius;
  p.friction.law = FrictionLaw::coulomb(friction);
  p.motion.creepage = {creepage * draw.number(-1, 1), creepage * draw.number(-1, 1), creepage / a * draw.number(-1, 1)};
  p.motion.rolling_speed = speed;
  return p;
}

Numbers numbers_of(const RollingProblem& problem, const ContactSolution& s) {
  const ElementGrid& grid = s.elements.grid;
  const double capacity = problem.friction.law.static_coefficient() * normal_force(grid, s.fields.pressure);
  const double half_width = 0.5 * loaded_part(grid, s.fields.pressure)->x.count() * grid.dx;
  const auto& [xi, eta, phi] = problem.motion.creepage;
  const double slip = std::hypot(xi, eta) + std::abs(phi) * half_width;
  return {s.totals.fx / capacity,
          s.totals.fy / capacity,
          s.totals.mz / (capacity * half_width),
          s.totals.frictional_power / (capacity * slip * speed),
          s.approach,
          s.totals.peak_pressure};
}

/// On grids of 4, 8, ... elements across.
struct Convergence {
  std::vector<Numbers> first, mean; ///< of one grid; of several
  Numbers exact;
};

Convergence convergence_of(const RollingProblem& problem, int finest, int grids, const Progress& progress) {
  LayeredRolling solver({.theory = Theory::exact, .tolerance = 1e-8});
  Convergence out;
  for (int elements = 4; elements <= finest; elements *= 2) {
    Numbers mean{};
    for (int n = 0; n < grids; ++n) {
      const double moved = static_cast<double>(n) / grids;
      const Numbers found = numbers_of(problem, solver.solve(problem, elements, moved, essential_part(progress, 0, 0)));
      if (n == 0) out.first.push_back(found);
      mean = combined(1, mean, 1.0 / grids, found);
    }
    out.mean.push_back(mean);
  }
  const Numbers &coarse = out.mean[out.mean.size() - 2], &fine = out.mean.back();
  for (int k = 0; k < numbers; ++k) out.exact[k] = limit_of_first_order(coarse[k], fine[k]);
  for (auto* values : {&out.first, &out.mean})
    for (Numbers& v : *values)
      for (int k : {4, 5}) v[k] /= out.exact[k];
  out.exact[4] = out.exact[5] = 1;
  return out;
}

double largest_of_forces(const Numbers& a, const Numbers& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::string sizes(const std::vector<double>& errors) {
  return fmt::format("{:.1e} {:.1e}", root_mean_square(errors), median(errors));
}

/// How errors of all contacts fall from the first size to the last one: their order in the elements' size.
double order(double first, double last, std::size_t doublings) {
  return std::log2(first / last) / static_cast<double>(doublings);
}

/// Sizes are 4 * 2^k elements across, from `from` to `to`.
void report_convergence(Report& report, const std::vector<Convergence>& contacts, std::size_t from, std::size_t to) {
  const auto limit = [](const Convergence& c, std::size_t k) {
    Numbers out;
    for (int n = 0; n < numbers; ++n) out[n] = limit_of_first_order(c.mean[k - 1][n], c.mean[k][n]);
    return out;
  };
  const auto straight = [](const Convergence& c, std::size_t k) { return combined(2, c.mean[k], -1, c.mean[k - 1]); };
  report.line("    errors of the forces, rms and median, over mu Fn: one grid; mean; limit; 2 F(h/2) - F(h)");
  int below = 0, estimates = 0;
  for (std::size_t k = from; k <= to; ++k) {
    std::vector<double> one, mean, limits, doubled, ratio;
    for (const Convergence& c : contacts) {
      one.push_back(largest_of_forces(c.first[k], c.exact));
      mean.push_back(largest_of_forces(c.mean[k], c.exact));
      limits.push_back(largest_of_forces(limit(c, k), c.exact));
      doubled.push_back(largest_of_forces(straight(c, k), c.exact));
      const auto change = [&](std::size_t to_size) { return largest_of_forces(c.mean[to_size - 1], c.mean[to_size]); };
      if (k < 3) continue; // the solver's first estimate has three changes, to 32 elements
      const double estimate = 1.5 * std::max({change(k), change(k - 1) / 2, change(k - 2) / 4}); // as the solver's
      ratio.push_back(estimate / limits.back());
      below += estimate < limits.back(), ++estimates;
    }
    const std::string estimated = ratio.empty() ? "" : fmt::format(", estimate over the limit's {:.1f}", median(ratio));
    report.line(fmt::format("    {:5d} across: {}; {}; {}; {}{}", 4 << k, sizes(one), sizes(mean), sizes(limits),
                            sizes(doubled), estimated));
  }
  report.bounded("  estimates below the error, of all", "{:.3f}", static_cast<double>(below) / estimates, "<= 0.1");
  for (int n = 0; n < numbers; ++n) {
    const auto fall = [&](auto value) {
      const auto error = [&](std::size_t k) {
        std::vector<double> errors;
        errors.reserve(contacts.size());
        for (const Convergence& c : contacts) errors.push_back(std::abs(value(c, k)[n] - c.exact[n]));
        return median(errors);
      };
      return order(error(from), error(to), to - from);
    };
    report.line(
        fmt::format("    order of the median error, {}: one grid {:.1f}, mean {:.1f}, limit {:.1f}, 2 F - F {:.1f}",
                    names[n], fall([](const Convergence& c, std::size_t k) { return c.first[k]; }),
                    fall([](const Convergence& c, std::size_t k) { return c.mean[k]; }), fall(limit), fall(straight)));
  }
}

std::vector<Convergence> random_contacts(int count, bool line, int finest, int grids, const Progress& progress) {
  Draw draw(line ? 2 : 3);
  std::vector<Convergence> out;
  for (int n = 0; n < count; ++n) {
    go_on(progress, static_cast<double>(n) / count);
    out.push_back(convergence_of(random_problem(draw, n % 3, line), finest, grids, progress));
  }
  return out;
}

} // namespace

void report_layered_accuracy(Report& report, const Progress& progress) {
  report.heading("Extrapolated forces of coats, rubber covers and covers that relax, in steady rolling");
  report.line("  36 rollers, on four grids of a size, to 1024 strips");
  report_convergence(report, random_contacts(36, true, 1024, 4, part(progress, 0, 0.3)), 2, 6);
  report.line("  30 balls and ellipsoids, on two grids of a size, to 128 x 128 elements");
  report_convergence(report, random_contacts(30, false, 128, 2, part(progress, 0.3, 1)), 2, 3);
}

} // namespace microslip::validation
