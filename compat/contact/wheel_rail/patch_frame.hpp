#pragma once

#include "compat/contact/wheel_rail/patch_rules.hpp"
#include "compat/contact/wheel_rail/placement.hpp"

#include <algorithm>

namespace microslip::contact_program {

/// A row of elements on a curved surface, in the track's axes.
struct SurfaceRow {
  Vec3<double> point; ///< of its middle, x as of the patch's reference [m]
  double angle = 0;   ///< of its plane [rad]
};

/// Position and elements of a patch [m]. The frame's x runs along the track, its y (s) along the rail's
/// surface, its z into the rail.
struct PatchFrame {
  Frame<double> reference; ///< at the weighted centre on the rail, turned about x by the mean angle
  Frame<double> grid;      ///< in whose coordinates the elements are given: the reference, or moved along its plane
  double angle = 0;        ///< DELTCP [rad]
  double s_rail = 0;       ///< of the reference along the rail's profile
  int mx = 0, my = 0;
  double x0 = 0, s0 = 0; ///< the corner of the elements
  double dx = 0, ds = 0;
  std::vector<SurfaceRow> rows;   ///< of a curved patch, else empty: the elements lie in the frame's plane
  double y0 = 0, y1 = 0;          ///< the overlap's extent across the track, which the wheel's surface must cover
  std::vector<double> separators; ///< lines of s between the parts that are solved together, ascending
  std::vector<double> factors;    ///< of PatchRegion, for parts in ascending s

  double x1() const { return x0 + mx * dx; }
  double s1() const { return s0 + my * ds; }
  double row_s(int j) const { return s0 + (j + 0.5) * ds; }
  /// Position of a row's middle in the plane, and the angle of the row to it.
  double row_in_plane(int j) const { return rows.empty() ? row_s(j) : grid.inner(row_of(j).point).y; }
  /// y of its middle across the track.
  double row_in_track(int j) const { return grid.outer({0, row_in_plane(j), 0}).y; }
  /// Distance of y across the track from the overlap.
  double distance_across(double y) const { return std::max({y0 - y, y - y1, 0.0}); }
  double row_turn(int j) const { return rows.empty() ? 0 : row_of(j).angle - angle; }

private:
  const SurfaceRow& row_of(int j) const { return rows[static_cast<std::size_t>(j)]; }
};

/// A part of a patch's plane, in the coordinates of its elements [m].
struct PatchBox {
  double x0 = 0, x1 = 0, s0 = 0, s1 = 0;
};

/// Alignment of the elements of successive cases.
enum class GridOrigin {
  reference, ///< an element's centre is at the reference
  moving,    ///< fixed across the rail, and along the track to the wheelset: transient rolling
  fixed,     ///< fixed on the rail: shifts
};

/// Elements that a patch may have, `most` being NPOT_MAX.
double most_elements(GridOrigin origin, int most);

/// Lets the elements reach far enough to cover a box as well. Where that takes more than `most`, a box that lies apart
/// from them along the track is left out, and the result false: so far away its tractions deform next to nothing here.
/// For another one throws Error.
bool cover(PatchFrame& frame, const PatchBox& box, double most);

/// `rail` in track coordinates, `place` is S_WS. Elements are doubled until there are less than `most`.
PatchFrame lay_out_patch(const PatchRegion& patch, const Placement& placement, const ProfileCurve& rail,
                         const PatchRules& sizes, GridOrigin origin, double place, int most);

} // namespace microslip::contact_program
