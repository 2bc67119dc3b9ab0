#include "microslip/simplified/computed_coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {
namespace {

constexpr int ratios = 25;   // a/b in equal steps of its logarithm
constexpr int materials = 5; // nu = 0, 0.125, ..., 0.5
constexpr int numbers = 4;   // C11, C22, C23, C33
constexpr int intervals = ratios - 1;

/// Rows of a/b, nu, C11, C22, C23, C33; nu fastest.
constexpr std::array<double, std::size_t{ratios} * materials*(numbers + 2)> table = {
#include "microslip/simplified/computed_coefficients.inc"
};

/// Interpolated numbers: scale/C11, scale/C22, (1 - nu) C23/scale, (1 - nu) C33/scale. Over nu these come closest to
/// polynomials, and the scales take away most of how they vary with the axis ratio.
using Values = std::array<double, std::size_t{materials} * numbers>;
std::array<double, numbers> scales(double a_over_b) {
  return {1 + a_over_b, 1 + a_over_b, std::sqrt(a_over_b) * (1 + a_over_b), 1 + 1 / a_over_b};
}

/// Between the ratios Hermite's cubics, with slopes of five points.
class Cubics {
public:
  Cubics() {
    std::array<Values, ratios> value{}, slope{};
    for (int i = 0; i < ratios; ++i)
      for (int m = 0; m < materials; ++m) {
        const double* row = &table[std::size_t(i * materials + m) * (numbers + 2)];
        const auto s = scales(row[0]);
        for (int n = 0; n < numbers; ++n)
          value[i][m * numbers + n] = n < 2 ? s[n] / row[2 + n] : (1 - row[1]) * row[2 + n] / s[n];
      }
    // Derivatives of the fourth degree's polynomial through five values, at each of them.
    constexpr double weights[5][5] = {
        {-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}, {-1, 6, -18, 10, 3}, {3, -16, 36, -48, 25}};
    for (int i = 0; i < ratios; ++i) {
      const int first = std::clamp(i - 2, 0, ratios - 5);
      for (std::size_t k = 0; k < slope[i].size(); ++k)
        for (int p = 0; p < 5; ++p) slope[i][k] += weights[i - first][p] * value[first + p][k] / 12;
    }
    for (int i = 0; i < intervals; ++i)
      for (std::size_t k = 0; k < value[i].size(); ++k) {
        const double rise = value[i + 1][k] - value[i][k], s0 = slope[i][k], s1 = slope[i + 1][k];
        cubics_[i][0][k] = value[i][k];
        cubics_[i][1][k] = s0;
        cubics_[i][2][k] = 3 * rise - 2 * s0 - s1;
        cubics_[i][3][k] = s0 + s1 - 2 * rise;
      }
  }

  Values at(double a_over_b) const {
    const double range = std::log(computed_largest_ratio / computed_least_ratio);
    const double position =
        std::clamp(intervals * std::log(a_over_b / computed_least_ratio) / range, 0.0, 1.0 * intervals);
    const int i = std::min(static_cast<int>(position), intervals - 1);
    const double t = position - i;
    const auto& c = cubics_[i];
    Values v;
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = c[0][k] + t * (c[1][k] + t * (c[2][k] + t * c[3][k]));
    return v;
  }

private:
  std::array<std::array<Values, 4>, intervals> cubics_{};
};

/// Lagrange's polynomial through the materials.
std::array<double, materials> weights_of(double nu) {
  const double position = nu * 2 * (materials - 1);
  std::array<double, materials> weights;
  for (int m = 0; m < materials; ++m) {
    weights[m] = 1;
    for (int k = 0; k < materials; ++k)
      if (k != m) weights[m] *= (position - k) / (m - k);
  }
  return weights;
}

const Cubics cubics;

} // namespace

CreepageCoefficients computed_coefficients(double a_over_b, double nu) {
  const Values v = cubics.at(a_over_b);
  const auto weights = weights_of(nu);
  const auto s = scales(a_over_b);
  std::array<double, numbers> c{};
  for (int m = 0; m < materials; ++m)
    for (int n = 0; n < numbers; ++n) c[n] += weights[m] * v[m * numbers + n];
  const double rest = 1 - nu;
  return {s[0] / c[0], s[1] / c[1], c[2] * s[2] / rest, c[3] * s[3] / rest};
}

} // namespace microslip
