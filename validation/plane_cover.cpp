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

/// The wave numbers of a series that repeats itself beyond the cover's memory, with a hat's transform times the weight.
template <class Add> void for_waves(const PlaneCover& cover, double d, double length, const Add& add) {
  constexpr double shortest = 40; // k d of the last wave
  const double period = length + 30 * cover.thickness, step = 2 * std::numbers::pi / period;
  for (int m = 0; m * step * d < shortest; ++m) {
    const double k = std::max(m * step, 1e-3 / (cover.thickness + length)), half = 0.5 * k * d;
    add(k, m * step, (m == 0 ? 1 : 2) / period * d * std::pow(std::sin(half) / half, 2));
  }
}

/// Influence of a hat of pressure, of unit height and the length 2 d, on points n d further, by a series that repeats
/// itself far beyond the cover's memory.
struct HatInfluence {
  std::vector<double> displacement, stretch; ///< u_n [m/Pa], du_x/dx [1/Pa]

  HatInfluence(const PlaneCover& cover, double d, double length, int count)
      : displacement(static_cast<std::size_t>(count)), stretch(displacement) {
    const double at_once = (1 - 2 * cover.poisson_ratio) / (2 * cover.shear_modulus); // of a half-space, where it acts
    stretch[0] = -at_once;
    for_waves(cover, d, length, [&](double k, double wavenumber, double weight) {
      const double normal = weight * normal_response(cover, k) / k,
                   along = -weight * (coupling_response(cover, k) - at_once);
      for (int n = 0; n < count; ++n) {
        const double wave = std::cos(wavenumber * n * d);
        displacement[static_cast<std::size_t>(n)] += normal * wave;
        stretch[static_cast<std::size_t>(n)] += along * wave;
      }
    });
  }
};

} // namespace

double normal_response(const PlaneCover& cover, double k) {
  const double kappa = kappa_of(cover), alpha = k * cover.thickness, e = std::exp(-2 * alpha);
  return (1 - cover.poisson_ratio) / cover.shear_modulus * (2 * kappa * (1 - e * e) - 8 * alpha * e) /
         denominator(kappa, alpha, e);
}

double shear_response(const PlaneCover& cover, double k) {
  const double kappa = kappa_of(cover), alpha = k * cover.thickness, e = std::exp(-2 * alpha);
  return (1 - cover.poisson_ratio) / cover.shear_modulus * (2 * kappa * (1 - e * e) + 8 * alpha * e) /
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

StickingNip stick(const PlaneCover& cover, double radius, double force, double half_width, int nodes) {
  constexpr int most_rounds = 50;
  const double d = half_width / nodes;
  const int last = 3 * nodes / 2, count = 2 * last + 1; // from -3/2 to 3/2 of the half-width
  const auto x = [&](int i) { return (i - last) * d; };
  std::vector<double> normal(static_cast<std::size_t>(count + 1)), shear = normal, coupling = normal;
  for_waves(cover, d, 4 * half_width, [&](double k, double wavenumber, double weight) {
    for (int n = 0; n <= count; ++n) {
      const double c = std::cos(wavenumber * n * d), s = std::sin(wavenumber * n * d);
      normal[static_cast<std::size_t>(n)] += weight * normal_response(cover, k) / k * c;
      shear[static_cast<std::size_t>(n)] += weight * shear_response(cover, k) / k * c;
      coupling[static_cast<std::size_t>(n)] += weight * coupling_response(cover, k) / k * s;
    }
  });
  const auto even = [](const std::vector<double>& of, int n) { return of[static_cast<std::size_t>(std::abs(n))]; };
  const auto odd = [&](int n) { return n < 0 ? -even(coupling, n) : even(coupling, n); };
  const auto along_by_p = [&](int n) { return -odd(n); };

  int first = last - nodes, end = last + nodes + 1; // nodes in contact
  for (int round = 0;; ++round) {
    const int m = end - first;
    // Pressures, tractions, approach and stretch: u_n = delta - x^2/(2 R) and u_x(x + d) - u_x(x) = stretch d at the
    // nodes, with the force and no tangential one.
    const auto n = static_cast<std::size_t>(m), size = 2 * n + 2;
    std::vector<std::vector<double>> rows(size, std::vector<double>(size + 1));
    for (std::size_t at = 0; at < n; ++at) {
      const int i = first + static_cast<int>(at);
      for (std::size_t by = 0; by < n; ++by) {
        const int away = i - first - static_cast<int>(by);
        rows[at][by] = even(normal, away);
        rows[at][n + by] = odd(away);
        rows[n + at][by] = along_by_p(away + 1) - along_by_p(away);
        rows[n + at][n + by] = even(shear, away + 1) - even(shear, away);
      }
      rows[at][2 * n] = -1;
      rows[at][size] = -x(i) * x(i) / (2 * radius);
      rows[n + at][2 * n + 1] = -d;
      rows[2 * n][at] = d;
      rows[2 * n + 1][n + at] = d;
    }
    rows[2 * n][size] = force;
    const std::vector<double> v = eliminate(std::move(rows));
    const auto gap = [&](int i) { // deformed
      double sum = x(i) * x(i) / (2 * radius) - v[2 * n];
      for (int by = 0; by < m; ++by)
        sum += even(normal, i - first - by) * v[static_cast<std::size_t>(by)] +
               odd(i - first - by) * v[n + static_cast<std::size_t>(by)];
      return sum;
    };
    int next_first = first, next_end = end;
    if (v[0] < 0) ++next_first;
    if (v[n - 1] < 0) --next_end;
    if (next_first == first && gap(first - 1) < 0) --next_first;
    if (next_end == end && gap(end) < 0) ++next_end;
    if ((next_first == first && next_end == end) || round == most_rounds) return {v[2 * n], v[2 * n + 1]};
    first = next_first, end = next_end;
  }
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
