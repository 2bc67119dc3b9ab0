#include "microslip/railway/wheel_rail.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/contact/mirrored_solution.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/numerics/fade.hpp"
#include "microslip/railway/call_progress.hpp"
#include "microslip/railway/derailment.hpp"
#include "microslip/railway/equivalent_rail.hpp"
#include "microslip/railway/exact_contact.hpp"
#include "microslip/railway/patch_damage.hpp"
#include "microslip/railway/profile_dimensions.hpp"
#include "microslip/railway/relative_motion.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheel_status.hpp"
#include "microslip/railway/wheel_warnings.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
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
  const double roller = bodies.track.roller_radius, nominal = bodies.wheelset.nominal_radius;
  if (roller < 0 && !(-roller > nominal))
    throw Error("roller_radius", roller, "m",
                "a raceway's larger than the wheel's, less than " + std::to_string(-nominal));
  if (bodies.friction.empty()) throw Error("friction: no coefficient is given");
  for (std::size_t k = 0; k < bodies.friction.size(); ++k) {
    require_between("friction", bodies.friction[k].coefficient, "-", 0, FrictionLaw::largest_coefficient);
    if (method.level == WheelRailLevel::exact) require_positive("friction", bodies.friction[k].coefficient, "-");
    require_finite("friction angle", bodies.friction[k].angle, "rad");
    if (k > 0 && !(bodies.friction[k].angle > bodies.friction[k - 1].angle))
      throw Error("friction angle", bodies.friction[k].angle, "rad", "larger than the one before");
  }
  require_shape(method);
  if (method.level == WheelRailLevel::table) {
    if (!method.table) throw Error("table: the level \"table\" needs a creep-force table, and none is given");
    if (method.table->direction() != RollingDirection::forward)
      throw Error("table: must be one for rolling forward; the other direction is its mirror image");
    if (method.fields) throw Error("fields: a creep-force table has none; the levels fastsim2 and exact do");
  }
  require_count("elements", method.elements, 6, 1000);
  require_between("tolerance", method.tolerance, "-", smallest_load_tolerance, largest_load_tolerance);
  const auto& [hardness, shear_yield_strength, wear_map] = bodies.strength;
  if (hardness) require_positive("hardness", *hardness, "Pa");
  if (shear_yield_strength) require_positive("shear_yield_strength", *shear_yield_strength, "Pa");
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

/// And its derivatives.
void mirror(WheelRailDerivatives& d) {
  WheelState<double> ones;
  for (double* x : ones.numbers()) *x = 1;
  WheelState<double> mirrored = ones.mirrored();
  for (std::size_t k = 0; k < wheel_variables; ++k) {
    const double sign = k < state_numbers ? *mirrored.numbers()[k] : 1;
    d.force[k] = sign * d.force[k], d.moment[k] = sign * d.moment[k], d.vertical[k] *= sign;
    for (double* odd : {&d.force[k].y, &d.moment[k].x, &d.moment[k].z}) *odd = -*odd;
  }
}

/// What all patches do to the wheel, and the wheelset's height.
struct Wrench {
  Vec3<double> force, moment;
  double height = 0;

  static Wrench of(const WheelRailSolution& s) { return {s.force, s.moment, s.vertical}; }
  friend Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.moment + b.moment, a.height + b.height};
  }
  friend Wrench operator-(const Wrench& a, const Wrench& b) { return a + -1 * b; }
  friend Wrench operator*(double f, const Wrench& a) { return {f * a.force, f * a.moment, f * a.height}; }
};

/// Derivatives of what a solve finds by the ten basic numbers of a state, of all of them together by the vertical
/// force.
struct BasicDerivatives {
  std::array<Wrench, basic_motions> by{};
  Wrench by_force{};
};
constexpr auto height_number = static_cast<std::size_t>(WheelVariable::vertical);

/// Difference by the state's number k, to the side of the step's sign.
template <class Forces>
Wrench difference(const WheelState<double>& state, std::size_t k, double step, const Wrench& here,
                  const Forces& forces) {
  WheelState<double> there = state;
  *there.numbers()[k] += step;
  return 1 / step * (forces(there) - here);
}

bool is_velocity(std::size_t basic) {
  return basic >= static_cast<std::size_t>(WheelVariable::forward_velocity);
}

/// Steps of differences.
struct DifferenceSteps {
  double place, yaw, creepage; ///< [m], [rad], [-]

  double of(std::size_t basic, double speed) const {
    constexpr double radius = 0.5; // [m]
    switch (static_cast<WheelVariable>(basic)) {
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
};

/// Forward differences at the coarse level: a hundred-thousandth or less of an approach of 50 um and a creepage of
/// 0.001.
constexpr DifferenceSteps coarse_steps = {1e-10, 5e-9, 5e-10};

/// Central ones at the exact level. Elements come and go with every micrometre or so, each with a kink in the forces,
/// and so do those that slide with the creepage: steps take some together. They are small beside the patch's approach
/// [m], on which the load depends where the height is given, and beside creepages of 0.001.
DifferenceSteps exact_steps(double approach, bool force_given) {
  constexpr double of_approach = 0.02, of_approach_with_force = 0.08;
  return {(force_given ? of_approach_with_force : of_approach) * approach, 2e-5, 1e-5};
}

/// Along the track [m], and of the wheel's pitch [rad]: surfaces vary slowly there.
constexpr std::array<std::pair<std::size_t, double>, 2> place_steps = {std::pair{longitudinal_number, 1e-6},
                                                                       {pitch_number, 2e-6}};
constexpr double longer_along = 20; ///< these steps of the exact level
using PlaceDerivatives = std::array<Wrench, place_steps.size()>;

/// From derivatives with the height held to those with the vertical force held, by the implicit function theorem.
BasicDerivatives with_force_held(const BasicDerivatives& height_held) {
  const Wrench& by_height = height_held.by[height_number];
  BasicDerivatives out;
  out.by_force = 1 / by_height.force.z * by_height, out.by_force.height = 1 / by_height.force.z;
  for (std::size_t k = 0; k < basic_motions; ++k)
    out.by[k] = height_held.by[k] - height_held.by[k].force.z * out.by_force;
  return out;
}

/// Returns whether the surfaces are more than a round wheel on a prismatic rail.
bool has_general_surfaces(const WheelRailBodies& bodies) {
  return bodies.rail_surface || bodies.wheel_surface || bodies.track.roller_radius != 0;
}

/// A round wheel and a prismatic rail, those that are given or the equivalent ones of a state.
struct PlainContact {
  WheelRailBodies bodies;
  std::optional<EquivalentRail> equivalent;
  CoarseContact coarse;

  PlainContact(const WheelRailBodies& given, const WheelRailMethod& method, const NominalPlacement& nominal)
      : bodies(given), coarse(bodies, method, nominal) {}
  PlainContact(const WheelRailBodies& given, const WheelRailMethod& method, const NominalPlacement& nominal,
               EquivalentRail rail)
      : bodies(given), equivalent(std::move(rail)), coarse(with_profiles(), method, nominal, &*equivalent) {}

private:
  const WheelRailBodies& with_profiles() {
    bodies.rail = equivalent->rail(), bodies.wheel = equivalent->wheel();
    return bodies;
  }
};

} // namespace

/// Solves left wheels; right ones in a mirror.
struct WheelRail::Workspace {
  WheelRailBodies bodies;
  WheelRailMethod method;
  NominalPlacement nominal = nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel);
  bool is_general = has_general_surfaces(bodies);
  std::unique_ptr<PlainContact> contact = std::make_unique<PlainContact>(bodies, method, nominal);
  std::optional<double> flange_angle = wheel_dimensions(bodies.wheel, default_tape_line(bodies.wheel)).flange_angle;
  std::optional<double> nose = flange_nose(bodies.wheel);
  Warnings of_bodies = warnings_of(bodies);
  WheelRailSolution trial{};
  Progress progress = {}; ///< of the call at hand

  Workspace(WheelRailBodies given, const WheelRailMethod& how) : bodies(std::move(given)), method(how) {
    trial.patches.reserve(most_patches);
  }

  bool is_right() const { return bodies.side == TrackSide::right; }
  WheelState<double> left(const WheelState<double>& state) const { return is_right() ? state.mirrored() : state; }

  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    solve_left(left(state), vertical_force, out);
    if (is_right()) mirror(out);
  }

  void differentiate(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out,
                     WheelRailDerivatives& derivatives) {
    derivatives = {};
    solve_left(left(state), vertical_force, out);
    if (is_solved(out.status) && !find_derivatives(left(state), vertical_force, out, derivatives)) {
      derivatives = {};
      out.status = Status::not_converged, out.residual = 1, out.reason = Unsolved::derivatives;
    }
    if (is_right()) mirror(out), mirror(derivatives);
  }

private:
  /// No number of a state makes it throw: the state has a status, and others can be solved.
  void solve_left(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    try {
      find_forces(state, vertical_force, out);
    } catch (const Error&) {
      out.status = Status::not_converged, out.residual = std::numeric_limits<double>::quiet_NaN();
    }
    conclude(out, state.vertical, method.solved_tolerance());
    assess(out);
    if (method.level != WheelRailLevel::exact && !method.fields) out.fields.clear();
  }

  void find_forces(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    if (!solve_coarse(state, vertical_force, out)) return;
    if (method.surface() == PatchShape::flat)
      out.warnings.add_if(contact->coarse.change_by_planes() > limit(Warning::flat_surface) / 2, Warning::flat_surface);
    if (method.level == WheelRailLevel::exact)
      solve_exact(contact->coarse, state, contact->bodies, method, vertical_force, out, progress);
    else if (method.level == WheelRailLevel::fastsim2 && (method.fields || bodies.strength.hardness))
      contact->coarse.add_fields(out);
  }

  /// What the forces of a left wheel do to the surfaces and to its guidance, and what makes them doubtful.
  void assess(WheelRailSolution& out) const {
    for (std::size_t k = 0; k < out.patches.size(); ++k) {
      const ContactSolution* fields = k < out.fields.size() ? &out.fields[k] : nullptr;
      out.patches[k].damage = patch_damage(bodies.strength, out.patches[k], fields);
    }
    if (out.force.z > 0) out.y_over_q = -out.force.y / out.force.z;
    if (flange_angle) out.nadal_limit = nadal_limit(*flange_angle, contact->coarse.friction(*flange_angle));
    if (out.patches.empty()) return;
    for (const WheelRailPatch& patch : out.patches)
      out.warnings.add_if(method.surface() == PatchShape::flat && patch.turn > largest_flat_turn,
                          Warning::flat_surface);
    out.warnings = out.warnings | of_bodies | warnings_of(bodies, out, nose);
    if (out.status == Status::ok && out.warnings.is_decisive())
      out.status = Status::implausible, out.reason = Unsolved::implausible;
  }

  /// Returns whether there is contact.
  bool solve_coarse(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    out.patches.clear(), out.fields.clear();
    out.patches.reserve(most_patches); // for all that come later
    out.force = out.moment = {};
    out.residual = 0, out.iterations = 0, out.warnings = {};
    out.y_over_q.reset(), out.nadal_limit.reset();
    out.vertical = state.vertical, out.reason = Unsolved::none;
    if (!is_in_range(state) || (vertical_force && !is_vertical_force(*vertical_force))) {
      out.status = Status::invalid_input;
      return false;
    }
    out.status = Status::no_contact;
    if (is_general && !find_equivalent(state, vertical_force.has_value())) return false;
    contact->coarse.solve(state, vertical_force, out);
    if (out.status == Status::no_contact) return false;
    contact->coarse.sum(out);
    return true;
  }

  /// In the state's height, or in that where the wheel first touches. False where there is no rail.
  bool find_equivalent(WheelState<double> state, bool where_it_touches) {
    constexpr int descents = 2;       // the second one from where the first one has found it nearly
    constexpr double searched = 3e-4; // [m]
    for (int k = 0;; ++k) {
      const WheelPlacement<double> placement = place(nominal, state);
      std::optional<EquivalentRail> rail;
      try {
        rail.emplace(
            TrueSurfaces{{&bodies.rail, bodies.rail_surface.get()}, {&bodies.wheel, bodies.wheel_surface.get()}},
            placement);
      } catch (const Error&) { // interrupted
        return false;
      }
      double clearance = std::numeric_limits<double>::infinity();
      if (where_it_touches && k < descents) {
        ContactSearch search(rail->rail(), rail->wheel());
        for (const ContactPoint& point : search.find(placement, searched)) clearance = std::min(clearance, point.gap);
      }
      if (std::isfinite(clearance)) {
        state.vertical -= clearance;
        continue;
      }
      contact = std::make_unique<PlainContact>(bodies, method, nominal, std::move(*rail));
      return true;
    }
  }

  /// False if they are not numbers.
  bool find_derivatives(const WheelState<double>& state, std::optional<double> vertical_force,
                        const WheelRailSolution& found, WheelRailDerivatives& d) {
    try {
      differentiate_left(state, vertical_force, found, d);
    } catch (const Error&) {
      return false;
    }
    double sum = 0;
    for (std::size_t k = 0; k < wheel_variables; ++k)
      sum += dot(d.force[k], {1, 1, 1}) + dot(d.moment[k], {1, 1, 1}) + d.vertical[k];
    return std::isfinite(sum);
  }

  void differentiate_left(WheelState<double> state, std::optional<double> vertical_force,
                          const WheelRailSolution& found, WheelRailDerivatives& d) {
    state.vertical = found.vertical;
    double speed = 0, approach = 0;
    for (const WheelRailPatch& patch : found.patches)
      speed = std::max(speed, patch.rolling_speed), approach = std::max(approach, patch.approach);
    const bool exact = method.level == WheelRailLevel::exact;
    Wrench coarse_here = Wrench::of(found);
    if (exact || vertical_force) {
      solve_coarse(state, {}, trial);
      coarse_here = Wrench::of(trial);
    }
    BasicDerivatives basic = coarse_derivatives(state, speed, coarse_here);
    if (vertical_force) basic = with_force_held(basic);
    PlaceDerivatives by_place = place_derivatives(state, coarse_here, basic);
    if (exact) basic = exact_derivatives(state, vertical_force, speed, approach, basic, by_place);
    const auto motions = relative_motions(nominal, state);
    for (std::size_t k = 0; k < state_numbers; ++k) {
      const Wrench turned = {cross(motions[k].turn, found.force), cross(motions[k].turn, found.moment)};
      Wrench sum = turned - turned.force.z * basic.by_force + motions[k].ahead * by_place[0];
      if (k == pitch_number) sum = sum + by_place[1];
      for (std::size_t i = 0; i < basic_motions; ++i) sum = sum + motions[k].combination[i] * basic.by[i];
      d.force[k] = sum.force, d.moment[k] = sum.moment, d.vertical[k] = sum.height;
    }
    if (vertical_force)
      d.force[height_number] = d.moment[height_number] = {}, d.vertical[height_number] = 0;
    else
      d.vertical[height_number] = 1;
    d.force[state_numbers] = basic.by_force.force, d.moment[state_numbers] = basic.by_force.moment;
    d.vertical[state_numbers] = basic.by_force.height;
  }

  /// The equivalent rail is found anew at each step, to less digits.
  double step_scale() const { return is_general ? 100 : 1; }

  /// By the position along the track and the pitch, forward differences at the coarse level; with what `basic` holds
  /// held.
  PlaceDerivatives place_derivatives(const WheelState<double>& state, const Wrench& here,
                                     const BasicDerivatives& basic) {
    PlaceDerivatives derivatives{};
    if (!is_general) return derivatives;
    for (std::size_t k = 0; k < place_steps.size(); ++k) {
      const auto& [number, step] = place_steps[k];
      Wrench& d = derivatives[k];
      d = difference(state, number, step, here, [&](const WheelState<double>& there) {
        solve_coarse(there, {}, trial);
        return Wrench::of(trial);
      });
      d.height = 0;
      d = d - d.force.z * basic.by_force;
    }
    return derivatives;
  }

  /// Forward differences with the height held. Velocities alone need no new pressures: they come first, instead of
  /// the last solve.
  BasicDerivatives coarse_derivatives(const WheelState<double>& state, double speed, const Wrench& here) {
    BasicDerivatives derivatives;
    for (std::size_t k = basic_motions; k-- > 0;) {
      const double step = step_scale() * coarse_steps.of(k, speed);
      if (!(step > 0)) continue;
      derivatives.by[k] = difference(state, k, step, here, [&](const WheelState<double>& there) {
        if (is_velocity(k)) {
          contact->coarse.move(there);
          contact->coarse.sum(trial);
        } else {
          solve_coarse(there, {}, trial);
        }
        return Wrench::of(trial);
      });
      derivatives.by[k].height = 0; // held
    }
    return derivatives;
  }

  /// Central differences, with held what is given.
  BasicDerivatives exact_derivatives(const WheelState<double>& state, std::optional<double> vertical_force,
                                     double speed, double approach, const BasicDerivatives& coarse_level,
                                     PlaceDerivatives& by_place) {
    constexpr double share_of_force = 1e-3;
    const DifferenceSteps steps = exact_steps(approach, vertical_force.has_value());
    const auto forces = [&](const WheelState<double>& there, std::optional<double> force) {
      solve_left(there, force, trial);
      return Wrench::of(trial);
    };
    const auto central = [&](std::size_t number, double step) {
      WheelState<double> there = state;
      double& x = *there.numbers()[number];
      const double here = x;
      x = here + step;
      const Wrench up = forces(there, vertical_force);
      x = here - step;
      Wrench d = 0.5 / step * (up - forces(there, vertical_force));
      if (!vertical_force) d.height = 0; // as it is given
      return d;
    };
    BasicDerivatives derivatives = coarse_level;
    for (std::size_t k = 0; k < basic_motions; ++k) {
      const double step = steps.of(k, speed);
      if (step > 0 && !(vertical_force && k == height_number)) derivatives.by[k] = central(k, step);
    }
    if (is_general)
      for (std::size_t k = 0; k < place_steps.size(); ++k)
        by_place[k] = central(place_steps[k].first, longer_along * place_steps[k].second);
    if (!vertical_force) return derivatives;
    const double step = share_of_force * *vertical_force;
    derivatives.by_force = 0.5 / step * (forces(state, *vertical_force + step) - forces(state, *vertical_force - step));
    return derivatives;
  }
};

double WheelRailMethod::conformity(double turn) const {
  constexpr double curved = 10 * std::numbers::pi / 180, conformal = 18 * std::numbers::pi / 180; // [rad]
  if (level != WheelRailLevel::exact) return 0;
  if (shape) return *shape == PatchShape::conformal ? 1 : 0;
  return 1 - fade(turn, curved, conformal);
}

void require_shape(const WheelRailMethod& method, const std::string& name) {
  if (method.level == WheelRailLevel::exact || method.surface() == PatchShape::curved) return;
  throw Error(name + ": the rows of " + (method.level == WheelRailLevel::table ? "table" : "fastsim2") +
              " follow the surface: curved, or left out");
}

WheelRail::WheelRail(WheelRailBodies bodies, const WheelRailMethod& method) {
  check(bodies, method);
  workspace_ = std::make_unique<Workspace>(std::move(bodies), method);
}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;

void WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                      WheelRailSolution& solution, const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->solve(state, vertical_force, solution);
}

WheelRailSolution WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                                   const Progress& progress) {
  WheelRailSolution solution;
  solve(state, vertical_force, solution, progress);
  return solution;
}

void WheelRail::differentiate(const WheelState<double>& state, std::optional<double> vertical_force,
                              WheelRailSolution& solution, WheelRailDerivatives& derivatives,
                              const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->differentiate(state, vertical_force, solution, derivatives);
}

} // namespace microslip
