#include "microslip/railway/wheelset_on_track.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/numerics/elimination.hpp"
#include "microslip/railway/call_progress.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheel_status.hpp"
#include "microslip/railway/wheelset_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

using Three = std::array<double, 3>;
using Matrix3 = std::array<Three, 3>;

constexpr std::size_t column(WheelsetVariable which) {
  return static_cast<std::size_t>(which);
}
/// The numbers of the state come first, in the same order as for a wheel.
constexpr std::size_t state_variables = column(WheelsetVariable::vertical_force);
static_assert(static_cast<std::size_t>(WheelVariable::yaw_velocity) == column(WheelsetVariable::yaw_velocity));
/// What may be found: height, roll, pitch velocity.
constexpr std::array<std::size_t, 3> unknown_columns = {
    column(WheelsetVariable::vertical), column(WheelsetVariable::roll), column(WheelsetVariable::pitch_velocity)};

Three unknowns_of(const WheelsetState& state) {
  return {state.left.vertical, state.left.roll, state.left.pitch_velocity};
}
void set_unknowns(WheelsetState& state, const Three& u) {
  state.left.vertical = u[0], state.left.roll = u[1], state.left.pitch_velocity = u[2];
}

double largest(const Three& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}
double length(const Three& v) {
  return std::hypot(v[0], v[1], v[2]);
}

Vec3<double> mirrored(const Vec3<double>& v) {
  return {v.x, -v.y, v.z};
}

/// Solves m x = b; false for a matrix that is singular.
bool solve_linear(const Matrix3& m, const Three& b, Three& x) {
  std::array<double, 9> rows;
  for (std::size_t i = 0; i < 3; ++i) std::copy(m[i].begin(), m[i].end(), rows.begin() + 3 * i);
  x = b;
  return eliminate(rows, {x});
}

/// Broyden's update: the matrix that differs least from m and has the difference `change` along `step`.
void update(Matrix3& m, const Three& step, const Three& change) {
  const double square = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const double missing = change[i] - m[i][0] * step[0] - m[i][1] * step[1] - m[i][2] * step[2];
    for (std::size_t j = 0; j < 3; ++j) m[i][j] += missing * step[j] / square;
  }
}

struct Range {
  double low, high;
};

/// The zero of a decreasing function near x: bracketed in steps that double, then by find_bracketed_root. x stays where
/// it is if there is none in the range.
template <class Function>
Status find_zero(double& x, double step, const Range& range, double tolerance, const Function& function) {
  const double start = x, precision = 1e-10 * step;
  const auto at = [&](double place) {
    x = place;
    return function(place);
  };
  RootSide low{x, at(x)};
  if (std::abs(low.value) <= tolerance) return Status::ok;
  step = std::copysign(step, low.value);
  RootSide high = low;
  for (; high.value * low.value > 0; step *= 2) {
    low = high;
    const double next = std::clamp(low.at + step, range.low, range.high);
    if (!(std::abs(next - low.at) > precision)) {
      x = start;
      return Status::no_solution;
    }
    high = {next, at(next)};
  }
  return find_bracketed_root(low, high, tolerance, precision, at).found ? Status::ok : Status::not_converged;
}

struct Wheels {
  WheelRail left, right;
};

/// The prescribed forces as three numbers: F_z; M_x, or F_z of the left wheel less that of the right one; the moment of
/// the contacts about the axle. With sizes that their residuals are measured by, and those of the unknowns.
struct Target {
  bool load = false, of_wheels = false, torque = false;
  Three value{}, size{1, 1, 1}, unknown_size{};

  bool finds(std::size_t k) const { return k < 2 ? load : torque; }
};

Vec3<double> axle(const WheelState<double>& s) {
  return rotation_about_x(s.roll) * (rotation_about_z(s.yaw) * Vec3<double>{0, 1, 0});
}

/// The axes about which roll and yaw turn the wheelset.
Vec3<double> turning_axis(const WheelState<double>& s, std::size_t variable) {
  if (variable == column(WheelsetVariable::roll)) return {1, 0, 0};
  if (variable == column(WheelsetVariable::yaw)) return rotation_about_x(s.roll) * Vec3<double>{0, 0, 1};
  return {};
}

bool is_finite(const WheelsetSolution& s) {
  return std::isfinite(dot(s.force, s.force) + dot(s.moment, s.moment) + s.vertical + s.roll + s.pitch_velocity);
}

} // namespace

struct WheelsetOnTrack::Workspace {
  WheelRailMethod method;
  NominalPlacement left_place, right_place;
  WheelsetSearch rigid;
  Wheels wheels;
  std::optional<Wheels> coarse; ///< at the level exact: for starts and slopes
  WheelsetSolution trial{};
  WheelRailDerivatives by_left{}, by_right{};
  WheelsetDerivatives slopes{};
  int evaluations = 0;    ///< of both wheels in this solve
  Progress progress = {}; ///< of the call at hand

  Workspace(const WheelRailBodies& l, const WheelRailBodies& r, const WheelRailMethod& how)
      : method(how), left_place(nominal_placement(l.track, l.rail, l.wheelset, l.wheel)),
        right_place(nominal_placement(r.track, r.rail, r.wheelset, r.wheel)),
        rigid(l.track, l.wheelset, {l.rail, l.wheel}, {r.rail, r.wheel}), wheels{{l, how}, {r, how}} {
    if (how.level != WheelRailLevel::exact) return;
    const WheelRailMethod fast{.tolerance = how.tolerance}; // whose rows follow the surface, whatever shape is given
    coarse.emplace(Wheels{{l, fast}, {r, fast}});
  }

  /// Brackets within brackets end after some hundred times as many evaluations as Newton's method takes.
  bool has_spent_all() const {
    constexpr int most_evaluations = 1500;
    return evaluations > most_evaluations;
  }

  double tolerance() const { return coarse ? std::max(method.tolerance, 1e-5) : method.tolerance; }

  /// From the wheelset's centre to that of a wheel.
  static Vec3<double> lever(const NominalPlacement& nominal, const WheelState<double>& s) {
    return place(nominal, s).wheel.frame.origin - Vec3<double>{0, s.lateral, nominal.nominal_radius + s.vertical};
  }
  Vec3<double> left_lever(const WheelsetState& s) const { return lever(left_place, s.left); }
  Vec3<double> right_lever(const WheelsetState& s) const { return mirrored(lever(right_place, s.right().mirrored())); }

  /// Adds up both wheels.
  void sum(const WheelsetState& state, WheelsetSolution& out) const {
    const auto &l = out.left, &r = out.right;
    out.force = l.force + r.force;
    out.moment = l.moment + r.moment + cross(left_lever(state), l.force) + cross(right_lever(state), r.force);
    out.vertical = state.left.vertical, out.roll = state.left.roll, out.pitch_velocity = state.left.pitch_velocity;
    const auto either = [&](Status status) { return l.status == status || r.status == status; };
    out.status = Status::ok;
    if (either(Status::implausible)) out.status = Status::implausible;
    if (either(Status::not_converged)) out.status = Status::not_converged;
    if (l.status == Status::no_contact && r.status == Status::no_contact) out.status = Status::no_contact;
    if (either(Status::invalid_input)) out.status = Status::invalid_input;
    out.warnings = l.warnings | r.warnings;
  }

  /// Both wheels where they are.
  void evaluate(Wheels& by, const WheelsetState& state, WheelsetSolution& out) {
    ++evaluations;
    go_on(progress, 0);
    by.left.solve(state.left, {}, out.left, progress);
    by.right.solve(state.right(), {}, out.right, progress);
    sum(state, out);
  }

  /// The same with derivatives, nothing held.
  void differentiate(Wheels& by, const WheelsetState& state, WheelsetSolution& out) {
    go_on(progress, 0);
    by.left.differentiate(state.left, {}, out.left, by_left, progress);
    by.right.differentiate(state.right(), {}, out.right, by_right, progress);
    sum(state, out);
    slopes = {};
    const Vec3<double> left = left_lever(state), right = right_lever(state);
    for (std::size_t k = 0; k < state_variables; ++k) {
      const Vec3<double> axis = turning_axis(state.left, k);
      slopes.force[k] = by_left.force[k] + by_right.force[k];
      slopes.moment[k] = by_left.moment[k] + by_right.moment[k] + cross(left, by_left.force[k]) +
                         cross(right, by_right.force[k]) + cross(cross(axis, left), out.left.force) +
                         cross(cross(axis, right), out.right.force);
    }
  }

  Three residual(const Target& target, const WheelsetState& state, const WheelsetSolution& out) const {
    const Three found = {out.force.z, target.of_wheels ? out.left.force.z - out.right.force.z : out.moment.x,
                         dot(axle(state.left), out.moment)};
    Three r{};
    for (std::size_t i = 0; i < 3; ++i)
      if (target.finds(i)) r[i] = (found[i] - target.value[i]) / target.size[i];
    return r;
  }

  /// Derivatives of the residual by a variable of the state.
  Three residual_slope(const Target& target, const WheelsetState& state, const WheelsetSolution& out,
                       std::size_t variable) const {
    const Vec3<double> direction = axle(state.left), moment = slopes.moment[variable];
    const Three found = {
        slopes.force[variable].z, target.of_wheels ? by_left.force[variable].z - by_right.force[variable].z : moment.x,
        dot(direction, moment) + dot(cross(turning_axis(state.left, variable), direction), out.moment)};
    Three r{};
    for (std::size_t i = 0; i < 3; ++i)
      if (target.finds(i)) r[i] = found[i] / target.size[i];
    return r;
  }

  /// Of the residual by the unknowns in their sizes; that of 1 for what is not looked for.
  Matrix3 jacobian(const Target& target, const WheelsetState& state, const WheelsetSolution& out) const {
    Matrix3 m{};
    for (std::size_t j = 0; j < 3; ++j) {
      const Three slope = residual_slope(target, state, out, unknown_columns[j]);
      for (std::size_t i = 0; i < 3; ++i)
        m[i][j] = target.finds(i) && target.finds(j) ? slope[i] * target.unknown_size[j] : i == j;
    }
    return m;
  }

  Target target_of(const WheelsetState& state, const WheelsetLoad& load, const WheelsetSolution& out) const {
    const double base = left_place.wheel.lateral, radius = left_place.nominal_radius;
    Target target{.load = load.vertical.has_value(), .torque = load.axle_torque.has_value()};
    double whole = std::max(std::abs(out.force.z), 1.0);
    if (target.load) {
      if (const auto* both = std::get_if<AxleLoad>(&*load.vertical)) {
        whole = both->vertical_force;
        target.value = {whole, both->roll_moment};
        target.size[1] = whole * base;
      } else {
        const auto& [left, right] = std::get<WheelLoads>(*load.vertical);
        whole = left + right;
        target.of_wheels = true;
        target.value = {whole, left - right};
        target.size[1] = whole;
      }
    }
    target.value[2] = -load.axle_torque.value_or(0);
    target.size[0] = whole, target.size[2] = whole * radius;
    constexpr double height = 1e-5, creepage = 1e-3, least_speed = 1e-3; // [m], [-], [m/s]
    target.unknown_size = {height, height / base,
                           creepage * std::max(std::abs(state.left.forward_velocity), least_speed) / radius};
    return target;
  }

  /// Where both rigid wheels touch, lowered until each bears its share; rolling freely.
  Status start(const WheelsetLoad& load, WheelsetState& state) {
    double radius = left_place.nominal_radius;
    if (load.vertical) {
      const WheelsetContact touch = rigid.solve(state);
      if (touch.status == Status::no_contact) return touch.status;
      state.left.roll = touch.roll, state.left.vertical = touch.vertical;
      radius = (touch.left.radius + touch.right.radius) / 2;
    }
    if (load.axle_torque) state.left.pitch_velocity = state.left.forward_velocity / radius;
    if (load.vertical) {
      const auto* both = std::get_if<AxleLoad>(&*load.vertical);
      lower(first(), state,
            both ? WheelLoads{both->vertical_force / 2, both->vertical_force / 2}
                 : std::get<WheelLoads>(*load.vertical));
      state.left.roll += apart() / (2 * left_place.wheel.lateral);
      state.left.vertical = (trial.left.vertical + trial.right.vertical) / 2;
    }
    return Status::ok;
  }

  /// Each wheel by itself lowered until it bears its load: `trial`.
  void lower(Wheels& by, const WheelsetState& state, const WheelLoads& loads) {
    ++evaluations;
    go_on(progress, 0);
    by.left.solve(state.left, loads.left, trial.left, progress);
    by.right.solve(state.right(), loads.right, trial.right, progress);
    sum(state, trial);
  }
  /// By how much the left wheel is then higher than the right one.
  double apart() const { return trial.left.vertical - trial.right.vertical; }

  Wheels& first() { return coarse ? *coarse : wheels; }

  /// Newton's method, with Broyden's updates while they do; `state` becomes the best one found. Of no use across jumps.
  bool newton(Wheels& by, Wheels& for_slopes, const Target& target, WheelsetState& state, WheelsetSolution& out) {
    constexpr int most_iterations = 25, most_halvings = 6;
    constexpr double good = 0.1;        // reduction of the residual
    constexpr double longest_step = 30; // in the unknowns' sizes
    const double wanted = tolerance();
    evaluate(by, state, out);
    Three value = residual(target, state, out), step{};
    Matrix3 slope{};
    bool stale = true;
    for (int k = 0; k < most_iterations && largest(value) > wanted; ++k) {
      if (stale) {
        differentiate(for_slopes, state, trial);
        slope = jacobian(target, state, trial);
      }
      if (!solve_linear(slope, value, step)) break;
      const Three here = unknowns_of(state);
      WheelsetState there = state;
      Three next{}, scaled{};
      double part = std::min(1.0, longest_step / largest(step));
      for (int halving = 0;; ++halving, part /= 2) {
        if (halving == most_halvings) break;
        Three u = here;
        for (std::size_t i = 0; i < 3; ++i) {
          scaled[i] = target.finds(i) ? -part * step[i] : 0;
          u[i] += scaled[i] * target.unknown_size[i];
        }
        set_unknowns(there, u);
        evaluate(by, there, trial);
        next = residual(target, there, trial);
        if (length(next) < length(value)) break;
      }
      ++out.iterations;
      const double reduction = length(next) / length(value);
      if (!(reduction < 1)) {
        if (stale) break;
        stale = true; // the updates have led astray
        continue;
      }
      Three change{};
      for (std::size_t i = 0; i < 3; ++i) change[i] = next[i] - value[i];
      update(slope, scaled, change);
      stale = reduction > good;
      state = there, value = next;
      const int iterations = out.iterations;
      std::swap(out, trial);
      out.iterations = iterations;
    }
    out.residual = largest(value);
    return out.residual <= wanted;
  }

  /// The pitch velocity at which the contacts balance the torque, bracketed; `trial` by `forces` for a state.
  template <class Forces> Status bracket_pitch(const Target& target, WheelsetState& state, const Forces& forces) {
    if (!target.torque) {
      forces(state);
      return Status::ok;
    }
    double& pitch = state.left.pitch_velocity;
    const double reach = 1e3 * target.unknown_size[2]; // up to full sliding
    return find_zero(pitch, target.unknown_size[2], {pitch - reach, pitch + reach}, tolerance() / 4, [&](double) {
      if (has_spent_all()) return 0.0;
      forces(state);
      return residual(target, state, trial)[2];
    });
  }

  /// By shares of the load: the wheels are lowered each by itself until they bear theirs; the roll angle at which both
  /// are at the same height, and the share that has the roll moment, are bracketed. Forces of a wheel are a smooth
  /// function of its load also where they change much with its height.
  Status bracket(Wheels& by, const Target& target, WheelsetState& state, int& iterations) {
    if (!target.load)
      return bracket_pitch(target, state, [&](const WheelsetState& s) { evaluate(by, s, trial), ++iterations; });
    constexpr double least_share = 1e-3, first_step = 0.05, largest_roll = 0.05;
    double share = target.of_wheels ? 0.5 + target.value[1] / (2 * target.value[0]) : 0.5;
    Status level = Status::ok, pitch = Status::ok;
    const auto find_roll = [&](double part) {
      const WheelLoads loads = {part * target.value[0], (1 - part) * target.value[0]};
      double& roll = state.left.roll;
      level = find_zero(roll, target.unknown_size[1], {roll - largest_roll, roll + largest_roll},
                        tolerance() * target.unknown_size[0], [&](double) {
                          if (has_spent_all()) return 0.0;
                          pitch = bracket_pitch(target, state,
                                                [&](const WheelsetState& s) { lower(by, s, loads), ++iterations; });
                          return apart();
                        });
      return target.of_wheels ? 0 : -residual(target, state, trial)[1];
    };
    const Status shared = find_zero(share, first_step, {least_share, 1 - least_share}, tolerance(), find_roll);
    state.left.vertical = (trial.left.vertical + trial.right.vertical) / 2;
    for (const Status status : {pitch, level, shared})
      if (status == Status::no_solution) return status;
    return Status::ok;
  }

  void solve(WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& out) {
    out.residual = 0, out.iterations = 0, evaluations = 0;
    if (is_valid(state, load)) {
      find_balance(state, load, out);
    } else {
      out.left = out.right = {};
      sum(state, out);
      out.status = Status::invalid_input;
    }
    conclude(load, out);
  }

  /// Makes status and numbers agree, as conclude() of a wheel does.
  void conclude(const WheelsetLoad& load, WheelsetSolution& out) const {
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
    if (out.status == Status::not_converged && out.residual <= tolerance()) out.residual = 1;
    out.reason = usual_reason(out.status, Unsolved::off_its_rail, Unsolved::no_balance);
    for (const WheelRailSolution* wheel : {&out.left, &out.right})
      if (out.status == Status::not_converged && wheel->status == out.status && out.reason == Unsolved::residual)
        out.reason = wheel->reason;
  }

  void find_balance(WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& out) {
    if (!load.vertical && !load.axle_torque) return evaluate(wheels, state, out);
    if (const Status status = start(load, state); status != Status::ok) {
      out.left = out.right = {};
      sum(state, out);
      out.status = status;
      return;
    }
    evaluate(first(), state, out);
    const Target target = target_of(state, load, out);
    const WheelsetState begin = state;
    bool found = newton(first(), first(), target, state, out);
    Status reason = Status::not_converged;
    if (!found) {
      state = begin;
      const Status bracketed = bracket(first(), target, state, out.iterations);
      if (bracketed == Status::no_solution && !has_spent_all()) reason = Status::no_solution;
      found = newton(first(), first(), target, state, out);
    }
    if (coarse) found = newton(wheels, *coarse, target, state, out);
    if (!found) out.status = reason;
  }

  static bool is_valid(const WheelsetState& state, const WheelsetLoad& load) {
    if (!is_in_range(state.left) || !is_in_range(state.right())) return false;
    if (load.axle_torque && !std::isfinite(*load.axle_torque)) return false;
    if (!load.vertical) return true;
    if (const auto* both = std::get_if<AxleLoad>(&*load.vertical))
      return is_vertical_force(both->vertical_force) && std::isfinite(both->roll_moment);
    const auto& [left, right] = std::get<WheelLoads>(*load.vertical);
    return is_vertical_force(left) && is_vertical_force(right);
  }

  void differentiate(WheelsetState state, const WheelsetLoad& load, WheelsetSolution& out,
                     WheelsetDerivatives& derivatives) {
    solve(state, load, out);
    derivatives = {};
    if (!is_solved(out.status)) return;
    const double residual = out.residual;
    const int iterations = out.iterations;
    const Warnings warnings = out.warnings;
    differentiate(wheels, state, out);
    out.residual = residual, out.iterations = iterations, out.warnings = warnings;
    if (!is_solved(out.status)) {
      out.residual = 1, out.reason = Unsolved::derivatives;
      return;
    }
    hold(target_of(state, load, out), state, out, derivatives);
  }

  /// From derivatives with nothing held to those with the prescribed forces held: du/dx = -R_u^-1 R_x.
  void hold(const Target& target, const WheelsetState& state, const WheelsetSolution& out,
            WheelsetDerivatives& d) const {
    const Matrix3 matrix = jacobian(target, state, out);
    // Adds what the unknowns do when the residual would change by `by`.
    const auto add = [&](std::size_t k, const Three& by) {
      Three change{};
      if (!solve_linear(matrix, by, change)) return;
      const std::array<double*, 3> found = {&d.vertical[k], &d.roll[k], &d.pitch_velocity[k]};
      for (std::size_t j = 0; j < 3; ++j) {
        if (!target.finds(j)) continue;
        *found[j] = -change[j] * target.unknown_size[j];
        d.force[k] = d.force[k] + *found[j] * slopes.force[unknown_columns[j]];
        d.moment[k] = d.moment[k] + *found[j] * slopes.moment[unknown_columns[j]];
      }
    };
    for (std::size_t k = 0; k < state_variables; ++k) {
      const auto at = std::find(unknown_columns.begin(), unknown_columns.end(), k) - unknown_columns.begin();
      if (at < 3 && target.finds(static_cast<std::size_t>(at))) continue;
      d.force[k] = slopes.force[k], d.moment[k] = slopes.moment[k];
      add(k, residual_slope(target, state, out, k));
    }
    const double by_force = -1 / target.size[0], by_second = -1 / target.size[1];
    if (target.load && !target.of_wheels) {
      add(column(WheelsetVariable::vertical_force), {by_force, 0, 0});
      add(column(WheelsetVariable::roll_moment), {0, by_second, 0});
    } else if (target.load) {
      add(column(WheelsetVariable::vertical_force_left), {by_force, by_second, 0});
      add(column(WheelsetVariable::vertical_force_right), {by_force, -by_second, 0});
    }
    if (target.torque) add(column(WheelsetVariable::axle_torque), {0, 0, 1 / target.size[2]});
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
  WheelsetState there = state;
  workspace_->solve(there, load, solution);
}

WheelsetSolution WheelsetOnTrack::solve(const WheelsetState& state, const WheelsetLoad& load,
                                        const Progress& progress) {
  WheelsetSolution solution;
  solve(state, load, solution, progress);
  return solution;
}

void WheelsetOnTrack::differentiate(const WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& solution,
                                    WheelsetDerivatives& derivatives, const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->differentiate(state, load, solution, derivatives);
}

} // namespace microslip
