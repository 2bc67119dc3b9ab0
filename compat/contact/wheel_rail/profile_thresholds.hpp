#pragma once

#include <numbers>

namespace microslip::contact_program {

/// Numbers by which the points of a profile are read, in mm and rad unless said otherwise. They are CONTACT's, of
/// m_profile.f90 but where another file is named; docs/contact-thresholds.md has both beside each other.
struct ProfileThresholds {
  /// Points closer than this to the one before are dropped, in the file's unit: point_dist_min.
  static constexpr double spacing = 1e-4;
  /// The least that point.dist.min of a Simpack file stands for, in the file's unit.
  static constexpr double least_spacing = 1e-6;

  static constexpr double zigzag = 5 * std::numbers::pi / 6;   ///< ZIGTHRS where it is not given: zig_thrs
  static constexpr double least_zigzag = std::numbers::pi / 4; ///< and the least of a given one
  static constexpr double kink_high = std::numbers::pi / 6;    ///< KINKHIGH where it is not given
  static constexpr double kink_ratio = 5;                      ///< KINKHIGH over KINKLOW where that is not given
  static constexpr double kink_width = 2;                      ///< KINKWID where it is not given
  static constexpr double most_omitted = 0.5;                  ///< MAXOMIT where it is not given: f_max_omit

  /// SCALE counts as 1 up to this.
  static constexpr double no_scale = 5e-4;
  /// Length of the polygon.
  static constexpr double shortest = 5, longest = 500;

  /// Shares of all points at either end: a wheel's least z with z downwards lies in the first ones, a rail's first
  /// change of z in the others: check_z_pos_down.
  static constexpr double ends_of_wheel = 0.05, ends_of_rail = 0.1;
  /// A change of a rail's z, over its whole height, that counts; and the least height.
  static constexpr double change_of_rail = 0.001, least_height = 1e-5;

  /// Weights of a smoothing spline's points where the profile ends, with ISMOOTH = 1, and at kinks, over those of
  /// other points: m_spline_make.f90.
  static constexpr double weight_of_ends = 20, weight_of_kinks = 100;

  /// Greatest distance of the points at which a slice is sampled: ds_max2d of m_varprof.f90.
  static constexpr double slice_spacing = 0.5;
};

} // namespace microslip::contact_program
