#include "microslip/railway/wheel_rail.hpp"

#include "microslip/contact/mirrored_solution.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/derailment.hpp"
#include "microslip/railway/exact_contact.hpp"
#include "microslip/railway/patch_damage.hpp"
#include "microslip/railway/profile_dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

void check(const WheelRailBodies& bodies, const WheelRailMethod& method) {
  if (bodies.rail.role() != ProfileRole::rail) throw Error("rail: its profile is that of a wheel");
  if (bodies.wheel.role() != ProfileRole::wheel) throw Error("wheel: its profile is that of a rail");
  require_positive("shear_modulus", bodies.material.shear_modulus, "Pa");
  require_between("poisson_ratio", bodies.material.poisson_ratio, "-", 0, 0.5);
  if (bodies.material.dissimilarity != 0)
    throw Error("dissimilarity", bodies.material.dissimilarity, "-", "0: wheel and rail are elastically similar");
  if (bodies.friction.empty()) throw Error("friction: no coefficient is given");
  for (std::size_t k = 0; k < bodies.friction.size(); ++k) {
    require_between("friction", bodies.friction[k].coefficient, "-", 0, FrictionLaw::largest_coefficient);
    if (method.level == WheelRailLevel::exact) require_positive("friction", bodies.friction[k].coefficient, "-");
    require_finite("friction angle", bodies.friction[k].angle, "rad");
    if (k > 0 && !(bodies.friction[k].angle > bodies.friction[k - 1].angle))
      throw Error("friction angle", bodies.friction[k].angle, "rad", "larger than the one before");
  }
  require_count("elements", method.elements, 6, 1000);
  require_between("tolerance", method.tolerance, "-", 1e-12, 1e-2);
  const auto& [hardness, shear_yield_strength, wear_map] = bodies.strength;
  if (hardness) require_positive("hardness", *hardness, "Pa");
  if (shear_yield_strength) require_positive("shear_yield_strength", *shear_yield_strength, "Pa");
}

/// All numbers of a state added up: not finite if one of them is not.
double checksum(const WheelState<double>& s) {
  const WheelDeflection<double>& d = s.deflection;
  const RailDeviation<double>& r = s.rail;
  return s.lateral + s.vertical + s.roll + s.yaw + s.forward_velocity + s.lateral_velocity + s.vertical_velocity +
         s.roll_velocity + s.pitch_velocity + s.yaw_velocity + s.curvature + d.longitudinal + d.lateral + d.vertical +
         d.roll + d.yaw + d.longitudinal_velocity + d.lateral_velocity + d.vertical_velocity + d.roll_velocity +
         d.pitch_velocity + d.yaw_velocity + r.lateral + r.vertical + r.roll + r.lateral_velocity +
         r.vertical_velocity + r.roll_velocity;
}

/// A left wheel's solution as that of a right one.
void mirror(WheelRailSolution& out) {
  for (double* odd : {&out.force.y, &out.moment.x, &out.moment.z}) *odd = -*odd;
  for (WheelRailPatch& patch : out.patches)
    for (double* odd :
         {&patch.place.y, &patch.angle, &patch.creepage.lateral, &patch.creepage.spin, &patch.fs, &patch.moment})
      *odd = -*odd;
  for (ContactSolution& fields : out.fields) mirror(fields);
}

/// The variable of a state.
double& variable(WheelState<double>& s, WheelVariable which) {
  double* const places[wheel_variables] = {&s.lateral,
                                           &s.vertical,
                                           &s.roll,
                                           &s.yaw,
                                           &s.forward_velocity,
                                           &s.lateral_velocity,
                                           &s.vertical_velocity,
                                           &s.roll_velocity,
                                           &s.pitch_velocity,
                                           &s.yaw_velocity};
  return *places[static_cast<std::size_t>(which)];
}

bool is_velocity(WheelVariable which) {
  return which >= WheelVariable::forward_velocity;
}

/// Half the step of a central difference: places change an approach of 50 um, velocities a creepage of .001
/// by a ten-thousandth.
double difference_step(WheelVariable which, double speed) {
  constexpr double place = 5e-9, yaw = 2e-7, creepage = 1e-7, radius = 0.5; // [m], [rad], [-], [m]
  switch (which) {
  case WheelVariable::lateral:
  case WheelVariable::vertical:
    return place;
  case WheelVariable::roll:
    return place / radius;
  case WheelVariable::yaw:
    return yaw;
  case WheelVariable::forward_velocity:
  case WheelVariable::lateral_velocity:
  case WheelVariable::vertical_velocity:
    return creepage * speed;
  default:
    return creepage * speed / radius;
  }
}

} // namespace

struct WheelRail::Workspace {
  WheelRailBodies bodies;
  WheelRailMethod method;
  CoarseContact coarse{bodies, method};
  std::optional<double> flange_angle = wheel_dimensions(bodies.wheel, default_tape_line(bodies.wheel)).flange_angle;
  WheelRailSolution trial{};

  /// Forces in the place of the state, beside the solution in it; after a solve in the same place velocities alone need
  /// no new pressures at the coarse level.
  void try_state(const WheelState<double>& state, bool same_place) {
    if (!same_place || method.level == WheelRailLevel::exact) {
      solve(state, {}, trial);
      return;
    }
    const bool right = bodies.side == TrackSide::right;
    coarse.move(right ? state.mirrored() : state);
    coarse.sum(trial);
    if (right) mirror(trial);
  }

  void differentiate(WheelState<double> state, std::optional<double> vertical_force, WheelRailSolution& out,
                     WheelRailDerivatives& derivatives) {
    solve(state, vertical_force, out);
    derivatives = {};
    if (out.status != Status::ok) return;
    state.vertical = out.vertical;
    const double larger = method.level == WheelRailLevel::exact ? 100 : 1; // its forces have the error of a tolerance
    double speed = 0;
    for (const WheelRailPatch& patch : out.patches) speed = std::max(speed, patch.rolling_speed);
    for (std::size_t k = wheel_variables; k-- > 0;) {
      const WheelVariable which = static_cast<WheelVariable>(k);
      const double step = larger * difference_step(which, speed);
      if (!(step > 0)) continue;
      const bool velocity = is_velocity(which);
      if (k + 1 == wheel_variables && vertical_force) solve(state, {}, trial);
      WheelState<double> low = state, high = state;
      variable(low, which) -= step, variable(high, which) += step;
      try_state(high, velocity);
      const Vec3<double> force = trial.force, moment = trial.moment;
      try_state(low, velocity);
      derivatives.force[k] = 0.5 / step * (force - trial.force);
      derivatives.moment[k] = 0.5 / step * (moment - trial.moment);
    }
    if (vertical_force) hold_vertical_force(derivatives);
  }

  /// From derivatives with the height held to those with the vertical force held.
  static void hold_vertical_force(WheelRailDerivatives& d) {
    constexpr auto height = static_cast<std::size_t>(WheelVariable::vertical);
    const Vec3<double> force = d.force[height], moment = d.moment[height];
    for (std::size_t k = 0; k < wheel_variables; ++k) {
      d.vertical[k] = k == height ? 1 / force.z : -d.force[k].z / force.z;
      const Vec3<double> direct_force = k == height ? Vec3<double>{} : d.force[k];
      const Vec3<double> direct_moment = k == height ? Vec3<double>{} : d.moment[k];
      d.force[k] = direct_force + d.vertical[k] * force;
      d.moment[k] = direct_moment + d.vertical[k] * moment;
    }
  }

  void solve(const WheelState<double>& given, std::optional<double> vertical_force, WheelRailSolution& out) {
    const bool right = bodies.side == TrackSide::right;
    const WheelState<double> state = right ? given.mirrored() : given;
    out.patches.clear(), out.fields.clear();
    out.force = out.moment = {};
    out.residual = 0, out.iterations = 0, out.at_profile_end = false;
    out.vertical = state.vertical;
    out.y_over_q.reset(), out.nadal_limit.reset();
    if (!std::isfinite(checksum(state)) || (vertical_force && !(*vertical_force > 0 && *vertical_force < 1e12))) {
      out.status = Status::invalid_input;
      return;
    }
    coarse.solve(state, vertical_force, out);
    if (out.status == Status::no_contact) return;
    coarse.sum(out);
    if (method.level == WheelRailLevel::exact)
      solve_exact(coarse, state, bodies, method, vertical_force, out);
    else if (method.fields || bodies.strength.hardness)
      coarse.add_fields(out);
    assess(out);
    if (method.level != WheelRailLevel::exact && !method.fields) out.fields.clear();
    if (right) mirror(out);
  }

  /// What the forces of a left wheel do to the surfaces and to its guidance.
  void assess(WheelRailSolution& out) const {
    for (std::size_t k = 0; k < out.patches.size(); ++k) {
      const ContactSolution* fields = k < out.fields.size() ? &out.fields[k] : nullptr;
      out.patches[k].damage = patch_damage(bodies.strength, out.patches[k], fields);
    }
    if (out.force.z > 0) out.y_over_q = -out.force.y / out.force.z;
    if (flange_angle) out.nadal_limit = nadal_limit(*flange_angle, coarse.friction(*flange_angle));
  }
};

WheelRail::WheelRail(WheelRailBodies bodies, const WheelRailMethod& method) {
  check(bodies, method);
  workspace_ = std::unique_ptr<Workspace>(new Workspace{std::move(bodies), method});
}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;

void WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                      WheelRailSolution& solution) {
  workspace_->solve(state, vertical_force, solution);
}

WheelRailSolution WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force) {
  WheelRailSolution solution;
  workspace_->solve(state, vertical_force, solution);
  return solution;
}

void WheelRail::differentiate(const WheelState<double>& state, std::optional<double> vertical_force,
                              WheelRailSolution& solution, WheelRailDerivatives& derivatives) {
  workspace_->differentiate(state, vertical_force, solution, derivatives);
}

} // namespace microslip
