#include "validation/plane_cover.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace microslip::validation {
namespace {

/// 2 exp(-2 alpha) D, with e = exp(-2 alpha).
double denominator(double kappa, double alpha, double e) {
  return 2 * kappa * (1 + e * e) + 2 * e * (1 + kappa * kappa + 4 * alpha * alpha);
}

double kappa_of(const PlaneCover& cover) {
  return 3 - 4 * cover.poisson_ratio;
}

/// Solves A x = b by elimination with pivots; A has rows of n + 1 numbers, b the last of each.
std::vector<double> eliminate(std::vector<std::vector<double>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t c = 0; c < n; ++c) {
    const auto pivot = std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(),
                                        [c](const auto& a, const auto& b) { return std::abs(a[c]) < std::abs(b[c]); });
    std::swap(rows[c], *pivot);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  std::vector<double> x(n);
  for (std::size_t r = n; r-- > 0;) {
    double rest = rows[r][n];
    for (std::size_t k = r + 1; k < n; ++k) rest -= rows[r][k] * x[k];
    x[r] = rest / rows[r][r];
  }
  return x;
}

/// Influence of a hat of pressure, of unit height and the length 2 d, on points n d further, by a series that repeats
/// itself far beyond the cover's memory.
struct HatInfluence {
  std::vector<double> displacement, stretch; ///< u_n [m/Pa], du_x/dx [1/Pa]

  HatInfluence(const PlaneCover& cover, double d, double length, int count)
      : displacement(static_cast<std::size_t>(count)), stretch(displacement) {
    const double period = length + 30 * cover.thickness, step = 2 * std::numbers::pi / period;
    const double at_once = (1 - 2 * cover.poisson_ratio) / (2 * cover.shear_modulus); // of a half-space, where it acts
    stretch[0] = -at_once;
    constexpr double shortest = 100; // k d of the last wave
    for (int m = 0; m * step * d < shortest; ++m) {
      const double k = std::max(m * step, 1e-3 / (cover.thickness + length)), half = 0.5 * k * d;
      const double hat = d * std::pow(std::sin(half) / half, 2), weight = (m == 0 ? 1 : 2) * hat / period;
      const double normal = weight * normal_response(cover, k) / k,
                   along = -weight * (coupling_response(cover, k) - at_once);
      for (int n = 0; n < count; ++n) {
        const double wave = std::cos(m * step * n * d);
        displacement[static_cast<std::size_t>(n)] += normal * wave;
        stretch[static_cast<std::size_t>(n)] += along * wave;
      }
    }
  }
};

} // namespace

double normal_response(const PlaneCover& cover, double k) {
  const double kappa = kappa_of(cover), alpha = k * cover.thickness, e = std::exp(-2 * alpha);
  return (1 - cover.poisson_ratio) / cover.shear_modulus * (2 * kappa * (1 - e * e) - 8 * alpha * e) /
         denominator(kappa, alpha, e);
}

double coupling_response(const PlaneCover& cover, double k) {
  const double kappa = kappa_of(cover), alpha = k * cover.thickness, e = std::exp(-2 * alpha);
  return (kappa * (kappa - 1) * (1 - e) * (1 - e) - 8 * alpha * alpha * e) /
         (2 * cover.shear_modulus * denominator(kappa, alpha, e));
}

PlaneNip press(const PlaneCover& cover, double radius, double half_width, int nodes) {
  const auto n = static_cast<std::size_t>(nodes);
  const double d = half_width / nodes;
  const HatInfluence hat(cover, d, 4 * half_width, 2 * nodes + 1);
  const auto of_pair = [](const std::vector<double>& influence, std::size_t at, std::size_t node) {
    const double own = influence[at > node ? at - node : node - at];
    return node == 0 ? own : own + influence[at + node];
  };
  // Pressures at the nodes but the last, which has none, and the approach: u_n = delta - x^2/(2 R) at all of them.
  std::vector<std::vector<double>> rows(n + 1, std::vector<double>(n + 2));
  for (std::size_t at = 0; at <= n; ++at) {
    for (std::size_t node = 0; node < n; ++node) rows[at][node] = of_pair(hat.displacement, at, node);
    const double x = static_cast<double>(at) * d;
    rows[at][n] = -1;
    rows[at][n + 1] = -x * x / (2 * radius);
  }
  const std::vector<double> found = eliminate(std::move(rows));
  PlaneNip nip{half_width, d, {found.begin(), found.end() - 1}, std::vector<double>(n + 1), 0, found.back()};
  nip.pressure.push_back(0);
  for (std::size_t at = 0; at <= n; ++at)
    for (std::size_t node = 0; node < n; ++node) nip.stretch[at] += of_pair(hat.stretch, at, node) * nip.pressure[node];
  for (std::size_t node = 0; node < n; ++node) nip.force += (node == 0 ? 1 : 2) * nip.pressure[node] * d;
  return nip;
}

double PlaneNip::overdrive() const {
  double within = 0; // of one side
  for (std::size_t node = 0; node + 1 < pressure.size(); ++node) {
    const double more = 0.5 * (pressure[node] + pressure[node + 1]) * spacing;
    if (within + more >= 0.25 * force) {
      const double share = (0.25 * force - within) / more;
      return stretch[node] + share * (stretch[node + 1] - stretch[node]);
    }
    within += more;
  }
  return stretch.back();
}

} // namespace microslip::validation
