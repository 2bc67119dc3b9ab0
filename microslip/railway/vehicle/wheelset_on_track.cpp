#include "microslip/railway/vehicle/wheelset_on_track.hpp"

#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/numerics/damped_newton.hpp"
#include "microslip/railway/call_progress.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/problem/wheel_status.hpp"
#include "microslip/railway/vehicle/wheelset_equations.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheel_theories.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

bool is_valid(const WheelsetState& state, const WheelsetLoad& load) {
  if (!is_in_range(state.left) || !is_in_range(state.right())) return false;
  if (load.axle_torque && !std::isfinite(*load.axle_torque)) return false;
  if (!load.vertical) return true;
  if (const auto* both = std::get_if<AxleLoad>(&*load.vertical))
    return is_vertical_force(both->vertical_force) && std::isfinite(both->roll_moment);
  const auto& [left, right] = std::get<WheelLoads>(*load.vertical);
  return is_vertical_force(left) && is_vertical_force(right);
}

bool is_finite(const WheelsetSolution& s) {
  return std::isfinite(dot(s.force, s.force) + dot(s.moment, s.moment) + s.vertical + s.roll + s.pitch_velocity);
}

/// Makes status and numbers agree, as conclude() of a wheel does.
void conclude(const WheelsetLoad& load, double tolerance, WheelsetSolution& out) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (out.status == Status::invalid_input) {
    out.force = out.moment = {none, none, none};
    out.residual = none;
  } else if (!is_finite(out)) {
    out.left = out.right = {};
    out.force = out.moment = {}, out.vertical = out.roll = out.pitch_velocity = 0;
    out.status = Status::not_converged, out.residual = 1;
  }
  if (load.vertical && is_solved(out.status))
    for (const WheelRailSolution* wheel : {&out.left, &out.right})
      out.warnings.add_if(wheel->force.z < limit(Warning::wheel_lifted) * out.force.z / 2, Warning::wheel_lifted);
  // What was not solved has a residual that says so, and the reason that a wheel has.
  if (out.status == Status::not_converged && out.residual <= tolerance) out.residual = 1;
  out.reason = usual_reason(out.status, Unsolved::off_its_rail, Unsolved::no_balance);
  for (const WheelRailSolution* wheel : {&out.left, &out.right})
    if (out.status == Status::not_converged && wheel->status == out.status && out.reason == Unsolved::residual)
      out.reason = wheel->reason;
}

/// The faster method for starts and slopes; its rows follow the surface, whatever shape is given.
WheelRailMethod fast_method(const WheelRailMethod& method) {
  return {.tolerance = method.tolerance};
}

/// The bodies without layers, which it does not have.
WheelRailBodies half_spaces(WheelRailBodies bodies) {
  bodies.layered.reset();
  return bodies;
}

} // namespace

struct WheelsetOnTrack::Workspace {
  double tolerance; ///< of the residual
  WheelsetSearch rigid;
  WheelPair wheels;
  std::optional<WheelPair> fast; ///< where the wheels are solved by elements: for starts and slopes
  WheelsetSolution trial{};
  WheelPairDerivatives slopes{};
  int evaluations = 0, iterations = 0; ///< of both wheels, of the search, in this solve
  Progress progress = {};              ///< of the call at hand

  Workspace(const WheelRailBodies& l, const WheelRailBodies& r, const WheelRailMethod& method)
      : tolerance(method.tolerance), rigid(l.track, l.wheelset, {l.rail, l.wheel}, {r.rail, r.wheel}),
        wheels(l, r, method) {
    if (!theory_of(method).by_elements) return;
    tolerance = std::max(tolerance, 1e-5);
    fast.emplace(half_spaces(l), half_spaces(r), fast_method(method));
  }

  WheelPair& first() { return fast ? *fast : wheels; }

  void solve(WheelsetState state, const WheelsetLoad& load, WheelsetSolution& out) {
    out.residual = 0, iterations = 0, evaluations = 0;
    if (is_valid(state, load))
      find_balance(state, load, out);
    else
      leave_unsolved(state, Status::invalid_input, out);
    out.iterations = iterations;
    conclude(load, tolerance, out);
  }

  void differentiate(WheelsetState state, const WheelsetLoad& load, WheelsetSolution& out,
                     WheelsetDerivatives& derivatives) {
    solve(state, load, out);
    derivatives = {};
    if (!is_solved(out.status)) return;
    state.left.vertical = out.vertical, state.left.roll = out.roll, state.left.pitch_velocity = out.pitch_velocity;
    const Warnings warnings = out.warnings;
    wheels.differentiate(state, out, slopes, progress);
    out.warnings = warnings;
    if (!is_solved(out.status)) {
      out.residual = 1, out.reason = Unsolved::derivatives;
      return;
    }
    WheelsetEquations(state, load, wheels, out.force.z).hold(state, out, slopes, derivatives);
  }

private:
  /// Finds the balance by Newton's method from where both wheels carry their shares, else between brackets; at the
  /// level exact from there on.
  void find_balance(WheelsetState state, const WheelsetLoad& load, WheelsetSolution& out) {
    if (!load.vertical && !load.axle_torque) return evaluate(wheels, state, out);
    wheels.reset(), first().reset();
    if (!start(load, state)) return leave_unsolved(state, Status::no_contact, out);
    evaluate(first(), state, out);
    const WheelsetEquations equations(state, load, wheels, out.force.z);
    const WheelsetState begin = state;
    bool found = balance(first(), equations, state, out);
    Status reason = Status::not_converged;
    if (!found) {
      state = begin;
      if (!bracket(equations, state) && !has_spent_all()) reason = Status::no_solution;
      found = balance(first(), equations, state, out);
    }
    if (fast) found = balance(wheels, equations, state, out);
    if (found && !fast) {
      wheels.reset();
      evaluate(wheels, state, out); // what the state has, to the last bit
    }
    if (!found) out.status = reason;
  }

  void leave_unsolved(const WheelsetState& state, Status status, WheelsetSolution& out) const {
    out.left = out.right = {};
    wheels.sum(state, out);
    out.status = status;
  }

  /// Moves to where both rigid wheels touch, lowered until each carries its share; rolling freely. False where one is
  /// off its rail.
  bool start(const WheelsetLoad& load, WheelsetState& state) {
    double radius = wheels.nominal_radius();
    if (load.vertical) {
      const WheelsetContact touch = rigid.solve(state);
      if (touch.status == Status::no_contact) return false;
      state.left.roll = touch.roll, state.left.vertical = touch.vertical;
      radius = (touch.left.radius + touch.right.radius) / 2;
    }
    if (load.axle_torque) state.left.pitch_velocity = state.left.forward_velocity / radius;
    if (load.vertical) {
      const auto* both = std::get_if<AxleLoad>(&*load.vertical);
      lower(state, both ? WheelLoads{both->vertical_force / 2, both->vertical_force / 2}
                        : std::get<WheelLoads>(*load.vertical));
      state.left.roll += apart() / (2 * wheels.half_base());
      state.left.vertical = middle();
    }
    return true;
  }

  void evaluate(WheelPair& by, const WheelsetState& state, WheelsetSolution& out) {
    ++evaluations;
    by.solve(state, {}, out, progress);
  }

  /// Lowers each wheel by itself until it carries its load: `trial`.
  void lower(const WheelsetState& state, const WheelLoads& loads) {
    ++evaluations;
    first().solve(state, loads, trial, progress);
  }
  /// Height of the left wheel over the right one, and of the wheelset [m].
  double apart() const { return trial.left.vertical - trial.right.vertical; }
  double middle() const { return (trial.left.vertical + trial.right.vertical) / 2; }

  /// A state and its solution for find_root, with forces of `wheels` and slopes of the faster ones.
  struct Balance {
    Workspace& work;
    WheelPair& wheels;
    const WheelsetEquations& equations;
    WheelsetState& state;
    WheelsetSolution& solution;
    WheelsetState tried = {};

    WheelsetEquations::Vector residual(const WheelsetEquations::Vector& step) {
      tried = equations.moved(state, step);
      work.evaluate(wheels, tried, work.trial);
      return equations.residual(tried, work.trial);
    }
    void accept() {
      state = tried;
      std::swap(solution, work.trial);
    }
    WheelsetEquations::Matrix jacobian() {
      work.first().differentiate(state, work.trial, work.slopes, work.progress);
      return equations.jacobian(state, work.trial, work.slopes);
    }
  };

  /// Newton's method from `state` on, which becomes the best one found. Of no use across jumps.
  bool balance(WheelPair& by, const WheelsetEquations& equations, WheelsetState& state, WheelsetSolution& out) {
    const auto [residual, steps] = find_root<3>(Balance{*this, by, equations, state, out}, tolerance);
    iterations += steps;
    out.residual = residual;
    return residual <= tolerance;
  }

  /// Brackets within brackets end after some hundred times as many evaluations as Newton's method takes.
  bool has_spent_all() const {
    constexpr int most_evaluations = 1500;
    return evaluations > most_evaluations;
  }

  /// Brackets the zero of a falling function of a number of the state, which stays as it is where there is none.
  template <class Function>
  bool find(double& number, double step, double reach, double precision, const Function& function) {
    const double start = number;
    const auto value = [&](double at) {
      number = at;
      return has_spent_all() ? 0.0 : function();
    };
    if (find_root_nearby(start, step, start - reach, start + reach, precision, value)) return true;
    number = start;
    return false;
  }

  /// Brackets the pitch velocity at which the contacts balance the torque; `forces` finds those of a state in `trial`.
  template <class Forces>
  bool bracket_pitch(const WheelsetEquations& equations, WheelsetState& state, const Forces& forces) {
    constexpr auto pitch = WheelsetEquations::pitch_velocity;
    const auto residual = [&] {
      ++iterations;
      forces(state);
      return equations.residual(state, trial)[pitch];
    };
    if (!equations.finds(pitch)) return residual(), true;
    const double step = equations.size_of(pitch), reach = 1e3 * step; // up to full sliding
    return find(state.left.pitch_velocity, step, reach, tolerance / 4, residual);
  }

  /// Brackets by shares of the load: each wheel is lowered by itself until it carries its share; bracketed are the roll
  /// angle with both at the same height and the share with the roll moment. Forces of a wheel are a smooth function of
  /// its load also where they change much with its height. Returns false if no pitch, roll or share is found.
  bool bracket(const WheelsetEquations& equations, WheelsetState& state) {
    if (!equations.finds(WheelsetEquations::height))
      return bracket_pitch(equations, state, [&](const WheelsetState& s) { evaluate(first(), s, trial); });
    constexpr double least_share = 1e-3, first_step = 0.05, largest_roll = 0.05;
    bool has_pitch = true, has_roll = true;
    const auto moment = [&](double share) {
      const auto lowered_apart = [&] {
        has_pitch = bracket_pitch(equations, state, [&](const WheelsetState& s) { lower(s, equations.loads(share)); });
        return apart();
      };
      has_roll = find(state.left.roll, equations.size_of(WheelsetEquations::roll), largest_roll,
                      tolerance * equations.size_of(WheelsetEquations::height), lowered_apart);
      return equations.has_wheel_loads() ? 0 : -equations.residual(state, trial)[1];
    };
    const bool has_share =
        find_root_nearby(equations.share(), first_step, least_share, 1 - least_share, tolerance, moment).has_value();
    state.left.vertical = middle();
    return has_pitch && has_roll && has_share;
  }
};

namespace {

WheelRailBodies on_side(WheelRailBodies bodies, TrackSide side) {
  bodies.side = side;
  return bodies;
}

} // namespace

WheelsetOnTrack::WheelsetOnTrack(const WheelRailBodies& bodies, const WheelRailMethod& method)
    : WheelsetOnTrack(bodies, bodies, method) {}

WheelsetOnTrack::WheelsetOnTrack(WheelRailBodies left, WheelRailBodies right, const WheelRailMethod& method) {
  right.track = left.track, right.wheelset = left.wheelset;
  workspace_ = std::make_unique<Workspace>(on_side(std::move(left), TrackSide::left),
                                           on_side(std::move(right), TrackSide::right), method);
}
WheelsetOnTrack::WheelsetOnTrack(WheelsetOnTrack&&) noexcept = default;
WheelsetOnTrack& WheelsetOnTrack::operator=(WheelsetOnTrack&&) noexcept = default;
WheelsetOnTrack::~WheelsetOnTrack() = default;

void WheelsetOnTrack::solve(const WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& solution,
                            const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->solve(state, load, solution);
}

WheelsetSolution WheelsetOnTrack::solve(const WheelsetState& state, const WheelsetLoad& load,
                                        const Progress& progress) {
  WheelsetSolution solution;
  solve(state, load, solution, progress);
  return solution;
}

void WheelsetOnTrack::reset() {
  workspace_->wheels.reset(), workspace_->first().reset();
}

void WheelsetOnTrack::differentiate(const WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& solution,
                                    WheelsetDerivatives& derivatives, const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->differentiate(state, load, solution, derivatives);
}

} // namespace microslip
