// Look-ups in creep-force tables, compiled once for every instruction set.

#include "microslip/table/kernel/creep_look_up.hpp"

#include "microslip/numerics/lanes.hpp"
#include "microslip/table/creep_coordinates.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace microslip::detail {
namespace {

using creep_coordinates::crowding;
using creep_coordinates::half_way;

/// Below 1 by this the length of the force over mu Fn begins to bend, so that it stays below 1.
constexpr double bend = 3e-4;

/// theta = 2 atan(u) for 0 <= u <= 1, to 1e-10: from pi/8 on, to which |q| <= tan(pi/8) is left.
MICROSLIP_INLINE double twice_arctangent(double u) {
  constexpr double k = std::numbers::sqrt2 - 1;
  const double q = (u - k) / (1 + k * u), square = q * q;
  double sum = 1.0 / 25;
#pragma GCC unroll 16
  for (int n = 23; n >= 1; n -= 2) sum = 1.0 / n - square * sum;
  return std::numbers::pi / 4 + 2 * q * sum;
}

/// 1 - cos x and sin x to 1e-12 for 0 <= x <= pi/3.
MICROSLIP_INLINE double rise(double x) {
  const double q = x * x;
  return q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90 * (1 - q / 132)))));
}
MICROSLIP_INLINE double sine(double x) {
  const double q = x * x;
  return x * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110)))));
}

/// Positions of contacts on an axis of the table, and the weights of the three coefficients there with their
/// derivatives with respect to the position.
template <int size> struct AxisPositions {
  int node[size];
  double value[3][size], slope[3][size];

  /// A position from 0 to `last`, counted in nodes; quadratic_weights.
  MICROSLIP_INLINE void set(int i, double position, int last) {
    const double f = position - find_node(i, position, last), before = 0.5 - f, after = 0.5 + f;
    value[0][i] = before * before / 2, value[1][i] = 0.75 - f * f, value[2][i] = after * after / 2;
    slope[0][i] = -before, slope[1][i] = -2 * f, slope[2][i] = after;
  }
  /// Sets position and weights for a TrigonometricSpline.
  MICROSLIP_INLINE void set(int i, double position, int last, double step, double scale) {
    const double f = position - find_node(i, position, last), before = (0.5 - f) * step, after = (0.5 + f) * step;
    const double first = scale * rise(before), third = scale * rise(after);
    const double first_slope = -scale * step * sine(before), third_slope = scale * step * sine(after);
    value[0][i] = first, value[1][i] = 1 - first - third, value[2][i] = third;
    slope[0][i] = first_slope, slope[1][i] = -first_slope - third_slope, slope[2][i] = third_slope;
  }

private:
  MICROSLIP_INLINE int find_node(int i, double position, int last) {
    const int nearest = static_cast<int>(position + 0.5); // NOLINT(bugprone-incorrect-roundings): in lanes, and >= 0
    return node[i] = nearest < last ? nearest : last;
  }
};

/// Scaled creepages on the quarter of the sphere.
template <int size> struct Places {
  using Numbers = double[size];
  AxisPositions<size> ratio, level, elevation, azimuth;
  Numbers turned, mirrored; ///< -1: all creepages, X are reversed
  Numbers x, y, z;
  Numbers cos_theta, sin_theta, cos_alpha, sin_alpha;
  Numbers t, w;            ///< w = 1 - t
  Numbers per_r;           ///< 1/r
  Numbers per_stretched;   ///< 1/|(s X, Y/s, Z)|
  Numbers elevation_slope; ///< of its position with respect to theta

  MICROSLIP_INLINE void find(const CreepGrid& grid, const CreepBlock<size>& block) {
    const double elevations_per_angle = (grid.elevations - 1) / (std::numbers::pi / 2),
                 azimuths_per_angle = (grid.azimuths - 1) / std::numbers::pi;
#pragma omp simd
    for (int i = 0; i < size; ++i) {
      turned[i] = block.z[i] < 0 ? -1.0 : 1.0;
      mirrored[i] = block.x[i] * turned[i] < 0 ? -1.0 : 1.0;
      x[i] = block.x[i] * turned[i] * mirrored[i];
      y[i] = block.y[i] * turned[i];
      z[i] = block.z[i] * turned[i];
      const double r = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      per_r[i] = 1 / (r > 0 ? r : 1);
      w[i] = half_way / (r + half_way);
      t[i] = r / (r + half_way);
      level.set(i, t[i] * grid.levels, grid.levels);
      ratio.set(i, block.ratio[i], grid.ratios - 1);

      const double along = x[i] * block.stretch[i], aside = y[i] / block.stretch[i];
      const double across = std::sqrt(along * along + aside * aside),
                   stretched = std::sqrt(across * across + z[i] * z[i]);
      per_stretched[i] = 1 / (stretched > 0 ? stretched : 1);
      // At the pole alpha has no value: a point beside it has the same forces and derivatives.
      const double per_across = 1 / (across > 0 ? across : 1), cosine = across * per_stretched[i], least = 1e-6;
      cos_alpha[i] = across > 0 ? along * per_across : 1;
      sin_alpha[i] = aside * per_across;
      cos_theta[i] = stretched > 0 ? (cosine > least ? cosine : least) : 1;
      sin_theta[i] = z[i] * per_stretched[i];
      const double tangent = sin_alpha[i] / (1 + cos_alpha[i]); // of alpha/2
      const double alpha = tangent < 0 ? -twice_arctangent(-tangent) : twice_arctangent(tangent);
      azimuth.set(i, alpha * azimuths_per_angle + 0.5 * (grid.azimuths - 1), grid.azimuths - 1, grid.azimuth_step,
                  grid.azimuth_scale);
      const double theta = twice_arctangent(sin_theta[i] / (1 + cos_theta[i]));
      const double sin2 = 2 * sin_theta[i] * cos_theta[i], cos2 = 1 - 2 * sin_theta[i] * sin_theta[i];
      elevation.set(i, elevations_per_angle * (theta - crowding / 2 * sin2 * cos2), grid.elevations - 1);
      elevation_slope[i] = elevations_per_angle * (1 - crowding * (1 - 2 * sin2 * sin2));
    }
  }
};

/// All channels.
using Channels = LaneVector<double, creep_channels>;

MICROSLIP_INLINE void add_channels(double weight, const float* from, Channels& to) {
#ifdef __AVX__ // g++ 12 would convert the halves one by one
  to += weight * Channels(_mm256_cvtps_pd(_mm_loadu_ps(from)));
#else
  to += weight * Channels{from[0], from[1], from[2], from[3]};
#endif
}

/// Three neighbours in azimuth.
struct Row {
  Channels node[3] = {};

  MICROSLIP_INLINE void add(double weight, const float* from) {
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) add_channels(weight, from + i * std::ptrdiff_t{creep_channels}, node[i]);
  }
  MICROSLIP_INLINE void add(double weight, const Row& row) {
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) node[i] += weight * row.node[i];
  }
};

/// S and its derivatives with respect to the positions on the axes, by channel and contact.
template <int size> struct Samples {
  using Numbers = double[creep_channels][size];
  Numbers value = {}, by_level = {}, by_elevation = {}, by_azimuth = {};

  template <bool gradient>
  MICROSLIP_INLINE void find(const CreepGrid& grid, const CreepBlock<size>& block, const Places<size>& p) {
    for (int lane = 0; lane < block.count; ++lane) {
      const std::ptrdiff_t first = p.ratio.node[lane] * grid.ratio_stride + p.level.node[lane] * grid.level_stride +
                                   p.elevation.node[lane] * grid.elevation_stride +
                                   std::ptrdiff_t{p.azimuth.node[lane]} * creep_channels;
      for (int m = 0; m < block.materials; ++m)
        if (block.weight[m][lane] != 0)
          add<gradient>(grid, block.coefficients[m] + first, block.weight[m][lane], p, lane);
    }
  }

private:
  template <bool gradient>
  MICROSLIP_INLINE void add(const CreepGrid& grid, const float* first, double weight, const Places<size>& p, int lane) {
    Row sum, level_slope, elevation_slope;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const float* const from = first + i * grid.ratio_stride + j * grid.level_stride;
        const double share = weight * p.ratio.value[i][lane];
        if constexpr (gradient) {
          Row row, slope;
#pragma GCC unroll 3
          for (int k = 0; k < 3; ++k) {
            row.add(p.elevation.value[k][lane], from + k * grid.elevation_stride);
            slope.add(p.elevation.slope[k][lane], from + k * grid.elevation_stride);
          }
          sum.add(share * p.level.value[j][lane], row);
          level_slope.add(share * p.level.slope[j][lane], row);
          elevation_slope.add(share * p.level.value[j][lane], slope);
        } else {
#pragma GCC unroll 3
          for (int k = 0; k < 3; ++k)
            sum.add(share * p.level.value[j][lane] * p.elevation.value[k][lane], from + k * grid.elevation_stride);
        }
      }
    add(sum, p.azimuth.value, lane, value);
    if constexpr (gradient) {
      add(sum, p.azimuth.slope, lane, by_azimuth);
      add(level_slope, p.azimuth.value, lane, by_level);
      add(elevation_slope, p.azimuth.value, lane, by_elevation);
    }
  }
  MICROSLIP_INLINE static void add(const Row& row, const double (&weights)[3][size], int lane, Numbers& to) {
    const Channels sum =
        weights[0][lane] * row.node[0] + weights[1][lane] * row.node[1] + weights[2][lane] * row.node[2];
#pragma GCC unroll 4
    for (int c = 0; c < creep_channels; ++c) to[c][lane] += sum[c];
  }
};

template <int size, bool gradient> void look_up(const CreepGrid& grid, CreepBlock<size>& block) {
  Places<size> p;
  p.find(grid, block);
  Samples<size> samples;
  samples.template find<gradient>(grid, block, p);
#pragma omp simd
  for (int i = 0; i < size; ++i) {
    const double t = p.t[i], w = p.w[i];
    const double q[] = {p.x[i], block.y_y[i] * p.y[i] + block.y_z[i] * p.z[i],
                        block.m_y[i] * p.y[i] + block.m_z[i] * p.z[i]};
    double f[3];
#pragma GCC unroll 3
    for (int n = 0; n < 3; ++n) f[n] = t * t * samples.value[n][i] - q[n] * w * w;
    const double adhesion = samples.value[3][i];
    block.adhesion[i] = adhesion > 0 ? (adhesion < 1 ? adhesion : 1) : 0;

    // The length of (fx, fy) ends at 1: from 1 - bend on it follows a curve with the same slope and curvature there.
    const double length = std::sqrt(f[0] * f[0] + f[1] * f[1]), excess = (length - (1 - bend)) / bend;
    const bool bent = excess > 0;
    const double root = std::sqrt(1 + excess * excess), per_length = 1 / (bent ? length : 1);
    const double ratio = bent ? (1 - bend + bend * excess / root) * per_length : 1;

    if constexpr (gradient) {
      const double by_q[3][3] = {{1, 0, 0}, {0, block.y_y[i], block.y_z[i]}, {0, block.m_y[i], block.m_z[i]}};
      const double cos_theta = p.cos_theta[i], sin_theta = p.sin_theta[i], cos_alpha = p.cos_alpha[i],
                   sin_alpha = p.sin_alpha[i], s = block.stretch[i];
      const double along_r[] = {p.x[i] * p.per_r[i], p.y[i] * p.per_r[i], p.z[i] * p.per_r[i]};
      const double along_theta[] = {-sin_theta * cos_alpha * s, -sin_theta * sin_alpha / s, cos_theta};
      const double along_alpha[] = {-sin_alpha * s, cos_alpha / s, 0};
      const double sign[] = {p.mirrored[i], 1, 1}, outer = t * t * p.per_stretched[i];
      double by[3][3];
#pragma GCC unroll 3
      for (int n = 0; n < 3; ++n) {
        const double by_t = 2 * t * samples.value[n][i] + t * t * samples.by_level[n][i] * grid.levels;
        const double by_r = (2 * q[n] * w + by_t) * w * w / half_way;
        const double by_theta = outer * samples.by_elevation[n][i] * p.elevation_slope[i];
        const double by_alpha = outer * samples.by_azimuth[n][i] / (grid.azimuth_step * cos_theta);
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          by[n][k] = by_r * along_r[k] + by_theta * along_theta[k] + by_alpha * along_alpha[k] - by_q[n][k] * w * w;
      }
      const double change = bent ? (1 / (root * root * root) - ratio) * per_length : 0;
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        const double by_length = (f[0] * by[0][k] + f[1] * by[1][k]) * per_length;
        block.derivative[0][k][i] = (ratio * by[0][k] + change * by_length * f[0]) * sign[0] * sign[k];
        block.derivative[1][k][i] = (ratio * by[1][k] + change * by_length * f[1]) * sign[k];
        block.derivative[2][k][i] = by[2][k] * sign[k];
      }
    }
    block.force[0][i] = ratio * f[0] * p.mirrored[i] * p.turned[i];
    block.force[1][i] = ratio * f[1] * p.turned[i];
    block.force[2][i] = f[2] * p.turned[i];
  }
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

CreepKernels creep_kernels() {
  return {{look_up<creep_batch, false>, look_up<creep_batch, true>}, {look_up<1, false>, look_up<1, true>}};
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
