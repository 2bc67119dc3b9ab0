#pragma once

#include "small_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

/// A run in equal steps. The first component of the states is the lateral displacement [m].
template <std::size_t N> struct History {
  double step = 0; ///< [s]
  std::vector<Vector<N>> states = {};
  long newton_iterations = 0, jacobians = 0, halvings = 0, jumps = 0; ///< of the integrator
  double seconds = 0;                                                 ///< of computing time
  double contact_seconds = 0;                                         ///< what of it the contact law took
  long contacts = 0;                                                  ///< solved, with derivatives or without

  double duration() const { return step * static_cast<double>(states.size() - 1); }

  /// Extreme values of the lateral displacement, by a parabola through three points, and when they are reached.
  struct Peak {
    double time, value;
  };
  std::vector<Peak> peaks() const {
    std::vector<Peak> found;
    for (std::size_t k = 1; k + 1 < states.size(); ++k) {
      const double before = states[k - 1][0], here = states[k][0], after = states[k + 1][0];
      if ((here - before) * (after - here) > 0 || here == before) continue;
      const double slope = (after - before) / 2, curvature = after - 2 * here + before, shift = -slope / curvature;
      found.push_back({(static_cast<double>(k) + shift) * step, here + slope * shift / 2});
    }
    return found;
  }

  /// Largest |y| of the last `duration` seconds.
  double amplitude(double duration) const {
    const auto count = std::min<std::size_t>(states.size(), static_cast<std::size_t>(duration / step));
    double largest = 0;
    for (std::size_t k = states.size() - count; k < states.size(); ++k)
      largest = std::max(largest, std::abs(states[k][0]));
    return largest;
  }

  /// Growth rate of the peaks [1/s], by least squares through the logarithms of those after `from` [s].
  double growth_rate(double from) const {
    double n = 0, sum_t = 0, sum_l = 0, sum_tt = 0, sum_tl = 0;
    for (const Peak& peak : peaks()) {
      if (peak.time < from) continue;
      const double l = std::log(std::abs(peak.value));
      n += 1, sum_t += peak.time, sum_l += l, sum_tt += peak.time * peak.time, sum_tl += peak.time * l;
    }
    return (n * sum_tl - sum_t * sum_l) / (n * sum_tt - sum_t * sum_t);
  }
};
