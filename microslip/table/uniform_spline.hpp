#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace microslip {

/// Weights of the three B-splines of a quadratic spline at a point -1/2 <= f <= 1/2 from a node, in steps of the
/// equidistant nodes, and their derivatives with respect to f. The spline's pieces meet midway between nodes.
struct SplineWeights {
  std::array<double, 3> value, slope;
};

inline SplineWeights quadratic_weights(double f) {
  const double before = 0.5 - f, after = 0.5 + f;
  return {{before * before / 2, 0.75 - f * f, after * after / 2}, {-before, -2 * f, after}};
}

/// Splines which between their nodes are made of 1, cos x and sin x, and so reproduce the first harmonics exactly. The
/// first weight at f is scale (1 - cos((1/2 - f) step)), the last one that at -f, and all three sum to 1.
struct TrigonometricSpline {
  double step;  ///< the nodes' distance [rad], at most pi/3
  double scale; ///< 1/(2 (1 - cos step))

  explicit TrigonometricSpline(double nodes_distance)
      : step(nodes_distance), scale(1 / (2 * (1 - std::cos(nodes_distance)))) {}
  /// A node's weight in the values of its neighbours.
  double outer() const { return scale * (1 - std::cos(step / 2)); }
};

/// Numbers that stand side by side in every row of an array: `groups` times `width` of them, one group beginning
/// `distance` after the other.
struct SplineColumns {
  std::size_t width, groups = 1, distance = 0;
};

/// Finds the coefficients of splines from their values, of many at a time and in place: by elimination in the
/// band of the conditions on the coefficients, once for all splines.
class SplineFilter {
public:
  /// The coefficients c_-1 to c_n of the quadratic spline through the values at nodes 0 to n - 1, whose first two
  /// pieces and last two pieces are one polynomial.
  static SplineFilter not_a_knot(int n);
  /// c_-1 to c_n+1 through the values at nodes 1 to n, the one at node 0 unknown: the first three pieces and the last
  /// two are one polynomial.
  static SplineFilter without_first(int n);
  /// c_0 to c_n of a spline that is even or odd about node 0 through the values at nodes 0 to n - 1, then its
  /// derivative at node n - 1 with respect to the node's number.
  static SplineFilter clamped(int n, bool even);
  /// c_0 to c_n-1 of a spline that is even or odd about both its first and last node. `outer` is the weight of a node's
  /// neighbours, 1/8 for quadratic ones.
  static SplineFilter mirrored(int n, bool even, double outer);

  std::size_t coefficients() const { return rows_.size(); }
  /// Turns values into coefficients, one spline in each column: a row for each coefficient, `stride` apart, with the
  /// values in those from row `first_value` on. What other rows had is lost.
  void apply(double* rows, std::size_t stride, const SplineColumns& columns) const;
  std::size_t first_value() const { return first_value_; }

private:
  static constexpr int reach = 3; ///< of a condition to both sides
  /// One row of the factors of the conditions' matrix.
  struct Row {
    std::array<double, reach> lower = {}, upper = {}; ///< by the distance from the diagonal, less 1
    double per_pivot = 0;
  };
  class Conditions;
  SplineFilter(const Conditions& conditions, std::size_t first_value, std::size_t values);

  std::vector<Row> rows_;
  std::size_t first_value_, values_;
};

} // namespace microslip
