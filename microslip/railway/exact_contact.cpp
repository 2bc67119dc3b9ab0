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
  const ContactPatch* patch;
  ExactPatch exact;
  double force;     ///< normal [N]
  double stiffness; ///< its change with the approach, at first after Hertz [N/m]
  double share;     ///< vertical force for each newton of it
  ExactPatch::Rolled rolled{};
  double force_before = 0, approach_before = 0; ///< of the last step
};

/// By how much a force on one patch lifts the rail at another one, for each newton [m/N].
double far_field(const CombinedMaterial& material, const PatchFrame& one, const PatchFrame& other) {
  const Vec3<double> way = other.origin - one.origin;
  return (1 - material.poisson_ratio) * std::cos(one.angle - other.angle) /
         (std::numbers::pi * material.shear_modulus * std::sqrt(dot(way, way)));
}

/// Approach [m] of a patch with the wheel lowered by `zeta`: the others lift it off.
double approach_of(const std::vector<Loaded>& loaded, const Loaded& one, const CombinedMaterial& material,
                   double zeta) {
  const PatchFrame& frame = one.patch->outline.frame;
  double approach = zeta * std::cos(frame.angle);
  for (const Loaded& other : loaded)
    if (&other != &one) approach -= far_field(material, frame, other.patch->outline.frame) * other.force;
  return approach;
}

/// Changes of the normal forces by `rise` [N] of each patch on its own, when each lifts the others off.
std::vector<double> with_coupling(const std::vector<Loaded>& loaded, const CombinedMaterial& material,
                                  const std::vector<double>& rise) {
  constexpr int sweeps = 30; // each reduces the error to a third or less
  std::vector<double> change = rise;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      double lift = 0;
      for (std::size_t l = 0; l < loaded.size(); ++l)
        if (l != k)
          lift += far_field(material, loaded[k].patch->outline.frame, loaded[l].patch->outline.frame) * change[l];
      change[k] = rise[k] - loaded[k].stiffness * lift;
    }
  return change;
}

/// Finds normal forces F_i = N_i(zeta cos(angle_i) - sum C_ij F_j) and, where a vertical force [N] is given, the
/// lowering zeta [m] with which they bear it: Newton's method with stiffnesses dN_i that secants improve. Returns zeta.
double share_load(std::vector<Loaded>& loaded, const CombinedMaterial& material, std::optional<double> vertical_force,
                  double zeta) {
  constexpr int most_steps = 12;
  constexpr double tolerance = 1e-6;
  if (loaded.size() == 1 && vertical_force) {
    loaded.front().force = *vertical_force / loaded.front().share;
    return zeta;
  }
  std::vector<double> missing(loaded.size()), by_zeta(loaded.size());
  for (int step = 0; step < most_steps; ++step) {
    double largest = 0, error = 0, vertical = 0;
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      Loaded& one = loaded[k];
      const double approach = approach_of(loaded, one, material, zeta);
      const double now = one.exact.normal_force(material, approach);
      const double secant = (now - one.force_before) / (approach - one.approach_before);
      if (step > 0 && secant > 0.3 * one.stiffness && secant < 3 * one.stiffness) one.stiffness = secant;
      one.force_before = now, one.approach_before = approach;
      missing[k] = now - one.force;
      by_zeta[k] = one.stiffness * std::cos(one.patch->outline.frame.angle);
      largest = std::max(largest, now), error = std::max(error, std::abs(missing[k]));
      vertical += one.force * one.share;
    }
    const double short_of = vertical_force ? *vertical_force - vertical : 0;
    if (std::max(error, std::abs(short_of)) <= tolerance * largest) break;
    const std::vector<double> direct = with_coupling(loaded, material, missing);
    const std::vector<double> lowered = with_coupling(loaded, material, by_zeta);
    double direct_vertical = 0, lowered_vertical = 0;
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      direct_vertical += direct[k] * loaded[k].share;
      lowered_vertical += lowered[k] * loaded[k].share;
    }
    const double more = vertical_force ? (short_of - direct_vertical) / lowered_vertical : 0;
    for (std::size_t k = 0; k < loaded.size(); ++k)
      loaded[k].force = std::max(loaded[k].force + direct[k] + more * lowered[k], 0.0);
    zeta += more;
  }
  return zeta;
}

/// Of the tractions on a patch, each along the axes of its row.
double vertical_force_of(const Loaded& one) {
  const ContactSolution& s = one.rolled.solution;
  double sum = 0;
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    const double angle = one.exact.row(static_cast<int>(i) / one.exact.grid().mx).angle;
    sum += (s.fields.pressure[i] * std::cos(angle) + s.fields.traction.y[i] * std::sin(angle)) * s.elements.area[i];
  }
  return sum;
}

void sum(const CoarseContact& coarse, std::vector<Loaded>& loaded, WheelRailSolution& out) {
  const Vec3<double> centre = coarse.surface().placement().wheel.frame.origin;
  WheelForces wheel;
  out.patches.clear();
  for (Loaded& one : loaded) {
    if (!(one.force > 0)) continue;
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
  for (const ContactPatch& patch : coarse.patches()) {
    const double load = patch.normal_force;
    const Vec2 extent = patch.extent;
    loaded.push_back({&patch,
                      ExactPatch(coarse.surface(), patch.outline, method.shape, extent.x / method.elements,
                                 extent.y / method.elements, patch.least_gap, patch.speed),
                      load, -1.5 * load / patch.least_gap, patch.vertical_share});
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
    double missing = vertical_force.value_or(0);
    for (const Loaded& one : loaded) missing -= vertical_force ? one.force * one.share : 0;
    double change = 0;
    for (Loaded& one : loaded) {
      if (!(one.force > 0)) continue;
      one.rolled = one.exact.roll(bodies.material, one.force, friction, direction);
      const double share = vertical_force_of(one) / one.force;
      change += std::abs(share - std::exchange(one.share, share)) * one.force;
    }
    if (loaded.size() == 1) lowering = loaded[0].rolled.approach / std::cos(loaded[0].patch->outline.frame.angle);
    out.residual = vertical_force ? (change + std::abs(missing)) / *vertical_force : 0;
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
