#include "fit/student.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <numbers>

namespace microslip::fit {
namespace {

/// P(|T| <= t).
double probability_within(double t, int freedom) {
  const double angle = std::atan(t / std::sqrt(freedom)), sine = std::sin(angle), square = std::pow(std::cos(angle), 2);
  const bool is_odd = freedom % 2 == 1;
  double term = is_odd ? std::cos(angle) : 1, sum = 0;
  for (int k = is_odd ? 3 : 2; k <= freedom; k += 2) {
    sum += term;
    term *= square * (k - 1) / k;
  }
  return is_odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

} // namespace

double student_quantile(double probability, int freedom) {
  require_between("probability", probability, "-", 1e-6, 1 - 1e-6);
  if (freedom < 1) throw Error("freedom", freedom, "-", ">= 1");
  double low = 0, high = 1e12;
  while (high - low > 1e-12 * high) {
    const double middle = low > 0 ? std::sqrt(low * high) : 1e-9 * high;
    (probability_within(middle, freedom) < probability ? low : high) = middle;
  }
  return high;
}

} // namespace microslip::fit
