#pragma once

#include <optional>
#include <utility>

namespace microslip::validation {

/// What is left of the change of a function between two arguments when the interval is halved again and again, towards
/// where most of the change happens: nothing where the function is steep, but continuous. `f` gives its value or
/// nothing, which counts as no jump; `change` the size of the difference of two values.
template <class Function, class Change>
double jump_between(double low, double high, int halvings, Function&& f, Change&& change) {
  auto at_low = f(low), at_high = f(high);
  if (!at_low || !at_high) return 0;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    auto there = f(middle);
    if (!there) return 0;
    const bool below = change(*at_low, *there) > change(*there, *at_high);
    (below ? high : low) = middle;
    (below ? at_high : at_low) = std::move(there);
  }
  return change(*at_low, *at_high);
}

} // namespace microslip::validation
