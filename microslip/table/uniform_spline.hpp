#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Weights of the three B-splines of a quadratic spline at a place -1/2 <= f <= 1/2 from a node, in steps of the
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

/// Finds the coefficients of a spline from its values: a matrix, as rows are short and many.
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

  int values() const { return columns_; }
  int coefficients() const { return rows_; }
  /// What coefficient number `row` takes of value number `column`.
  double weight(int row, int column) const { return matrix_[std::size_t(row * columns_ + column)]; }
  /// From every `value_stride`-th value to every `coefficient_stride`-th coefficient.
  void apply(const double* values, std::size_t value_stride, double* coefficients,
             std::size_t coefficient_stride) const;

private:
  /// From the conditions on the coefficients, row by row, of which the first are those with a value.
  SplineFilter(std::vector<double> conditions, int size, int values);

  int rows_, columns_;
  std::vector<double> matrix_;
};

} // namespace microslip
