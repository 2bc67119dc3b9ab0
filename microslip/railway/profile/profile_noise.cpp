#include "microslip/railway/profile/profile_noise.hpp"

#include "microslip/railway/profile/curvature_steps.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

namespace microslip {
namespace {

constexpr double median_of_normal = 0.67449; // of |x| for a normal distribution of deviation 1

double distance(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(b.y - a.y, b.z - a.z);
}

/// The value that this part of them does not exceed.
double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

/// Distance of the middle one of an odd number of points, `stride` apart, across the line through its neighbours, from
/// the polynomial through the others, over what it is for independent errors of deviation 1.
template <std::size_t count> double residual(std::span<const ProfilePoint> points, std::size_t stride) {
  constexpr std::size_t middle = count / 2;
  std::array<double, count> s{};
  const auto point = [&](std::size_t i) -> const ProfilePoint& { return points[i * stride]; };
  for (std::size_t i = 1; i < count; ++i) s[i] = s[i - 1] + distance(point(i - 1), point(i));
  ProfilePoint off = point(middle);
  double squares = 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == middle) continue;
    double weight = 1;
    for (std::size_t j = 0; j < count; ++j)
      if (j != i && j != middle) weight *= (s[middle] - s[j]) / (s[i] - s[j]);
    off.y -= weight * point(i).y;
    off.z -= weight * point(i).z;
    squares += weight * weight;
  }
  const double along_y = point(middle + 1).y - point(middle - 1).y;
  const double along_z = point(middle + 1).z - point(middle - 1).z;
  return std::abs(off.z * along_y - off.y * along_z) / (std::hypot(along_y, along_z) * std::sqrt(squares));
}

/// Distances of points from the polynomials through others near them, by the point in the middle; NaN where there is
/// none.
template <std::size_t count> std::vector<double> residuals(std::span<const ProfilePoint> points, std::size_t stride) {
  std::vector<double> all(points.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k + (count - 1) * stride < points.size(); ++k)
    all[k + count / 2 * stride] = residual<count>(points.subspan(k), stride);
  return all;
}

/// Stations along points at which their scatter is estimated, and the points around each that count.
class Windows {
public:
  /// At least 20 mm wide, and 60 points.
  Windows(std::size_t points, double spacing) : points_(points) {
    constexpr double width = 20e-3;
    constexpr std::size_t fewest = 60;
    const auto wide = static_cast<std::size_t>(std::min(width / spacing, static_cast<double>(points)));
    half_ = std::max(wide, fewest) / 2;
    const std::size_t apart = std::max<std::size_t>(half_ / 4, 1);
    for (std::size_t at = 0; at < points; at += apart) stations_.push_back(at);
  }

  std::size_t size() const { return stations_.size(); }

  /// Deviation of normal errors with the median of the residuals around each station.
  std::vector<double> scatter(std::span<const double> residuals) const {
    std::vector<double> result, around;
    for (const std::size_t at : stations_) {
      around.clear();
      for (std::size_t k = at - std::min(at, half_); k < std::min(at + half_ + 1, points_); ++k)
        if (std::isfinite(residuals[k])) around.push_back(residuals[k]);
      result.push_back(around.empty() ? 0 : median(around) / median_of_normal);
    }
    return result;
  }

  /// Values at all points of those at the stations, linear in between.
  std::vector<double> at_points(std::span<const double> at_stations) const {
    std::vector<double> result(points_);
    for (std::size_t k = 0, i = 0; k < points_; ++k) {
      while (i + 1 < size() && stations_[i + 1] <= k) ++i;
      result[k] = at_stations[i];
      if (i + 1 == size()) continue;
      const double part = static_cast<double>(k - stations_[i]) / static_cast<double>(stations_[i + 1] - stations_[i]);
      result[k] += part * (at_stations[i + 1] - at_stations[i]);
    }
    return result;
  }

private:
  std::size_t points_, half_ = 0;
  std::vector<std::size_t> stations_;
};

/// The means of `count` points in succession, by the point in their middle; those at both ends of fewer.
std::vector<ProfilePoint> running_means(std::span<const ProfilePoint> points, std::size_t count) {
  std::vector<ProfilePoint> means;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t first = k - std::min(k, count / 2), last = std::min(first + count, points.size());
    ProfilePoint sum;
    for (std::size_t i = first; i < last; ++i) sum.y += points[i].y, sum.z += points[i].z;
    const auto n = static_cast<double>(last - first);
    means.push_back({sum.y / n, sum.z / n});
  }
  return means;
}

double median_spacing(std::span<const ProfilePoint> points) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) steps.push_back(distance(points[k], points[k + 1]));
  return median(std::move(steps));
}

/// Standard deviation of rounded heights, which are multiples of some length apart: the largest such length, found by
/// Euclid's algorithm, over sqrt(12). Values of y may be multiples of their spacing.
double rounding_deviation(std::span<const ProfilePoint> points) {
  constexpr double least = 1e-10; // [m], of numbers that are not rounded
  double length = 0;
  for (const ProfilePoint& point : points)
    for (double rest = std::abs(point.z - points.front().z); rest > least;) {
      const double next = std::abs(std::remainder(length, rest));
      length = std::exchange(rest, next);
    }
  return length / std::sqrt(12.0);
}

/// Deviations of errors at the stations along points: of single points, and of independent errors with the same waves
/// of a few millimetres.
struct LocalNoise {
  LocalNoise(std::span<const ProfilePoint> points, double spacing) : windows(points.size(), spacing) {
    constexpr double widest_mean = 0.8e-3, clearly = 1.5; // less may be chance
    constexpr double most = 10;                           // more is shape
    constexpr std::size_t fewest_means = 40;
    const double rounding = rounding_deviation(points);
    single = windows.scatter(residuals<5>(points, 1));
    long_waves = single;
    for (std::size_t m = 2; static_cast<double>(m) * spacing <= widest_mean && fewest_means * m <= points.size();
         m *= 2) {
      const auto of_means = windows.scatter(residuals<7>(running_means(points, m), m));
      for (std::size_t i = 0; i < windows.size(); ++i) {
        const double alike = std::sqrt(static_cast<double>(m)) * of_means[i];
        const bool is_shape = alike > most * std::max(single[i], rounding);
        if (alike > clearly * single[i] && !is_shape) long_waves[i] = std::max(long_waves[i], alike);
      }
    }
  }

  Windows windows;
  std::vector<double> single, long_waves;
};

/// A smooth curve with points measured beside it.
class Section {
public:
  explicit Section(std::span<const ProfilePoint> curve)
      : curve_(curve), s_(curve.size()), curvatures_(curve.size()), normals_(curve.size()) {
    for (std::size_t k = 1; k < s_.size(); ++k) s_[k] = s_[k - 1] + distance(curve[k - 1], curve[k]);
    for (std::size_t k = 0; k < s_.size(); ++k) {
      const ProfilePoint tangent = derivative(k);
      const double length = std::hypot(tangent.y, tangent.z);
      normals_[k] = {-tangent.z / length, tangent.y / length};
    }
    for (std::size_t k = 1; k + 1 < s_.size(); ++k) {
      const ProfilePoint a = chord(k - 1), b = chord(k);
      curvatures_[k] = 2 * ((b.y - a.y) * normals_[k].y + (b.z - a.z) * normals_[k].z) / (s_[k + 1] - s_[k - 1]);
    }
  }

  std::span<const double> s() const { return s_; }

  std::vector<double> distances(std::span<const ProfilePoint> measured) const {
    std::vector<double> result;
    for (std::size_t k = 0; k < s_.size(); ++k)
      result.push_back((measured[k].y - curve_[k].y) * normals_[k].y + (measured[k].z - curve_[k].z) * normals_[k].z);
    return result;
  }

  /// Distances of the smooth curve that measured ones are beside.
  std::vector<double> smooth(std::span<const double> measured, std::span<const double> variances) const {
    return distances_with_few_curvature_steps(s_, curvatures_, measured, variances);
  }

  /// Factor by which errors are more variable.
  double noise_factor(std::span<const double> measured, std::span<const double> variances) const {
    return noise_factor_beside_few_curvature_steps(s_, curvatures_, measured, variances);
  }

  std::vector<ProfilePoint> points(std::span<const double> distances) const {
    std::vector<ProfilePoint> result;
    for (std::size_t k = 0; k < s_.size(); ++k)
      result.push_back({curve_[k].y + distances[k] * normals_[k].y, curve_[k].z + distances[k] * normals_[k].z});
    return result;
  }

private:
  /// Of the parabola through a point and its neighbours; at the ends of the chord.
  ProfilePoint derivative(std::size_t k) const {
    if (k == 0) return chord(0);
    if (k + 1 == s_.size()) return chord(k - 1);
    const double before = s_[k] - s_[k - 1], after = s_[k + 1] - s_[k], all = before + after;
    const ProfilePoint a = chord(k - 1), b = chord(k);
    return {(a.y * after + b.y * before) / all, (a.z * after + b.z * before) / all};
  }
  /// Direction of the side that begins with a point.
  ProfilePoint chord(std::size_t k) const {
    const double length = s_[k + 1] - s_[k];
    return {(curve_[k + 1].y - curve_[k].y) / length, (curve_[k + 1].z - curve_[k].z) / length};
  }

  std::span<const ProfilePoint> curve_;
  std::vector<double> s_, curvatures_; // at both ends no curvature, which no step needs
  std::vector<ProfilePoint> normals_;
};

/// The means of every `count` values in succession; those at the end that are fewer are left out.
std::vector<double> block_means(std::span<const double> values, std::size_t count) {
  std::vector<double> means;
  for (std::size_t k = 0; k + count <= values.size(); k += count)
    means.push_back(std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(k),
                                    values.begin() + static_cast<std::ptrdiff_t>(k + count), 0.0) /
                    static_cast<double>(count));
  return means;
}

std::vector<ProfilePoint> block_means(std::span<const ProfilePoint> points, std::size_t count) {
  std::vector<double> y, z;
  for (const auto& p : points) y.push_back(p.y), z.push_back(p.z);
  y = block_means(y, count), z = block_means(z, count);
  std::vector<ProfilePoint> means;
  for (std::size_t k = 0; k < y.size(); ++k) means.push_back({y[k], z[k]});
  return means;
}

/// Factor of variances with which means of a millimetre scatter beside a smooth curve: 1 for independent errors, more
/// for those that neighbours share.
double shared_noise(std::span<const ProfilePoint> measured, std::span<const ProfilePoint> smooth,
                    std::span<const double> variances, double spacing) {
  constexpr double wide = 1e-3, clearly = 1.5;
  const auto count = static_cast<std::size_t>(std::max(1L, std::lround(wide / spacing)));
  const auto curve = block_means(smooth, count);
  if (curve.size() < 4) return 1;
  auto of_means = block_means(variances, count);
  for (double& variance : of_means) variance /= static_cast<double>(count);
  const Section section{std::span<const ProfilePoint>(curve)};
  const double factor = section.noise_factor(section.distances(block_means(measured, count)), of_means);
  return factor > clearly ? factor : 1;
}

/// Points of a section about 2 mm apart, with points 3 mm before and behind them.
class CheckedPoints {
public:
  explicit CheckedPoints(std::span<const double> s) : s_(s) {
    constexpr double half_patch = 3e-3, apart = 2e-3;
    const auto index = [s](double at) {
      return static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), at) - s.begin());
    };
    for (double at = half_patch; at + half_patch < s.back(); at += apart) {
      const std::array triple = {index(at - half_patch), index(at), index(at + half_patch)};
      if (triple[0] < triple[1] && triple[1] < triple[2]) triples_.push_back(triple);
    }
  }

  std::span<const std::array<std::size_t, 3>> triples() const { return triples_; }

  /// Second derivative of the parabola through the values at three points.
  double curvature(std::span<const double> values, const std::array<std::size_t, 3>& at) const {
    const auto [i, j, k] = at;
    const double before = (values[j] - values[i]) / (s_[j] - s_[i]), after = (values[k] - values[j]) / (s_[k] - s_[j]);
    return 2 * (after - before) / (s_[k] - s_[i]);
  }

private:
  std::span<const double> s_;
  std::vector<std::array<std::size_t, 3>> triples_;
};

/// Adds the points of a smooth section that are checked, the first of which is this one of the profile, with the errors
/// that their curvature has when points on the section, with errors of their variances by chance, are smoothed.
void check(std::span<const ProfilePoint> smooth, std::span<const double> variances, std::size_t first,
           DenoisedPoints& result) {
  constexpr int repetitions = 8;
  const Section section(smooth);
  const CheckedPoints checked(section.s());
  std::vector<double> squares(checked.triples().size()), errors(smooth.size());
  std::mt19937 random;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t k = 0; k < errors.size(); ++k)
      errors[k] = (random() >> 31 == 0 ? 1 : -1) * std::sqrt(variances[k]);
    const auto left = section.smooth(errors, variances);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double error = checked.curvature(left, checked.triples()[i]);
      squares[i] += error * error / repetitions;
    }
  }
  for (std::size_t i = 0; i < squares.size(); ++i) {
    result.checked.push_back(first + checked.triples()[i][1]);
    result.curvature_deviation.push_back(std::sqrt(squares[i]));
  }
}

bool has_coinciding(std::span<const ProfilePoint> points) {
  constexpr double least = 1e-7; // [m]
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    if (!(distance(points[k], points[k + 1]) > least)) return true;
  return false;
}

/// A smooth curve beside points, for its direction: no smoother than it needs to be, so that it follows sharp corners.
std::vector<ProfilePoint> beside_points(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                        double length) {
  auto curve = smoothed(points, kinks, length / 3);
  return has_coinciding(curve) ? smoothed(points, kinks, length) : curve;
}

} // namespace

ProfileNoise estimate_noise(std::span<const ProfilePoint> points) {
  constexpr double most_curvature = 3; // [1/m], of a rail's head
  constexpr double upper_quartile = 0.75;
  if (points.size() < 5) return {};
  const double h = median_spacing(points);
  const LocalNoise local(points, h);
  const auto curvature = [h](double deviation) { return std::sqrt(6.0) * deviation / (h * h); };
  ProfileNoise noise;
  noise.deviation = quantile(local.single, upper_quartile);
  noise.curvature = curvature(noise.deviation);
  noise.long_waves = quantile(local.long_waves, upper_quartile);
  // 3.3 mm at 1 um and 0.25 mm: the best one wavelength for peak pressures of S1002 on 60E1, 1 to 20 um, 0.1 to 0.5 mm.
  const double density = noise.long_waves * noise.long_waves * h;
  if (curvature(noise.long_waves) > most_curvature)
    noise.smoothing_length = std::min(1.0, 3.3e-3 * std::pow(density / (1e-12 * 0.25e-3), 0.2));
  return noise;
}

std::optional<DenoisedPoints> denoised(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                       const ProfileNoise& noise) {
  const auto beside = beside_points(points, kinks, noise.smoothing_length);
  if (has_coinciding(beside)) return {};
  const double spacing = median_spacing(points);
  const LocalNoise local(points, spacing);
  auto variances = local.windows.at_points(local.long_waves);
  for (double& v : variances) v = v * v;
  for (const std::size_t kink : kinks) variances[kink] = 0;
  DenoisedPoints result{{points.begin(), points.end()}, noise.long_waves, {}, {}};
  std::vector<std::size_t> ends(kinks.begin(), kinks.end());
  ends.push_back(points.size() - 1);
  std::size_t first = 0;
  for (const std::size_t last : ends) {
    const std::size_t count = last - first + 1;
    if (count >= 4) {
      const auto measured = points.subspan(first, count);
      const auto curve = std::span<const ProfilePoint>(beside).subspan(first, count);
      const auto errors = std::span<double>(variances).subspan(first, count);
      const double factor = shared_noise(measured, curve, errors, spacing);
      for (double& variance : errors) variance *= factor;
      result.long_waves = std::max(result.long_waves, noise.long_waves * std::sqrt(factor));
      const Section section(curve);
      const auto smooth = section.points(section.smooth(section.distances(measured), errors));
      std::copy(smooth.begin(), smooth.end(), result.points.begin() + static_cast<std::ptrdiff_t>(first));
      check(smooth, errors, first, result);
    }
    first = last;
  }
  if (has_coinciding(result.points)) return {};
  return result;
}

double pressure_deviation(const DenoisedPoints& points) {
  constexpr double a = 1 / (2 * 0.46), b = 1 / (2 * 0.3);
  const double steepest = std::tan(15 * std::numbers::pi / 180);
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < points.checked.size(); ++i) {
    const std::size_t k = points.checked[i];
    const ProfilePoint &before = points.points[k - 1], &after = points.points[k + 1];
    if (std::abs(after.z - before.z) > steepest * std::abs(after.y - before.y)) continue;
    squares += points.curvature_deviation[i] * points.curvature_deviation[i];
    ++count;
  }
  return count == 0 ? 0 : 2.0 / 9 * (2 - b / (a + b)) * std::sqrt(squares / count) / (2 * b);
}

} // namespace microslip
