#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "microslip/exact/fitted/transient_rolling.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/rolling/solver.hpp"

#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// The part of Solver for Hertzian problems by the exact theory: normal and tangential problem on a grid of mx x my
/// elements across the ellipse. Influence coefficients are kept for the next problem if it has the same ellipse and
/// material. Problem and method are compatible (incompatibilities).
class EllipseSolver {
public:
  explicit EllipseSolver(const Method& method) : method_(method) {}

  /// Input out of range gives Status::invalid_input and NaN. `progress` is called in the steps of transient rolling,
  /// else of the Newton steps, and within them, and may end them: with status not_converged and the tractions so far,
  /// in transient rolling those of the last whole step. Where there are none yet, and for dissimilar bodies and
  /// friction that depends on the slip, with NaN.
  ContactSolution solve(const RollingProblem& problem, const Progress& progress);
  ExactDerivatives differentiate(const RollingProblem& problem, const Progress& progress);
  /// Responses at second order, of similar elastic bodies with Coulomb friction in steady rolling.
  FrequencyResponse respond(const RollingProblem& problem, std::span<const double> wavenumbers,
                            const Progress& progress);
  GapValues deformed_gap(const RollingProblem& problem, const Progress& progress);

private:
  ContactProblem kind_of(const RollingProblem& problem) const;
  void prepare_classical(const EllipticContact& contact, ElementShape elements, const Progress& progress);
  void prepare_second_order(const EllipticContact& contact, const Progress& progress);
  void prepare_transient(const EllipticContact& contact, const Progress& progress);
  void forget();
  bool is_of_last(const EllipticContact& contact);
  ContactSolution solve_classical(const RollingProblem& problem, const EllipticContact& contact,
                                  const Progress& progress);
  ContactStep sequence_step(const RollingProblem& problem, const EllipticContact& contact) const;
  ContactSolution solve_sequence(const RollingProblem& problem, const EllipticContact& contact,
                                 const Progress& progress);
  ExactDerivatives differentiate_classical(const RollingProblem& problem, const EllipticContact& contact,
                                           const Progress& progress);
  ContactSolution solve_second_order(const RollingProblem& problem, const EllipticContact& contact,
                                     const Progress& progress);
  ContactSolution solve_transient(const RollingProblem& problem, const EllipticContact& contact,
                                  const Progress& progress);
  ContactSolution fitted_solution(const SecondOrderSolution& found, const FittedContact& fitted,
                                  const EllipticContact& contact, RollingDirection direction) const;

  Method method_;
  double a_ = 0, b_ = 0;
  CombinedMaterial material_ = {0, 0, 0};
  // What belongs to that ellipse and material: one or the other.
  ElementGrid grid_;
  NormalSolution normal_; ///< for a load of 1 N; pressures and load are proportional at a given ellipse
  std::unique_ptr<TangentialProblem> tangential_;
  std::unique_ptr<HertzianRolling> second_order_;
  std::unique_ptr<TransientRolling> transient_;
  ContactSequence sequence_; ///< of bodies and friction that need one
};

} // namespace microslip
