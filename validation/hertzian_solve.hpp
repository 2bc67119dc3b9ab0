#pragma once

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

namespace microslip::validation {

/// A Hertzian contact of similar bodies by the exact theory: the normal problem solved with the load given, and
/// tangential problems with the bound mu p_n. Distinct objects may be used from distinct threads.
class HertzianSolve {
public:
  /// For a line contact gap.y counts for nothing. Throws Error unless the normal problem converges within the grid.
  HertzianSolve(const CombinedMaterial& material, const ElementGrid& grid, const GapCurvatures& gap,
                double normal_force);

  const ElementGrid& grid() const { return grid_; }
  const NormalSolution& normal() const { return normal_; }
  std::vector<double> bound(double friction) const;
  TangentialProblem& tangential() { return tangential_; }
  ContactSolution solve(double friction, const TangentialInput& input);

private:
  ElementGrid grid_;
  NormalSolution normal_;
  TangentialProblem tangential_;
};

/// Number of elements in a state.
int count(const ContactSolution& solution, CellState state);

/// Limit of a quantity with an error C/n^order from its values on n and fewer elements across.
double limit(double coarse, int coarse_elements, double fine, int fine_elements, int order = 1);

} // namespace microslip::validation
