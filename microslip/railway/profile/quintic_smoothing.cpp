#include "microslip/railway/profile/quintic_smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// Peano's kernel of the third divided difference: f[s0, s1, s2, s3] is the integral of its product with f'''. It is
/// the quadratic B-spline of these knots over 2 (s3 - s0).
double kernel(const std::array<double, 4>& s, double t) {
  double spline = 0;
  if (t < s[1])
    spline = (t - s[0]) * (t - s[0]) / ((s[2] - s[0]) * (s[1] - s[0]));
  else if (t < s[2])
    spline = ((t - s[0]) * (s[2] - t) / (s[2] - s[0]) + (s[3] - t) * (t - s[1]) / (s[3] - s[1])) / (s[2] - s[1]);
  else
    spline = (s[3] - t) * (s[3] - t) / ((s[3] - s[1]) * (s[3] - s[2]));
  return spline / (2 * (s[3] - s[0]));
}

} // namespace

std::array<double, 4> third_difference(const std::array<double, 4>& s) {
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < 4; ++i) {
    double product = 1;
    for (std::size_t k = 0; k < 4; ++k)
      if (k != i) product *= s[i] - s[k];
    weights[i] = 1 / product;
  }
  return weights;
}

QuinticSmoothing::QuinticSmoothing(std::span<const double> steps, std::span<const double> inverse_weights,
                                   double lambda)
    : inverse_weights_(inverse_weights.begin(), inverse_weights.end()), lambda_(lambda) {
  if (steps.size() < half_width) return;
  bands_ = SymmetricBand<half_width>(steps.size() + 1 - half_width);
  add_kernels(steps);
  add_weights();
  bands_.factorise();
}

/// Integrals of products of two kernels, exact by three points of Gauss in each step.
void QuinticSmoothing::add_kernels(std::span<const double> steps) {
  std::vector<double> s = {0};
  for (const double step : steps) s.push_back(s.back() + step);
  const auto points = [&](std::size_t j) { return std::array{s[j], s[j + 1], s[j + 2], s[j + 3]}; };
  for (std::size_t j = 0; j < bands_.size(); ++j) differences_.push_back(third_difference(points(j)));
  const double root = std::sqrt(0.6);
  const std::array<std::pair<double, double>, 3> gauss = {{{-root, 5. / 18}, {0, 8. / 18}, {root, 5. / 18}}};
  for (std::size_t step = 0; step < steps.size(); ++step)
    for (const auto& [place, weight] : gauss) {
      const double t = s[step] + 0.5 * steps[step] * (1 + place);
      const std::size_t first = step < half_width ? 0 : step - half_width + 1, last = std::min(step, bands_.size() - 1);
      for (std::size_t j = first; j <= last; ++j)
        for (std::size_t k = j; k <= last; ++k)
          bands_[j][k - j] += weight * steps[step] * kernel(points(j), t) * kernel(points(k), t);
    }
}

void QuinticSmoothing::add_weights() {
  for (std::size_t j = 0; j < bands_.size(); ++j)
    for (std::size_t offset = 0; offset <= half_width && j + offset < bands_.size(); ++offset)
      for (std::size_t i = offset; i <= half_width; ++i)
        bands_[j][offset] +=
            lambda_ * differences_[j][i] * inverse_weights_[j + i] * differences_[j + offset][i - offset];
}

void QuinticSmoothing::smooth(std::span<double> values) const {
  const std::size_t count = bands_.size();
  std::vector<double> third(count); // coefficients of f''' on the kernels
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i <= half_width; ++i) third[j] += differences_[j][i] * values[j + i];
  bands_.solve(third);
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i <= half_width; ++i)
      values[j + i] -= lambda_ * inverse_weights_[j + i] * differences_[j][i] * third[j];
}

} // namespace microslip
