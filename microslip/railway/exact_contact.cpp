#include "microslip/railway/exact_contact.hpp"

#include "microslip/railway/exact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

/// A loaded patch of the coarse level and its elements for the exact theory.
struct Loaded {
  ContactPatch* patch;
  ExactPatch exact;
  double force; ///< normal [N]
  ExactPatch::Rolled rolled{};
};

/// By how much a force on one patch lifts the rail at another one, for each newton [m/N].
double far_field(const CombinedMaterial& material, const PatchFrame& one, const PatchFrame& other) {
  const Vec3<double> way = other.origin - one.origin;
  return (1 - material.poisson_ratio) * std::cos(one.angle - other.angle) /
         (std::numbers::pi * material.shear_modulus * std::sqrt(dot(way, way)));
}

/// Normal forces of patches that act on each other, with the wheel lowered by `zeta` [m]; returns the vertical force.
double bear(std::vector<Loaded>& loaded, const CombinedMaterial& material, double zeta) {
  constexpr int most_sweeps = 8;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0, largest = 0;
    for (Loaded& one : loaded) {
      const PatchFrame& frame = one.patch->outline.frame;
      double approach = zeta * std::cos(frame.angle);
      for (const Loaded& other : loaded)
        if (&other != &one) approach -= far_field(material, frame, other.patch->outline.frame) * other.force;
      const double before = std::exchange(one.force, one.exact.normal_force(material, approach));
      change += std::abs(one.force - before), largest = std::max(largest, one.force);
    }
    if (loaded.size() == 1 || change < 1e-6 * largest) break;
  }
  double sum = 0;
  for (const Loaded& one : loaded) sum += one.force * one.patch->vertical_share();
  return sum;
}

/// The lowering [m] with which the patches bear the vertical force [N], by secants; sets their normal forces.
double find_lowering(std::vector<Loaded>& loaded, const CombinedMaterial& material, double vertical_force,
                     double lowering) {
  constexpr int most_steps = 12;
  constexpr double tolerance = 1e-6;
  double depth = 0;
  for (const Loaded& one : loaded) depth = std::max(depth, -one.patch->least_gap);
  double before = lowering, excess_before = bear(loaded, material, before) - vertical_force;
  if (std::abs(excess_before) < tolerance * vertical_force) return before;
  double zeta = before - excess_before * depth / (1.5 * (excess_before + vertical_force)); // after Hertz, F ~ depth^1.5
  for (int k = 0; k < most_steps; ++k) {
    const double excess = bear(loaded, material, zeta) - vertical_force;
    if (std::abs(excess) < tolerance * vertical_force || excess == excess_before) break;
    const double next = zeta - excess * (zeta - before) / (excess - excess_before);
    before = zeta, excess_before = excess, zeta = next;
  }
  return zeta;
}

/// One patch has the force that its part of the vertical one demands; several share it by the wheel's height.
double share_load(std::vector<Loaded>& loaded, const CombinedMaterial& material, std::optional<double> vertical_force,
                  double lowering) {
  if (!vertical_force) {
    bear(loaded, material, 0);
    return 0;
  }
  if (loaded.size() > 1) return find_lowering(loaded, material, *vertical_force, lowering);
  loaded.front().force = *vertical_force / loaded.front().patch->vertical_share();
  return lowering;
}

void sum(const CoarseContact& coarse, std::vector<Loaded>& loaded, WheelRailSolution& out) {
  const Vec3<double> centre = coarse.surface().placement().wheel.frame.origin;
  WheelForces wheel;
  out.patches.clear();
  for (Loaded& one : loaded) {
    ContactSolution& solution = one.rolled.solution;
    WheelRailPatch patch = coarse.describe(*one.patch);
    patch.approach += one.rolled.approach;
    const Elements& e = solution.elements;
    const SurfaceFields& f = solution.fields;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (!(f.pressure[i] > 0)) continue;
      const Vec3<double> traction{f.traction.x[i], f.traction.y[i], f.pressure[i]};
      wheel.add(e.area[i] * traction, one.exact.row(static_cast<int>(i) / one.exact.grid().mx), e.x[i],
                one.patch->outline.frame, centre, patch);
    }
    patch.contact_area = solution.totals.adhesion_area + solution.totals.slip_area;
    patch.slip_area = solution.totals.slip_area;
    patch.peak_pressure = solution.totals.peak_pressure;
    patch.frictional_power = solution.totals.frictional_power;
    patch.status = solution.report.status;
    if (patch.status != Status::ok) out.status = patch.status;
    out.patches.push_back(patch);
    out.fields.push_back(std::move(solution));
  }
  out.force = wheel.force, out.moment = wheel.moment;
}

} // namespace

void solve_exact(CoarseContact& coarse, const WheelRailBodies& bodies, const WheelRailMethod& method,
                 std::optional<double> vertical_force, WheelRailSolution& out) {
  constexpr int most_rounds = 6;
  std::vector<Loaded> loaded;
  for (ContactPatch& patch : coarse.patches()) {
    const double load = patch.normal_force();
    if (!(load > 0)) continue;
    const Vec2 extent = patch.extent();
    loaded.push_back({&patch,
                      ExactPatch(coarse.surface(), patch.outline, method.shape, extent.x / method.elements,
                                 extent.y / method.elements, patch.least_gap, patch.speed),
                      load});
  }
  if (loaded.empty()) {
    out.status = Status::no_contact;
    return;
  }
  const auto friction = [&coarse](double angle) { return coarse.friction(angle); };
  const RollingDirection direction = coarse.rolls_forward() ? RollingDirection::forward : RollingDirection::backward;
  double lowering = 0;
  for (int round = 0; round < most_rounds; ++round) {
    lowering = share_load(loaded, bodies.material, vertical_force, lowering);
    double change = 0;
    for (Loaded& one : loaded) {
      one.rolled = one.exact.roll(bodies.material, one.force, friction, direction);
      const double shear = one.rolled.solution.totals.fy / one.force;
      const double sine = std::sin(one.patch->outline.frame.angle);
      change += std::abs((shear - std::exchange(one.patch->shear, shear)) * sine) * one.force;
    }
    if (loaded.size() == 1) lowering = loaded[0].rolled.approach / std::cos(loaded[0].patch->outline.frame.angle);
    out.residual = vertical_force ? change / *vertical_force : 0;
    out.status = Status::not_converged;
    // Beyond this the discretisation's error is larger by far.
    if (out.residual < std::max(method.tolerance, 1e-5)) {
      out.status = Status::ok;
      break;
    }
  }
  if (vertical_force) out.vertical -= lowering;
  sum(coarse, loaded, out);
}

} // namespace microslip
