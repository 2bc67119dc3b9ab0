#include "microslip/rolling/rolling_problem.hpp"

#include "microslip/error.hpp"

namespace microslip {

bool is_hertzian(const RollingProblem& problem) {
  return std::holds_alternative<Ellipse>(problem.geometry) || std::holds_alternative<GapCurvatures>(problem.geometry);
}

HertzContact hertz_contact(const RollingProblem& problem) {
  const CombinedMaterial& material = problem.bodies.material;
  const auto& [given, value] = problem.load;
  const bool force = given == NormalLoad::Given::force;
  if (const auto* ellipse = std::get_if<Ellipse>(&problem.geometry)) {
    const HertzContact of_unit_force = hertz_from_ellipse(ellipse->a, ellipse->b, material, 1);
    // At a given ellipse the approach is proportional to the force.
    return hertz_from_ellipse(ellipse->a, ellipse->b, material, force ? value : value / of_unit_force.approach);
  }
  if (const auto* gap = std::get_if<GapCurvatures>(&problem.geometry))
    return force ? hertz_from_load(*gap, material, value) : hertz_from_approach(*gap, material, value);
  throw Error("geometry: must be an ellipse or curvatures for Hertz's theory");
}

} // namespace microslip
