#pragma once

#include "microslip/numerics/symmetric_band.hpp"

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// Weights of the third divided difference of values at four ascending points.
std::array<double, 4> third_difference(const std::array<double, 4>& s);

/// Natural quintic smoothing spline: values at points s_i minimise sum w_i (x_i - f(s_i))^2 + lambda int f'''^2 ds, so
/// that parabolas stay as they are and a wave of wavenumber k keeps 1/(1 + lambda k^6) of its amplitude (Reinsch's
/// equations with third differences). Factorised once for several coordinates. Cost O(points).
class QuinticSmoothing {
public:
  /// Steps s_i+1 - s_i > 0, one less than points, and 1/w_i >= 0 of the points, 0 for one that stays.
  QuinticSmoothing(std::span<const double> steps, std::span<const double> inverse_weights, double lambda);

  /// Smooths the values of one coordinate in place; less than four stay.
  void smooth(std::span<double> values) const;

private:
  static constexpr std::size_t half_width = 3;
  using Differences = std::array<double, half_width + 1>;

  void add_kernels(std::span<const double> steps);
  void add_weights();

  std::vector<double> inverse_weights_;
  double lambda_;
  std::vector<Differences> differences_; ///< third divided differences, by their first point
  SymmetricBand<half_width> bands_;
};

} // namespace microslip
