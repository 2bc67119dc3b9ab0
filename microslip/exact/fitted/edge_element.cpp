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

/// Widths for steps at the distances 1.3, 1.35, ... 2.3, as printed by the study `edge-constants`.
constexpr std::array widths_of_step = {0.943724, 1.049268, 1.135826, 1.208002, 1.268711, 1.320016, 1.363452,
                                       1.400188, 1.431117, 1.456896, 1.477928, 1.494173, 1.505281, 1.519494,
                                       1.535796, 1.553415, 1.571995, 1.591323, 1.611253, 1.631684, 1.652536};

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
  // |beta'| < 0.07, so each step of omega = distance - beta(omega) gains more than a digit.
  double omega = distance, previous;
  do {
    previous = omega;
    omega = std::clamp(distance - inset(omega), narrowest_leading_element, widest_leading_element);
  } while (std::abs(omega - previous) > 1e-15);
  return omega;
}

double leading_element_width_of_step(double distance) {
  require_between("distance", distance, "-", nearest_edge_of_step, nearest_edge_of_step + 1);
  constexpr int intervals = static_cast<int>(widths_of_step.size()) - 1, nodes = 4;
  const double position = (distance - nearest_edge_of_step) * intervals;
  const int first = std::clamp(static_cast<int>(position) - 1, 0, intervals + 1 - nodes);
  double width = 0; // by Lagrange's polynomial of degree 3
  for (int i = first; i < first + nodes; ++i) {
    double weight = 1;
    for (int other = first; other < first + nodes; ++other)
      if (other != i) weight *= (position - other) / (i - other);
    width += weight * widths_of_step[static_cast<std::size_t>(i)];
  }
  return width;
}

} // namespace microslip
