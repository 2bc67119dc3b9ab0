#include "microslip/railway/row_influence.hpp"

#include "microslip/numerics/elliptic.hpp"

#include <cstddef>
#include <numbers>

namespace microslip {
namespace {

double curvature_at(double delta) {
  return RowInfluence::line(delta) / (1 + delta * delta);
}

/// Integral over [low, high], by Gauss's rule of order 10 (Abramowitz & Stegun, table 25.4).
template <class F> double integrate(F&& f, double low, double high) {
  constexpr std::array<double, 5> nodes = {0.148874338981631211, 0.433395394129247191, 0.679409568299024406,
                                           0.865063366688984511, 0.973906528517171720};
  constexpr std::array<double, 5> weights = {0.295524224714752870, 0.269266719309996355, 0.219086362515982044,
                                             0.149451349150580593, 0.066671344308688138};
  const double middle = (low + high) / 2, half = (high - low) / 2;
  double sum = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    sum += weights[k] * (f(middle - half * nodes[k]) + f(middle + half * nodes[k]));
  return half * sum;
}

/// The cubic over t in [0, h] with these values and slopes at its ends.
std::array<double, 4> cubic(double value, double slope, double value_after, double slope_after, double h) {
  const double secant = (value_after - value) / h;
  return {value, slope, (3 * secant - 2 * slope - slope_after) / h, (slope + slope_after - 2 * secant) / (h * h)};
}

} // namespace

double RowInfluence::line(double delta) {
  const double rest = 1 + delta * delta;
  return 2 * complete_elliptic_integrals(delta / std::sqrt(rest)).D / std::sqrt(rest);
}

RowInfluence::RowInfluence() {
  const std::uint64_t last = bit_cast<std::uint64_t>(largest) >> bits_dropped;
  Values here = near(smallest);
  for (std::uint64_t k = first_segment; k < last; ++k) {
    const double start = bit_cast<double>(k << bits_dropped), end = bit_cast<double>((k + 1) << bits_dropped);
    Values after{};
    after.phi = here.phi + integrate(line, start, end);
    after.psi = here.psi + integrate(curvature_at, start, end);
    after.f = line(end), after.curvature = curvature_at(end);
    segments_.push_back({start, cubic(here.phi, here.f, after.phi, after.f, end - start),
                         cubic(here.psi, here.curvature, after.psi, after.curvature, end - start)});
    here = after;
  }
  phi_at_largest_ = here.phi, psi_at_largest_ = here.psi;
}

/// f = 4 ln 2 - 2 - 2 ln delta + O(delta^2 ln delta), and so is f/(1 + delta^2).
RowInfluence::Values RowInfluence::near(double delta) const {
  const double size = std::abs(delta);
  if (!(size > 0)) return {0, 0, 0, 0};
  const double f = 4 * std::numbers::ln2 - 2 - 2 * std::log(size);
  return {delta * (f + 2), delta * (f + 2), f, f};
}

/// f = pi/2 (delta^2 + 1/4)^(-1/2) + O(delta^-5).
RowInfluence::Values RowInfluence::far(double delta) const {
  constexpr double pi = std::numbers::pi;
  const double square = delta * delta;
  const double f = pi / 2 / std::sqrt(square + 0.25);
  // asinh(2 delta) = ln(4 delta) + 1/(16 delta^2) + ...
  const double phi =
      phi_at_largest_ + pi / 2 * (std::log(std::abs(delta) / largest) + (1 / square - 1 / (largest * largest)) / 16);
  const auto rest = [](double x2) { return pi / (4 * x2) * (1 - 9 / (16 * x2)); };
  const double psi = psi_at_largest_ + rest(largest * largest) - rest(square);
  return {std::copysign(phi, delta), std::copysign(psi, delta), f, f / (1 + square)};
}

} // namespace microslip
