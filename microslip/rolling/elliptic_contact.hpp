#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "microslip/exact/fitted/transient_rolling.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/progress.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Discretisation of rolling. Shifts, and rolling with a prescribed step, are always classical.
enum class Discretisation {
  second_order, ///< SecondOrderRolling, TransientRolling: forces with errors of second order in the elements' size
  classical,    ///< TangentialProblem: Kalker's regular elements, errors of first order
};

/// Options of the exact theory for a Hertzian contact.
struct ExactOptions {
  int mx = 24; ///< elements across the ellipse along x, 1 to 4,000
  int my = 24; ///< and along y
  Discretisation discretisation = Discretisation::second_order;
  ElementShape elements = ElementShape::constant; ///< bilinear needs Discretisation::classical
  RollingDirection direction = RollingDirection::forward;
  double tolerance = 1e-6; ///< of the residual, as in FrictionSolution
  /// Dissimilar bodies, viscoelastic ones, or with a layer between them, which are solved classically;
  /// none: similar elastic bodies with the contact's constants. The ellipse is that of the elastic bodies without
  /// friction.
  std::optional<Bodies> bodies = {};
  Coupling coupling = Coupling::newton;
  FrictionMemory friction_memory = {}; ///< of friction that depends on the slip, which is solved classically, too
  SlipStart slip_start = SlipStart::below;
  /// Bodies whose surfaces have temperatures in steady rolling, and what these add to the friction; both are solved
  /// classically. The effect needs the bodies.
  std::optional<ThermalBodies> thermal = {};
  std::optional<TemperatureEffect> temperature_effect = {};

  friend bool operator==(const ExactOptions&, const ExactOptions&) = default;
};

/// Motion of the bodies over each other, beyond the creepages of EllipticContact. For a shift these are the rigid shift
/// [m] and rotation [rad].
struct ExactMotion {
  ContactMotion kind = ContactMotion::steady;
  std::optional<double> force_x = {}, force_y = {}; ///< [N] on body 1, in place of the creepage in that direction
  double step = 0; ///< dq [m], the distance rolled in a step, >= 0; 0: the elements' length
  int steps = 1;   ///< of transient rolling, from zero tractions on, 1 to 1,000,000; all under the same conditions
};

/// Distance of the deformed bodies at the elements of a grid [m].
struct DeformedGap {
  ElementGrid grid;
  std::vector<double> gap;
};

/// Forces in steady rolling and their derivatives: row k belongs to fx, fy, mz, columns to xi [-], eta [-], phi [1/m].
struct ExactDerivatives {
  ContactSolution solution;
  double jacobian[3][3] = {};
  long products = 0; ///< that the derivatives took
};

/// Hertzian contacts by the exact theory: normal and tangential problem on a grid of mx x my elements across the
/// ellipse. Influence coefficients are kept for the next contact if it has the same ellipse and material. Distinct
/// objects may be used from distinct threads.
class EllipticContactSolver {
public:
  /// Throws Error if an option is out of range, or if the grid needs more memory than the machine has.
  explicit EllipticContactSolver(const ExactOptions& options);

  const ExactOptions& options() const { return options_; }

  /// Input out of range gives Status::invalid_input and NaN. `progress` is called in the steps of transient rolling,
  /// else of the Newton steps, and within them, and may end them: with status not_converged and the tractions so far,
  /// in transient rolling those of the last whole step. Where there are none yet, and for dissimilar bodies and
  /// friction that depends on the slip, with NaN.
  ContactSolution solve(const EllipticContact& contact, const ExactMotion& motion = {}, const Progress& progress = {});

  /// Steady rolling with creepages given, at second order: forces and the derivatives of these very numbers, from the
  /// converged equations by the implicit function theorem. They hold away from the kinks where an element passes from
  /// adhesion to slip, and are accurate to 1e-5 of a column's size with the default tolerance.
  /// `progress` is called in the Newton steps and linear solves; false ends them, with status not_converged and
  /// NaN.
  ExactDerivatives differentiate(const EllipticContact& contact, const Progress& progress = {});

  /// Deformed distance of the bodies h - delta + u_n [m] at the elements of the solution, zero in contact: the normal
  /// problem on their grid. Throws Error for what `solve` refuses, and Stopped if `progress` returns false.
  DeformedGap deformed_gap(const EllipticContact& contact, const ExactMotion& motion = {},
                           const Progress& progress = {});

private:
  void check_input(const EllipticContact& contact, const ExactMotion& motion) const;
  ContactProblem problem_of(const EllipticContact& contact, const ExactMotion& motion) const;
  void require_memory_for(ContactProblem problem) const;
  void prepare_classical(const EllipticContact& contact, const Progress& progress);
  void prepare_second_order(const EllipticContact& contact, const Progress& progress);
  void prepare_transient(const EllipticContact& contact, const Progress& progress);
  void forget();
  bool is_of_last(const EllipticContact& contact);
  ContactSolution solve_classical(const EllipticContact& contact, const ExactMotion& motion, const Progress& progress);
  TangentialSolution roll(TangentialInput input, int steps, double normal_force, std::span<const double> bound,
                          const Progress& progress, std::vector<SolutionStep>& history);
  ContactStep sequence_step(const EllipticContact& contact, const ExactMotion& motion) const;
  ContactSolution solve_sequence(const EllipticContact& contact, const ExactMotion& motion, const Progress& progress);
  EllipticContact mirrored(EllipticContact contact) const;
  ExactMotion mirrored(ExactMotion motion) const;
  ContactSolution solve_second_order(const EllipticContact& contact, const ExactMotion& motion,
                                     const Progress& progress);
  ContactSolution solve_transient(const EllipticContact& contact, const ExactMotion& motion, const Progress& progress);
  ContactSolution fitted_solution(const SecondOrderSolution& found, const FittedContact& fitted,
                                  const EllipticContact& contact) const;

  ExactOptions options_;
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
