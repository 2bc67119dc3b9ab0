#include "microslip/rolling/rolling_problem.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <limits>

namespace microslip {

RollingProblem rolling_problem(const EllipticContact& contact, const Motion& motion) {
  RollingProblem problem;
  problem.geometry = Ellipse{contact.a, contact.b};
  problem.bodies = CombinedMaterial{contact.shear_modulus, contact.poisson_ratio, contact.dissimilarity};
  problem.load = {NormalLoad::Given::force, contact.normal_force};
  problem.friction.law = contact.friction;
  problem.motion = motion;
  problem.motion.creepage = contact.creepage;
  problem.motion.rolling_speed = contact.rolling_speed;
  return problem;
}

double rolling_velocity(const Motion& motion) {
  return motion.direction == RollingDirection::forward ? motion.rolling_speed : -motion.rolling_speed;
}

bool is_hertzian(const RollingProblem& problem) {
  return std::holds_alternative<Ellipse>(problem.geometry) || std::holds_alternative<GapCurvatures>(problem.geometry);
}

bool is_line_contact(const RollingProblem& problem) {
  if (const auto* curvatures = std::get_if<GapCurvatures>(&problem.geometry)) return curvatures->is_line();
  if (const auto* formula = std::get_if<GapFormula>(&problem.geometry)) return formula->grid.line;
  const auto* values = std::get_if<GapValues>(&problem.geometry);
  return values != nullptr && values->grid.line;
}

CombinedMaterial half_spaces(const RollingProblem& problem) {
  return problem.layered ? problem.layered->surfaces() : problem.bodies.material;
}

namespace {

/// Of a metre of cylinders; what there is not is NaN.
HertzContact line_contact(double curvature, const CombinedMaterial& material, const NormalLoad& load) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  HertzContact hertz{none, none, none, none, none, none, {curvature, 0}};
  if (load.given != NormalLoad::Given::force) return hertz;
  const LineContact line = line_contact_from_load(curvature, material, load.value);
  hertz.a = line.half_width, hertz.normal_force = load.value, hertz.peak_pressure = line.peak_pressure;
  return hertz;
}

} // namespace

HertzContact hertz_contact(const RollingProblem& problem) {
  const CombinedMaterial material = half_spaces(problem);
  const auto& [given, value] = problem.load;
  const bool force = given == NormalLoad::Given::force;
  if (const auto* ellipse = std::get_if<Ellipse>(&problem.geometry)) {
    const HertzContact of_unit_force = hertz_from_ellipse(ellipse->a, ellipse->b, material, 1);
    // At a given ellipse the approach is proportional to the force.
    return hertz_from_ellipse(ellipse->a, ellipse->b, material, force ? value : value / of_unit_force.approach);
  }
  const auto* gap = std::get_if<GapCurvatures>(&problem.geometry);
  if (gap != nullptr && gap->is_line() && problem.layered) return line_contact(gap->x, material, problem.load);
  if (gap != nullptr)
    return force ? hertz_from_load(*gap, material, value) : hertz_from_approach(*gap, material, value);
  throw Error("geometry: must be an ellipse or curvatures for Hertz's theory");
}

EllipticContact elliptic_contact(const RollingProblem& problem) {
  const auto* ellipse = std::get_if<Ellipse>(&problem.geometry);
  if (ellipse == nullptr || problem.load.given != NormalLoad::Given::force)
    return elliptic_contact(problem, hertz_contact(problem));
  HertzContact known{};
  known.a = ellipse->a;
  known.b = ellipse->b;
  known.normal_force = problem.load.value;
  return elliptic_contact(problem, known);
}

EllipticContact elliptic_contact(const RollingProblem& problem, const HertzContact& hertz) {
  const CombinedMaterial material = half_spaces(problem);
  return {.a = hertz.a,
          .b = hertz.b,
          .shear_modulus = material.shear_modulus,
          .poisson_ratio = material.poisson_ratio,
          .normal_force = hertz.normal_force,
          .friction = problem.friction.law,
          .creepage = problem.motion.creepage,
          .rolling_speed = problem.motion.rolling_speed,
          .dissimilarity = material.dissimilarity};
}

void check(const Motion& m) {
  if (m.force_x) require_finite("force_x", *m.force_x, "N");
  if (m.force_y) require_finite("force_y", *m.force_y, "N");
  require_between("step", m.step, "m", 0, std::numeric_limits<double>::max());
  require_count("steps", m.steps, 1, most_steps);
}

} // namespace microslip
