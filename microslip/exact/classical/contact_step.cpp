#include "microslip/exact/classical/contact_step.hpp"

#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/normal/normal_totals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

} // namespace

void add_temperatures(const ContactStep& step, ContactSolution& solution) {
  const TangentialInput& motion = step.motion;
  if (!step.thermal || step.frictionless || motion.motion != ContactMotion::steady) return;
  SurfaceFields& f = solution.fields;
  std::vector<double> heat;
  heat.reserve(step.grid.count());
  for (std::size_t k = 0; k < step.grid.count(); ++k)
    heat.push_back(-motion.rolling_speed * (f.traction.x[k] * f.slip.x[k] + f.traction.y[k] * f.slip.y[k]));
  SurfaceTemperature found =
      surface_temperature(step.grid, motion.direction, motion.rolling_speed, *step.thermal, f.pressure, heat);
  f.temperature1 = std::move(found.body1);
  f.temperature2 = std::move(found.body2);
  solution.highest_temperature = found.highest;
}

ElementGrid origin_of_particles(const ContactStep& step) {
  ElementGrid origin = step.grid;
  if (step.motion.motion != ContactMotion::transient) return origin;
  const Vec2 offset = way_of(step.motion, signed_step(step.motion, step.grid));
  origin.x0 += offset.x;
  origin.y0 += offset.y;
  return origin;
}

TangentialInput motion_of(const ContactStep& step) {
  TangentialInput motion = step.motion;
  motion.extra_x = step.extra_slip_x;
  motion.extra_y = step.extra_slip_y;
  return motion;
}

NormalSolution given_normal(const ContactStep& step) {
  NormalSolution s;
  s.pressure = step.given->pressure;
  s.approach = step.given->approach;
  s.displacement = step.given->displacement;
  if (s.displacement.empty()) {
    s.displacement.resize(step.grid.count());
    NormalOperator(step.bodies.material, step.grid, step.motion.progress).apply(s.pressure, s.displacement);
  }
  find_totals(step.grid, step.gap, s);
  if (s.status == Status::ok && s.contact_elements == 0) s.status = Status::no_contact;
  return s;
}

/// Excluded elements get a gap too large to close.
NormalSolution solve_normal(NormalProblem& problem, const ContactStep& step) {
  if (step.excluded.empty()) return problem.solve(step.gap, step.load, normal_tolerance, step.motion.progress);
  const auto [low, high] = std::minmax_element(step.gap.begin(), step.gap.end());
  double distance = std::max({*high - *low, std::abs(*high), step.grid.dx * 1e-6});
  for (int attempt = 0;; ++attempt, distance *= 10) {
    std::vector<double> gap = step.gap;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (step.excluded[k]) gap[k] = *high + distance;
    NormalSolution s = problem.solve(gap, step.load, normal_tolerance, step.motion.progress);
    bool is_within = true;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (step.excluded[k] && s.pressure[k] > 0) is_within = false;
    if (is_within || attempt == 12) {
      if (!is_within) s.status = Status::not_converged;
      return s;
    }
  }
}

} // namespace microslip
