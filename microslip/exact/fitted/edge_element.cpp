#include "microslip/exact/fitted/edge_element.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {
namespace {

/// Chebyshev coefficients of beta over [narrowest, widest], as printed by the study `edge-constants`.
constexpr std::array coefficients = {0.33398194076,  0.02019663091, 0.00708698822, -0.00063489291, 0.00006781576,
                                     -0.00000747070, 0.00000057229, 0.00000008652, -0.00000007171, 0.00000003051,
                                     -0.00000001108, 0.00000000374, -0.00000000112};

/// beta(omega) by Clenshaw's recurrence.
double inset(double omega) {
  constexpr double middle = (narrowest_leading_element + widest_leading_element) / 2;
  constexpr double half = (widest_leading_element - narrowest_leading_element) / 2;
  const double x = (omega - middle) / half;
  double value = 0, previous = 0;
  for (std::size_t k = coefficients.size() - 1; k > 0; --k) {
    const double next = coefficients[k] + 2 * x * value - previous;
    previous = value;
    value = next;
  }
  return coefficients[0] + x * value - previous;
}

} // namespace

double edge_inset(double omega) {
  return inset(require_between("omega", omega, "-", narrowest_leading_element, widest_leading_element));
}

double edge_distance(double omega) {
  return omega + edge_inset(omega);
}

double leading_element_width(double distance) {
  require_between("distance", distance, "-", edge_distance(narrowest_leading_element),
                  edge_distance(widest_leading_element));
  // |beta'| < .07, so each step of omega = distance - beta(omega) gains more than a digit.
  double omega = distance, previous;
  do {
    previous = omega;
    omega = std::clamp(distance - inset(omega), narrowest_leading_element, widest_leading_element);
  } while (std::abs(omega - previous) > 1e-15);
  return omega;
}

} // namespace microslip
