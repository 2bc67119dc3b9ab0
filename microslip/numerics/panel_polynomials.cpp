#include "microslip/numerics/panel_polynomials.hpp"

#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr std::size_t n = PanelPolynomials::nodes;
using Square = std::array<std::array<double, n>, n>;

double chebyshev_node(std::size_t k) {
  return -std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
}

/// Coefficients of x^power in Chebyshev's polynomials T_0 .. T_n-1.
Square powers_of_chebyshev() {
  Square t{};
  t[0][0] = t[1][1] = 1;
  for (std::size_t m = 2; m < n; ++m)
    for (std::size_t power = 0; power < n; ++power)
      t[m][power] = (power > 0 ? 2 * t[m - 1][power - 1] : 0) - t[m - 2][power];
  return t;
}

/// The discrete cosine transform, which makes coefficients of Chebyshev's polynomials, the first index, from values at
/// the nodes.
Square chebyshev_from_values() {
  Square matrix{};
  for (std::size_t m = 0; m < n; ++m)
    for (std::size_t k = 0; k < n; ++k)
      matrix[m][k] = (m == 0 ? 1.0 : 2.0) / n * std::cos(static_cast<double>(m) * std::acos(chebyshev_node(k)));
  return matrix;
}

/// Coefficients of powers from values at the nodes. By way of Chebyshev's, which decay: sums of powers of the values
/// themselves would lose four digits.
std::array<double, n> powers_of_values(const std::array<double, n>& values) {
  static const Square chebyshev = chebyshev_from_values(), powers = powers_of_chebyshev();
  std::array<double, n> coefficients{};
  for (std::size_t m = 0; m < n; ++m) {
    double share = 0;
    for (std::size_t k = 0; k < n; ++k) share += chebyshev[m][k] * values[k];
    for (std::size_t power = 0; power < n; ++power) coefficients[power] += share * powers[m][power];
  }
  return coefficients;
}

} // namespace

PanelPolynomials::PanelPolynomials(double from, double width, std::size_t functions)
    : from_(from), width_(width), functions_(functions) {}

PanelPolynomials::PanelPolynomials(double from, double to, double width, std::size_t functions, const Values& values)
    : PanelPolynomials(from, width, functions) {
  extend(to, values);
}

void PanelPolynomials::extend(double to, const Values& values) {
  const std::size_t first = panels_,
                    wanted = static_cast<std::size_t>(std::max(1.0, std::ceil((to - from_) / width_ - 1e-9)));
  if (wanted <= first) return;
  panels_ = wanted;
  coefficient_.resize(panels_ * nodes * functions_);
  const int added = static_cast<int>(wanted - first);
  distribute(added, threads_for(wanted - first, 2), {}, [&](int panel, int, const Progress&) {
    const std::size_t p = first + static_cast<std::size_t>(panel);
    std::array<double, nodes> at;
    for (std::size_t k = 0; k < nodes; ++k)
      at[k] = from_ + width_ * (static_cast<double>(p) + (1 + chebyshev_node(k)) / 2);
    std::vector<double> found(nodes * functions_);
    values(at, found);
    for (std::size_t f = 0; f < functions_; ++f) {
      std::array<double, nodes> of_function;
      for (std::size_t k = 0; k < nodes; ++k) of_function[k] = found[k * functions_ + f];
      const std::array<double, nodes> powers = powers_of_values(of_function);
      for (std::size_t power = 0; power < nodes; ++power)
        coefficient_[(p * nodes + power) * functions_ + f] = powers[power];
    }
  });
}

void PanelPolynomials::evaluate(double t, std::span<double> out) const {
  const double along = std::clamp((t - from_) / width_, 0.0, static_cast<double>(panels_));
  const std::size_t panel = std::min(static_cast<std::size_t>(along), panels_ - 1);
  const double x = 2 * (along - static_cast<double>(panel)) - 1;
  const double* c = coefficient_.data() + ((panel + 1) * nodes - 1) * functions_; // of the highest power
  std::copy_n(c, functions_, out.begin());
  for (std::size_t power = 1; power < nodes; ++power) {
    c -= functions_;
    for (std::size_t f = 0; f < functions_; ++f) out[f] = out[f] * x + c[f];
  }
}

} // namespace microslip
