#pragma once

#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/railway/profile/profile.hpp"
#include "microslip/railway/profile/profile_surface.hpp"

namespace microslip {

/// A profile, and the surface of slices where it varies.
struct BodyShape {
  const Profile* profile = nullptr;
  const ProfileSurface* surface = nullptr;
};

/// A profile at one position along the track, and the v of its first point.
struct ProfileSection {
  Profile profile;
  double first = 0;
};

/// Section at u, along the track [m] or around the wheel [rad]. Throws Error where there are fewer than two points, as
/// in an interruption.
ProfileSection section_at(const BodyShape& body, double u);

/// Intersection of a straight line and a surface.
struct SurfaceHit {
  double n = 0; ///< along the line, from its point [m]
  double v = 0; ///< across the surface: that of its slices, or the number of a point of the profile, with fractions
};

/// Point where the line p + n d, d a unit vector across the track's x, meets a rail or a wheel in its position:
/// Newton's method from `hit`. False where it does not, as beyond a profile and in an interruption. Cost some 0.5 us.
bool find_on_rail(BodyShape rail, const WheelPlacement<double>& placement, const Vec3<double>& p, const Vec3<double>& d,
                  SurfaceHit& hit);
bool find_on_wheel(BodyShape wheel, const WheelPlacement<double>& placement, const Vec3<double>& p,
                   const Vec3<double>& d, SurfaceHit& hit);

/// The number of a profile's point at the parameter s [m], with fractions in between; and back.
double number_at(const Profile& profile, double s);
double parameter_at(const Profile& profile, double number);

} // namespace microslip
