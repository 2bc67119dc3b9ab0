#include "microslip/railway/rows/row_height.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/railway/problem/wheel_status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

/// Largest overlap [m] in the search of a height, at least that of its start: a thousandth of the
/// rolling radius, where steel has pressures of some 5 GPa.
double largest_depth(const ContactPoint& touch, double start) {
  return std::max(1e-3 * touch.radius / std::max(std::cos(touch.inclination), 0.1), start);
}

/// Secants for the depth below the first touch, from by how much more the wheel should be lowered: the slope of that is
/// about -1. Steps from loads that have not converged tell nothing about it.
class DepthSecants {
public:
  /// Starts with a slope that is known, or 0.
  explicit DepthSecants(double slope) : slope_(slope) {}

  double slope() const { return slope_; }

  /// Takes what is missing at a depth.
  void record(double here, double missing, bool converged) {
    const double slope = (missing - missing_) / (here - here_);
    if (seen_ && converged_ && slope < -0.05 && slope > -4) slope_ = slope;
    if (slope_ != 0 || seen_) share_left_ = 0;
    if (slope_ != 0) share_left_ += std::abs(1 + slope_);   // of a slope that is right,
    if (seen_) share_left_ += std::abs(missing / missing_); // and what it was off in the last step
    here_ = here, missing_ = missing, seen_ = true, converged_ = converged;
  }

  /// Share of the missing force that is left after lowering the wheel by all of it.
  double share_left() const { return std::clamp(share_left_, 0.01, 1.0); }

  double next() const { return std::max(here_ - missing_ / (slope_ == 0 ? -1 : slope_), 0.1 * here_); }

private:
  double slope_, share_left_ = 1, here_ = 0, missing_ = 0;
  bool seen_ = false, converged_ = false;
};

/// Lowering of the wheel from its first touch, after Hertz with the surfaces' curvatures at the point, in
/// its inclined plane.
double hertzian_lowering(const ContactPoint& point, const CombinedMaterial& material, double vertical_force) {
  const double cosine = std::max(std::cos(point.inclination), 0.1),
               curvature = std::clamp(point.curvature * cosine * cosine * cosine, 0.2, 1e3);
  const GapCurvatures gap{1 / (2 * point.radius), curvature / 2};
  return hertz_from_load(gap, material, vertical_force / cosine).approach / cosine;
}

} // namespace

void RowHeight::reset() {
  rows_.forget_loads();
  last_ = {};
}

void RowHeight::move(const WheelState<double>& state) {
  rows_.move(state);
  roll();
}

bool RowHeight::shift(const WheelState<double>& state) {
  rows_.shift(state);
  const bool found = rows_.count() > 0 && press_here().change == 0;
  if (found) roll();
  return found;
}

/// Finds the loads where the wheel stands, anew if the last ones do not lead to them.
RowNormal::Result RowHeight::press_here() {
  constexpr int most_steps = 60, steps_from_last = 12;
  if (rows_.has_loads()) {
    const RowNormal::Result found = rows_.find_loads({}, steps_from_last);
    if (found.change == 0) return found;
    rows_.forget_loads();
  }
  return rows_.find_loads({}, most_steps);
}

double RowHeight::predict_depth(double from, double vertical_force) {
  return predicted_ = rows_.predict_depth(from, vertical_force);
}

/// A first depth [m]: after Hertz, from there by virtual penetration.
double RowHeight::first_depth(const ContactPoint& touch, double vertical_force) {
  constexpr double wider = 1.3, most = 3; // of Hertz's
  const double hertzian = hertzian_lowering(touch, bodies_.material, vertical_force);
  const double depth = predict_depth(wider * hertzian, vertical_force);
  return depth > hertzian / most && depth < most * hertzian ? depth : hertzian;
}

void RowHeight::solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
  const ContactPoint touch = rows_.touch(state);
  out.status = Status::no_contact;
  if (!std::isfinite(touch.gap)) return;
  if (!vertical_force) {
    if (touch.gap < 0) lower(-touch.gap, out);
    return;
  }
  if (settle_from_last(touch, *vertical_force, out)) return;
  reset();
  out.iterations = 0;
  const double start = first_depth(touch, *vertical_force);
  deepest_ = largest_depth(touch, start);
  if (!settle(touch, *vertical_force, start, out)) bracket(*vertical_force, start, out);
}

/// Settles from the last force's height, if it was near. False if that leads to no solution.
bool RowHeight::settle_from_last(const ContactPoint& touch, double vertical_force, WheelRailSolution& out) {
  constexpr double most_force = 2, most_depth = 2, most_move = 1e-3; // over the last ones; [m]
  const double force = vertical_force / last_.force;
  if (!rows_.has_loads() ||
      !(force < most_force && force > 1 / most_force && std::abs(touch.s_rail - last_.rail_s) < most_move))
    return false;
  const double near = last_.depth * std::cbrt(force * force);
  const double start = last_.ratio * predict_depth(near, vertical_force);
  if (!(start < most_depth * near && start > near / most_depth)) return false;
  deepest_ = largest_depth(touch, start);
  return settle(touch, vertical_force, start, out);
}

/// The wheel lowered by a depth [m] that is given. Returns its vertical force [N].
double RowHeight::lower(double depth, WheelRailSolution& out) {
  ++out.iterations;
  rows_.lower_to(depth);
  out.vertical = rows_.vertical();
  if (rows_.count() == 0) {
    out.status = Status::no_contact;
    return 0;
  }
  const RowNormal::Result found = press_here();
  roll();
  const bool complete = rows_.is_complete();
  out.residual = complete ? found.change : 1;
  out.status = out.residual == 0 ? Status::ok : Status::not_converged;
  out.reason = !complete ? Unsolved::too_many_patches : out.residual > 0 ? Unsolved::pressures : Unsolved::none;
  return vertical_force();
}

/// Steps of loads, tangential forces and height in turn from a depth [m] on. False if they do not settle.
bool RowHeight::settle(const ContactPoint& touch, double vertical_force, double depth, WheelRailSolution& out) {
  constexpr int most_iterations = 12;
  DepthSecants descent(last_.slope);
  while (out.iterations < most_iterations) {
    ++out.iterations;
    rows_.lower_to(depth);
    if (rows_.count() == 0 || !rows_.is_complete()) return false;
    // Rows move with the height: a few steps are enough, unless they do not settle.
    const int steps = out.iterations == 1 ? 4 : out.iterations < 5 ? 2 : 12;
    const RowNormal::Result found = rows_.find_loads(vertical_force, steps);
    const double change = roll();
    // The loads carry the vertical force on a wheel that is lowered by what is missing; only the rows have yet to move.
    const double missing = found.lowering - change / found.stiffness;
    descent.record(depth, missing, found.change == 0);
    const double left = std::abs(found.stiffness * found.lowering) * descent.share_left();
    out.residual = (left + std::abs(change)) / vertical_force;
    if (out.residual <= tolerance_ && found.change == 0) {
      rows_.lower_by(found.lowering);
      last_ = {vertical_force, touch.s_rail, rows_.depth(), rows_.depth() / predicted_, descent.slope()};
      out.vertical = rows_.vertical();
      out.status = Status::ok;
      return true;
    }
    depth = descent.next();
  }
  return false;
}

/// The height that carries the vertical force [N] by forces at given heights alone: from the first touch downwards,
/// each time by half of the distance so far, until one carries it or the bodies overlap too far. What jumps over the
/// force carries it only if nothing else does. Heights at which the pressures are not found do not count.
void RowHeight::bracket(double vertical_force, double start, WheelRailSolution& out) {
  constexpr double growth = 1.5, precision = 1e-11; // [-], [m]
  const auto missing = [&](double depth) { return lower(depth, out) / vertical_force - 1; };
  RootSide before{0, -1}, nearest{0, std::numeric_limits<double>::infinity()};
  std::optional<RootSide> jump;
  rows_.forget_loads();
  for (double depth = start / 16; before.at < deepest_; depth *= growth) {
    const double at = std::min(depth, deepest_);
    const RootSide here{at, missing(at)};
    if (out.status == Status::not_converged) {
      if (at < deepest_) continue;
      break;
    }
    if ((here.value >= 0) != (before.value >= 0)) {
      const BracketedRoot root = find_bracketed_root(before, here, tolerance_, precision, missing);
      out.residual = std::max(out.residual, std::abs(root.side.value));
      if (root.found) return;
      if (!jump) jump = root.side;
    }
    before = here;
    if (here.value < 0 && std::abs(here.value) < std::abs(nearest.value)) nearest = here;
  }
  double left = std::abs(missing(jump.value_or(nearest).at));
  if (jump && out.status == Status::not_converged) { // where the pressures are not found nothing is known to jump
    left = std::abs(missing(nearest.at));
    jump.reset();
  }
  out.residual = std::max(left, out.residual);
  if (jump) return mark_jump(out);
  out.status = Status::no_solution, out.reason = Unsolved::no_height;
}

/// Vertical force of the rows' loads and tangential forces [N].
double RowHeight::vertical_force() const {
  double sum = 0;
  for (std::size_t k = 0; k < rows_.count(); ++k) {
    const double angle = rows_.normal(k).angle;
    sum += rolling_.loaded()[k].load * std::cos(angle) + rolling_.forces(k).fy * std::sin(angle);
  }
  return sum;
}

} // namespace microslip
