#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Points smoothed by wavelength: y and z separately minimise sum w_i (x_i - f(s_i))^2 + lambda int f''^2 ds with
/// w_i = (s_i+1 - s_i-1)/2 and lambda = (L/2 pi)^4 over each section between kinks. A wave of wavenumber k keeps
/// 1/(1 + lambda k^4) of its amplitude: half of it at the wavelength L, all but (L/l)^4 of it at a longer one l. Kinks
/// stay where they are. s is the length of the polygon through the given points. L = `length` [m] in
/// (0, 1], else Error. Cost O(points).
std::vector<ProfilePoint> smoothed(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                   double length);

/// What smooth curves have little of: f'' or f''' squared.
enum class SmoothingPenalty { second_derivative, third_derivative };

/// Smoothed points with weights > 0 of all points and lambda >= 0 given, in any unit of length. Kinks move, too.
std::vector<ProfilePoint> smoothed_with_weights(std::span<const ProfilePoint> points,
                                                std::span<const std::size_t> kinks, double lambda,
                                                std::span<const double> weights,
                                                SmoothingPenalty penalty = SmoothingPenalty::second_derivative);

/// The weights of `smoothed`, except at kinks: half of the sides that meet at each point, which all together are the
/// polygon's length.
std::vector<double> shares_of_length(std::span<const ProfilePoint> points);

/// The lambda of a wavelength, (L/2 pi)^4.
double smoothing_factor(double length);

} // namespace microslip
