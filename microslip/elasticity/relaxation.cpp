#include "microslip/elasticity/relaxation.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <numeric>

namespace microslip {
namespace {

/// Terms of ascending rates 1/tau, one for each time.
PronySeries ordered(PronySeries series) {
  std::sort(series.begin(), series.end(), [](const PronyTerm& a, const PronyTerm& b) { return a.time > b.time; });
  PronySeries merged;
  for (const PronyTerm& term : series) {
    if (!merged.empty() && merged.back().time == term.time)
      merged.back().share += term.share;
    else
      merged.push_back(term);
  }
  return merged;
}

/// M(-rate)/M0, which falls from infinity to minus infinity between neighbouring poles 1/tau.
double modulus_at_rate(const PronySeries& series, double rate) {
  double modulus = 1;
  for (const auto& [share, time] : series) modulus -= share / (1 - rate * time);
  return modulus;
}

double zero_between(const PronySeries& series, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return low > 0 ? low : high;
    (modulus_at_rate(series, middle) > 0 ? low : high) = middle;
  }
}

double creep_ratio(const PronySeries& series, double rate) {
  double slope = 0; // of M/M0 by the rate, with the opposite sign
  for (const auto& [share, time] : series) slope += share * time / ((1 - rate * time) * (1 - rate * time));
  return 1 / (rate * slope);
}

} // namespace

void check(const std::string& field, const PronySeries& series) {
  for (std::size_t k = 0; k < series.size(); ++k) {
    const std::string term = field + "[" + std::to_string(k) + "]";
    require_positive(term + ".share", series[k].share, "-");
    require_positive(term + ".time", series[k].time, "s");
  }
  const double sum = std::accumulate(series.begin(), series.end(), 0.0,
                                     [](double so_far, const PronyTerm& term) { return so_far + term.share; });
  if (!(sum < 1)) throw Error("sum of " + field + ".share", sum, "-", "below 1");
}

std::complex<double> relative_modulus(const PronySeries& series, double omega) {
  std::complex<double> modulus = 1;
  for (const auto& [share, time] : series) modulus -= share / std::complex<double>(1, omega * time);
  return modulus;
}

std::vector<MaterialCreep> creep_of(const PronySeries& series) {
  const PronySeries terms = ordered(series);
  std::vector<MaterialCreep> creep;
  double pole_before = 0;
  for (const PronyTerm& term : terms) {
    const double rate = zero_between(terms, pole_before, 1 / term.time);
    creep.push_back({creep_ratio(terms, rate), 1 / rate});
    pole_before = 1 / term.time;
  }
  std::reverse(creep.begin(), creep.end());
  return creep;
}

} // namespace microslip
