#include "validation/hertzian_solve.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::validation {
namespace {

NormalSolution solve_normal(const CombinedMaterial& material, const ElementGrid& grid, const GapCurvatures& gap,
                            double normal_force) {
  NormalSolution solution =
      NormalProblem(material, grid).solve(hertzian_gap(gap, grid), {NormalLoad::Given::force, normal_force}, 1e-11);
  if (solution.status != Status::ok || solution.touches_border)
    throw Error("normal problem: not converged, or the contact reaches the border of the grid");
  return solution;
}

} // namespace

HertzianSolve::HertzianSolve(const CombinedMaterial& material, const ElementGrid& grid, const GapCurvatures& gap,
                             double normal_force)
    : grid_(grid), normal_(solve_normal(material, grid, gap, normal_force)), tangential_(material, grid) {}

std::vector<double> HertzianSolve::bound(double friction) const {
  std::vector<double> bound = normal_.pressure;
  for (double& g : bound) g *= friction;
  return bound;
}

ContactSolution HertzianSolve::solve(double friction, const TangentialInput& input) {
  return tangential_.solve(bound(friction), input);
}

int count(const ContactSolution& solution, CellState state) {
  return static_cast<int>(std::count(solution.fields.state.begin(), solution.fields.state.end(), state));
}

double limit(double coarse, int coarse_elements, double fine, int fine_elements, int order) {
  return fine + (fine - coarse) / (std::pow(double(fine_elements) / coarse_elements, order) - 1);
}

} // namespace microslip::validation
