#pragma once

#include "microslip/exact/classical/slip_friction.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <array>
#include <optional>
#include <vector>

namespace microslip {

/// Initial state of a step of a sequence.
enum class StepStart {
  fresh,    ///< no tractions
  previous, ///< those at the end of the step before
  pressure, ///< the pressure at its end, and no tractions
  repeated, ///< those that the step before started from: the same step once more
};

/// State that a step starts from: that of the step before, on the same grid in the contact's frame.
struct TangentialState {
  VectorField traction = {};         ///< [Pa]; empty: none
  std::vector<double> pressure = {}; ///< p_n [Pa], which matters for dissimilar materials; empty: none
  /// Loss of friction that depends on the slip, static minus present coefficient [-], and the slip velocity
  /// [m/s]; empty: nothing.
  std::vector<double> friction_drop = {}, slip_velocity = {};
  std::vector<double> plastic_deformation = {}; ///< of a layer [m]; empty: none

  std::array<std::vector<double>*, 6> fields() {
    return {&traction.x, &traction.y, &pressure, &friction_drop, &slip_velocity, &plastic_deformation};
  }
};

/// A pressure that is given and not solved for.
struct GivenPressure {
  std::vector<double> pressure;          ///< p_n [Pa] of the elements
  double approach = 0;                   ///< delta that belongs to it [m]
  double normal_force = 0;               ///< Fn that belongs to it [N]; the sum over the elements differs by their size
  std::vector<double> displacement = {}; ///< u_n [m]; empty: that of the half-space
};

/// Solver of the coupled normal and tangential problems of dissimilar materials.
enum class Coupling {
  newton,      ///< both simultaneously, CoupledNewton
  alternating, ///< in turn until neither changes (Panagiotopoulos 1975); elastic bodies
};

/// A normal and a tangential problem on a grid.
struct ContactStep {
  ElementGrid grid;
  Bodies bodies = {};
  /// Only for elastic bodies without a layer, and without a given pressure; the bodies then only set the size of
  /// displacements. In rolling steps are whole elements along x.
  ElementResponse response = {};
  std::vector<double> gap = {};    ///< undeformed distance h of the elements [m]
  std::vector<char> excluded = {}; ///< 1 for elements that cannot come into contact; empty: none
  NormalLoad load = {};
  std::optional<GivenPressure> given = {};   ///< instead of gap and load
  std::vector<FrictionLaw> friction = {};    ///< of each row of the grid; one: the same for all
  FrictionMemory friction_memory = {};       ///< of friction that depends on the slip
  SlipStart slip_start = SlipStart::below;   ///< where the slip of such friction begins
  std::optional<ThermalBodies> thermal = {}; ///< bodies whose surfaces have temperatures, in steady rolling
  /// Effect of these on the friction of each row; one: the same for all; empty: nothing. Not with a layer that yields.
  std::vector<TemperatureEffect> temperature_effect = {};
  bool frictionless = false;          ///< the normal problem only; tractions are zero
  StepStart start = StepStart::fresh; ///< of shifts and transient rolling
  bool warm_start = false;            ///< the iteration starts from the tractions of the step before
  TangentialInput motion = {};        ///< without forces, extra slip, previous and start, which are set here
  /// Slip of each element on top of that of the creepages; empty: none. In a shift [m], else [-].
  std::vector<double> extra_slip_x = {}, extra_slip_y = {};
  std::optional<double> force_x = {}, force_y = {}; ///< given, over Fn [-]
  Coupling coupling = Coupling::newton;             ///< if the bodies' problems are coupled
};

/// The traction bound of a step's elements.
struct ElementFriction {
  std::span<const double> coefficients;   ///< mu [-]
  SlipFriction* slip_dependent = nullptr; ///< instead of mu p_n; mu then is that at rest
};

/// Both problems' solution: in the fields friction is the traction bound of the elements over their pressure, empty
/// without tractions; the frictional power is that of TangentialProblem; residual and counts of the report are those of
/// the tangential problem, its status is that of both.
struct ContactStepSolution : ContactSolution {
  NormalSolution normal;
  double normal_force = 0; ///< Fn [N]
  int contact_elements = 0, adhesion_elements = 0, slip_elements = 0;
  /// State of friction where the bound depends on the slip, else empty.
  SlipFriction::State slip_friction;
  int plastic_elements = 0; ///< where it yields; they do not count as slip
  int alternations = 0;     ///< with Coupling::alternating: how often both problems were solved
};

/// Adds the temperatures of the surfaces, from the heat -V p.s; none without thermal bodies or for other than steady
/// rolling.
void add_temperatures(const ContactStep& step, ContactSolution& solution);
/// The grid's elements where their particles were before the step: elsewhere in transient rolling only.
ElementGrid origin_of_particles(const ContactStep& step);
/// The motion of a step with its extra slip, which belongs to the step.
TangentialInput motion_of(const ContactStep& step);
/// The normal problem of a step as if its bodies were similar; without pressure on the elements that are excluded.
NormalSolution solve_normal(NormalProblem& problem, const ContactStep& step);
/// The pressure that is given, with its displacements and totals.
NormalSolution given_normal(const ContactStep& step);

} // namespace microslip
