#include "microslip/table/creep_spline.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::detail {
namespace {

using creep_coordinates::LinearTheory;

/// What the mirror images of creepages do to the channels: +1 or -1.
constexpr double mirrored_in_x[creep_channels] = {-1, 1, 1, 1};   ///< of (-X, Y, Z)
constexpr double mirrored_in_yz[creep_channels] = {1, -1, -1, 1}; ///< of (X, -Y, -Z)

/// Makes the coefficients of all levels, elevations and azimuths of one a/b and nu.
class BlockSpline {
public:
  BlockSpline(const CreepTableAxes& axes)
      : axes_(axes), size_(axes),
        levels_(SplineFilter::without_first(axes.levels)), elevations_{SplineFilter::clamped(axes.elevations, false),
                                                                       SplineFilter::clamped(axes.elevations, true)},
        azimuths_{SplineFilter::mirrored(axes.azimuths, false, outer(axes)),
                  SplineFilter::mirrored(axes.azimuths, true, outer(axes))} {}

  std::size_t coefficients() const {
    return std::size_t(size_.levels) * std::size_t(size_.elevations) * std::size_t(size_.azimuths) * creep_channels;
  }

  void find(const CreepTableNodes& nodes, std::size_t material, std::size_t ratio, std::span<double> coefficients) {
    read(nodes, material, ratio);
    filter_levels();
    for (int level = 0; level < size_.levels; ++level) {
      filter_elevations(&by_level_[std::size_t(level) * plane()]);
      filter_azimuths(&coefficients[std::size_t(level) * std::size_t(size_.elevations) * std::size_t(size_.azimuths) *
                                    creep_channels]);
    }
  }

private:
  static double outer(const CreepTableAxes& axes) { return TrigonometricSpline(axes.azimuth_step()).outer(); }
  std::size_t plane() const { return std::size_t(axes_.elevations) * std::size_t(axes_.azimuths) * creep_channels; }
  std::size_t at(int elevation, int azimuth) const {
    return (std::size_t(elevation) * std::size_t(axes_.azimuths) + std::size_t(azimuth)) * creep_channels;
  }

  /// What the spline goes through.
  void read(const CreepTableNodes& nodes, std::size_t material, std::size_t ratio) {
    const double a_over_b = axes_.ratio(static_cast<int>(ratio));
    const LinearTheory linear(creepage_coefficients(a_over_b, axes_.poisson_ratios[material], CreepageTable::computed),
                              creep_coordinates::spin_scale(a_over_b));
    const auto numbers = nodes.block(material, ratio);
    values_.resize(numbers.size());
    for (int level = 0; level < axes_.levels; ++level) {
      const double t = axes_.level(level);
      const double share = creep_coordinates::half_way * (1 - t) / t; // q (1 - t)^2/t^2 for a direction of length 1
      for (int i = 0; i < axes_.elevations; ++i)
        for (int j = 0; j < axes_.azimuths; ++j) {
          const double theta = axes_.elevation(i), alpha = axes_.azimuth(j);
          const auto [x, y, z] = creep_coordinates::direction(a_over_b, theta, alpha);
          const double q[] = {x, y + linear.y_z * z, linear.m_y * y + linear.m_z * z};
          const std::size_t node = std::size_t(level) * plane() + at(i, j);
          for (std::size_t c = 0; c < 3; ++c)
            values_[node + c] = numbers[node + c] * nodes.unit[c] / (t * t) + share * q[c];
          values_[node + 3] = numbers[node + 3] * nodes.unit[3];
        }
    }
  }

  void filter_levels() {
    by_level_.resize(std::size_t(size_.levels) * plane());
    for (std::size_t k = 0; k < plane(); ++k) levels_.apply(&values_[k], plane(), &by_level_[k], plane());
  }

  /// From the values of one level to coefficients in the elevation, by_elevation_. Of channel c at (-theta, alpha) is
  /// what it is at (theta, -alpha), perhaps with the sign reversed: one half of the sum and of the difference of the
  /// two is even in theta, the other one odd. At the pole it is the same for all azimuths, and its derivative must be a
  /// multiple of cos(alpha) or sin(alpha), that of a smooth function of X, Y and Z.
  void filter_elevations(double* values) {
    const int last = axes_.azimuths - 1, pole = axes_.elevations - 1;
    by_elevation_.resize(std::size_t(axes_.elevations + 1) * std::size_t(axes_.azimuths) * creep_channels);
    side_.resize(std::size_t(axes_.elevations) + 1);
    half_.resize(side_.size());
    for (int c = 0; c < creep_channels; ++c) {
      double mean = 0;
      for (int j = 0; j <= last; ++j) mean += values[at(pole, j) + std::size_t(c)] / axes_.azimuths;
      if (c == 0) mean = 0; // Fx is odd in X
      for (int j = 0; j <= last; ++j) values[at(pole, j) + std::size_t(c)] = mean;
      const double slope = slope_at_pole(values, c);
      for (int j = 0; 2 * j <= last; ++j)
        for (const bool even : {false, true}) {
          const double sign = even ? mirrored_in_yz[c] : -mirrored_in_yz[c];
          for (int i = 0; i <= pole; ++i)
            side_[std::size_t(i)] =
                (values[at(i, j) + std::size_t(c)] + sign * values[at(i, last - j) + std::size_t(c)]) / 2;
          side_.back() = slope * (harmonic(c, j) + sign * harmonic(c, last - j)) / 2;
          elevations_[even].apply(side_.data(), 1, half_.data(), 1);
          for (int i = 0; i <= axes_.elevations; ++i) {
            double& to = by_elevation_[at(i, j) + std::size_t(c)];
            double& mirrored = by_elevation_[at(i, last - j) + std::size_t(c)];
            to = (even ? to : 0) + half_[std::size_t(i)];
            if (j != last - j) mirrored = (even ? mirrored : 0) + sign * half_[std::size_t(i)];
          }
        }
    }
  }

  double harmonic(int channel, int azimuth) const {
    const double alpha = axes_.azimuth(azimuth);
    return channel == 0 ? std::cos(alpha) : std::sin(alpha);
  }

  /// The derivative at the pole over its harmonic, with respect to the elevation's number: from differences across the
  /// pole, to the other half of a great circle, by least squares.
  double slope_at_pole(const double* values, int c) const {
    const int last = axes_.azimuths - 1, pole = axes_.elevations - 1;
    double numerator = 0, denominator = 0;
    for (int j = 0; j <= last; ++j) {
      const auto rise = [&](int steps) {
        return mirrored_in_x[c] * values[at(pole - steps, last - j) + std::size_t(c)] -
               values[at(pole - steps, j) + std::size_t(c)];
      };
      numerator += (8 * rise(1) - rise(2)) / 12 * harmonic(c, j);
      denominator += harmonic(c, j) * harmonic(c, j);
    }
    return numerator / denominator;
  }

  /// From by_elevation_ to the coefficients of one level, with those beyond the borders.
  void filter_azimuths(double* to) const {
    const auto place = [&](int elevation, int azimuth) {
      return (std::size_t(elevation) * std::size_t(size_.azimuths) + std::size_t(azimuth)) * creep_channels;
    };
    const int n = axes_.azimuths;
    for (int i = 0; i <= axes_.elevations; ++i)
      for (int c = 0; c < creep_channels; ++c) {
        double* row = to + place(i + 1, 0) + c;
        azimuths_[mirrored_in_x[c] > 0].apply(&by_elevation_[at(i, 0) + std::size_t(c)], creep_channels,
                                              row + creep_channels, creep_channels);
        row[0] = mirrored_in_x[c] * row[2 * creep_channels];
        row[std::size_t(n + 1) * creep_channels] = mirrored_in_x[c] * row[std::size_t(n - 1) * creep_channels];
      }
    for (int j = 0; j < size_.azimuths; ++j) // at -theta what there is at theta and -alpha
      for (int c = 0; c < creep_channels; ++c)
        to[place(0, j) + std::size_t(c)] = mirrored_in_yz[c] * to[place(2, size_.azimuths - 1 - j) + std::size_t(c)];
  }

  const CreepTableAxes& axes_;
  CreepSplineSize size_;
  SplineFilter levels_, elevations_[2], azimuths_[2]; ///< of the latter odd and even ones
  std::vector<double> values_, by_level_, by_elevation_, side_, half_;
};

} // namespace

CreepSpline::CreepSpline(const CreepTableNodes& nodes, std::span<const double> weights) {
  BlockSpline block(nodes.axes);
  const std::size_t size = block.coefficients();
  const auto ratios = static_cast<std::size_t>(nodes.axes.ratios);
  std::vector<double> by_ratio(ratios * size), found(size), sum(size);
  for (std::size_t m = 0; m < weights.size(); ++m)
    for (std::size_t i = 0; i < ratios && weights[m] != 0; ++i) {
      block.find(nodes, m, i, found);
      for (std::size_t k = 0; k < size; ++k) by_ratio[i * size + k] += weights[m] * found[k];
    }
  const SplineFilter filter = SplineFilter::not_a_knot(nodes.axes.ratios);
  coefficients_.reserve((ratios + 2) * size);
  for (int row = 0; row < filter.coefficients(); ++row) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (int i = 0; i < filter.values(); ++i) {
      const double weight = filter.weight(row, i);
      const double* from = &by_ratio[std::size_t(i) * size];
      for (std::size_t k = 0; k < size; ++k) sum[k] += weight * from[k];
    }
    add_rounded(nodes.axes, sum);
  }
}

void CreepSpline::add_rounded(const CreepTableAxes& axes, std::span<double> coefficients) {
  constexpr double unit = 0x1p-20;
  for (double& c : coefficients) c = unit * std::nearbyint(c / unit);
  // At the pole the spline is an eighth of before + 6 at + beyond, which has to be the same for all azimuths.
  const CreepSplineSize size(axes);
  const std::size_t row = std::size_t(size.azimuths) * creep_channels, plane = row * std::size_t(size.elevations);
  for (std::size_t level = 0; level < coefficients.size(); level += plane) {
    double* const beyond = &coefficients[level + plane - row];
    const double *const at = beyond - row, *const before = at - row;
    for (std::size_t c = 0; c < creep_channels; ++c) {
      const double pole = c == 0 ? 0 : before[c] + 6 * at[c] + beyond[c];
      for (std::size_t k = c; k < row; k += creep_channels) beyond[k] = pole - 6 * at[k] - before[k];
    }
  }
  coefficients_.insert(coefficients_.end(), coefficients.begin(), coefficients.end());
}

} // namespace microslip::detail
