#include "validation/half_line.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {
namespace {

using std::numbers::ln2;
using std::numbers::pi;

/// 1 - sin(x)/x, 0 <= x <= pi/2, with full relative accuracy.
double one_minus_sinc(double x) {
  double sum = 0, term = 1;
  for (int k = 2; k < 28; k += 2) {
    term *= -x * x / (k * (k + 1));
    sum -= term;
  }
  return sum;
}

/// Sum over j = 1, 2, ... of (-1)^(j + 1) ((2 pi j - theta)^-2 - (2 pi j + theta)^-2), accelerated as Cohen, Rodriguez
/// Villegas & Zagier (2000, algorithm 1) do; 24 terms leave 6^-24.
double alternating_images(double theta) {
  constexpr int terms = 24;
  const double power = std::pow(3 + std::sqrt(8.0), terms), d = (power + 1 / power) / 2;
  double b = -1, c = -d, sum = 0;
  for (int k = 0; k < terms; ++k) {
    const double period = 2 * pi * (k + 1), product = period * period - theta * theta;
    c = b - c;
    sum += c * 4 * period * theta / (product * product);
    b *= double(k + terms) * (k - terms) / ((k + 0.5) * (k + 1));
  }
  return sum / d;
}

/// ln M(theta), M = 4 sin^2(theta/2) sum over all j of (-1)^j/(k |k|), k = theta + 2 pi j, 0 < theta < pi.
double log_symbol(double theta) {
  return 2 * std::log1p(-one_minus_sinc(theta / 2)) + std::log1p(theta * theta * alternating_images(theta));
}

/// exp(x) - 1 - x, x <= 0, with full relative accuracy.
double exp_minus_linear(double x) {
  if (x < -1) return std::expm1(x) - x;
  double sum = 0, term = x;
  for (int k = 2; k < 20; ++k) sum += term *= x / k;
  return sum;
}

/// Displacement at x by a unit traction on left < x < right.
double displacement(double x, double left, double right) {
  const auto antiderivative = [](double t) { return t == 0 ? 0 : t * (std::log(std::abs(t)) - 1); };
  return (antiderivative(x - right) - antiderivative(x - left)) / pi;
}

/// By a regular element at the distance t from its centre; at its centre.
double regular(double t) {
  return displacement(t, -0.5, 0.5);
}
constexpr double regular_centre = (1 + ln2) / pi;

} // namespace

HalfLine::HalfLine(double spacing) {
  // t = tan(theta/2) maps Poisson's formula for ln G at z = exp(-s) to kernels r/(r^2 + t^2), r = tanh(s/2).
  std::vector<double> t, m;
  double log_first = 0;
  for (int k = 0; k <= static_cast<int>(90 / spacing); ++k) {
    t.push_back(std::exp(-45 + k * spacing));
    m.push_back(log_symbol(2 * std::atan(t.back())));
    kappa_ -= spacing / (2 * pi) * m.back() / t.back();
    log_first -= spacing / pi * m.back() * t.back() / (1 + t.back() * t.back());
  }
  first_ = std::exp(log_first);

  for (int k = 0; k <= static_cast<int>(85.2 / spacing); ++k) {
    const double s = std::exp(-80 + k * spacing), r = std::tanh(s / 2), one_minus_r = 2 / (std::exp(s) + 1);
    double log_g = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double tt = t[i] * t[i];
      log_g -= spacing / pi * m[i] * t[i] * one_minus_r * (r - tt) / ((r * r + tt) * (1 + tt));
    }
    s_.push_back(s);
    weight_.push_back(s * spacing / pi);
    log_c_.push_back(s < ln2 ? std::log(-std::expm1(-s)) : std::log1p(-std::exp(-s)));
    log_g_.push_back(log_g);
  }
  chain_.reserve(s_.size() * s_.size());
  for (const double s : s_)
    for (const double other : s_) chain_.push_back(1 / std::expm1(s + other));
}

/// Displacement at y, 0 at all centres and at y = 1/2: that of p ~ n^(1/2) with the linear function that it lacks. The
/// element n = 0 is apart, for its displacement by itself is no such integral.
double HalfLine::growing(double y) const {
  const double up = y + 0.5;
  double sum = first_ * (regular(up) - regular_centre - up * (regular(1) - regular_centre));
  for (std::size_t i = 0; i < s_.size(); ++i) {
    const double s = s_[i], c = std::exp(log_c_[i]);
    const double others = first_ * std::expm1(log_g_[i] - 1.5 * log_c_[i]);
    const double seen = std::exp(s / 2) * (exp_minus_linear(-up * s) - up * exp_minus_linear(-s));
    sum += weight_[i] * seen * c / (s * s) * others;
  }
  return sum;
}

/// The same of p ~ n^(-1/2), 0 at all centres.
double HalfLine::decaying(double y) const {
  double sum = first_ * (regular(y + 0.5) - regular_centre);
  for (std::size_t i = 0; i < s_.size(); ++i) {
    const double s = s_[i], c = std::exp(log_c_[i]);
    const double others = first_ * std::expm1(log_g_[i] - 0.5 * log_c_[i]);
    sum += weight_[i] * std::exp(s / 2) * std::expm1(-(y + 0.5) * s) * c / (s * s) * others;
  }
  return sum;
}

/// A unit traction on the leading element as the half-line feels it: the weights of exp(-n s) in T(1/K-) applied to its
/// displacements at the centres n = 0, 1, ...
std::vector<double> HalfLine::induced(double omega) const {
  std::vector<double> source(s_.size());
  for (std::size_t i = 0; i < s_.size(); ++i) {
    const double s = s_[i], inverse_factor = first_ * std::exp(log_g_[i] + 0.5 * log_c_[i]);
    source[i] = weight_[i] * std::exp(-s / 2) * -std::expm1(-omega * s) / (s * s) * inverse_factor;
  }
  return source;
}

/// Displacement at y, 0 at all centres, by a unit traction on the leading element and by what it induces:
/// U - l^T A^-1 L with A^-1 = T(1/K+) T(1/K-), minus the same at the centre n = 0, where it vanishes.
double HalfLine::leading(double y, double omega, const std::vector<double>& source) const {
  double sum = displacement(y, 0, omega) - displacement(-0.5, 0, omega), at_y = 0, total = 0;
  for (std::size_t i = 0; i < s_.size(); ++i) {
    const double s = s_[i], c = std::exp(log_c_[i]), inverse_factor = first_ * std::exp(log_g_[i] + 0.5 * log_c_[i]);
    const double common = weight_[i] * c / (s * s) * inverse_factor;
    at_y += common * std::exp(-y * s);
    total += source[i];
    double chained = 0;
    for (std::size_t j = 0; j < s_.size(); ++j) chained += chain_[i * s_.size() + j] * source[j];
    sum -= common * std::exp(s / 2) * std::expm1(-(y + 0.5) * s) * chained;
  }
  return sum - (at_y - 1 / first_) * total;
}

double HalfLine::distance(double omega) const {
  return distance(omega, {omega / 2, omega + 0.5});
}

double HalfLine::distance(double omega, const std::array<double, 2>& points) const {
  const auto [first, second] = points;
  const std::vector<double> source = induced(omega);
  // growing + a decaying + q leading vanishes at both points; the far field moves by a.
  const double d1 = decaying(first), l1 = leading(first, omega, source), g1 = growing(first);
  const double d2 = decaying(second), l2 = leading(second, omega, source), g2 = growing(second);
  const double a = (l1 * g2 - l2 * g1) / (d1 * l2 - d2 * l1);
  return 0.25 + kappa_ + a;
}

} // namespace microslip::validation
