#pragma once

#include "campaign/sample_points.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace microslip::campaign {

/// What the cases of a sample are for, in the order of their words in files.
enum class SampleAim {
  quantiles,    ///< a case for each point
  sobol_indices ///< keys + 2 cases for each, see Sample
};

/// Correlation of the normal scores of two parameters, by their places.
struct Correlation {
  std::size_t first, second;
  double value; ///< in (-1, 1)
};

/// Which part of its distribution each parameter has in each case of a random sample.
///
/// For Sobol's indices a point is a pair of values for each parameter, and gives a case A with the first values, a
/// case B with the second ones, and for each parameter a case that differs from A in it alone, where it is as in B
/// (Saltelli et al. 2010). They follow each other.
class Sample {
public:
  /// Throws Error if correlations contradict each other: their matrix must be positive definite.
  Sample(SampleAim aim, PointSet set, std::size_t points, std::uint64_t seed, std::vector<std::string> names,
         const std::vector<Correlation>& correlations);

  std::size_t points() const { return points_; }
  SampleAim aim() const { return aim_; }
  /// Cases of a point: 1, or parameters + 2.
  std::size_t cases_of_point() const { return aim_ == SampleAim::quantiles ? 1 : parameters_ + 2; }
  std::size_t cases() const { return points_ * cases_of_point(); }

  /// In [0, 1), of parameter `k` in a case. Correlated ones are joined by their normal scores (a Gaussian copula).
  double part(std::size_t index, std::size_t k) const;

private:
  void factorise(const std::vector<Correlation>& correlations);

  SampleAim aim_;
  std::size_t points_, parameters_;
  SamplePoints at_;
  std::vector<double>
      factor_; ///< lower triangle by rows of Cholesky's factor of the correlations; empty: there are none
};

} // namespace microslip::campaign
