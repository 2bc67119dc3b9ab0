#pragma once

#include <cstddef>
#include <numbers>

namespace microslip::contact_program {

/// Numbers by which the contact of a wheel is searched and its patches are laid out, in m and rad unless said
/// otherwise. Where a comment names CONTACT's, they are its: those of m_wr_locatecp.f90 but where another file is
/// named. docs/contact-thresholds.md has both beside each other.
struct SearchThresholds {
  static constexpr double locus_step = 0.3; ///< of the gap over the locus, over DS: fac_dyds
  /// The locus jumps where its polygon turns by this, x being multiplied by the next number, within a window of the
  /// third one, or where it has a longer side than the last one: kink_high, scale_z, kink_wid, ds_thrs.
  static constexpr double jump_turn = std::numbers::pi / 10, jump_x = 0.1, jump_window = 1e-5, jump_length = 0.1;

  /// Gaps of neighbouring points that differ by less are one plateau with one minimum: thresh.
  static constexpr double plateau = 1e-9;
  /// Near misses that count at most.
  static constexpr std::size_t most_near_misses = 2;
  /// The least weight of a point of overlap in the means of x, y and angle: over the locus [m3], over a surface [m2].
  static constexpr double least_weight = 1e-19, least_weight_on_surface = 1e-16;

  /// Steps of the gap's grid of brute force: along the track over DX, that of a wheel that is not round; across it over
  /// DS, that with D = 6.
  static constexpr double step_along = 1.5, step_along_varied = 4, step_across = 0.75, step_across_steep = 0.3;
  /// How far that grid reaches to either side of the axle, over the wheel's radius; with D = 6 and for a radius below
  /// the third number; in rad of a wheel that is not round.
  static constexpr double reach = 0.125, reach_steep = 0.242, small_radius = 0.0305, reach_varied = 0.2;

  /// Points at most of the gap's line over the locus and of its grid of brute force, which take seconds. Ours.
  static constexpr double most_on_line = 2e6, most_on_grid = 2e7;
  /// Rows of that grid at least, which the curvature across the rail is found from. Ours.
  static constexpr int least_rows = 3;

  /// Exponent of the factor with which parts of a patch act on each other.
  static constexpr double blending = 0.8;
  /// A patch's plane is at least this far from vertical.
  static constexpr double off_vertical = 1e-3;
  /// NPOT_MAX counts from this on; elements are not enlarged along a side of at most so many.
  static constexpr int least_limit = 100, few_elements = 10;
  /// Elements of a patch at most where they are not enlarged, with T = 1 and 2, and by NPOT_MAX. Ours: solutions take
  /// seconds, or minutes if NPOT_MAX asks for it.
  static constexpr double most_elements = 5e5, most_asked_for = 2e7;

  /// Elements that a patch with D = 4 may have beyond the overlap, on either side: the overlap's extent from the
  /// reference times the first number, and so many; those beyond the last one that lies within the overlap.
  static constexpr double curved_share = 0.2;
  static constexpr int curved_spare = 3, curved_beyond = 2;
  /// Least length of the mean of both normals, of rail and wheel, where they face each other.
  static constexpr double facing = 0.9;

  /// Height of the wheel at which its depth below the rail is refused, over its radius. Ours.
  static constexpr double deepest = 0.1;
  /// Curvature of the rail across the track below which it counts as this, for the first height of a search [1/m].
  static constexpr double least_curvature = 0.1;
  /// Solutions of a search for a prescribed force at most. Ours: CONTACT's are MAXNR.
  static constexpr int most_solutions = 60;
};

} // namespace microslip::contact_program
