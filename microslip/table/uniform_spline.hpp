#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Weights of the four B-splines of a spline on equidistant nodes, at a fraction f of an interval, and their
/// derivatives with respect to f. They sum to 1.
struct SplineWeights {
  std::array<double, 4> value, slope;
};

/// Of cubic splines.
inline SplineWeights cubic_weights(double f) {
  const double g = 1 - f;
  return {{g * g * g / 6, 2.0 / 3 - f * f * (1 - f / 2), 2.0 / 3 - g * g * (1 - g / 2), f * f * f / 6},
          {-g * g / 2, f * (1.5 * f - 2), g * (2 - 1.5 * g), f * f / 2}};
}

/// Of splines which between their nodes are made of 1, x, cos x and sin x, and so reproduce the first harmonics
/// exactly. `step` is the nodes' distance [rad], at most pi/3.
class TrigonometricWeights {
public:
  TrigonometricWeights() = default;
  explicit TrigonometricWeights(double step);

  SplineWeights operator()(double f) const {
    const double x = f * step_, y = step_ - x;
    const double first = scale_ * lag(y), last = scale_ * lag(x);
    const double first_slope = -slope_scale_ * rise(y), last_slope = slope_scale_ * rise(x);
    const double third = f + first - 2 * last, third_slope = 1 + first_slope - 2 * last_slope;
    return {{first, 1 - first - third - last, third, last},
            {first_slope, -first_slope - third_slope - last_slope, third_slope, last_slope}};
  }

private:
  /// x - sin x and 1 - cos x, to 1e-12 of their sizes.
  static double lag(double x) {
    const double q = x * x;
    return x * q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110 * (1 - q / 156)))));
  }
  static double rise(double x) {
    const double q = x * x;
    return q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90 * (1 - q / 132)))));
  }

  double step_ = 1, scale_ = 0, slope_scale_ = 0;
};

/// Finds the coefficients of a spline from its values: a matrix, as rows are short and many.
class SplineFilter {
public:
  /// The coefficients c_-1 to c_n of the cubic spline through the values at nodes 0 to n - 1, without jumps of the
  /// third derivative at nodes 1 and n - 2.
  static SplineFilter not_a_knot(int n);
  /// c_-1 to c_n+1 through the values at nodes 1 to n, the one at node 0 unknown: no jumps at nodes 1, 2 and n - 1.
  static SplineFilter without_first(int n);
  /// c_0 to c_n of a spline that is even or odd about node 0 through the values at nodes 0 to n - 1, then its
  /// derivative at node n - 1 with respect to the node's number.
  static SplineFilter clamped(int n, bool even);
  /// c_0 to c_n-1 of a spline that is even or odd about both its first and last node. `outer` is the weight of a node's
  /// neighbours, `outer` = 1/6 for cubic ones.
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
