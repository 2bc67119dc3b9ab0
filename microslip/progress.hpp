#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>

namespace microslip {

/// Called by long work with the fraction done, 0 to 1: after every iteration, between the products of the linear
/// solvers and between the rows of influence coefficients. Returning false asks the work to stop.
using Progress = std::function<bool(double fraction)>;

/// Ends work that has nothing to hand back yet, as it prepares for a grid, when its progress function returns false.
class Stopped : public std::exception {
public:
  const char* what() const noexcept override { return "ended by the progress function"; }
};

/// Tells of the fraction done. Throws Stopped if the work is to stop.
inline void go_on(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Stopped();
}

/// Progress of a part of the work, from one fraction of the whole to another; `whole` must outlive it.
inline Progress part(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double fraction) { return whole(from + (to - from) * fraction); };
}

/// The same of a part that the rest cannot do without: it ends with Stopped.
inline Progress essential_part(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double fraction) {
    go_on(whole, from + (to - from) * fraction);
    return true;
  };
}

/// The fraction done of an iteration whose residual was `first`, is `now` and has to fall to `goal`: of the digits.
inline double digits_done(double first, double now, double goal) {
  return goal > 0 && now < first ? std::min(1.0, std::log(first / now) / std::log(first / goal)) : 0;
}

} // namespace microslip
