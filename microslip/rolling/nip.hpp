#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/rolling/contact_warnings.hpp"
#include "microslip/rolling/solver.hpp"

#include <memory>

namespace microslip {

/// One of two bodies that roll over each other.
enum class Roller { body1, body2 };

/// Radii of two rollers along the rolling direction [m]: positive convex, negative hollow, infinite flat.
struct RollerRadii {
  double body1, body2;

  /// 1/R1 + 1/R2 [1/m].
  double curvature() const { return 1 / body1 + 1 / body2; }
};

/// What a nip asks of one roller.
struct RollerState {
  /// Power that pressure takes from it [W], -V integral of p_n du_n/dx: of an elastic body what its tractions give
  /// back.
  double pressure_power = 0;
  /// Torque over the radius that its drive must supply to keep it turning [N]: +-Fx and the pressure's power over its
  /// surface speed. Negative: it is driven by the other.
  double drive = 0;
  double indentation = 0; ///< largest displacement inwards [m]
  double cover = 0;       ///< thickness of its cover [m], see Nip
  double strain = 0;      ///< indentation over the cover's thickness [-], 0 without a cover
};

/// Results of steady rolling as users of rollers name them. Lengths are known to an element. A cover are the layers
/// that are softer than a tenth of the substrate's shear modulus; its strain, the indentation over its thickness, is
/// the usual measure of rollers: the mean over the thickness where it is thin beside the nip, less than the largest
/// strain where it is thick.
struct Nip {
  double width = 0;             ///< length of the contact along x [m]
  double peak_pressure = 0;     ///< [Pa]
  double indentation = 0;       ///< approach of both bodies [m]
  double traction = 0;          ///< tangential force, sqrt(Fx^2 + Fy^2) [N]
  double traction_capacity = 0; ///< mu Fn [N], with the static coefficient
  double utilisation = 0;       ///< traction over its capacity [-]; 0 without friction
  /// Power lost inside the bodies [W], -V integral of p_n du_n/dx + p.du/dx over the displacements of both; zero for
  /// elastic ones of whatever materials.
  double hysteresis_power = 0;
  double slip_power = 0;         ///< power lost in slip [W]
  double rolling_resistance = 0; ///< hysteresis_power/V [N]: the force that it takes to roll one over the other
  RollerState body1, body2;
  ContactWarnings warnings; ///< large_strain, thick_cover
};

/// Results of a nip from the solution of a problem with layered bodies; half-spaces are those without layers. With
/// sigma = +-1 the direction of rolling, V1 = V (1 - sigma xi/2) and V2 = V (1 + sigma xi/2) the rollers' surface
/// speeds, u_n the displacement inwards and D_i the pressure's power of body i, drives are sigma Fx + D_1/V1 and -sigma
/// Fx + D_2/V2, and their power is hysteresis_power + slip_power. Derivatives are central differences, which take
/// nothing from elastic bodies. Pressure acts across the surface as it is deformed, so that it turns no rigid roller,
/// whose radius is the surface's: D_i = 0. Throws Error without layered bodies, for other than steady rolling, for a
/// solution without contact, and for radii that do not fit the problem's curvatures to 1e-6, Stopped where `progress`
/// returns false. It takes influence numbers of each body that is not rigid.
Nip nip_of(const RollingProblem& problem, const ContactSolution& solution, const RollerRadii& radii,
           const Progress& progress = {});

/// Steady rolling in which one roller has no torque.
struct FreeRoller {
  /// Surface speed of the free roller over that of the other one [-], omega R of both with radii that are not deformed;
  /// above 1 it is overdriven.
  double speed_ratio = 0;
  double creepage = 0; ///< xi [-]
  double fx = 0;       ///< on body 1 [N], which balances the free roller's hysteresis
  ContactSolution solution;
};

/// The speed ratio at which a roller turns without torque, neither by its drive nor by a bearing: the longitudinal
/// force balances its D_i, in steps that begin with Fx = 0, which is all for elastic bodies up to terms of the order of
/// the strain. The problem's load is a force. Throws Error as nip_of and Solver::solve do; where friction cannot turn
/// the roller, or the force does not settle, the solution's status says so. Throws Stopped if `progress` returns false.
/// Cost: two to four solves.
FreeRoller roll_without_torque(Solver& solver, const RollingProblem& problem, const RollerRadii& radii, Roller driven,
                               const Progress& progress = {});

/// Nips of one problem after another: kernels of bodies and influence numbers of elements are kept as long as they are
/// the same, which changes no result.
class NipAnalysis {
public:
  NipAnalysis();
  ~NipAnalysis();
  NipAnalysis(NipAnalysis&&) noexcept;
  NipAnalysis& operator=(NipAnalysis&&) noexcept;

  /// As nip_of.
  Nip find(const RollingProblem& problem, const ContactSolution& solution, const RollerRadii& radii,
           const Progress& progress = {});
  /// As the function of this name.
  FreeRoller roll_without_torque(Solver& solver, const RollingProblem& problem, const RollerRadii& radii, Roller driven,
                                 const Progress& progress = {});

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

/// Surface speed of a roller, V (1 -+ sigma xi/2) [m/s].
double surface_speed(Roller roller, const Motion& motion, double creepage);

} // namespace microslip
