#include "microslip/table/creep_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip::detail {
namespace {

using creep_coordinates::LinearTheory;

constexpr std::size_t channels = creep_channels;
using Channels = std::array<double, channels>;

/// Signs of the channels for mirror images of creepages: +1 or -1.
constexpr Channels mirrored_in_x = {-1, 1, 1, 1};   ///< of (-X, Y, Z)
constexpr Channels mirrored_in_yz = {1, -1, -1, 1}; ///< of (X, -Y, -Z)

/// Makes the coefficients from the values at the nodes, one axis after the other. Arrays are by a/b, level, elevation,
/// azimuth and channel, as far as they have them, the last one fastest.
class SplineMaker {
public:
  explicit SplineMaker(const CreepTableAxes& axes)
      : axes_(axes), size_(axes), levels_(std::size_t(axes.levels)), elevations_(std::size_t(axes.elevations)),
        azimuths_(std::size_t(axes.azimuths)), row_(azimuths_ * channels), plane_(elevations_ * row_),
        along_ratio_(SplineFilter::not_a_knot(axes.ratios)), along_level_(SplineFilter::without_first(axes.levels)),
        along_elevation_{SplineFilter::clamped(axes.elevations, false), SplineFilter::clamped(axes.elevations, true)},
        along_azimuth_{SplineFilter::mirrored(axes.azimuths, false, outer(axes)),
                       SplineFilter::mirrored(axes.azimuths, true, outer(axes))},
        by_ratio_(std::size_t(size_.ratios) * levels_ * plane_), by_level_(std::size_t(size_.levels) * plane_),
        half_(along_elevation_[0].coefficients() * half_row()), other_half_(half_.size()),
        coefficients_(std::size_t(size_.elevations) * coefficient_row()) {
    for (std::size_t j = 0; j < azimuths_; ++j) {
      const double alpha = axes_.azimuth(static_cast<int>(j));
      harmonics_.push_back({std::cos(alpha), std::sin(alpha), std::sin(alpha), std::sin(alpha)});
    }
  }

  CreepSpline make(const CreepTableNodes& nodes, std::span<const double> weights) {
    std::fill(by_ratio_.begin(), by_ratio_.end(), 0.0);
    for (std::size_t m = 0; m < weights.size(); ++m)
      if (weights[m] != 0) add(nodes, m, weights[m]);
    for (std::size_t first = 0; first < levels_ * plane_; first += row_)
      along_ratio_.apply(&by_ratio_[first], levels_ * plane_, {row_});
    CreepSpline all;
    all.reserve(std::size_t(size_.ratios) * std::size_t(size_.levels) * coefficients_.size());
    for (std::size_t ratio = 0; ratio < std::size_t(size_.ratios); ++ratio) {
      filter_levels(&by_ratio_[ratio * levels_ * plane_]);
      for (std::size_t level = 0; level < std::size_t(size_.levels); ++level) {
        filter_elevations(&by_level_[level * plane_]);
        filter_azimuths();
        round();
        all.insert(all.end(), coefficients_.begin(), coefficients_.end());
      }
    }
    return all;
  }

private:
  static double outer(const CreepTableAxes& axes) { return TrigonometricSpline(axes.azimuth_step()).outer(); }
  std::size_t at(std::size_t elevation, std::size_t azimuth) const { return elevation * row_ + azimuth * channels; }
  /// Numbers of the azimuths up to the middle one.
  std::size_t half_row() const { return (azimuths_ + 1) / 2 * channels; }
  std::size_t coefficient_row() const { return std::size_t(size_.azimuths) * channels; }
  double* coefficients_at(std::size_t elevation, std::size_t azimuth) {
    return &coefficients_[elevation * coefficient_row() + azimuth * channels];
  }

  /// Adds the values of one Poisson's ratio of the nodes.
  void add(const CreepTableNodes& nodes, std::size_t material, double weight) {
    for (int ratio = 0; ratio < axes_.ratios; ++ratio) {
      const std::vector<Channels> q = linear_forces(axes_.ratio(ratio), axes_.poisson_ratios[material]);
      const std::int16_t* numbers = nodes.block(material, std::size_t(ratio)).data();
      double* to = &by_ratio_[(std::size_t(ratio) + along_ratio_.first_value()) * levels_ * plane_];
      for (int level = 0; level < axes_.levels; ++level) {
        const double t = axes_.level(level), per_square = weight / (t * t);
        const Channels unit = {nodes.unit[0] * per_square, nodes.unit[1] * per_square, nodes.unit[2] * per_square,
                               nodes.unit[3] * weight};
        // q (1 - t)^2/t^2 of a direction of length 1
        const double share = weight * creep_coordinates::half_way * (1 - t) / t;
        for (const Channels& linear : q)
          for (std::size_t c = 0; c < channels; ++c) *to++ += *numbers++ * unit[c] + share * linear[c];
      }
    }
  }

  /// q of linear theory for (X, Y, Z) of length 1, in all directions; none of the adhesion.
  std::vector<Channels> linear_forces(double a_over_b, double poisson_ratio) const {
    const LinearTheory linear(creepage_coefficients(a_over_b, poisson_ratio, CreepageTable::computed),
                              creep_coordinates::spin_scale(a_over_b));
    std::vector<Channels> q;
    q.reserve(elevations_ * azimuths_);
    for (int i = 0; i < axes_.elevations; ++i) {
      const double theta = axes_.elevation(i);
      for (int j = 0; j < axes_.azimuths; ++j) {
        const auto [x, y, z] = creep_coordinates::direction(a_over_b, theta, axes_.azimuth(j));
        q.push_back({x, y + linear.y_z * z, linear.m_y * y + linear.m_z * z, 0});
      }
    }
    return q;
  }

  void filter_levels(const double* values) {
    std::copy_n(values, levels_ * plane_, &by_level_[along_level_.first_value() * plane_]);
    for (std::size_t first = 0; first < plane_; first += row_) along_level_.apply(&by_level_[first], plane_, {row_});
  }

  /// Turns the values of one level into coefficients in the elevation. A channel at (-theta, alpha) is what it is at
  /// (theta, -alpha), perhaps with the sign reversed: one half of the sum and of the difference of the two is even in
  /// theta, the other one odd. At the pole it is the same for all azimuths, and its derivative must be a multiple of
  /// cos(alpha) or sin(alpha), that of a smooth function of X, Y and Z.
  void filter_elevations(double* values) {
    const std::size_t last = azimuths_ - 1, pole = elevations_ - 1;
    level_pole(values);
    const Channels slope = slopes_at_pole(values);
    const auto split = [&](std::size_t i, const auto& value) {
      for (std::size_t j = 0; 2 * j <= last; ++j)
        for (std::size_t c = 0; c < channels; ++c) {
          const double here = value(j, c), mirrored = mirrored_in_yz[c] * value(last - j, c);
          half_[i * half_row() + j * channels + c] = (here + mirrored) / 2;
          other_half_[i * half_row() + j * channels + c] = (here - mirrored) / 2;
        }
    };
    for (std::size_t i = 0; i <= pole; ++i)
      split(i, [&](std::size_t j, std::size_t c) { return values[at(i, j) + c]; });
    split(elevations_, [&](std::size_t j, std::size_t c) { return slope[c] * harmonics_[j][c]; });
    along_elevation_[true].apply(half_.data(), half_row(), {half_row()});
    along_elevation_[false].apply(other_half_.data(), half_row(), {half_row()});
    for (std::size_t i = 0; i <= elevations_; ++i)
      for (std::size_t j = 0; 2 * j <= last; ++j)
        for (std::size_t c = 0; c < channels; ++c) {
          const double even = half_[i * half_row() + j * channels + c];
          const double odd = other_half_[i * half_row() + j * channels + c];
          coefficients_at(i + 1, j + 1)[c] = even + odd;
          if (j != last - j) coefficients_at(i + 1, last - j + 1)[c] = mirrored_in_yz[c] * (even - odd);
        }
  }

  /// Gives the pole one value for all azimuths.
  void level_pole(double* values) const {
    double* const pole = values + at(elevations_ - 1, 0);
    Channels mean = {};
    for (std::size_t k = 0; k < row_; ++k) mean[k % channels] += pole[k] / static_cast<double>(azimuths_);
    mean[0] = 0; // Fx is odd in X
    for (std::size_t k = 0; k < row_; ++k) pole[k] = mean[k % channels];
  }

  /// The derivatives at the pole over their harmonics, with respect to the elevation's number: from differences across
  /// the pole, to the other half of a great circle, by least squares.
  Channels slopes_at_pole(const double* values) const {
    const std::size_t last = azimuths_ - 1, pole = elevations_ - 1;
    Channels slope, numerator = {}, denominator = {};
    for (std::size_t j = 0; j <= last; ++j)
      for (std::size_t c = 0; c < channels; ++c) {
        const auto rise = [&](std::size_t steps) {
          return mirrored_in_x[c] * values[at(pole - steps, last - j) + c] - values[at(pole - steps, j) + c];
        };
        numerator[c] += (8 * rise(1) - rise(2)) / 12 * harmonics_[j][c];
        denominator[c] += harmonics_[j][c] * harmonics_[j][c];
      }
    for (std::size_t c = 0; c < channels; ++c) slope[c] = numerator[c] / denominator[c];
    return slope;
  }

  /// Filters the coefficients of one level; then sets those beyond the borders.
  void filter_azimuths() {
    const std::size_t n = azimuths_, rows = elevations_ + 1;
    along_azimuth_[false].apply(coefficients_at(1, 1), channels, {1, rows, coefficient_row()});
    along_azimuth_[true].apply(coefficients_at(1, 1) + 1, channels, {channels - 1, rows, coefficient_row()});
    for (std::size_t i = 1; i <= rows; ++i)
      for (std::size_t c = 0; c < channels; ++c) {
        coefficients_at(i, 0)[c] = mirrored_in_x[c] * coefficients_at(i, 2)[c];
        coefficients_at(i, n + 1)[c] = mirrored_in_x[c] * coefficients_at(i, n - 1)[c];
      }
    for (std::size_t j = 0; j < n + 2; ++j) // at -theta what there is at theta and -alpha
      for (std::size_t c = 0; c < channels; ++c)
        coefficients_at(0, j)[c] = mirrored_in_yz[c] * coefficients_at(2, n + 1 - j)[c];
  }

  /// Rounds to multiples of 2^-20: large numbers have no smaller bits.
  void round() {
    constexpr double large = 0x1.8p52 * 0x1p-20;
    for (double& c : coefficients_) c = c + large - large;
    // At the pole the spline is an eighth of before + 6 at + beyond, which has to be the same for all azimuths.
    double* const beyond = coefficients_at(elevations_ + 1, 0);
    const double *const at = beyond - coefficient_row(), *const before = at - coefficient_row();
    Channels pole = {};
    for (std::size_t c = 1; c < channels; ++c) pole[c] = before[c] + 6 * at[c] + beyond[c];
    for (std::size_t k = 0; k < coefficient_row(); ++k) beyond[k] = pole[k % channels] - 6 * at[k] - before[k];
  }

  const CreepTableAxes& axes_;
  CreepSplineSize size_;
  std::size_t levels_, elevations_, azimuths_; ///< nodes
  std::size_t row_, plane_;                    ///< numbers of one elevation, of one level
  SplineFilter along_ratio_, along_level_, along_elevation_[2], along_azimuth_[2]; ///< of the latter odd and even ones
  PopulatedVector<double> by_ratio_;      ///< values, of which those along a/b become coefficients
  std::vector<double> by_level_;          ///< of one a/b
  std::vector<double> half_, other_half_; ///< of one level, even and odd in theta, with the elevation beyond the pole
  std::vector<double> coefficients_;      ///< of one level
  std::vector<Channels> harmonics_;       ///< by azimuth, of the derivatives at the pole
};

} // namespace

std::vector<CreepSpline> creep_splines(const CreepTableNodes& nodes, std::span<const std::vector<double>> weights) {
  std::vector<CreepSpline> splines;
  if (weights.empty()) return splines;
  SplineMaker maker(nodes.axes);
  for (const auto& of_one : weights) splines.push_back(maker.make(nodes, of_one));
  return splines;
}

} // namespace microslip::detail
