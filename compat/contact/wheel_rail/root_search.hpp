#pragma once

#include <optional>

namespace microslip::contact_program {

/// Finds where a continuous function is zero: steps that double until it changes its sign, then straight lines between
/// the nearest points on either side, the staying one's value halved (Illinois).
class RootSearch {
public:
  /// The first step, of either sign, goes from the first point.
  explicit RootSearch(double first_step) : step_(first_step) {}

  /// The argument to try next after this value.
  double next(double x, double value);
  /// The length of the bracket; none before there is one.
  std::optional<double> width() const;

private:
  struct Point {
    double x = 0, value = 0;
  };

  double step_;
  std::optional<Point> last_, other_; ///< on either side of the zero once both are there
  bool bracketed_ = false;
};

} // namespace microslip::contact_program
