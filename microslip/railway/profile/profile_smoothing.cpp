#include "microslip/railway/profile/profile_smoothing.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/quintic_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

double distance(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(b.y - a.y, b.z - a.z);
}

/// Reinsch's equations of a smoothing spline, (R + lambda Q' V Q) m = Q' x and f = x - lambda V Q m, factorised once
/// for both coordinates. m are second derivatives at inner points, V the inverse weights: 0 holds a point where it is.
class SmoothingSection {
public:
  SmoothingSection(std::span<const double> steps, std::span<const double> inverse_weights, double lambda)
      : steps_(steps), inverse_weights_(inverse_weights), lambda_(lambda) {
    factorise();
  }

  /// Smooths the values of one coordinate in place.
  void smooth(std::span<double> values) const {
    const std::size_t unknowns = pivots_.size();
    std::vector<double> m(unknowns);
    for (std::size_t j = 0; j < unknowns; ++j) {
      m[j] = (values[j + 2] - values[j + 1]) / steps_[j + 1] - (values[j + 1] - values[j]) / steps_[j];
      if (j > 0) m[j] -= first_[j - 1] * m[j - 1];
      if (j > 1) m[j] -= second_[j - 2] * m[j - 2];
    }
    for (std::size_t j = unknowns; j-- > 0;) {
      m[j] /= pivots_[j];
      if (j + 1 < unknowns) m[j] -= first_[j] * m[j + 1];
      if (j + 2 < unknowns) m[j] -= second_[j] * m[j + 2];
    }
    for (std::size_t j = 0; j < unknowns; ++j) {
      const auto q = column(j);
      for (std::size_t i = 0; i < 3; ++i) values[j + i] -= lambda_ * inverse_weights_[j + i] * q[i] * m[j];
    }
  }

private:
  /// Column j of Q: the second difference at point j + 1.
  std::array<double, 3> column(std::size_t j) const {
    const double before = 1 / steps_[j], after = 1 / steps_[j + 1];
    return {before, -(before + after), after};
  }

  /// Entry (j, j + offset) of R + lambda Q' V Q.
  double entry(std::size_t j, std::size_t offset) const {
    const auto q = column(j), other = column(j + offset);
    double sum = 0;
    for (std::size_t i = offset; i < 3; ++i) sum += q[i] * inverse_weights_[j + i] * other[i - offset];
    const double r = offset == 0 ? (steps_[j] + steps_[j + 1]) / 3 : offset == 1 ? steps_[j + 1] / 6 : 0;
    return r + lambda_ * sum;
  }

  /// L D L' of the pentadiagonal matrix: pivots and the two subdiagonals of L.
  void factorise() {
    const std::size_t unknowns = steps_.size() - 1;
    pivots_.resize(unknowns);
    first_.resize(unknowns);
    second_.resize(unknowns);
    for (std::size_t j = 0; j < unknowns; ++j) {
      double pivot = entry(j, 0), next = j + 1 < unknowns ? entry(j, 1) : 0;
      if (j > 0) {
        pivot -= first_[j - 1] * first_[j - 1] * pivots_[j - 1];
        next -= first_[j - 1] * second_[j - 1] * pivots_[j - 1];
      }
      if (j > 1) pivot -= second_[j - 2] * second_[j - 2] * pivots_[j - 2];
      pivots_[j] = pivot;
      first_[j] = next / pivot;
      second_[j] = j + 2 < unknowns ? entry(j, 2) / pivot : 0;
    }
  }

  std::span<const double> steps_, inverse_weights_;
  double lambda_;
  std::vector<double> pivots_, first_, second_;
};

template <class Smoothing>
std::vector<ProfilePoint> smoothed_section(std::span<const ProfilePoint> points,
                                           std::span<const double> inverse_weights, double lambda) {
  const std::size_t n = points.size();
  if (n < 3) return {points.begin(), points.end()};
  std::vector<double> steps(n - 1), y(n), z(n);
  for (std::size_t k = 0; k + 1 < n; ++k) steps[k] = distance(points[k], points[k + 1]);
  for (std::size_t k = 0; k < n; ++k) {
    y[k] = points[k].y;
    z[k] = points[k].z;
  }
  const Smoothing section(steps, inverse_weights, lambda);
  section.smooth(y);
  section.smooth(z);
  std::vector<ProfilePoint> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back({y[k], z[k]});
  return result;
}

/// A kink has the position that the section behind it gives it.
template <class Smoothing>
std::vector<ProfilePoint> smoothed_sections(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                            double lambda, std::span<const double> inverse_weights) {
  std::vector<ProfilePoint> result(points.begin(), points.end());
  std::size_t first = 0;
  for (std::size_t k = 0; k <= kinks.size(); ++k) {
    const std::size_t last = k < kinks.size() ? kinks[k] : points.size() - 1, count = last - first + 1;
    const auto section =
        smoothed_section<Smoothing>(points.subspan(first, count), inverse_weights.subspan(first, count), lambda);
    std::copy(section.begin(), section.end(), result.begin() + static_cast<std::ptrdiff_t>(first));
    first = last;
  }
  return result;
}

} // namespace

std::vector<double> shares_of_length(std::span<const ProfilePoint> points) {
  std::vector<double> shares(points.size());
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double half = distance(points[k], points[k + 1]) / 2;
    shares[k] += half;
    shares[k + 1] += half;
  }
  return shares;
}

std::vector<ProfilePoint> smoothed(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks,
                                   double length) {
  if (!(length > 0 && length <= 1)) throw Error("smoothing_length", length, "m", "in (0, 1]");
  std::vector<double> inverse_weights;
  for (const double share : shares_of_length(points)) inverse_weights.push_back(1 / share);
  for (const std::size_t kink : kinks) inverse_weights[kink] = 0;
  return smoothed_sections<SmoothingSection>(points, kinks, smoothing_factor(length), inverse_weights);
}

std::vector<ProfilePoint> smoothed_with_weights(std::span<const ProfilePoint> points,
                                                std::span<const std::size_t> kinks, double lambda,
                                                std::span<const double> weights, SmoothingPenalty penalty) {
  std::vector<double> inverse_weights;
  for (const double weight : weights) inverse_weights.push_back(1 / weight);
  return penalty == SmoothingPenalty::third_derivative
             ? smoothed_sections<QuinticSmoothing>(points, kinks, lambda, inverse_weights)
             : smoothed_sections<SmoothingSection>(points, kinks, lambda, inverse_weights);
}

double smoothing_factor(double length) {
  return std::pow(length / (2 * std::numbers::pi), 4);
}

} // namespace microslip
