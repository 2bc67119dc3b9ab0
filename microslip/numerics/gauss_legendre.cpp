#include "microslip/numerics/gauss_legendre.hpp"

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

struct Legendre {
  double value, slope;
};

/// P_n inside of (-1, 1), by the recursion in n.
Legendre legendre(int n, double x) {
  double before = 0, here = 1;
  for (int m = 1; m <= n; ++m) {
    const double next = ((2 * m - 1) * x * here - (m - 1) * before) / m;
    before = here;
    here = next;
  }
  return {here, n * (before - x * here) / (1 - x * x)};
}

} // namespace

GaussLegendre::GaussLegendre(int n) : node_(static_cast<std::size_t>(n)), weight_(node_.size()) {
  for (int k = 0; k < n; ++k) {
    double x = -std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5));
    for (int step = 0; step < 5; ++step) { // converges quadratically: three suffice
      const Legendre p = legendre(n, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(n, x).slope;
    node_[static_cast<std::size_t>(k)] = x;
    weight_[static_cast<std::size_t>(k)] = 2 / ((1 - x * x) * slope * slope);
  }
}

} // namespace microslip
