#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/classical/slip_friction.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace microslip {

/// The semi-axes of a Hertzian contact, along the rolling direction and across [m].
struct Ellipse {
  double a = 0, b = 0;
};

/// The undeformed distance of the bodies on a grid of elements: as a formula h(x, y) [m], or as values at the elements'
/// centres.
struct GapFormula {
  ElementGrid grid;
  std::function<double(double x, double y)> gap;
};
struct GapValues {
  ElementGrid grid;
  std::vector<double> gap; ///< h [m], in the order of Elements
};

/// The shape of the bodies about their contact: an ellipse that is known, or curvatures h = A x^2 + B y^2 from which
/// Hertz's theory finds it, or any gap on a grid. B = 0, cylinders with parallel axes, is for bodies with layers: in
/// line contact loads, forces and moments are those of a metre along the axes. There the displacements of half-spaces
/// below layers, and with them the approach, are relative to those of surfaces at the distance R = 1/(2 A).
using ContactGeometry = std::variant<Ellipse, GapCurvatures, GapFormula, GapValues>;

/// Friction between the bodies.
struct FrictionModel {
  FrictionLaw law = {};
  FrictionMemory memory = {};                               ///< of laws that depend on the slip
  std::optional<TemperatureEffect> temperature_effect = {}; ///< needs the bodies' thermal data
};

/// Motion of the bodies over each other.
struct Motion {
  ContactMotion kind = ContactMotion::steady;
  Creepage creepage = {};                           ///< for a shift the rigid shift [m] and rotation [rad]
  std::optional<double> force_x = {}, force_y = {}; ///< prescribed on body 1 [N], instead of that creepage
  double rolling_speed = 1;                         ///< V [m/s], > 0
  RollingDirection direction = RollingDirection::forward;
  double step = 0; ///< dq [m], the distance rolled in a step, >= 0; 0: the elements' length
  int steps = 1;   ///< of transient rolling, from zero tractions on, 1 to 1,000,000; all under the same conditions
};

/// V with the sign of the direction, positive along +x [m/s].
double rolling_velocity(const Motion& motion);

/// Two bodies that roll or are shifted over each other: everything that is given, in SI units.
struct RollingProblem {
  ContactGeometry geometry = {};
  Bodies bodies = {};   ///< combined material, with K; retarded parts; a layer between them
  NormalLoad load = {}; ///< normal force or approach
  FrictionModel friction = {};
  Motion motion = {};
  std::optional<ThermalBodies> thermal = {}; ///< bodies whose surfaces have temperatures
  /// Bodies with layers in place of `bodies`, which are left out: the exact theory on classical elements. Viscoelastic
  /// ones roll with the motion's speed.
  std::optional<LayeredBodies> layered = {};
};

/// A Hertzian contact as a problem: `motion` is what there is beyond its creepages and its speed.
RollingProblem rolling_problem(const EllipticContact& contact, const Motion& motion = {});

/// Returns whether the bodies touch in an ellipse, so that Hertz's theory and the simplified theory hold.
bool is_hertzian(const RollingProblem& problem);

/// Elastic half-spaces of the bodies' materials; of bodies with layers those of their surfaces' materials.
CombinedMaterial half_spaces(const RollingProblem& problem);

/// Returns whether the bodies touch in a line, by their curvatures or on a grid of strips.
bool is_line_contact(const RollingProblem& problem);

/// The ellipse of a Hertzian problem, of half_spaces without friction; of the line contact of bodies with layers a is
/// half its width, and b, approach and stiffness are NaN; by an approach all but the curvatures is. Throws Error for a
/// problem that is not Hertzian and for numbers out of range.
HertzContact hertz_contact(const RollingProblem& problem);

/// A Hertzian problem as the solvers of either theory take it. Of an ellipse under a force the numbers may be out of
/// range, which these solvers tell; else throws as hertz_contact.
EllipticContact elliptic_contact(const RollingProblem& problem);
EllipticContact elliptic_contact(const RollingProblem& problem, const HertzContact& hertz);

/// Throws Error for forces, a step or a number of steps out of range.
void check(const Motion& motion);

} // namespace microslip
