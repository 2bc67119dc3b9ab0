#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace microslip {

/// An argument and the value of a function there.
struct RootSide {
  double at = 0, value = 0;
};

/// Sign change of a function.
struct BracketedRoot {
  RootSide side;      ///< evaluated last: the root or, of the two sides of a jump, the one with the smaller value
  RootSide other;     ///< of a jump
  bool found = false; ///< |value| <= tolerance; else the function jumps over zero there
};

/// Finds an argument with |f| <= tolerance between two with values of opposite signs, or closes in on a jump until its
/// sides are `precision` apart: the ITP method (Oliveira & Takahashi 2020, ACM Trans. Math. Softw. 47(1), algorithm 1),
/// which converges superlinearly where f is smooth and takes at most one evaluation more than bisection. What is not a
/// number counts as a positive value.
template <class Function>
BracketedRoot find_bracketed_root(RootSide low, RootSide high, double tolerance, double precision, Function&& f) {
  constexpr double kappa = 0.2; // of kappa_1 = kappa/(b0 - a0), with kappa_2 = 2
  if (high.at < low.at) std::swap(low, high);
  const double sign = low.value < 0 ? 1 : -1, whole = high.at - low.at;
  const int most = static_cast<int>(std::ceil(std::log2(std::max(whole / precision, 1.0)))) + 1;
  RootSide last = low;
  const auto evaluate = [&](double at) {
    last = {at, f(at)};
    return std::abs(last.value) <= tolerance;
  };
  for (int k = 0; k < most && high.at - low.at > precision; ++k) {
    const double width = high.at - low.at, middle = low.at + width / 2;
    const double secant = low.at - low.value * width / (high.value - low.value);
    const double to_middle = middle - secant, truncation = kappa * width * width / whole;
    const double truncated = truncation <= std::abs(to_middle) ? secant + std::copysign(truncation, to_middle) : middle;
    const double reach = std::max(precision / 2 * std::exp2(most - k) - width / 2, 0.0); // about the middle
    double at = std::clamp(truncated, middle - reach, middle + reach);
    if (!(at > low.at && at < high.at)) at = middle; // the step was lost by rounding
    if (!(at > low.at && at < high.at)) break;       // neighbouring numbers
    if (evaluate(at)) return {last, last, true};
    (sign * last.value < 0 ? low : high) = last;
  }
  if (std::abs(high.value) <= std::abs(low.value)) std::swap(low, high);
  if (last.at != low.at) evaluate(low.at);
  return {last, high, std::abs(last.value) <= tolerance};
}

/// Finds the root of a decreasing function from a point near it on: bracketed by steps that double, then by
/// find_bracketed_root to 1e-10 of the first step. Nothing where the function has one sign from there to `lowest` or
/// `highest`.
template <class Function>
std::optional<BracketedRoot> find_root_nearby(double start, double step, double lowest, double highest,
                                              double tolerance, Function&& f) {
  const double precision = 1e-10 * step;
  RootSide low{start, f(start)};
  if (std::abs(low.value) <= tolerance) return BracketedRoot{low, low, true};
  step = std::copysign(step, low.value);
  RootSide high = low;
  for (; high.value * low.value > 0; step *= 2) {
    low = high;
    const double next = std::clamp(low.at + step, lowest, highest);
    if (!(std::abs(next - low.at) > precision)) return {};
    high = {next, f(next)};
  }
  return find_bracketed_root(low, high, tolerance, precision, f);
}

} // namespace microslip
