#include "microslip/railway/exact/load_sharing.hpp"

#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

/// The pressures of all patches but one as loads.
std::vector<PointLoad> loads_on(const std::vector<ContactGroup>& groups, const ContactGroup& one) {
  std::vector<PointLoad> all;
  for (const ContactGroup& other : groups) {
    if (&other == &one || !(other.exact.normal_force() > 0)) continue;
    for (PointLoad load : other.exact.loads()) {
      load.force *= other.force / other.exact.normal_force();
      all.push_back(load);
    }
  }
  return all;
}

/// Approach [m] of a patch with the wheel lowered by `zeta` [m] and others that lift it.
double approach_of(const ContactGroup& one, std::span<const PointLoad> loads, double zeta) {
  double approach = zeta * one.cosine();
  for (const PointLoad& load : loads) approach -= one.exact.lift_by(load);
  return approach;
}

/// Changes of the normal forces [N] that were those of each patch on its own, when each lifts the others off; as they
/// were where together they have none.
void couple(const std::vector<ContactGroup>& groups, std::vector<double>& direct, std::vector<double>& lowered) {
  const std::size_t n = groups.size();
  std::vector<double> rows;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < n; ++l) {
      PointLoad unit = groups[l].exact.load();
      unit.force = 1;
      rows.push_back(k == l ? 1 : groups[k].stiffness * groups[k].exact.lift_by(unit));
    }
    rows.push_back(direct[k]), rows.push_back(lowered[k]);
  }
  if (!eliminate(rows, n, 2)) return;
  for (std::size_t k = 0; k < n; ++k) direct[k] = rows[k * (n + 2) + n], lowered[k] = rows[k * (n + 2) + n + 1];
}

/// A step of Newton's method for normal forces F_i = N_i(zeta cos(angle_i) - sum C_ij F_j) that carry a vertical force
/// [N] where one is given. Returns the change of zeta [m], nothing where lowering the wheel would lift it less.
std::optional<double> correct(std::vector<ContactGroup>& groups, std::optional<double> vertical_force) {
  std::vector<double> direct, lowered;
  for (const ContactGroup& one : groups) {
    direct.push_back(one.pressed - one.force);
    lowered.push_back(one.stiffness * one.cosine());
  }
  couple(groups, direct, lowered);
  double more = 0;
  if (vertical_force) {
    double short_of = *vertical_force, vertical_by_zeta = 0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      short_of -= (groups[k].force + direct[k]) * groups[k].share;
      vertical_by_zeta += lowered[k] * groups[k].share;
    }
    if (!(vertical_by_zeta > 0)) return {};
    more = short_of / vertical_by_zeta;
  }
  if (!std::isfinite(more)) return {};
  for (std::size_t k = 0; k < groups.size(); ++k)
    groups[k].force = std::max(groups[k].force + direct[k] + more * lowered[k], 0.0);
  return more;
}

/// Change of a patch's normal force with the approach as it is after Hertz: from the approach beyond the first touch.
double hertzian_stiffness(const ContactGroup& one, std::span<const PointLoad> loads) {
  if (!(one.exact.normal_force() > 0)) return 0;
  const double touching = one.exact.approach() - one.exact.least_gap();
  return 1.5 * one.exact.normal_force() / std::max(touching + approach_of(one, loads, 0), 0.1 * touching);
}

/// Presses a patch with the wheel lowered by `zeta`, the others lifting it; a secant improves its stiffness.
void solve_normal(std::vector<ContactGroup>& groups, ContactGroup& one, double zeta, double tolerance) {
  constexpr double least_change = 5e-4; // of the force, beyond what tolerances leave
  const std::vector<PointLoad> loads = loads_on(groups, one);
  one.exact.apply_lift(loads);
  one.exact.solve_normal(zeta * one.cosine(), tolerance);
  one.pressed = one.exact.normal_force();
  const double approach = approach_of(one, loads, zeta);
  if (one.force_before && std::abs(one.pressed - *one.force_before) > least_change * one.pressed) {
    const double secant = (one.pressed - *one.force_before) / (approach - one.approach_before);
    if (secant > 0.5 * one.stiffness && secant < 2 * one.stiffness) one.stiffness = secant;
  }
  // Without contact it has no part in the next step; that it once had would let the others' forces diverge.
  if (!(one.stiffness > 0) || !(one.pressed > 0)) one.stiffness = hertzian_stiffness(one, loads);
  one.force_before = one.pressed, one.approach_before = approach;
}

/// Scales pressures to the forces wanted if these differ by little: of a change, that leaves a third in the approach.
bool scale(std::vector<ContactGroup>& groups) {
  constexpr double little = 1e-4, settled = 1e-6;
  for (const ContactGroup& one : groups)
    if (std::abs(one.force - one.exact.normal_force()) > little * one.force || one.exact.unsettled() > settled)
      return false;
  for (ContactGroup& one : groups)
    if (one.force > 0) one.exact.scale_to(one.force), one.pressed = one.force;
  return true;
}

} // namespace

void press_first(std::vector<ContactGroup>& groups) {
  constexpr double tolerance = 1e-4;
  for (ContactGroup& one : groups) {
    std::vector<PointLoad> rows;
    for (const ContactGroup& other : groups)
      if (&other != &one) rows.insert(rows.end(), other.start.begin(), other.start.end());
    one.exact.apply_lift(rows);
    if (one.force > 0) {
      one.exact.press_with(one.force, tolerance);
      one.pressed = one.force - hertzian_stiffness(one, rows) * one.exact.approach();
    } else {
      one.exact.solve_normal(0, tolerance);
      one.pressed = one.force = one.exact.normal_force();
    }
    one.stiffness = hertzian_stiffness(one, rows);
  }
}

std::optional<double> share_load(std::vector<ContactGroup>& groups, std::optional<double> vertical_force, double zeta,
                                 Round round) {
  constexpr int most_steps = 12;
  constexpr double rough = 1e-4;
  if (groups.size() == 1) {
    const double tolerance = round == Round::forecast ? rough : 1e-6;
    ContactGroup& only = groups.front();
    if (vertical_force && !(only.share > 0)) return {};
    if (vertical_force) only.force = *vertical_force / only.share;
    if (!vertical_force)
      only.exact.solve_normal(0, tolerance);
    else if (!scale(groups))
      only.exact.press_with(only.force, tolerance);
    return only.exact.approach() / only.cosine();
  }
  const bool first = round != Round::later;
  const double tolerance = first ? rough : 2e-7;
  double of_pressures = 0.1 * tolerance;
  for (int step = 0; step < most_steps; ++step) {
    const std::optional<double> more = correct(groups, vertical_force);
    if (!more) return {};
    zeta += *more;
    if (!first && step == 0 && scale(groups)) break;
    double largest = 0, error = 0;
    for (ContactGroup& one : groups) {
      solve_normal(groups, one, zeta, of_pressures);
      largest = std::max(largest, one.pressed), error = std::max(error, std::abs(one.pressed - one.force));
    }
    if (error <= tolerance * largest && of_pressures <= tolerance) break;
    of_pressures = std::clamp(0.01 * error / largest, normal_tolerance, 0.1 * tolerance);
  }
  return zeta;
}

} // namespace microslip
