#pragma once

#include "microslip/railway/profile/profile_preparation.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace microslip {

/// Profiles known by name, from the arcs, lines and polynomials of their standards. What is not here (56E1, 60E2, EPS
/// and 1/40 of EN 13715) is missing for want of a source that states every radius and junction.
enum class StandardProfile {
  s1002,   ///< wheel of EN 13715, flange 28 mm high
  rail_60, ///< head of 60E1, EN 13674-1, not canted
  rail_54, ///< head of 54E1, EN 13674-1, not canted
  cone_20, ///< straight tread 1:20 with the flange of S1002; no standard's wheel, but one whose conicity is known
  cone_40  ///< the same with 1:40
};

/// The words for them: S1002, 60E1, 54E1, cone-1:20, cone-1:40.
inline constexpr std::array<std::string_view, 5> standard_profile_names = {"S1002", "60E1", "54E1", "cone-1:20",
                                                                           "cone-1:40"};

/// Range of a flange's thickness Sd [m] at 10 mm below the tape line. 32.5 mm is that of EN 13715's drawing; how the
/// standard builds thinner ones is not known here, theirs is a construction of microslip: `standard_points`.
inline constexpr double thinnest_flange = 0.0285, thickest_flange = 0.0325;

/// The standard's role.
ProfileRole role_of(StandardProfile standard);

/// Points at most 0.25 mm apart in the axes of a profile [m], from the gauge side to the field side. A wheel's y = 0 is
/// the tape circle, with z = 0 there; it runs from the flange's back at y = -70 mm to y = 60 mm. A rail's y = 0 is its
/// axis, z = 0 its top; it runs down to 30 mm on both sides.
///
/// S1002 (EN 13715), z down, in mm: line z = 1.364323640 - 0.066666667 y down from y = 60 to 32.15796; polynomials of
/// degree 8 and 7 to -26 and -35; arcs of 13, 20, 12 and 20.5 mm, with a flank of 70 degrees between the first two. A
/// thinner flange moves its arcs: the root's with the polynomial of degree 7 along the tangent at y = -26, where a
/// straight line fills the gap, the tip's towards the back so far that they stay tangent to the flank. So Sh stays 28
/// mm, and no angle jumps.
///
/// Rail heads (EN 13674-1): arcs of 300, 80 and 13 mm, tangent to one another, the first two 20.456 and 52.053 mm wide
/// (60E1) or 20.024 and 49.727 mm (54E1), then sides 1:20, which close to the widths of 72 and 70 mm.
///
/// Throws Error for a thickness outside [thinnest_flange, thickest_flange], and for that of a rail.
std::vector<ProfilePoint> standard_points(StandardProfile standard, std::optional<double> flange_thickness = {});

/// The profile through these points, with a report that names the standard.
PreparedProfile standard_profile(StandardProfile standard, std::optional<double> flange_thickness = {},
                                 const ProfileTreatment& treatment = {});

} // namespace microslip
