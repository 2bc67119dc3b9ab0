#include "compat/contact/wheel_rail/patch_case.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip::contact_program {
namespace {

/// One set of a patch in a plane; rows of a curved one have separate sets where friction varies with the
/// inclination.
FrictionData friction_of(const Case& c, const PatchLocation& location, const PatchFrame& frame) {
  FrictionData friction = c.friction;
  if (friction.stations.empty()) return friction;
  const WheelRailData& data = *c.wheel_rail;
  const bool along = data.digits.varfrc == FrictionStations::along_track;
  friction.by_row = !along && !frame.rows.empty();
  friction.sets.clear();
  for (const SurfaceRow& row : frame.rows)
    if (friction.by_row) friction.sets.push_back(friction_at(c.friction, row.angle));
  if (!friction.by_row) friction.sets = {friction_at(c.friction, along ? data.position.s : location.angle_on_wheel)};
  friction.stations.clear();
  return friction;
}

/// The lines between sub-patches, and the factor of each pair: 1 and 2, 1 and 3, ..., 2 and 3, ...
std::vector<double> sub_patches(const PatchFrame& frame) {
  const std::size_t n = frame.separators.size() + 1;
  std::vector<double> values = {static_cast<double>(n)};
  values.insert(values.end(), frame.separators.begin(), frame.separators.end());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) values.push_back(frame.factors[i * n + j]);
  return values;
}

/// Digits of module 3 instead of those that module 1 has otherwise.
void set_digits(Digits& d) {
  d.norm = Normal::approach;
  d.force = Prescribed::creepages;
  d.varfrc = FrictionSets::one;
  d.discns = GridSource::read;
  d.rznorm = DistanceSource::read;
  d.exrhs = ExtraSlip::none;
  d.stress = InteriorPoints::none;
}

} // namespace

std::vector<double> friction_at(const FrictionData& friction, double station) {
  const auto& at = friction.stations;
  const auto above = std::upper_bound(at.begin(), at.end(), station);
  if (above == at.begin()) return friction.sets.front();
  if (above == at.end()) return friction.sets.back();
  const auto k = static_cast<std::size_t>(above - at.begin());
  const double share = (station - at[k - 1]) / (at[k] - at[k - 1]);
  std::vector<double> set = friction.sets[k - 1];
  for (std::size_t i = 0; i < set.size(); ++i) set[i] += share * (friction.sets[k][i] - set[i]);
  return set;
}

PatchLocation locate(const PatchFrame& frame, const Placement& placement) {
  const Frame<double>& reference = frame.reference;
  PatchLocation l;
  l.track = reference.origin;
  l.rail = placement.rail.inner(reference.origin);
  l.wheel = placement.wheel.inner(reference.origin);
  l.angle = frame.angle;
  const auto turned = [&](const Rotation<double>& axes) {
    return roll_of({axes.back(reference.axes.ex), axes.back(reference.axes.ey), axes.back(reference.axes.ez)});
  };
  l.angle_on_rail = turned(placement.rail.axes);
  l.angle_on_wheel = turned(placement.wheel.axes);
  return l;
}

Case patch_case(const Case& c, const PatchFrame& frame, const UndeformedDistance& distance, const PatchMotion& motion,
                const PatchLocation& location) {
  Case p = c;
  p.wheel_rail.reset();
  set_digits(p.digits);
  p.friction = friction_of(c, location, frame);
  for (int j = 0; j < static_cast<int>(frame.rows.size()); ++j)
    p.material->correction.angles.emplace_back(frame.row_s(j), frame.angle + frame.row_turn(j));
  p.load = {NormalLoad::Given::approach, distance.approach};
  p.x = Slip{motion.xi};
  p.y = Slip{motion.eta};
  p.phi = motion.phi;
  const Vec3<double> reference = frame.grid.inner(frame.reference.origin);
  p.spin_x = reference.x;
  p.spin_y = reference.y;
  RollingData rolling;
  rolling.chi = motion.backward ? std::numbers::pi : 0;
  rolling.dq = c.wheel_rail->grid.dqrel * frame.dx;
  rolling.veloc = motion.velocity;
  p.rolling = rolling;
  p.potential =
      PotentialContact{Potential::corner_and_size, frame.mx, frame.my, {frame.x0, frame.s0, frame.dx, frame.ds}, 1};
  p.geometry = {};
  p.geometry.base = Base::by_element;
  p.geometry.values = distance.values;
  if (!frame.separators.empty() && c.digits.bound == PressureModel::half_space) {
    p.geometry.planform = Planform::sub_patches;
    p.geometry.plan_values = sub_patches(frame);
  }
  p.extra = motion.extra.empty() ? ExtraSlip::none : ExtraSlip::by_element;
  p.extra_slip = motion.extra;
  for (double& slip : p.extra_slip) slip /= unit_of_slip(p.digits);
  return p;
}

} // namespace microslip::contact_program
