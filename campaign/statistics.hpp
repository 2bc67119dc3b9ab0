#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace microslip::campaign {

/// A quantile and the interval that has it with a probability of 95 %, whatever the distribution: between the values of
/// the ranks n p -+ 1.96 sqrt(n p (1 - p)), or the least and the largest one where there are none so far out.
struct Quantile {
  double probability = 0, value = 0, low = 0, high = 0;
};

/// What a sample of independent values says of their distribution.
struct Spread {
  std::size_t count = 0;
  double mean = 0, mean_error = 0; ///< with its standard error, standard deviation / sqrt(count)
  double standard_deviation = 0;   ///< with count - 1; 0 of one value
  double least = 0, largest = 0;
  std::vector<Quantile> quantiles;
};

/// Of values that are not NaN; `probabilities` in (0, 1). Quantiles lie between two values by p (n - 1), counted from
/// 0. Values of Sobol's sequence or a Latin hypercube err less than the intervals say. Cost O(n log n). All is NaN
/// without values.
Spread spread_of(std::span<const double> values, std::span<const double> probabilities);

/// Share of a quantity's variance that a parameter has alone (first order) and with all others (total), with their
/// standard errors.
struct SobolIndex {
  double first = 0, first_error = 0, total = 0, total_error = 0;
};

/// Indices of each parameter from the values of a sample's cases in their order, see Sample: with the deviations a, b
/// and c_k of the cases A, B and the one of parameter k from the mean of A and B, and v = (a^2 + b^2)/2, means of the
/// points give T_k = (a - c_k)^2/2 over v (Jansen 1999), and S_k = b (c_k - a) over v (Saltelli et al. 2010), which is
/// sharp for parameters that matter little, or v - (b - c_k)^2/2 over v (Jansen), for those that matter much: the
/// average of both that scatters least. Errors are those of ratios of means. Points with a NaN are left out. All is
/// NaN where nothing varies.
std::vector<SobolIndex> sobol_indices(std::span<const double> values, std::size_t parameters);

} // namespace microslip::campaign
