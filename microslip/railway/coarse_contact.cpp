#include "microslip/railway/coarse_contact.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/railway/wheel_status.hpp"
#include "microslip/simplified/load_moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace microslip {
namespace {

/// Rows of a wheel at most, and cells of each for FASTSIM2.
constexpr std::size_t most_rows = 128;
constexpr int cells = 10;

/// How far bodies may overlap where a height is looked for, over the rolling radius: there steel has pressures of some
/// 5 GPa.
constexpr double largest_overlap = 1e-3;

/// V: the mean of the speeds at which the contact moves over the rail and over the wheel [m/s].
double rolling_speed(const WheelPlacement<double>& p, const Vec3<double>& place) {
  const double over_rail = p.wheel.velocity.x - p.rail.velocity_at(place).x;
  const double by_turning = cross(p.wheel.angular_velocity, place - p.wheel.frame.origin).x;
  return (std::abs(over_rail) + std::abs(by_turning)) / 2;
}

/// Secants for the depth below the first touch, from by how much more the wheel should be lowered: the slope of that is
/// about -1. Steps from loads that have not converged tell nothing about it.
class Descent {
public:
  /// With a slope that is known, or 0.
  explicit Descent(double slope) : slope_(slope) {}

  double slope() const { return slope_; }

  /// Takes what is missing at a depth.
  void see(double here, double missing, bool converged) {
    const double slope = (missing - missing_) / (here - here_);
    if (seen_ && converged_ && slope < -0.05 && slope > -4) slope_ = slope;
    share_left_ = slope_ == 0 && !seen_
                      ? 1
                      : (slope_ == 0 ? 0 : std::abs(1 + slope_)) + (seen_ ? std::abs(missing / missing_) : 0);
    here_ = here, missing_ = missing, seen_ = true, converged_ = converged;
  }

  /// What lowering the wheel by all that is missing leaves of it.
  double share_left() const { return std::clamp(share_left_, 0.01, 1.0); }

  double next() const { return std::max(here_ - missing_ / (slope_ == 0 ? -1 : slope_), 0.1 * here_); }

private:
  double slope_, share_left_ = 1, here_ = 0, missing_ = 0;
  bool seen_ = false, converged_ = false;
};

/// Rows of equal width in a patch's frame that bear what the given rows bear, which are of any width. Lengths, middles,
/// friction and creepages are means over the load.
std::vector<LoadedRow> even_rows(std::span<const LoadedRow> rows, const PatchFrame& frame) {
  constexpr int count = 40; // narrower than the given rows, so that few of them are cut
  const auto loaded = [](const LoadedRow& row) { return row.load > 0; };
  const auto first = std::find_if(rows.begin(), rows.end(), loaded);
  const auto last = std::find_if(rows.rbegin(), rows.rend(), loaded);
  const double low = first->y - first->width / 2, width = (last->y + last->width / 2 - low) / count;
  double load = 0, given = 0; // the rows' widths are those of the surface, their positions those of its parameter
  std::vector<LoadedRow> even;
  for (int k = 0; k < count; ++k) {
    LoadedRow sum{.y = low + (k + 0.5) * width - frame.rail_s, .width = width};
    double square = 0;
    for (const LoadedRow& row : rows) {
      const double from = std::max(row.y - row.width / 2, low + k * width);
      const double to = std::min(row.y + row.width / 2, low + (k + 1) * width);
      if (!(to > from) || !loaded(row)) continue;
      const double part = row.load * (to - from) / row.width, centre = row.centre - frame.origin.x;
      const Creepage& w = row.creepage;
      sum.load += part, sum.centre += part * centre, sum.friction += part * row.friction;
      square += part * row.half_length * row.half_length;
      sum.creepage.longitudinal += part * w.longitudinal, sum.creepage.spin += part * w.spin;
      sum.creepage.lateral += part * (w.lateral + w.spin * frame.origin.x);
    }
    sum.half_length = width;
    if (sum.load > 0) {
      for (double* mean :
           {&sum.centre, &sum.friction, &sum.creepage.longitudinal, &sum.creepage.lateral, &sum.creepage.spin})
        *mean /= sum.load;
      sum.half_length = std::sqrt(square / sum.load);
    }
    load += sum.load;
    even.push_back(sum);
  }
  for (const LoadedRow& row : rows) given += row.load;
  for (LoadedRow& row : even) row.load *= given / load;
  return even;
}

/// The moment of a row itself, beyond that of its forces at its centre [N m].
double moment_beside(const LoadedRow& row, const RowForces& forces) {
  return forces.mz - row.centre * forces.fy;
}

} // namespace

void WheelForces::add(const Vec3<double>& f, const PatchRow& row, double x, const Vec3<double>& centre) {
  const Vec3<double> normal = row.normal(), tangent{0, normal.z, -normal.y};
  const Vec3<double> leaning = Vec3<double>{f.x - row.slope * f.z, 0, 0} + f.y * tangent + f.z * normal;
  force = force + leaning;
  moment = moment + cross(row.point + Vec3<double>{x, 0, 0} - centre, leaning);
}

void WheelForces::add(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame,
                      const Vec3<double>& centre, WheelRailPatch& patch) {
  add(f, row, x, centre);
  const Vec3<double> tangential = Vec3<double>{f.x, 0, 0} + f.y * row.tangent();
  const Vec3<double> whole = tangential + f.z * row.normal();
  const Vec3<double> place = row.point + Vec3<double>{x, 0, 0};
  patch.fx += whole.x, patch.fs += dot(whole, frame.tangent()), patch.normal_force += dot(whole, frame.normal());
  patch.moment += dot(cross(place - frame.origin, tangential), frame.normal());
}

CoarseContact::CoarseContact(const WheelRailBodies& bodies, const WheelRailMethod& method,
                             const NominalPlacement& nominal, const EquivalentRail* equivalent)
    : bodies_(bodies), method_(method), nominal_(nominal), equivalent_(equivalent), search_(bodies.rail, bodies.wheel),
      penetration_(bodies.rail, bodies.wheel, most_rows), rows_(bodies.rail, bodies.wheel, most_rows, equivalent),
      normal_(most_rows), forward_(cells, most_rows), backward_(cells, most_rows, RollingDirection::backward),
      shear_(most_rows), last_shear_(most_rows), speed_(most_rows), loaded_(most_rows), flat_rows_(most_rows),
      forces_(most_rows), flat_forces_(most_rows) {
  normal_rows_.reserve(most_rows);
  patches_.reserve(most_rows);
  if (method.level == WheelRailLevel::table) look_up_.emplace(method.table, most_rows);
}

double CoarseContact::friction(double angle) const {
  const std::vector<InclinedFriction>& friction = bodies_.friction;
  const auto after =
      std::find_if(friction.begin(), friction.end(), [angle](const InclinedFriction& f) { return f.angle > angle; });
  if (after == friction.begin()) return friction.front().coefficient;
  if (after == friction.end()) return friction.back().coefficient;
  const InclinedFriction &low = *(after - 1), &high = *after;
  return low.coefficient + (angle - low.angle) / (high.angle - low.angle) * (high.coefficient - low.coefficient);
}

void CoarseContact::put(const WheelState<double>& state, double vertical) {
  WheelState<double> there = state;
  there.vertical = vertical;
  placement_ = place(nominal_, there);
}

/// Regions and overlap of the wheel lowered by `depth` [m] from where it first touches, which it was searched for.
void CoarseContact::sample(const WheelState<double>& state, double depth) {
  if (depth > searched_) search(state, 2 * depth);
  put(state, state.vertical - clearance_ - depth);
  depth_ = depth;
  regions_ = search_.regions(clearance_ + depth);
  penetration_.sample(placement_, regions_.first(std::min(regions_.size(), most_rows)), depth);
}

/// The rows in such a position.
void CoarseContact::place_rows(const WheelState<double>& state, double depth) {
  sample(state, depth);
  take_rows();
}

/// Those of the overlap that was sampled, with what the last ones know of them.
void CoarseContact::take_rows() {
  complete_ = rows_.place(placement_, regions_, penetration_);
  normal_rows_.clear();
  std::swap(shear_, last_shear_);
  for (const ContactRow& row : rows_.rows()) {
    normal_rows_.push_back(row.normal);
    double& shear = shear_[normal_rows_.size() - 1];
    shear = warm_ && row.normal.before != no_row ? last_shear_[row.normal.before] : 0;
    normal_rows_.back().shear = shear;
  }
}

/// Loads of the rows in their positions.
RowNormal::Result CoarseContact::find_loads(std::optional<double> vertical_force, int steps) {
  RowNormal::Result found = normal_.solve(bodies_.material, normal_rows_, vertical_force, warm_, steps);
  const bool has_loads = std::isfinite(found.lowering) && std::isfinite(found.change) &&
                         std::isfinite(found.stiffness) && found.stiffness > 0;
  warm_ = has_loads;
  if (!has_loads) // as for contacts larger than their bodies: less depth, from the beginning
    found = {-0.3 * depth_, vertical_force.value_or(1) / depth_, 1, Status::not_converged, found.steps};
  if (found.status == Status::ok) found.change = 0;
  return found;
}

/// The gap at which a row takes its creepages: the least one of its patch [m]. Where two lobes of the overlap are all
/// but parted, that of the deeper one counts in proportion to how deep the bodies overlap on the way to it, so that
/// creepages are continuous where patches merge.
double CoarseContact::contact_gap(std::size_t row) const {
  const auto overlap = [&](std::size_t k) { return std::max(-normal_rows_[k].gap, 0.0); };
  const double own = overlap(row);
  double most = own, least = own;
  const auto see = [&](std::size_t k) {
    const double other = overlap(k);
    least = std::min(least, other);
    if (other > own) most = std::max(most, own + std::min(1.0, detail::united * least / own) * (other - own));
  };
  for (std::size_t k = row + 1; k < normal_rows_.size() && rows_.rows()[k].joined && least > 0; ++k) see(k);
  least = own;
  for (std::size_t k = row; k-- > 0 && rows_.rows()[k + 1].joined && least > 0;) see(k);
  return own > 0 ? -most : normal_rows_[row].gap;
}

/// Rows as FASTSIM2 takes them, with their creepages about x = 0 of the track axes.
void CoarseContact::load_rows() {
  constexpr double shortest = 1e-9; // [m]
  const PatchSurface surface = this->surface();
  for (std::size_t k = 0; k < normal_rows_.size(); ++k) {
    const ContactRow& row = rows_.rows()[k];
    const NormalRow& normal = normal_rows_[k];
    const double load = warm_ ? normal_.loads()[k] * normal.width : 0;
    loaded_[k] = {.y = row.at.s,
                  .width = normal.width,
                  .centre = normal.place.x,
                  .half_length = std::max(normal_.half_lengths()[k], shortest),
                  .load = load,
                  .friction = friction(normal.angle),
                  .joined = row.joined};
    if (!(load > 0)) continue;
    speed_[k] = rolling_speed(placement_, normal.place);
    loaded_[k].creepage = surface.creepage({}, PatchShape::curved, row.at, contact_gap(k), speed_[k]);
  }
}

/// FASTSIM2 or the look-up on all rows; returns by how much the vertical part of the tangential forces changes [N].
double CoarseContact::roll() {
  load_rows();
  const std::span<const LoadedRow> loaded(loaded_.data(), normal_rows_.size());
  if (look_up_)
    look_up_->solve(bodies_.material, loaded, rolls_forward() ? 1 : -1, forces_);
  else
    (rolls_forward() ? forward_ : backward_)
        .solve(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, loaded, forces_);
  double change = 0;
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    const double load = loaded[k].load, lateral = forces_[k].fy;
    change += (lateral - shear_[k] * load) * std::sin(normal_rows_[k].angle);
    shear_[k] = load > 0 ? lateral / load : 0;
  }
  return change;
}

void CoarseContact::move(const WheelState<double>& state) {
  put(state, state.vertical);
  roll();
}

bool CoarseContact::shift(const WheelState<double>& state) {
  constexpr int most_steps = 12;
  put(state, state.vertical);
  penetration_.start();
  clearance_ = search_.shift(placement_), depth_ = -clearance_;
  regions_ = search_.regions(0);
  penetration_.sample(placement_, regions_.first(std::min(regions_.size(), most_rows)), depth_);
  take_rows();
  const bool found = !normal_rows_.empty() && find_loads({}, most_steps).change == 0;
  warm_ = found;
  if (found) roll();
  return found;
}

WheelForces CoarseContact::forces() const {
  WheelForces wheel;
  const Vec3<double> centre = placement_.wheel.frame.origin;
  for (std::size_t k = 0; k < normal_rows_.size(); ++k) {
    const LoadedRow& row = loaded_[k];
    if (!(row.load > 0)) continue;
    const RowForces& f = forces_[k];
    const PatchRow& at = rows_.rows()[k].at;
    wheel.add({f.fx, f.fy, row.load}, at, row.centre, centre);
    wheel.moment = wheel.moment + moment_beside(row, f) * at.normal();
  }
  return wheel;
}

/// Finds all points at most `reach` [m] above the lowest one of the gap, which is returned; its gap is infinite if the
/// wheel is nowhere above the rail.
ContactPoint CoarseContact::search(const WheelState<double>& state, double reach) {
  ContactPoint lowest;
  lowest.gap = std::numeric_limits<double>::infinity();
  put(state, state.vertical);
  searched_ = reach;
  penetration_.start();
  points_ = search_.find(placement_, reach);
  for (const ContactPoint& point : points_)
    if (point.gap < lowest.gap) lowest = point;
  return lowest;
}

/// By how much the wheel is lowered from its first touch, after Hertz with the surfaces' curvatures at the point, in
/// its inclined plane.
double CoarseContact::hertzian_lowering(const ContactPoint& point, double vertical_force) const {
  const double cosine = std::max(std::cos(point.inclination), 0.1),
               curvature = std::clamp(point.curvature * cosine * cosine * cosine, 0.2, 1e3);
  const GapCurvatures gap{1 / (2 * point.radius), curvature / 2};
  return hertz_from_load(gap, bodies_.material, vertical_force / cosine).approach / cosine;
}

/// The depth [m] by virtual penetration, sampled at about that depth.
double CoarseContact::predict_depth(const WheelState<double>& state, double from, double vertical_force) {
  sample(state, from);
  return predicted_ = penetration_.depth_for(vertical_force, bodies_.material.contact_modulus(), placement_.radius);
}

/// A first depth [m]: after Hertz, from there by virtual penetration.
double CoarseContact::first_depth(const WheelState<double>& state, const ContactPoint& touch, double vertical_force) {
  constexpr double wider = 1.3, most = 3; // of Hertz's
  const double hertzian = hertzian_lowering(touch, vertical_force);
  const double depth = predict_depth(state, wider * hertzian, vertical_force);
  return depth > hertzian / most && depth < most * hertzian ? depth : hertzian;
}

double CoarseContact::largest_depth(const ContactPoint& touch, double start) const {
  return std::max(largest_overlap * touch.radius / std::max(std::cos(touch.inclination), 0.1), start);
}

void CoarseContact::reset() {
  warm_ = false, last_ = {};
}

void CoarseContact::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                          WheelRailSolution& out) {
  constexpr double first_search = 3e-4; // [m]
  const ContactPoint touch = search(state, first_search);
  clearance_ = touch.gap;
  out.status = Status::no_contact;
  if (!std::isfinite(clearance_)) return;
  if (!vertical_force) {
    if (clearance_ < 0) lower(state, -clearance_, out);
    return;
  }
  if (solve_from_last(state, touch, *vertical_force, out)) return;
  reset();
  out.iterations = 0;
  const double start = first_depth(state, touch, *vertical_force);
  deepest_ = largest_depth(touch, start);
  if (!settle(state, touch, *vertical_force, start, out)) bracket(state, *vertical_force, start, out);
}

/// From the last force's height, if it was near. False if that leads to no solution.
bool CoarseContact::solve_from_last(const WheelState<double>& state, const ContactPoint& touch, double vertical_force,
                                    WheelRailSolution& out) {
  constexpr double most_force = 2, most_depth = 2, most_move = 1e-3; // over the last ones; [m]
  const double force = vertical_force / last_.force;
  if (!warm_ || !(force < most_force && force > 1 / most_force && std::abs(touch.s_rail - last_.rail_s) < most_move))
    return false;
  const double near = last_.depth * std::cbrt(force * force);
  const double start = last_.ratio * predict_depth(state, near, vertical_force);
  if (!(start < most_depth * near && start > near / most_depth)) return false;
  deepest_ = largest_depth(touch, start);
  return settle(state, touch, vertical_force, start, out);
}

/// The wheel lowered by a depth [m] that is given. Returns its vertical force [N].
double CoarseContact::lower(const WheelState<double>& state, double depth, WheelRailSolution& out) {
  constexpr int most_steps = 60, steps_from_last = 12;
  ++out.iterations;
  place_rows(state, depth);
  out.vertical = state.vertical - clearance_ - depth;
  if (normal_rows_.empty()) {
    out.status = Status::no_contact;
    warm_ = false;
    return 0;
  }
  const bool warm = warm_;
  RowNormal::Result found = find_loads({}, warm ? steps_from_last : most_steps);
  if (warm && found.change > 0) {
    warm_ = false;
    found = find_loads({}, most_steps);
  }
  roll();
  out.residual = complete_ ? found.change : 1;
  out.status = out.residual == 0 ? Status::ok : Status::not_converged;
  out.reason = !complete_ ? Unsolved::too_many_patches : out.residual > 0 ? Unsolved::pressures : Unsolved::none;
  return vertical_force();
}

/// Steps of loads, tangential forces and height in turn from a depth [m] on. False if they do not settle.
bool CoarseContact::settle(const WheelState<double>& state, const ContactPoint& touch, double vertical_force,
                           double depth, WheelRailSolution& out) {
  constexpr int most_iterations = 12;
  Descent descent(last_.slope);
  while (out.iterations < most_iterations) {
    ++out.iterations;
    place_rows(state, depth);
    if (normal_rows_.empty() || !complete_) {
      warm_ = false;
      return false;
    }
    // Rows move with the height: a few steps are enough, unless they do not settle.
    const int steps = out.iterations == 1 ? 4 : out.iterations < 5 ? 2 : 12;
    const RowNormal::Result found = find_loads(vertical_force, steps);
    const double change = roll();
    // The loads bear the vertical force on a wheel that is lowered by what is missing; only the rows have yet to move.
    const double missing = found.lowering - change / found.stiffness;
    descent.see(depth, missing, found.change == 0);
    const double left = std::abs(found.stiffness * found.lowering) * descent.share_left();
    out.residual = (left + std::abs(change)) / vertical_force;
    if (out.residual <= method_.tolerance && found.change == 0) {
      depth_ += found.lowering;
      last_ = {vertical_force, touch.s_rail, depth_, depth_ / predicted_, descent.slope()};
      out.vertical = state.vertical - clearance_ - depth_;
      put(state, out.vertical);
      out.status = Status::ok;
      return true;
    }
    depth = descent.next();
  }
  return false;
}

/// The height that bears the vertical force [N] by forces at given heights alone: from the first touch downwards, each
/// time by half of the distance so far, until one carries it or the bodies overlap too far. What jumps over the force
/// carries it only if nothing else does. Heights at which the pressures are not found do not count.
void CoarseContact::bracket(const WheelState<double>& state, double vertical_force, double start,
                            WheelRailSolution& out) {
  constexpr double growth = 1.5, precision = 1e-11; // [-], [m]
  const auto missing = [&](double depth) { return lower(state, depth, out) / vertical_force - 1; };
  RootSide before{0, -1}, nearest{0, std::numeric_limits<double>::infinity()};
  std::optional<RootSide> jump;
  warm_ = false;
  for (double depth = start / 16; before.at < deepest_; depth *= growth) {
    const double at = std::min(depth, deepest_);
    const RootSide here{at, missing(at)};
    if (out.status == Status::not_converged) {
      if (at < deepest_) continue;
      break;
    }
    if ((here.value >= 0) != (before.value >= 0)) {
      const BracketedRoot root = find_bracketed_root(before, here, method_.tolerance, precision, missing);
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

/// Of the rows' loads and tangential forces [N].
double CoarseContact::vertical_force() const {
  double sum = 0;
  for (std::size_t k = 0; k < normal_rows_.size(); ++k) {
    const double angle = normal_rows_[k].angle;
    sum += loaded_[k].load * std::cos(angle) + forces_[k].fy * std::sin(angle);
  }
  return sum;
}

/// The rows of a region.
ContactPatch CoarseContact::patch_of(const ContactRegion& region, std::size_t first, std::size_t count) const {
  ContactPatch patch;
  patch.first = first;
  patch.loaded = {&loaded_[first], count}, patch.rows = rows_.rows().subspan(first, count);
  double vertical = 0;
  for (std::size_t k = first; k < first + count; ++k) {
    const double angle = normal_rows_[k].angle;
    patch.normal_force += loaded_[k].load;
    vertical += loaded_[k].load * std::cos(angle) + forces_[k].fy * std::sin(angle);
  }
  if (patch.normal_force > 0) patch.vertical_share = vertical / patch.normal_force;
  patch.outline = find_outline(placement_, bodies_.rail, bodies_.wheel, region, method_.surface(), equivalent_);
  patch.speed = rolling_speed(placement_, patch.outline.frame.origin);
  for (const ContactPoint& point : points_.subspan(region.first, region.count))
    patch.least_gap = std::min(patch.least_gap, (point.gap - clearance_ - depth_) * std::cos(point.inclination));
  return patch;
}

std::span<const ContactPatch> CoarseContact::patches() {
  patches_.clear();
  const std::span<const ContactRow> rows = rows_.rows();
  for (std::size_t first = 0, next = 0; first < rows.size(); first = next) {
    while (next < rows.size() && rows[next].region == rows[first].region) ++next;
    patches_.push_back(patch_of(regions_[static_cast<std::size_t>(rows[first].region)], first, next - first));
  }
  return patches_;
}

WheelRailPatch CoarseContact::describe(const PatchOutline& outline, double least_gap, double speed) const {
  const PatchFrame& frame = outline.frame;
  WheelRailPatch out;
  out.place = frame.origin, out.angle = frame.angle;
  const ProfilePoint on_wheel = bodies_.wheel.at(outline.wheel_s).value;
  out.rail_y = bodies_.rail.at(frame.rail_s).value.y, out.wheel_y = on_wheel.y;
  out.rolling_radius = placement_.radius - on_wheel.z;
  out.turn = outline.turn;
  out.friction = friction(frame.angle);
  out.approach = -least_gap;
  out.rolling_speed = speed;
  const PatchSurface surface = this->surface();
  out.creepage = surface.creepage(frame, PatchShape::flat, surface.first_row(frame, outline.wheel_s), least_gap, speed);
  return out;
}

void CoarseContact::sum(WheelRailSolution& out) {
  WheelForces wheel;
  const Vec3<double> centre = placement_.wheel.frame.origin;
  out.patches.clear();
  for (const ContactPatch& patch : patches()) {
    if (!(patch.normal_force > 0)) continue;
    WheelRailPatch sum = describe(patch.outline, patch.least_gap, patch.speed);
    for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
      const LoadedRow& row = loaded_[k];
      if (!(row.load > 0)) continue;
      const RowForces& f = forces_[k];
      const PatchRow& at = rows_.rows()[k].at;
      wheel.add({f.fx, f.fy, row.load}, at, row.centre, patch.outline.frame, centre, sum);
      const double own = moment_beside(row, f);
      sum.moment += own;
      wheel.moment = wheel.moment + own * at.normal();
      sum.contact_area += 2 * row.half_length * row.width, sum.slip_area += f.slip_area;
      sum.frictional_power -=
          speed_[k] * (row.creepage.longitudinal * f.fx + row.creepage.lateral * f.fy + row.creepage.spin * f.mz);
      if (look_up_ && !look_up_->in_range(k)) sum.status = Status::out_of_range;
      // Of a semi-ellipse along the row.
      sum.peak_pressure = std::max(sum.peak_pressure, 2 * row.load / (std::numbers::pi * row.half_length * row.width));
    }
    out.patches.push_back(sum);
  }
  out.force = wheel.force, out.moment = wheel.moment;
  for (const ContactRegion& region : regions_)
    out.warnings.add_if(region.inner.corner == Corner::end || region.outer.corner == Corner::end, Warning::profile_end);
}

double CoarseContact::change_by_planes() {
  const std::size_t count = normal_rows_.size();
  std::copy_n(loaded_.begin(), count, flat_rows_.begin());
  double bound = 0, across = 0; // of all rows, and the lateral force on planes less that on the true surfaces
  for (const ContactPatch& patch : patches()) {
    const double inclination = patch.outline.frame.angle;
    const WheelRailPatch plane = describe(patch.outline, patch.least_gap, patch.speed);
    for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
      LoadedRow& row = flat_rows_[k];
      const double s = dot(patch.outline.frame.tangent(), normal_rows_[k].place - patch.outline.frame.origin);
      row.creepage = plane.creepage;
      row.creepage.longitudinal -= plane.creepage.spin * s;
      row.creepage.lateral -= plane.creepage.spin * patch.outline.frame.origin.x;
      bound += row.friction * row.load;
      across -= row.load * (std::sin(inclination) - std::sin(normal_rows_[k].angle));
    }
  }
  (rolls_forward() ? forward_ : backward_)
      .solve(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, std::span(flat_rows_).first(count),
             flat_forces_);
  double along = 0;
  for (const ContactPatch& patch : patches()) {
    const double cosine = std::cos(patch.outline.frame.angle);
    for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
      along += flat_forces_[k].fx - forces_[k].fx;
      across += flat_forces_[k].fy * cosine - forces_[k].fy * std::cos(normal_rows_[k].angle);
    }
  }
  return bound > 0 ? std::hypot(along, across) / bound : 0;
}

void CoarseContact::add_fields(WheelRailSolution& out) {
  for (const ContactPatch& patch : patches()) {
    if (!(patch.normal_force > 0)) continue;
    const std::vector<LoadedRow> rows = even_rows(patch.loaded, patch.outline.frame);
    ContactSolution fields =
        (rolls_forward() ? forward_ : backward_)
            .solve_with_fields(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, rows, patch.speed);
    const WheelRailPatch description = describe(patch.outline, patch.least_gap, patch.speed);
    fields.creepage = description.creepage, fields.approach = description.approach;
    out.fields.push_back(std::move(fields));
  }
}

} // namespace microslip
