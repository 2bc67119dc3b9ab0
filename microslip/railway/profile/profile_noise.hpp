#pragma once

#include "microslip/railway/profile/profile.hpp"
#include "microslip/railway/profile/profile_report.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Scatter of points: the distance of each, across the curve, from the cubic in s through its two neighbours on either
/// side, over what that is for independent errors of deviation 1. Its median around a point, 20 mm and 60 points at
/// least, is the deviation there, since instruments err along their beams and less across steep parts. Corners and
/// outliers do not count. The upper quartile along the profile is its noise, zero for fewer than five points; the
/// deviation of curvature is sqrt(6) sigma/h^2, h the median spacing.
///
/// Errors that neighbours share, and those of rounded values, show in longer waves: means of m = 2, 4, ... points, up
/// to 0.8 mm wide, have a distance from the polynomial through three of them on either side. Of independent errors it
/// is that of single points over sqrt(m); where it is more by half, the largest one times sqrt(m) is the deviation of
/// independent errors with the same long waves. More than ten times that of single points, or of rounding by the
/// largest length that heights are multiples of, is the shape of the profile.
/// Cost O(points 20 mm/h).
ProfileNoise estimate_noise(std::span<const ProfilePoint> points);

/// Points smoothed by their noise, and what uncertainty is left.
struct DenoisedPoints {
  std::vector<ProfilePoint> points;
  double long_waves;                       ///< noise.long_waves, or more if neighbours share more of their errors
  std::vector<std::size_t> checked;        ///< points, about 2 mm apart,
  std::vector<double> curvature_deviation; ///< there [1/m], of the mean curvature of about 6 mm
};

/// The points moved, across the curve that `smoothed` makes of them with a third of the noise's own wavelength, to the
/// curve of few steps of curvature that they and the noise around each make probable
/// (`distances_with_few_curvature_steps`), between kinks, which stay. Points between two kinks that are fewer than four
/// stay as well. How much of their errors neighbours share is first found by means of a millimetre
/// (`noise_factor_beside_few_curvature_steps`). Deviations of curvature are those of eight repetitions with errors by
/// chance on the smoothed curve. None if the smooth curve that this starts from, or its own, is not one: points of it
/// coincide. Needs noise.smoothing_length > 0. Cost O(points), some 50 us each.
std::optional<DenoisedPoints> denoised(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                       const ProfileNoise& noise);

/// Relative standard deviation of the peak pressure between the straight tread of a wheel of radius 0.46 m and a rail's
/// head of radius 0.3 m that follows from the curvature of one of them, by the root mean square of the deviations at
/// the checked points that are inclined by less than 15 degrees. The pressure of Hertz is nearly proportional to (A^2
/// B^2/(A + B))^(2/9), A and B half the curvatures along and across (J. A. Greenwood, Tribology International 30 (1997)
/// 235-237). Zero if there is no such point.
double pressure_deviation(const DenoisedPoints& points);

} // namespace microslip
