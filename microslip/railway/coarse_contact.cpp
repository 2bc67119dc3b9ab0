#include "microslip/railway/coarse_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace {

/// V: the mean of the speeds at which the contact moves over the rail and over the wheel [m/s].
double rolling_speed(const WheelPlacement<double>& p, const Vec3<double>& place) {
  const double over_rail = p.wheel.velocity.x - p.rail.velocity_at(place).x;
  const double by_turning = cross(p.wheel.angular_velocity, place - p.wheel.frame.origin).x;
  return (std::abs(over_rail) + std::abs(by_turning)) / 2;
}

/// Secant steps to the zero of a function whose slope is about -1, as the lowering that is still needed.
struct Secant {
  double before = 0, value_before = 0;
  bool known = false;

  double next(double here, double value) {
    const double slope = known ? (value - value_before) / (here - before) : -1;
    before = here, value_before = value, known = true;
    return here - value / (slope < -0.5 && slope > -2 ? slope : -1);
  }
};

/// Where a monotone function's zero is known to lie; proposed steps that leave it are replaced by half the interval.
struct Bracket {
  double low = 0, high = std::numeric_limits<double>::infinity();

  double next(double here, double step) {
    (step > 0 ? low : high) = here;
    const double there = here + step;
    return there > low && there < high ? there : (low + high) / 2;
  }
};

ElementGrid cover(const PatchOutline& o) {
  const double dx = (o.x_high - o.x_low) / coarse_columns, dy = (o.s_high - o.s_low) / coarse_rows;
  return {.mx = coarse_columns, .my = coarse_rows, .x0 = o.x_low + dx / 2, .y0 = o.s_low + dy / 2, .dx = dx, .dy = dy};
}

} // namespace

double ContactPatch::normal_force() const {
  double sum = 0;
  for (const LoadedRow& part : loaded) sum += part.load;
  return sum;
}

Vec2 ContactPatch::extent() const {
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low, s = 0;
  for (const LoadedRow& part : loaded) {
    if (!(part.load > 0)) continue;
    x_low = std::min(x_low, part.centre - part.half_length), x_high = std::max(x_high, part.centre + part.half_length);
    s += part.width;
  }
  return {x_high - x_low, s};
}

double ContactPatch::vertical_share() const {
  double vertical = 0;
  for (int j = 0; j < coarse_rows; ++j)
    vertical += loaded[j].load * std::cos(row[j].angle) + forces[j].fy * std::sin(row[j].angle);
  return vertical / normal_force();
}

void WheelForces::add(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame,
                      const Vec3<double>& centre, WheelRailPatch& patch) {
  const Vec3<double> tangential = Vec3<double>{f.x, 0, 0} + f.y * row.tangent();
  const Vec3<double> whole = tangential + f.z * row.normal();
  const Vec3<double> place = row.point + Vec3<double>{x, 0, 0};
  force = force + whole;
  moment = moment + cross(place - centre, whole);
  patch.fx += whole.x, patch.fs += dot(whole, frame.tangent()), patch.normal_force += dot(whole, frame.normal());
  patch.moment += dot(cross(place - frame.origin, tangential), frame.normal());
}

CoarseContact::CoarseContact(const WheelRailBodies& bodies, const WheelRailMethod& method)
    : bodies_(bodies), method_(method),
      nominal_(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel)),
      search_(bodies.rail, bodies.wheel), patches_(most_patches) {
  regions_.reserve(100);
  views_.reserve(most_patches);
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

/// Outlines, gaps and rows of all patches when the wheel was lowered from where it was searched.
void CoarseContact::find_patches(double lowering) {
  const auto found = search_.regions(lowering);
  regions_.assign(found.begin(), found.end());
  // Should there be more than can be, the shortest are left out, and the solution is not one.
  left_out_ = regions_.size() > most_patches;
  if (left_out_) {
    const auto length = [](const ContactRegion& r) { return r.outer.s_wheel - r.inner.s_wheel; };
    std::nth_element(regions_.begin(), regions_.begin() + most_patches, regions_.end(),
                     [length](const ContactRegion& a, const ContactRegion& b) { return length(a) > length(b); });
    regions_.resize(most_patches);
  }
  count_ = 0;
  views_.clear();
  for (const ContactRegion& region : regions_) {
    ContactPatch& patch = patches_[count_];
    patch.outline = find_outline(placement_, bodies_.rail, bodies_.wheel, region);
    if (!(patch.outline.s_high > patch.outline.s_low) || !(patch.outline.x_high > patch.outline.x_low)) continue;
    patch.grid = cover(patch.outline);
    find_gaps(patch);
    views_.push_back(patch.view());
    ++count_;
  }
}

void CoarseContact::find_gaps(ContactPatch& patch) {
  const PatchSurface surface = this->surface();
  for (int i = 0; i < coarse_columns; ++i) patch.x[i] = patch.grid.x(i);
  PatchRow near = surface.first_row(patch.outline.frame, patch.outline.wheel_s);
  patch.least_gap = 0;
  patch.speed = rolling_speed(placement_, patch.outline.frame.origin);
  for (int j = 0; j < coarse_rows; ++j) {
    near = patch.row[j] = surface.row(patch.outline.frame, method_.shape, patch.grid.y(j), near);
    const std::span<double> gaps(&patch.gaps[static_cast<std::size_t>(j) * coarse_columns], coarse_columns);
    surface.find_gaps(patch.row[j], patch.x, gaps);
    near.wheel_s = patch.row[j].wheel_s;
    patch.angles[j] = patch.row[j].angle;
    for (const double h : gaps) patch.least_gap = std::min(patch.least_gap, h);
  }
}

/// Loads and extents of the rows from the pressures of their elements: the half-length is that of a
/// semi-ellipse with the same moment of inertia.
void CoarseContact::load_rows(ContactPatch& patch, std::span<const double> pressure) {
  const double area = patch.grid.element_area();
  const PatchSurface surface = this->surface();
  for (int j = 0; j < coarse_rows; ++j) {
    double sum = 0, first = 0, second = 0;
    for (int i = 0; i < coarse_columns; ++i) {
      const double p = pressure[static_cast<std::size_t>(j) * coarse_columns + i], x = patch.x[i];
      sum += p, first += p * x, second += p * x * x;
    }
    LoadedRow& row = patch.loaded[j];
    row = {.y = patch.grid.y(j),
           .width = patch.grid.dy,
           .centre = 0,
           .half_length = patch.grid.dx,
           .load = 0,
           .friction = friction(patch.row[j].angle)};
    row.creepage = surface.creepage(patch.outline.frame, method_.shape, patch.row[j], patch.least_gap, patch.speed);
    if (!(sum > 0)) continue;
    row.load = sum * area, row.centre = first / sum;
    row.half_length =
        2 * std::sqrt(std::max(second / sum - row.centre * row.centre, 0.0) + patch.grid.dx * patch.grid.dx / 12);
  }
}

/// FASTSIM2 on all patches; returns by how much the vertical part of the tangential forces changes [N].
double CoarseContact::roll() {
  double change = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    ContactPatch& patch = patches_[k];
    load_rows(patch, normal_.pressure().subspan(k * coarse_elements, coarse_elements));
    (rolls_forward() ? forward_ : backward_)
        .solve(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, patch.loaded, patch.forces);
    for (int j = 0; j < coarse_rows; ++j) {
      const double load = patch.loaded[j].load, lateral = patch.forces[j].fy;
      change += (lateral - patch.shear[j] * load) * std::sin(patch.row[j].angle);
      patch.shear[j] = load > 0 ? lateral / load : 0;
    }
  }
  return change;
}

void CoarseContact::move(const WheelState<double>& state) {
  put(state, state.vertical);
  for (ContactPatch& patch : patches()) patch.speed = rolling_speed(placement_, patch.outline.frame.origin);
  roll();
}

/// The lowest place of the gap, in a search that finds all places at most `depth` above it; its gap is infinite if
/// the wheel is nowhere above the rail.
ContactPoint CoarseContact::lowest_point(double depth) {
  ContactPoint lowest;
  lowest.gap = std::numeric_limits<double>::infinity();
  for (const ContactPoint& point : search_.find(placement_, depth))
    if (point.gap < lowest.gap) lowest = point;
  return lowest;
}

/// By how much the wheel is lowered from its first touch, after Hertz: the approach (9 F^2/(16 E*^2 R))^(1/3) of a
/// sphere whose radius is the mean of those of the surfaces at the point, in its inclined plane.
double CoarseContact::hertzian_lowering(const ContactPoint& point, double vertical_force) const {
  const double cosine = std::max(std::cos(point.inclination), 0.1),
               curvature = point.curvature * cosine * cosine * cosine;
  const double radius = std::sqrt(point.radius / std::clamp(curvature, 0.2, 1e3));
  const double load = vertical_force / cosine;
  return std::cbrt(9 * load * load / (16 * std::pow(bodies_.material.contact_modulus(), 2) * radius)) / cosine;
}

void CoarseContact::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                          WheelRailSolution& out) {
  constexpr int most_iterations = 50, plain_iterations = 10;
  put(state, state.vertical);
  double searched = 3e-4;
  ContactPoint lowest = lowest_point(searched);
  const double clearance = lowest.gap;
  out.status = Status::no_contact;
  if (!std::isfinite(clearance)) return;
  double lowering = vertical_force ? clearance + hertzian_lowering(lowest, *vertical_force) : 0;
  for (ContactPatch& patch : patches_) patch.shear.fill(0);
  bool warm = false;
  Secant secant;
  Bracket bracket;
  out.status = vertical_force ? Status::not_converged : Status::ok;
  for (out.iterations = 1; out.iterations <= most_iterations; ++out.iterations) {
    if (lowering - clearance > searched) {
      put(state, state.vertical);
      searched = 2 * (lowering - clearance);
      lowest_point(searched);
    }
    put(state, state.vertical - lowering);
    find_patches(lowering);
    if (count_ == 0) {
      out.status = Status::no_contact;
      return;
    }
    const CoarseNormal::Result found = normal_.solve(bodies_.material, views_, vertical_force, warm);
    const double change = roll();
    if (found.status != Status::ok || left_out_) out.status = Status::not_converged;
    if (!vertical_force) return;
    warm = true;
    out.residual = (std::abs(found.stiffness * found.lowering) + std::abs(change)) / *vertical_force;
    if (out.residual <= method_.tolerance && found.status == Status::ok && !left_out_) {
      out.status = Status::ok;
      break;
    }
    const double missing = found.lowering - change / found.stiffness;
    // Plain steps converge but where patches come and go; then the zero is bracketed.
    lowering = out.iterations < plain_iterations ? std::max(secant.next(lowering, missing), clearance)
                                                 : bracket.next(lowering, missing);
  }
  out.vertical = state.vertical - lowering;
}

WheelRailPatch CoarseContact::describe(const ContactPatch& patch) const {
  const PatchFrame& frame = patch.outline.frame;
  WheelRailPatch out;
  out.place = frame.origin, out.angle = frame.angle;
  const ProfilePoint on_wheel = bodies_.wheel.at(patch.outline.wheel_s).value;
  out.rail_y = bodies_.rail.at(frame.rail_s).value.y, out.wheel_y = on_wheel.y;
  out.rolling_radius = placement_.radius - on_wheel.z;
  out.turn = patch.outline.turn;
  out.approach = -patch.least_gap;
  out.rolling_speed = patch.speed;
  const PatchSurface surface = this->surface();
  out.creepage = surface.creepage(frame, PatchShape::flat, surface.first_row(frame, patch.outline.wheel_s),
                                  patch.least_gap, patch.speed);
  return out;
}

void CoarseContact::sum(WheelRailSolution& out) const {
  WheelForces wheel;
  const Vec3<double> centre = placement_.wheel.frame.origin;
  out.patches.clear();
  for (std::size_t k = 0; k < count_; ++k) {
    const ContactPatch& patch = patches_[k];
    WheelRailPatch sum = describe(patch);
    for (int j = 0; j < coarse_rows; ++j) {
      const LoadedRow& row = patch.loaded[j];
      if (!(row.load > 0)) continue;
      const RowForces& f = patch.forces[j];
      wheel.add({f.fx, f.fy, row.load}, patch.row[j], row.centre, patch.outline.frame, centre, sum);
      // The row's own moment, beyond that of its forces at its centre.
      const double own = f.mz - row.centre * f.fy;
      sum.moment += own;
      wheel.moment = wheel.moment + own * patch.row[j].normal();
      sum.contact_area += 2 * row.half_length * row.width, sum.slip_area += f.slip_area;
      sum.frictional_power -=
          patch.speed * (row.creepage.longitudinal * f.fx + row.creepage.lateral * f.fy + row.creepage.spin * f.mz);
      // Of a semi-ellipse along the row.
      sum.peak_pressure = std::max(sum.peak_pressure, 2 * row.load / (std::numbers::pi * row.half_length * row.width));
    }
    if (sum.normal_force != 0) out.patches.push_back(sum);
  }
  out.force = wheel.force, out.moment = wheel.moment;
  for (const ContactRegion& region : regions_)
    out.at_profile_end |= region.inner.corner == Corner::end || region.outer.corner == Corner::end;
}

} // namespace microslip
