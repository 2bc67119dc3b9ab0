#pragma once

#include "microslip/exact/classical/tangential_problem.hpp"

namespace microslip::validation {

/// When marching has reached the steady state.
struct MarchingLimits {
  double change = 1e-6; ///< of the tractions while the contact rolls a quarter of its length, over the bound (2-norms)
  int most_steps = 10000;
};

struct MarchedSolution {
  ContactSolution last;
  int steps = 0;
  double change = 0; ///< as in MarchingLimits, at the end
};

/// Rolls on in steps from `input.previous` (none: from no tractions) with everything else kept, until the tractions
/// stay: as Kalker's DUVOROL finds the steady state, by transient rolling. Status not_converged if they do not within
/// the limits.
MarchedSolution march_to_steady(TangentialProblem& problem, const ElementGrid& grid, std::span<const double> bound,
                                TangentialInput input, const MarchingLimits& limits = {});

} // namespace microslip::validation
