#include "microslip/railway/rows/row_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {

void WheelForces::add(const Vec3<double>& f, const PatchRow& row, double x, const Vec3<double>& centre) {
  const Vec3<double> normal = row.normal(), tangent{0, normal.z, -normal.y};
  const Vec3<double> leaning = Vec3<double>{f.x - row.slope * f.z, 0, 0} + f.y * tangent + f.z * normal;
  force = force + leaning;
  moment = moment + cross(row.point + Vec3<double>{x, 0, 0} - centre, leaning);
}

void add_to_patch(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame,
                  WheelRailPatch& patch) {
  const Vec3<double> tangential = Vec3<double>{f.x, 0, 0} + f.y * row.tangent();
  const Vec3<double> whole = tangential + f.z * row.normal();
  const Vec3<double> place = row.point + Vec3<double>{x, 0, 0};
  patch.fx += whole.x, patch.fs += dot(whole, frame.tangent()), patch.normal_force += dot(whole, frame.normal());
  patch.moment += dot(cross(place - frame.origin, tangential), frame.normal());
}

RowContact::RowContact(const WheelRailBodies& bodies, const WheelRailMethod& method, const NominalPlacement& nominal,
                       const EquivalentRail* equivalent)
    : bodies_(bodies), shape_(method.surface()), equivalent_(equivalent), rows_(bodies, nominal, equivalent),
      rolling_(bodies, method), height_(rows_, rolling_, bodies, equivalent, method.tolerance),
      flat_rows_(most_wheel_rows) {
  patches_.reserve(most_wheel_rows);
}

/// The rows of a region.
ContactPatch RowContact::patch_of(const ContactRegion& region, std::size_t first, std::size_t count) const {
  ContactPatch patch;
  patch.first = first;
  patch.loaded = rolling_.loaded().subspan(first, count), patch.rows = rows_.rows().subspan(first, count);
  double vertical = 0;
  for (std::size_t k = first; k < first + count; ++k) {
    const double angle = rows_.normal(k).angle;
    patch.normal_force += rolling_.loaded()[k].load;
    vertical += rolling_.loaded()[k].load * std::cos(angle) + rolling_.forces(k).fy * std::sin(angle);
  }
  if (patch.normal_force > 0) patch.vertical_share = vertical / patch.normal_force;
  patch.outline = find_outline(rows_.placement(), bodies_.rail, bodies_.wheel, region, shape_, equivalent_);
  patch.speed = rolling_speed(rows_.placement(), patch.outline.frame.origin);
  patch.least_gap = rows_.least_gap(region);
  return patch;
}

std::span<const ContactPatch> RowContact::patches() {
  patches_.clear();
  const std::span<const ContactRow> rows = rows_.rows();
  for (std::size_t first = 0, next = 0; first < rows.size(); first = next) {
    while (next < rows.size() && rows[next].region == rows[first].region) ++next;
    patches_.push_back(patch_of(rows_.regions()[static_cast<std::size_t>(rows[first].region)], first, next - first));
  }
  return patches_;
}

WheelRailPatch RowContact::describe(const PatchOutline& outline, double least_gap, double speed) const {
  const PatchFrame& frame = outline.frame;
  WheelRailPatch out;
  out.place = frame.origin, out.angle = frame.angle;
  const ProfilePoint on_wheel = bodies_.wheel.at(outline.wheel_s).value;
  out.rail_y = bodies_.rail.at(frame.rail_s).value.y, out.wheel_y = on_wheel.y;
  out.rolling_radius = rows_.placement().radius - on_wheel.z;
  out.turn = outline.turn;
  out.friction = friction(frame.angle);
  out.approach = -least_gap;
  out.rolling_speed = speed;
  const PatchSurface surface = this->surface();
  out.creepage = surface.creepage(frame, PatchShape::flat, surface.first_row(frame, outline.wheel_s), least_gap, speed);
  return out;
}

WheelForces RowContact::forces() const {
  WheelForces wheel;
  const Vec3<double> centre = rows_.placement().wheel.frame.origin;
  for (std::size_t k = 0; k < rows_.count(); ++k) {
    const LoadedRow& row = rolling_.loaded()[k];
    if (!(row.load > 0)) continue;
    const RowForces& f = rolling_.forces(k);
    const PatchRow& at = rows_.rows()[k].at;
    wheel.add({f.fx, f.fy, row.load}, at, row.centre, centre);
    wheel.moment = wheel.moment + rolling_.own_moment(k) * at.normal();
  }
  return wheel;
}

WheelRailPatch RowContact::sum_of(const ContactPatch& patch) const {
  WheelRailPatch sum = describe(patch.outline, patch.least_gap, patch.speed);
  for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
    const LoadedRow& row = rolling_.loaded()[k];
    if (!(row.load > 0)) continue;
    const RowForces& f = rolling_.forces(k);
    add_to_patch({f.fx, f.fy, row.load}, rows_.rows()[k].at, row.centre, patch.outline.frame, sum);
    sum.moment += rolling_.own_moment(k);
    sum.contact_area += 2 * row.half_length * row.width, sum.slip_area += f.slip_area;
    const Creepage& w = row.creepage;
    sum.frictional_power -= rolling_.speed(k) * (w.longitudinal * f.fx + w.lateral * f.fy + w.spin * f.mz);
    if (!rolling_.in_range(k)) sum.status = Status::out_of_range;
    // Of a semi-ellipse along the row.
    sum.peak_pressure = std::max(sum.peak_pressure, 2 * row.load / (std::numbers::pi * row.half_length * row.width));
  }
  return sum;
}

void RowContact::sum(WheelRailSolution& out) {
  out.patches.clear();
  for (const ContactPatch& patch : patches())
    if (patch.normal_force > 0) out.patches.push_back(sum_of(patch));
  const WheelForces wheel = forces();
  out.force = wheel.force, out.moment = wheel.moment;
  for (const ContactRegion& region : rows_.regions())
    out.warnings.add_if(region.inner.corner == Corner::end || region.outer.corner == Corner::end, Warning::profile_end);
}

double RowContact::change_by_planes() {
  const std::size_t count = rows_.count();
  std::copy_n(rolling_.loaded().begin(), count, flat_rows_.begin());
  double bound = 0, across = 0; // of all rows, and the lateral force on planes less that on the true surfaces
  for (const ContactPatch& patch : patches()) {
    const double inclination = patch.outline.frame.angle;
    const WheelRailPatch plane = describe(patch.outline, patch.least_gap, patch.speed);
    for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
      LoadedRow& row = flat_rows_[k];
      const double s = dot(patch.outline.frame.tangent(), rows_.normal(k).place - patch.outline.frame.origin);
      row.creepage = plane.creepage;
      row.creepage.longitudinal -= plane.creepage.spin * s;
      row.creepage.lateral -= plane.creepage.spin * patch.outline.frame.origin.x;
      bound += row.friction * row.load;
      across -= row.load * (std::sin(inclination) - std::sin(rows_.normal(k).angle));
    }
  }
  const std::span<const RowForces> flat = rolling_.forces_with(std::span(flat_rows_).first(count), rolls_forward());
  double along = 0;
  for (const ContactPatch& patch : patches()) {
    const double cosine = std::cos(patch.outline.frame.angle);
    for (std::size_t k = patch.first; k < patch.first + patch.loaded.size(); ++k) {
      along += flat[k].fx - rolling_.forces(k).fx;
      across += flat[k].fy * cosine - rolling_.forces(k).fy * std::cos(rows_.normal(k).angle);
    }
  }
  return bound > 0 ? std::hypot(along, across) / bound : 0;
}

void RowContact::add_fields(WheelRailSolution& out) {
  for (const ContactPatch& patch : patches()) {
    if (!(patch.normal_force > 0)) continue;
    ContactSolution fields = rolling_.fields(patch.loaded, patch.outline.frame, patch.speed, rolls_forward());
    const WheelRailPatch description = describe(patch.outline, patch.least_gap, patch.speed);
    fields.creepage = description.creepage, fields.approach = description.approach;
    out.fields.push_back(std::move(fields));
  }
}

} // namespace microslip
