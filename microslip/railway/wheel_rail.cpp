#include "microslip/railway/wheel_rail.hpp"

#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/coarse_normal.hpp"
#include "microslip/railway/exact_patch.hpp"
#include "microslip/railway/patch_outline.hpp"
#include "microslip/simplified/loaded_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace {

constexpr int columns = 10, rows = 10; ///< of a patch at the coarse level, across the overlap
constexpr std::size_t elements = columns * rows;
constexpr std::size_t most_patches = 6;
constexpr double nowhere = 1; ///< gap beyond the profiles [m]

/// mu at an inclination.
double friction_at(const std::vector<InclinedFriction>& friction, double angle) {
  const auto after =
      std::find_if(friction.begin(), friction.end(), [angle](const InclinedFriction& f) { return f.angle > angle; });
  if (after == friction.begin()) return friction.front().coefficient;
  if (after == friction.end()) return friction.back().coefficient;
  const InclinedFriction &low = *(after - 1), &high = *after;
  return low.coefficient + (angle - low.angle) / (high.angle - low.angle) * (high.coefficient - low.coefficient);
}

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
    require_finite("friction angle", bodies.friction[k].angle, "rad");
    if (k > 0 && !(bodies.friction[k].angle > bodies.friction[k - 1].angle))
      throw Error("friction angle", bodies.friction[k].angle, "rad", "larger than the one before");
  }
  require_count("elements", method.elements, 6, 1000);
  require_between("tolerance", method.tolerance, "-", 1e-12, 1e-2);
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

/// The sum of forces along a row's axes [N], and of their moment about a point of track axes [N m].
struct Wrench {
  Vec3<double> force, moment;

  void add(const Vec3<double>& f, const Vec3<double>& arm) {
    force = force + f;
    moment = moment + cross(arm, f);
  }
};

/// A patch while it is being solved: its elements at the coarse level, and its rows.
struct Patch {
  PatchOutline outline;
  ElementGrid grid;
  std::array<double, elements> gaps;
  std::array<PatchRow, rows> row;
  std::array<double, rows> angles;
  std::array<double, columns> x;
  double least_gap = 0, speed = 0;
  double shear = 0; ///< force along s over the normal force [-]
  std::array<LoadedRow, rows> loaded;
  std::array<RowForces, rows> forces;

  CoarsePatch view() const { return {grid, outline.frame.origin, outline.frame.angle, gaps, angles, shear}; }
};

/// mx x my elements that cover an outline and `margin` more on both ends of x.
ElementGrid cover(const PatchOutline& o, int mx, int my, int margin) {
  const double dx = (o.x_high - o.x_low) / mx, dy = (o.s_high - o.s_low) / my;
  return {
      .mx = mx + 2 * margin, .my = my, .x0 = o.x_low + (0.5 - margin) * dx, .y0 = o.s_low + dy / 2, .dx = dx, .dy = dy};
}

} // namespace

struct WheelRail::Workspace {
  WheelRailBodies bodies;
  WheelRailMethod method;
  NominalPlacement nominal;
  ContactSearch search;
  CoarseNormal normal{most_patches * elements};
  LoadedRowSolver forward{columns, rows}, backward{columns, rows, RollingDirection::backward};
  std::vector<ContactRegion> regions;
  std::vector<Patch> patches;
  std::vector<CoarsePatch> views;
  std::size_t count = 0; ///< patches in use
  WheelPlacement<double> placement{};

  Workspace(WheelRailBodies given, const WheelRailMethod& how)
      : bodies(std::move(given)), method(how),
        nominal(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel)),
        search(bodies.rail, bodies.wheel), patches(most_patches) {
    regions.reserve(100);
    views.reserve(most_patches);
  }

  PatchSurface surface() const { return {bodies.rail, bodies.wheel, placement}; }
  bool rolls_forward() const { return placement.wheel.velocity.x >= 0; }

  void put(const WheelState<double>& state, double vertical) {
    WheelState<double> there = state;
    there.vertical = vertical;
    placement = place(nominal, there);
  }

  /// Outlines, gaps and rows of all patches when the wheel was lowered from where it was searched.
  void find_patches(double lowering) {
    const auto found = search.regions(lowering);
    regions.assign(found.begin(), found.end());
    // Should there be more than can be, the shortest are left out.
    if (regions.size() > most_patches) {
      const auto length = [](const ContactRegion& r) { return r.outer.s_wheel - r.inner.s_wheel; };
      std::nth_element(regions.begin(), regions.begin() + most_patches, regions.end(),
                       [length](const ContactRegion& a, const ContactRegion& b) { return length(a) > length(b); });
      regions.resize(most_patches);
    }
    count = 0;
    views.clear();
    for (const ContactRegion& region : regions) {
      Patch& patch = patches[count];
      patch.outline = find_outline(placement, bodies.rail, bodies.wheel, region);
      if (!(patch.outline.s_high > patch.outline.s_low) || !(patch.outline.x_high > patch.outline.x_low)) continue;
      patch.grid = cover(patch.outline, columns, rows, 0);
      find_gaps(patch);
      views.push_back(patch.view());
      ++count;
    }
  }

  void find_gaps(Patch& patch) {
    const PatchSurface surface = this->surface();
    for (int i = 0; i < columns; ++i) patch.x[i] = patch.grid.x(i);
    PatchRow near = surface.first_row(patch.outline.frame, patch.outline.wheel_s);
    patch.least_gap = 0;
    patch.speed = rolling_speed(placement, patch.outline.frame.origin);
    for (int j = 0; j < rows; ++j) {
      near = patch.row[j] = surface.row(patch.outline.frame, method.shape, patch.grid.y(j), near);
      const std::span<double> gaps(&patch.gaps[static_cast<std::size_t>(j) * columns], columns);
      surface.find_gaps(patch.row[j], patch.x, nowhere, gaps);
      near.wheel_s = patch.row[j].wheel_s;
      patch.angles[j] = patch.row[j].angle;
      for (const double h : gaps) patch.least_gap = std::min(patch.least_gap, h);
    }
  }

  /// Loads and extents of the rows from the pressures of their elements: the half-length is that of a semi-ellipse with
  /// the same moment of inertia.
  void load_rows(Patch& patch, std::span<const double> pressure) {
    const double area = patch.grid.element_area();
    const PatchSurface surface = this->surface();
    for (int j = 0; j < rows; ++j) {
      double sum = 0, first = 0, second = 0;
      for (int i = 0; i < columns; ++i) {
        const double p = pressure[static_cast<std::size_t>(j) * columns + i], x = patch.x[i];
        sum += p, first += p * x, second += p * x * x;
      }
      LoadedRow& row = patch.loaded[j];
      row = {.y = patch.grid.y(j),
             .width = patch.grid.dy,
             .centre = 0,
             .half_length = patch.grid.dx,
             .load = 0,
             .friction = friction_at(bodies.friction, patch.row[j].angle)};
      row.creepage = surface.creepage(patch.outline.frame, method.shape, patch.row[j], patch.least_gap, patch.speed);
      if (!(sum > 0)) continue;
      row.load = sum * area, row.centre = first / sum;
      row.half_length =
          2 * std::sqrt(std::max(second / sum - row.centre * row.centre, 0.0) + patch.grid.dx * patch.grid.dx / 12);
    }
  }

  /// FASTSIM2 on all patches; returns by how much the vertical part of the tangential forces changes [N].
  double roll() {
    double change = 0;
    for (std::size_t k = 0; k < count; ++k) {
      Patch& patch = patches[k];
      load_rows(patch, normal.pressure().subspan(k * elements, elements));
      (rolls_forward() ? forward : backward)
          .solve(bodies.material.shear_modulus, bodies.material.poisson_ratio, patch.loaded, patch.forces);
      double lateral = 0, load = 0;
      for (int j = 0; j < rows; ++j) {
        const double sine = std::sin(patch.row[j].angle);
        change += (patch.forces[j].fy - patch.shear * patch.loaded[j].load) * sine;
        lateral += patch.forces[j].fy, load += patch.loaded[j].load;
      }
      patch.shear = load > 0 ? lateral / load : 0;
    }
    return change;
  }

  /// The lowest place of the gap, in a search that finds all places at most `depth` above it; its gap is infinite if
  /// the wheel is nowhere above the rail.
  ContactPoint lowest_point(double depth) {
    ContactPoint lowest;
    lowest.gap = std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : search.find(placement, depth))
      if (point.gap < lowest.gap) lowest = point;
    return lowest;
  }

  /// By how much the wheel is lowered from its first touch, after Hertz: the approach (9 F^2/(16 E*^2 R))^(1/3) of a
  /// sphere whose radius is the mean of those of the surfaces at the point, in its inclined plane.
  double hertzian_lowering(const ContactPoint& point, double vertical_force) const {
    const double cosine = std::max(std::cos(point.inclination), 0.1),
                 curvature = point.curvature * cosine * cosine * cosine;
    const double radius = std::sqrt(point.radius / std::clamp(curvature, 0.2, 1e3));
    const double load = vertical_force / cosine;
    return std::cbrt(9 * load * load / (16 * std::pow(bodies.material.contact_modulus(), 2) * radius)) / cosine;
  }

  /// Lowers the wheel until the patches bear the vertical force.
  void solve_coarse(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    constexpr int most_iterations = 50, plain_iterations = 10;
    put(state, state.vertical);
    double searched = 3e-4;
    ContactPoint lowest = lowest_point(searched);
    const double clearance = lowest.gap;
    out.status = Status::no_contact;
    if (!std::isfinite(clearance)) return;
    double lowering = vertical_force ? clearance + hertzian_lowering(lowest, *vertical_force) : 0;
    for (Patch& patch : patches) patch.shear = 0;
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
      if (count == 0) {
        out.status = Status::no_contact;
        return;
      }
      const CoarseNormal::Result found = normal.solve(bodies.material, views, vertical_force, warm);
      const double change = roll();
      if (found.status != Status::ok) out.status = found.status;
      if (!vertical_force) return;
      warm = true;
      out.residual = (std::abs(found.stiffness * found.lowering) + std::abs(change)) / *vertical_force;
      if (out.residual <= method.tolerance && found.status == Status::ok) {
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

  /// What a patch is, apart from its forces.
  WheelRailPatch describe(const Patch& patch) const {
    const PatchFrame& frame = patch.outline.frame;
    WheelRailPatch out;
    out.place = frame.origin, out.angle = frame.angle;
    const ProfilePoint on_wheel = bodies.wheel.at(patch.outline.wheel_s).value;
    out.rail_y = bodies.rail.at(frame.rail_s).value.y, out.wheel_y = on_wheel.y;
    out.rolling_radius = placement.radius - on_wheel.z;
    out.turn = patch.outline.turn;
    out.approach = -patch.least_gap;
    out.rolling_speed = patch.speed;
    const PatchSurface surface = this->surface();
    out.creepage = surface.creepage(frame, PatchShape::flat, surface.first_row(frame, patch.outline.wheel_s),
                                    patch.least_gap, patch.speed);
    return out;
  }

  /// Forces along the axes of a row at a point x of it, added to a patch's and to the wheel's.
  void add_forces(const PatchRow& row, const PatchFrame& frame, double x, const Vec3<double>& f, Wrench& wheel,
                  WheelRailPatch& patch) const {
    const Vec3<double> force = Vec3<double>{f.x, 0, 0} + f.y * row.tangent() + f.z * row.normal();
    const Vec3<double> place = row.point + Vec3<double>{x, 0, 0};
    wheel.add(force, place - placement.wheel.frame.origin);
    const Vec3<double> tangent{0, std::cos(frame.angle), std::sin(frame.angle)};
    const Vec3<double> normal_axis{0, -std::sin(frame.angle), std::cos(frame.angle)};
    patch.fx += force.x, patch.fs += dot(force, tangent), patch.normal_force += dot(force, normal_axis);
    const Vec3<double> tangential = Vec3<double>{f.x, 0, 0} + f.y * row.tangent();
    patch.moment += dot(cross(place - frame.origin, tangential), normal_axis);
  }

  void sum_coarse(WheelRailSolution& out) const {
    Wrench wheel;
    out.patches.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const Patch& patch = patches[k];
      WheelRailPatch sum = describe(patch);
      for (int j = 0; j < rows; ++j) {
        const LoadedRow& row = patch.loaded[j];
        if (!(row.load > 0)) continue;
        const RowForces& f = patch.forces[j];
        add_forces(patch.row[j], patch.outline.frame, row.centre, {f.fx, f.fy, row.load}, wheel, sum);
        // The row's own moment, beyond that of its forces at its centre.
        const double own = f.mz - row.centre * f.fy;
        sum.moment += own;
        wheel.moment = wheel.moment + own * patch.row[j].normal();
        sum.contact_area += 2 * row.half_length * row.width, sum.slip_area += f.slip_area;
        sum.frictional_power -=
            patch.speed * (row.creepage.longitudinal * f.fx + row.creepage.lateral * f.fy + row.creepage.spin * f.mz);
        // Of a semi-ellipse along the row.
        sum.peak_pressure =
            std::max(sum.peak_pressure, 2 * row.load / (std::numbers::pi * row.half_length * row.width));
      }
      if (sum.normal_force != 0) out.patches.push_back(sum);
    }
    out.force = wheel.force, out.moment = wheel.moment;
  }

  /// Lengths of the contact along x and s by its rows at the coarse level [m].
  static Vec2 extent_of(const Patch& patch) {
    double x_low = nowhere, x_high = -nowhere, s = 0;
    for (const LoadedRow& row : patch.loaded) {
      if (!(row.load > 0)) continue;
      x_low = std::min(x_low, row.centre - row.half_length), x_high = std::max(x_high, row.centre + row.half_length);
      s += row.width;
    }
    return {x_high - x_low, s};
  }

  double coarse_load(std::size_t k) const {
    double sum = 0;
    for (const LoadedRow& row : patches[k].loaded) sum += row.load;
    return sum;
  }

  /// By how much a force on one patch lifts the rail at another one, for each newton [m/N].
  double far_field(const PatchFrame& one, const PatchFrame& other) const {
    const Vec3<double> way = other.origin - one.origin;
    return (1 - bodies.material.poisson_ratio) * std::cos(one.angle - other.angle) /
           (std::numbers::pi * bodies.material.shear_modulus * std::sqrt(dot(way, way)));
  }

  /// The exact theory on the patches of the coarse level, whose forces are so near that only a few steps remain.
  void solve_exact(std::optional<double> vertical_force, WheelRailSolution& out) {
    std::vector<std::size_t> loaded;
    std::vector<ExactPatch> exact;
    std::vector<double> force;
    for (std::size_t k = 0; k < count; ++k) {
      const double load = coarse_load(k);
      if (!(load > 0)) continue;
      const Patch& patch = patches[k];
      loaded.push_back(k), force.push_back(load);
      const Vec2 extent = extent_of(patch);
      exact.emplace_back(surface(), patch.outline, method.shape, extent.x / method.elements, extent.y / method.elements,
                         patch.least_gap, patch.speed);
    }
    const auto friction = [this](double angle) { return friction_at(bodies.friction, angle); };
    const RollingDirection direction = rolls_forward() ? RollingDirection::forward : RollingDirection::backward;
    std::vector<ExactPatch::Rolled> rolled(exact.size());
    double lowering = 0;
    for (int round = 0; round < 6; ++round) {
      if (exact.size() > 1 || !vertical_force)
        lowering = share_load(exact, loaded, vertical_force, lowering, force);
      else
        force[0] = *vertical_force / vertical_share(patches[loaded[0]]);
      double change = 0;
      for (std::size_t k = 0; k < exact.size(); ++k) {
        rolled[k] = exact[k].roll(bodies.material, force[k], friction, direction);
        Patch& patch = patches[loaded[k]];
        const double shear = rolled[k].solution.totals.fy / force[k];
        change += std::abs((shear - patch.shear) * std::sin(patch.outline.frame.angle)) * force[k];
        patch.shear = shear;
      }
      if (exact.size() == 1) lowering = rolled[0].approach / std::cos(patches[loaded[0]].outline.frame.angle);
      out.residual = vertical_force ? change / *vertical_force : 0;
      if (!vertical_force || out.residual < std::max(method.tolerance, 1e-5)) break;
    }
    if (vertical_force) out.vertical -= lowering;
    sum_exact(exact, loaded, rolled, out);
  }

  /// Vertical force for each newton of a patch's normal force.
  static double vertical_share(const Patch& patch) {
    return std::cos(patch.outline.frame.angle) + patch.shear * std::sin(patch.outline.frame.angle);
  }

  /// Normal forces of several patches that act on each other as point forces, in the height of the wheel that has the
  /// vertical force, found by secants; returns by how much the wheel is lowered.
  double share_load(const std::vector<ExactPatch>& exact, const std::vector<std::size_t>& loaded,
                    std::optional<double> vertical_force, double lowering, std::vector<double>& force) const {
    const auto vertical_at = [&](double zeta) {
      for (int sweep = 0; sweep < 8; ++sweep) {
        double change = 0;
        for (std::size_t k = 0; k < exact.size(); ++k) {
          const PatchFrame& frame = patches[loaded[k]].outline.frame;
          double approach = zeta * std::cos(frame.angle);
          for (std::size_t l = 0; l < exact.size(); ++l)
            if (l != k) approach -= far_field(frame, patches[loaded[l]].outline.frame) * force[l];
          const double now = exact[k].normal_force(bodies.material, approach);
          change += std::abs(now - force[k]);
          force[k] = now;
        }
        if (exact.size() == 1 || change < 1e-6 * *std::max_element(force.begin(), force.end())) break;
      }
      double sum = 0;
      for (std::size_t k = 0; k < exact.size(); ++k) sum += force[k] * vertical_share(patches[loaded[k]]);
      return sum;
    };
    if (!vertical_force) {
      vertical_at(0);
      return 0;
    }
    double before = lowering, value = vertical_at(before) - *vertical_force;
    double depth = 0;
    for (const std::size_t k : loaded) depth = std::max(depth, -patches[k].least_gap);
    double zeta = before - value / (1.5 * (value + *vertical_force) / depth);
    for (int k = 0; k < 12; ++k) {
      const double here = vertical_at(zeta) - *vertical_force;
      if (std::abs(here) < 1e-6 * *vertical_force || here == value) break;
      const double next = zeta - here * (zeta - before) / (here - value);
      before = zeta, value = here, zeta = next;
    }
    return zeta;
  }

  void sum_exact(const std::vector<ExactPatch>& exact, const std::vector<std::size_t>& loaded,
                 std::vector<ExactPatch::Rolled>& rolled, WheelRailSolution& out) const {
    Wrench wheel;
    out.status = Status::ok;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const Patch& patch = patches[loaded[k]];
      ContactSolution& solution = rolled[k].solution;
      WheelRailPatch sum = describe(patch);
      sum.approach += rolled[k].approach;
      const Elements& e = solution.elements;
      for (std::size_t i = 0; i < e.size(); ++i) {
        const double area = e.area[i];
        if (!(solution.fields.pressure[i] > 0)) continue;
        add_forces(exact[k].row(static_cast<int>(i) / exact[k].grid().mx), patch.outline.frame, e.x[i],
                   {solution.fields.traction.x[i] * area, solution.fields.traction.y[i] * area,
                    solution.fields.pressure[i] * area},
                   wheel, sum);
      }
      sum.contact_area = solution.totals.adhesion_area + solution.totals.slip_area;
      sum.slip_area = solution.totals.slip_area;
      sum.peak_pressure = solution.totals.peak_pressure;
      sum.frictional_power = solution.totals.frictional_power;
      sum.status = solution.report.status;
      if (sum.status != Status::ok) out.status = sum.status;
      out.patches.push_back(sum);
      out.fields.push_back(std::move(solution));
    }
    out.force = wheel.force, out.moment = wheel.moment;
  }

  void solve(const WheelState<double>& given, std::optional<double> vertical_force, WheelRailSolution& out) {
    const bool right = bodies.side == TrackSide::right;
    const WheelState<double> state = right ? given.mirrored() : given;
    out.patches.clear(), out.fields.clear();
    out.force = out.moment = {};
    out.residual = 0, out.iterations = 0, out.at_profile_end = false;
    out.vertical = state.vertical;
    if (!std::isfinite(checksum(state)) || (vertical_force && !(*vertical_force > 0 && *vertical_force < 1e12))) {
      out.status = Status::invalid_input;
      return;
    }
    solve_coarse(state, vertical_force, out);
    if (out.status == Status::no_contact) return;
    if (method.level == WheelRailLevel::exact)
      solve_exact(vertical_force, out);
    else
      sum_coarse(out);
    for (const ContactRegion& region : regions)
      out.at_profile_end |= region.inner.corner == Corner::end || region.outer.corner == Corner::end;
    if (right) mirror(out);
  }

  /// A left wheel's solution as that of a right one.
  static void mirror(WheelRailSolution& out) {
    for (double* odd : {&out.force.y, &out.moment.x, &out.moment.z}) *odd = -*odd;
    for (WheelRailPatch& patch : out.patches)
      for (double* odd :
           {&patch.place.y, &patch.angle, &patch.creepage.lateral, &patch.creepage.spin, &patch.fs, &patch.moment})
        *odd = -*odd;
  }
};

WheelRail::WheelRail(WheelRailBodies bodies, const WheelRailMethod& method) {
  check(bodies, method);
  workspace_ = std::make_unique<Workspace>(std::move(bodies), method);
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

} // namespace microslip
