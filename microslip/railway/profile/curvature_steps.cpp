#include "microslip/railway/profile/curvature_steps.hpp"

#include "microslip/numerics/symmetric_band.hpp"
#include "microslip/railway/profile/quintic_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

constexpr int rounds = 100, cooling_rounds = 60;
constexpr double first_inflation = 400; // of the errors' variances, down to 1 while cooling
constexpr double freedom = 0.3;         // of Student's distribution
constexpr double first_scale = 1e4;     // [1/m^3]: steps of 3 1/m at 1 mm
constexpr double least_part = 1e-14;    // of Q in the diagonal, so that the matrix can be solved with

class CurvatureSteps {
public:
  CurvatureSteps(std::span<const double> s, std::span<const double> curvature, std::span<const double> measured,
                 std::span<const double> variances);

  std::vector<double> distances();
  double noise_factor();

private:
  using Differences = std::array<double, 4>;

  void factorise(double inflation);
  double improve_steps();
  std::vector<double> residuals(double inflation) const;

  std::span<const double> measured_, variances_;
  std::vector<Differences> differences_; ///< rows of D
  std::vector<double> right_side_;       ///< D d + c
  double scale_ = first_scale;           ///< q [1/m^3]
  std::vector<double> spacings_;         ///< h of each step
  std::vector<double> steps_;            ///< Q
  std::vector<double> solution_;         ///< g
  SymmetricBand<3> factors_;
};

CurvatureSteps::CurvatureSteps(std::span<const double> s, std::span<const double> curvature,
                               std::span<const double> measured, std::span<const double> variances)
    : measured_(measured), variances_(variances) {
  for (std::size_t j = 0; j + 3 < s.size(); ++j) {
    Differences row = third_difference({s[j], s[j + 1], s[j + 2], s[j + 3]});
    double step = curvature[j + 2] - curvature[j + 1];
    for (std::size_t i = 0; i < 4; ++i) {
      row[i] *= 2 * (s[j + 3] - s[j]);
      step += row[i] * measured[j + i];
    }
    differences_.push_back(row);
    right_side_.push_back(step);
    spacings_.push_back(s[j + 2] - s[j + 1]);
    steps_.push_back(scale_ * spacings_.back());
  }
}

/// Factor of the errors' variances in a round.
double inflation_of(int round) {
  return std::pow(first_inflation, 1 - std::min(1.0, static_cast<double>(round) / cooling_rounds));
}

std::vector<double> CurvatureSteps::distances() {
  for (int round = 0; round < rounds; ++round) {
    factorise(inflation_of(round));
    improve_steps();
  }
  factorise(1);
  std::vector<double> result(measured_.begin(), measured_.end());
  const auto taken = residuals(1);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] -= taken[k];
  return result;
}

/// The factor f for which residuals r have the median of r^2/(f V) that errors have, when steps have taken their part.
double CurvatureSteps::noise_factor() {
  constexpr double median_of_square = 0.45494; // of a normal variable of variance 1
  double factor = 0;
  for (int round = 0; round < rounds; ++round) {
    const double inflation = std::max(inflation_of(round), factor);
    factorise(inflation);
    std::vector<double> squares;
    const auto taken = residuals(inflation);
    for (std::size_t k = 0; k < taken.size(); ++k)
      if (variances_[k] > 0) squares.push_back(taken[k] * taken[k] / variances_[k]);
    if (squares.empty()) return 1;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    factor = *middle / median_of_square * static_cast<double>(taken.size()) / improve_steps();
  }
  return factor;
}

/// V D' g, by which n differs from d.
std::vector<double> CurvatureSteps::residuals(double inflation) const {
  std::vector<double> result(measured_.size());
  for (std::size_t j = 0; j < solution_.size(); ++j)
    for (std::size_t i = 0; i < 4; ++i)
      result[j + i] += inflation * variances_[j + i] * differences_[j][i] * solution_[j];
  return result;
}

/// Factors of D V D' + Q, and g, with V that many times as large; steps too small beside errors become larger.
void CurvatureSteps::factorise(double inflation) {
  const std::size_t count = differences_.size();
  factors_ = SymmetricBand<3>(count);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t offset = 0; offset <= 3 && j + offset < count; ++offset)
      for (std::size_t i = offset; i <= 3; ++i)
        factors_[j][offset] +=
            differences_[j][i] * inflation * variances_[j + i] * differences_[j + offset][i - offset];
    steps_[j] = std::max(steps_[j], least_part * factors_[j][0]);
    factors_[j][0] += steps_[j];
  }
  factors_.factorise();
  solution_ = right_side_;
  factors_.solve(solution_);
}

/// One round: with m = Q g the mean of a step, and 1 - Q z, z of the diagonal of (D V D' + Q)^-1, the part of its
/// variance that the data leave, (nu + Q z) Q = nu q h + m^2. Then q is the harmonic mean of Q/h. Returns
/// the number of differences that errors have, the sum of 1 - Q z.
double CurvatureSteps::improve_steps() {
  const auto diagonal = factors_.inverse_diagonal();
  double sum = 0, errors = 0;
  for (std::size_t j = 0; j < steps_.size(); ++j) {
    const double mean = steps_[j] * solution_[j];
    errors += 1 - steps_[j] * diagonal[j];
    steps_[j] = (freedom * scale_ * spacings_[j] + mean * mean) / (freedom + steps_[j] * diagonal[j]);
    sum += spacings_[j] / steps_[j];
  }
  scale_ = static_cast<double>(steps_.size()) / sum;
  return errors;
}

} // namespace

std::vector<double> distances_with_few_curvature_steps(std::span<const double> s, std::span<const double> curvature,
                                                       std::span<const double> measured,
                                                       std::span<const double> variances) {
  return CurvatureSteps(s, curvature, measured, variances).distances();
}

double noise_factor_beside_few_curvature_steps(std::span<const double> s, std::span<const double> curvature,
                                               std::span<const double> measured, std::span<const double> variances) {
  return CurvatureSteps(s, curvature, measured, variances).noise_factor();
}

} // namespace microslip
