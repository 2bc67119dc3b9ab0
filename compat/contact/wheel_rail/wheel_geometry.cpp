#include "compat/contact/wheel_rail/wheel_geometry.hpp"

#include "compat/contact/wheel_rail/curved_patch.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/wheel_rail/varied_profile.hpp"
#include "microslip/error.hpp"

#include <string>

namespace microslip::contact_program {

namespace {

bool contains(const GapRegion& whole, const GapRegion& part) {
  return part.x0 >= whole.x0 && part.x1 <= whole.x1 && part.y0 >= whole.y0 && part.y1 <= whole.y1;
}

/// PatchRegion::below_section of what these regions form on a rail made of slices.
double below_section(const Placement& p, const GapRegion& whole, const ProfileCurve& section,
                     const std::vector<GapRegion>& regions) {
  const auto height = [](const ProfileCurve& rail, double y) { return rail.at(rail.nearest_s_at_y(y)).value.z; };
  double sum = 0, weight = 0;
  for (const GapRegion& region : regions) {
    if (!contains(whole, region)) continue;
    weight += region.weight;
    if (const auto own = rail_section(p, region.x))
      sum += region.weight * (height(*own, region.y) - height(section, region.y));
  }
  return weight > 0 ? sum / weight : 0;
}

} // namespace

double place_on_track(const WheelRailData& data) {
  return data.digits.is_roller() ? 0 : data.position.s;
}

WheelGeometry::WheelGeometry(const WheelRailData& right, ProfileShape rail, const PlacedRail& placed,
                             ProfileShape wheel, GridOrigin origin, int most_elements)
    : data_(right), placed_at_zero_(place_at_zero(right, std::move(rail), placed.frame, std::move(wheel))),
      origin_(origin), most_elements_(most_elements), rail_in_track_(placed.in_track) {
  const bool brute_force = right.search == ContactSearch::brute_force || right.search == ContactSearch::steep;
  if (brute_force || placed_at_zero_.wheel_profile.varies())
    brute_force_.emplace(placed_at_zero_, *rail_in_track_, data_.grid, right.search == ContactSearch::steep);
  else
    at_zero_ = find_gap_line(placed_at_zero_, *rail_in_track_, data_.grid);
}

/// A round wheel that is lowered over a rail has the same locus, but not over a roller, whose slope depends on height.
GapLine WheelGeometry::line(double z) const {
  return data_.digits.is_roller() ? find_gap_line(placement(z), *rail_in_track_, data_.grid) : at_zero_->lowered(z);
}

double WheelGeometry::curvature() const {
  const double of_roller = data_.digits.is_roller() ? 0.5 / data_.track.roller_radius : 0;
  return 0.5 / data_.wheelset.nominal_radius + of_roller;
}

LeastGap WheelGeometry::least_gap_at_zero() const {
  return brute_force_ ? brute_force_->least() : least_gap(*at_zero_);
}

bool WheelGeometry::overlaps() const {
  return brute_force_ ? brute_force_->overlaps() : at_zero_->overlaps;
}

std::vector<GapRegion> WheelGeometry::regions(double z) const {
  const double depth = z - least_gap_at_zero().gap;
  if (depth > SearchThresholds::deepest * data_.wheelset.nominal_radius)
    throw Error("wheel and rail overlap by " + std::to_string(depth * per_m) + " mm; is the wheel's height right?");
  if (!brute_force_) return find_regions(line(z), curvature());
  return brute_force_->regions(z);
}

std::vector<NearMiss> WheelGeometry::near_misses(double z) const {
  if (!(data_.grid.g_miss > 0)) return {};
  return brute_force_ ? brute_force_->near_misses(z, data_.grid.g_miss)
                      : contact_program::near_misses(line(z), data_.grid.g_miss);
}

/// The rail's profile in the track's axes; of slices that in the middle of a patch.
std::shared_ptr<const ProfileCurve> WheelGeometry::rail_at(double x) const {
  if (!placed_at_zero_.rail_profile.varies()) return rail_in_track_;
  auto section = rail_section(placed_at_zero_, x);
  if (!section)
    throw Error("the rail is interrupted at x = " + std::to_string(x * per_m) + " mm, in the middle of a patch");
  return std::make_shared<ProfileCurve>(std::move(*section));
}

std::vector<PatchFrame> WheelGeometry::patches(double z) {
  const Placement placed = placement(z);
  std::vector<PatchFrame> frames;
  const std::vector<GapRegion> overlap = regions(z);
  for (PatchRegion& patch : make_patches(overlap, data_.grid)) {
    const auto rail = rail_at(patch.whole.x);
    if (placed_at_zero_.rail_profile.varies())
      patch.below_section = below_section(placed_at_zero_, patch.whole, *rail, overlap);
    frames.push_back(lay_out_patch(patch, placed, *rail, data_.grid, origin_, place_on_track(data_), most_elements_));
  }
  if (data_.search == ContactSearch::conformal)
    for (PatchFrame& frame : frames) CurvedPatch(frame, placed, *rail_in_track_).choose_rows(frame);
  return frames;
}

void WheelGeometry::bend(PatchFrame& frame, double z) const {
  if (data_.search != ContactSearch::conformal) return;
  const Placement placed = placement(z);
  CurvedPatch(frame, placed, *rail_in_track_).bend(frame);
}

} // namespace microslip::contact_program
