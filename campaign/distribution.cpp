#include "campaign/distribution.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>

namespace microslip::campaign {
namespace {

constexpr double least_part = 0x1p-53; ///< of random numbers, and the distance of the largest ones to 1

/// Mean and standard deviation of the logarithm of a log-normal number: s^2 = ln(1 + (sd/mean)^2), ln(mean) - s^2/2.
struct Logarithm {
  double mean, deviation;
};
Logarithm logarithm_of(const Distribution& d) {
  const double square = std::log1p(std::pow(d.standard_deviation / d.mean, 2));
  return {std::log(d.mean) - 0.5 * square, std::sqrt(square)};
}

/// Fraction that lies below an end.
double probability_below(const Distribution& d, double end) {
  if (std::isinf(end)) return end < 0 ? 0 : 1;
  if (d.kind == Distribution::Kind::normal) return normal_probability((end - d.mean) / d.standard_deviation);
  if (end <= 0) return 0;
  const Logarithm logarithm = logarithm_of(d);
  return normal_probability((std::log(end) - logarithm.mean) / logarithm.deviation);
}

double triangular_quantile(const Distribution& d, double part) {
  const double length = d.to - d.from, below = (d.mode - d.from) / length;
  return part < below ? d.from + std::sqrt(part * length * (d.mode - d.from))
                      : d.to - std::sqrt((1 - part) * length * (d.to - d.mode));
}

} // namespace

double normal_quantile(double part) {
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * part);
}

double normal_probability(double score) {
  return 0.5 * std::erfc(-score / std::numbers::sqrt2);
}

void Distribution::check() const {
  const bool is_uniform = kind == Kind::uniform;
  if (is_logarithmic && !(from * to > 0)) throw Error("a logarithmic scale needs ends of one sign");
  if (is_uniform) return;
  if (!(from < to)) throw Error("from", from, "", "less than to");
  if (kind == Kind::triangular) {
    if (!(from <= mode && mode <= to)) throw Error("mode", mode, "", "between from and to");
    return;
  }
  if (!(standard_deviation > 0)) throw Error("standard_deviation", standard_deviation, "", "positive");
  if (kind == Kind::log_normal && !(mean > 0)) throw Error("mean", mean, "", "positive in a log_normal distribution");
  if (!(probability_below(*this, to) - probability_below(*this, from) > 1e-6))
    throw Error("from and to leave less than 1e-6 of the distribution between them");
}

double Distribution::uncut(double part) const {
  const double score = normal_quantile(std::clamp(part, least_part, 1 - least_part));
  if (kind == Kind::normal) return mean + standard_deviation * score;
  const Logarithm logarithm = logarithm_of(*this);
  return std::exp(logarithm.mean + logarithm.deviation * score);
}

double Distribution::quantile(double part) const {
  if (kind == Kind::uniform) return is_logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
  if (kind == Kind::triangular) return triangular_quantile(*this, part);
  const double below = probability_below(*this, from), between = probability_below(*this, to) - below;
  return std::clamp(uncut(below + between * part), from, to);
}

} // namespace microslip::campaign
