#pragma once

#include "microslip/exact/normal_problem.hpp"
#include "microslip/exact/tangential_problem.hpp"

#include <memory>

namespace microslip {

/// How the exact theory discretises a Hertzian contact.
struct ExactOptions {
  int mx = 24; ///< elements across the ellipse along x, 1 to 4,000
  int my = 24; ///< and along y
  RollingDirection direction = RollingDirection::forward;
  double tolerance = 1e-6; ///< of the residual, as in FrictionSolution
};

/// What the exact theory finds for a Hertzian contact in steady rolling.
struct ExactContact {
  ContactFields fields; ///< rows with y ascending, in each from the leading to the trailing edge; with margins outside
                        ///< the contact
  double approach = 0;  ///< [m], of the discrete normal problem
  double peak_pressure = 0;     ///< [Pa]
  double power_by_creepage = 0; ///< -V (xi fx + eta fy + phi mz) [W]
  double elastic_energy = 0;    ///< of the tangential tractions [J]
  double residual = 0;
  int newton_steps = 0;
  long products = 0;
};

/// Steady rolling of Hertzian contacts by the exact theory, for creepages given and elastically similar bodies with
/// Coulomb friction: normal and tangential problem on a grid of mx x my elements across the ellipse. Influence
/// coefficients are kept for the next contact if it has the same ellipse and material.
class EllipticContactSolver {
public:
  /// Throws Error if an option is out of range.
  explicit EllipticContactSolver(const ExactOptions& options);

  const ExactOptions& options() const { return options_; }

  /// Input out of range gives Status::invalid_input and NaN, another friction law than Coulomb's too.
  ExactContact solve(const EllipticContact& contact);

private:
  void prepare(const EllipticContact& contact);
  ContactFields fields_of(const TangentialSolution& solution) const;

  ExactOptions options_;
  ElementGrid grid_;
  double a_ = 0, b_ = 0;
  CombinedMaterial material_ = {0, 0, 0};
  NormalSolution normal_; ///< for a load of 1 N; pressures and load are proportional at a given ellipse
  std::unique_ptr<TangentialProblem> tangential_;
};

} // namespace microslip
