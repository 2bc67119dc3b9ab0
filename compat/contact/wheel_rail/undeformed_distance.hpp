#pragma once

#include "compat/contact/wheel_rail/patch_frame.hpp"

#include <vector>

namespace microslip::contact_program {

/// The distance of the undeformed bodies at the elements' centres [m].
struct UndeformedDistance {
  std::vector<double> values;            ///< >= 0, zero where they overlap most; large where a body is missing
  std::vector<double> on_rail, on_wheel; ///< the surfaces' heights over the frame's plane; 0 where a body is missing
  double approach = 0;                   ///< the deepest overlap
  double turn = 0;                       ///< by how much the rail's surface turns within the overlap [rad]
};

/// As CONTACT has it: the wheel's profile at steps of DS, revolved at steps of DX, and interpolated bilinearly to the
/// elements' centres; the rail's spline. `rail` in track coordinates. A wheel that is not round is sampled at
/// the points of its slices and interpolated bicubically, and a rail made of slices has a separate section for each
/// column of elements. On a curved patch the distance along the frame's normal, times the cosine of the row's turn.
UndeformedDistance undeformed_distance(const PatchFrame& frame, const Placement& placement, const ProfileCurve& rail);

} // namespace microslip::contact_program
