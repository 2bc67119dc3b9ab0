#include "compat/contact/wheel_rail/wheel_geometry.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

double roll_of(const Frame<double>& frame) {
  return std::atan2(frame.axes.ey.z, frame.axes.ey.y);
}

} // namespace

WheelGeometry::WheelGeometry(const WheelRailData& right, std::shared_ptr<const ProfileCurve> rail,
                             std::shared_ptr<const ProfileCurve> wheel, GridOrigin origin, int most_elements,
                             const RailDeflection& deflection)
    : data_(right), rail_(std::move(rail)), wheel_(std::move(wheel)), origin_(origin), most_elements_(most_elements),
      deflection_(deflection) {
  const Placement at_zero = placement(0);
  const Vec3<double>& place = at_zero.rail.origin;
  rail_in_track_ = std::make_shared<ProfileCurve>(rail_->moved(roll_of(at_zero.rail), place.y, place.z));
  at_zero_ = find_gap_line(at_zero, *rail_in_track_, data_.grid.ds);
}

Placement WheelGeometry::placement(double z) const {
  return place(data_, rail_, wheel_, z, deflection_);
}

/// A wheel that is lowered over a prismatic rail has the same locus.
GapLine WheelGeometry::line(double z) {
  return at_zero_->lowered(z);
}

double WheelGeometry::curvature() const {
  return 0.5 / data_.wheelset.nominal_radius;
}

LeastGap WheelGeometry::least_gap_at_zero() {
  return least_gap(*at_zero_);
}

std::vector<PatchFrame> WheelGeometry::patches(double z) {
  const Placement placed = placement(z);
  std::vector<PatchFrame> frames;
  for (const PatchRegion& patch : make_patches(find_regions(line(z), curvature()), data_.grid))
    frames.push_back(
        lay_out_patch(patch, placed, rail(), data_.grid, origin_, data_.position.s, most_elements_));
  return frames;
}

} // namespace microslip::contact_program
