#pragma once

#include <limits>

namespace microslip::campaign {

/// Probability distribution of a number.
struct Distribution {
  /// In the order of their words in files, which have one more: the values of a table, each with the same probability.
  enum class Kind { uniform, normal, log_normal, triangular };

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Kind kind = Kind::uniform;
  /// Ends of a uniform and of a triangular one; a normal or log-normal one is cut off there.
  double from = -infinity, to = infinity;
  bool is_logarithmic = false; ///< uniform: not the number but its logarithm is
  /// Normal and log-normal: of the number itself, before it is cut off.
  double mean = 0, standard_deviation = 0;
  double mode = 0; ///< triangular: where the density has its peak

  /// Throws Error for ends of two signs with a logarithm, a log-normal mean or any standard deviation that is not
  /// positive, a mode that is not between the ends, and ends between which there is nothing.
  void check() const;

  /// Number below which a fraction `part` in [0, 1] of them lies; finite for `part` 0 and 1, too.
  double quantile(double part) const;

private:
  double uncut(double part) const;
};

/// Quantile function of the standard normal distribution, for `part` in (0, 1), and its inverse, within some 1e-15.
double normal_quantile(double part);
double normal_probability(double score);

} // namespace microslip::campaign
