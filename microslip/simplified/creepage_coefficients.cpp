#include "microslip/simplified/creepage_coefficients.hpp"

#include "microslip/simplified/computed_coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr int ratios = 10;   // g = min(a/b, b/a) = 0.1, 0.2, ..., 1
constexpr int numbers = 4;   // C11, C22, C23, C33
constexpr int materials = 3; // nu = 0, 0.25, 0.5

/// Kalker 1990, table E.3: [g][C11 C22 C23 C33][nu].
using Table = std::array<std::array<std::array<double, materials>, numbers>, ratios>;

constexpr Table slender_across = {{// a/b = g
                                   {{{2.51, 3.31, 4.85}, {2.51, 2.52, 2.53}, {.334, .473, .731}, {6.42, 8.28, 11.7}}},
                                   {{{2.59, 3.37, 4.81}, {2.59, 2.63, 2.66}, {.483, .603, .809}, {3.46, 4.27, 5.66}}},
                                   {{{2.68, 3.44, 4.80}, {2.68, 2.75, 2.81}, {.607, .715, .889}, {2.49, 2.96, 3.72}}},
                                   {{{2.78, 3.53, 4.82}, {2.78, 2.88, 2.98}, {.720, .823, .977}, {2.02, 2.32, 2.77}}},
                                   {{{2.88, 3.62, 4.83}, {2.88, 3.01, 3.14}, {.827, .929, 1.07}, {1.74, 1.93, 2.22}}},
                                   {{{2.98, 3.72, 4.91}, {2.98, 3.14, 3.31}, {.930, 1.03, 1.18}, {1.56, 1.68, 1.86}}},
                                   {{{3.09, 3.81, 4.97}, {3.09, 3.28, 3.48}, {1.03, 1.14, 1.29}, {1.43, 1.50, 1.60}}},
                                   {{{3.19, 3.91, 5.05}, {3.19, 3.41, 3.65}, {1.13, 1.25, 1.40}, {1.34, 1.37, 1.42}}},
                                   {{{3.29, 4.01, 5.12}, {3.29, 3.54, 3.82}, {1.23, 1.36, 1.51}, {1.27, 1.27, 1.27}}},
                                   {{{3.40, 4.12, 5.20}, {3.40, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}}}};

constexpr Table slender_along = {{// b/a = g
                                  {{{10.7, 11.7, 12.9}, {10.7, 12.8, 16.0}, {12.2, 14.6, 18.0}, {.795, .526, .228}}},
                                  {{{6.96, 7.78, 8.82}, {6.96, 8.14, 9.79}, {5.72, 6.63, 7.89}, {.828, .601, .341}}},
                                  {{{5.57, 6.34, 7.34}, {5.57, 6.40, 7.51}, {3.79, 4.32, 5.01}, {.868, .674, .446}}},
                                  {{{4.84, 5.57, 6.57}, {4.84, 5.48, 6.31}, {2.88, 3.24, 3.70}, {.912, .747, .549}}},
                                  {{{4.37, 5.10, 6.11}, {4.37, 4.90, 5.56}, {2.35, 2.62, 2.96}, {.958, .819, .650}}},
                                  {{{4.06, 4.78, 5.80}, {4.06, 4.50, 5.04}, {2.01, 2.23, 2.50}, {1.01, .892, .751}}},
                                  {{{3.82, 4.54, 5.58}, {3.82, 4.21, 4.67}, {1.76, 1.95, 2.18}, {1.05, .965, .852}}},
                                  {{{3.65, 4.36, 5.42}, {3.65, 3.99, 4.39}, {1.58, 1.75, 1.94}, {1.10, 1.04, .954}}},
                                  {{{3.51, 4.22, 5.30}, {3.51, 3.81, 4.16}, {1.44, 1.59, 1.77}, {1.16, 1.11, 1.06}}},
                                  {{{3.40, 4.12, 5.20}, {3.40, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}}}};

/// The powers of g by which the coefficients grow as the ellipse becomes slender. Divided by them they vary slowly, so
/// that little is lost between the rows of the table: across (C23 ~ sqrt g, C33 ~ 1/g), along (C11, C22 ~ 1/g, C23 ~
/// g^-3/2).
using Scales = std::array<double, numbers>;
Scales scales_across(double g) {
  return {1, 1, std::sqrt(g), 1 / g};
}
Scales scales_along(double g) {
  const double inverse = 1 / g;
  return {inverse, inverse, inverse * std::sqrt(inverse), 1};
}

/// Branch of the table, ready for use: the scaled inverse coefficients scale/C as cubic polynomials in g between
/// the rows, for the three materials. Inverse, because over nu 1/C is closest to a parabola.
class Branch {
public:
  Branch(const Table& table, Scales (*scales)(double)) : scales_(scales) {
    for (int n = 0; n < numbers; ++n)
      for (int m = 0; m < materials; ++m) {
        std::array<double, ratios> value{};
        for (int i = 0; i < ratios; ++i) value[i] = scales(0.1 * (i + 1))[n] / table[i][n][m];
        for (int i = 0; i < intervals; ++i) set_cubic(value, i, numbers * m + n);
      }
  }

  CreepageCoefficients at(double g, const std::array<double, materials>& weights) const {
    const double position = std::clamp(10 * g - 1, 0.0, double(intervals));
    const int i = std::min(static_cast<int>(position), intervals - 1);
    const double t = position - i;
    const auto& k = cubics_[i];
    std::array<double, std::size_t{numbers} * materials> value;
    for (int n = 0; n < numbers * materials; ++n) value[n] = k[0][n] + t * (k[1][n] + t * (k[2][n] + t * k[3][n]));
    Scales c = scales_(g);
    for (int n = 0; n < numbers; ++n)
      c[n] /= weights[0] * value[n] + weights[1] * value[numbers + n] + weights[2] * value[2 * numbers + n];
    return {c[0], c[1], c[2], c[3]};
  }

private:
  static constexpr int intervals = ratios - 1;

  /// Hermite's cubic on interval i, with central differences for the slopes (one-sided parabolas at the ends).
  void set_cubic(const std::array<double, ratios>& v, int i, int n) {
    const auto slope = [&](int k) {
      if (k == 0) return -1.5 * v[0] + 2 * v[1] - 0.5 * v[2];
      if (k == ratios - 1) return 1.5 * v[k] - 2 * v[k - 1] + 0.5 * v[k - 2];
      return 0.5 * (v[k + 1] - v[k - 1]);
    };
    const double rise = v[i + 1] - v[i], s0 = slope(i), s1 = slope(i + 1);
    const double powers[] = {v[i], s0, 3 * rise - 2 * s0 - s1, s0 + s1 - 2 * rise};
    for (int power = 0; power < 4; ++power) cubics_[i][power][n] = powers[power];
  }

  Scales (*scales_)(double);
  /// [interval][power of the position in it][material, coefficient]: in this order one pass evaluates all of them.
  std::array<std::array<std::array<double, std::size_t{numbers} * materials>, 4>, intervals> cubics_{};
};

/// Limits for slender ellipses (Kalker 1990, table E.3, rows g -> 0), [C11 C22 C23 C33].
Scales limit_across(double g, double nu) {
  constexpr double pi = std::numbers::pi;
  return {pi * pi / (4 * (1 - nu)), pi * pi / 4, pi * std::sqrt(g) / (3 * (1 - nu)) * (1 + nu * (std::log(16 / g) - 5)),
          pi * pi / (16 * (1 - nu) * g)};
}
Scales limit_along(double g, double nu) {
  constexpr double pi = std::numbers::pi;
  const double lambda = std::log(16 / (g * g)), tail = 3 - std::log(4.0);
  const double m = (1 - nu) * lambda + 2 * nu, n = (1 - nu) * lambda - 2 + 4 * nu;
  return {2 * pi / (g * (lambda - 2 * nu)) * (1 + tail / (lambda - 2 * nu)),
          2 * pi / (g * m) * (1 + (1 - nu) * tail / m), 2 * pi / (3 * g * std::sqrt(g) * n),
          pi / 4 * (1 - nu * (lambda - 2) / n)};
}

/// Below the table's last row, at g = last: the limit, corrected by its relative error at that row in proportion to g,
/// so that the coefficients are continuous and tend to the limit.
CreepageCoefficients beyond_table(const CreepageCoefficients& last_row, double last, Scales (*limit)(double, double),
                                  double g, double nu) {
  const Scales here = limit(g, nu), there = limit(last, nu);
  const Scales known = {last_row.c11, last_row.c22, last_row.c23, last_row.c33};
  Scales c{};
  for (int n = 0; n < numbers; ++n) c[n] = here[n] * (1 + (known[n] / there[n] - 1) * g / last);
  return {c[0], c[1], c[2], c[3]};
}

const Branch across(slender_across, scales_across);
const Branch along(slender_along, scales_along);

} // namespace

CreepageCoefficients creepage_coefficients(double a_over_b, double nu, CreepageTable table) {
  const bool wide = a_over_b <= 1;
  const Branch& branch = wide ? across : along;
  const double g = wide ? a_over_b : 1 / a_over_b;
  const auto limit = wide ? limit_across : limit_along;
  if (table == CreepageTable::computed) {
    const double last = wide ? computed_least_ratio : computed_largest_ratio;
    if (a_over_b >= computed_least_ratio && a_over_b <= computed_largest_ratio)
      return computed_coefficients(a_over_b, nu);
    return beyond_table(computed_coefficients(last, nu), wide ? last : 1 / last, limit, g, nu);
  }
  // Lagrange's parabola through nu = 0, 0.25, 0.5.
  const std::array<double, materials> weights = {8 * (nu - 0.25) * (nu - 0.5), -16 * nu * (nu - 0.5),
                                                 8 * nu * (nu - 0.25)};
  if (g >= 0.1) return branch.at(g, weights);
  return beyond_table(branch.at(0.1, weights), 0.1, limit, g, nu);
}

} // namespace microslip
