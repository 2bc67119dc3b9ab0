#include "microslip/simplified/ellipse_grid.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace microslip {

EllipseGrid::EllipseGrid(int mx, int my, TractionBound shape) : bound_integral(0), area(0) {
  const bool parabolic = shape == TractionBound::parabolic;
  const auto profile = [&](double position) { // (F13), (F11) along a row
    const double x = 1 - 2 * position / mx;
    return parabolic ? 1 - x * x : std::sqrt(1 - x * x);
  };
  profile_slope = parabolic ? 4.0 / mx : std::numeric_limits<double>::infinity();
  profile_centre.push_back(0);
  for (int i = 1; i <= mx; ++i) {
    profile_middle.push_back(profile(i == 1 ? 0.25 : i - 1));
    profile_centre.push_back(profile(i - 0.5));
  }
  const double row_sum = std::accumulate(profile_centre.begin(), profile_centre.end(), 0.0);
  for (int j = 0; j < my; ++j) {
    y.push_back((2 * j + 1.0) / my - 1);
    half_length.push_back(std::sqrt(1 - y[j] * y[j]));
    row_bound.push_back(parabolic ? half_length[j] * half_length[j] : half_length[j]);
    const double cell = (2 * half_length[j] / mx) * (2.0 / my);
    bound_integral += row_bound[j] * row_sum * cell;
    area += mx * cell;
  }
}

} // namespace microslip
