#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace microslip {

/// Several functions of one variable on panels of equal width: on each the polynomials of degree 11 through their
/// values at 12 Chebyshev points. For functions that are analytic up to the distance d from a panel of half width a the
/// error is some rho^-12, rho = d/a + sqrt(1 + (d/a)^2).
class PanelPolynomials {
public:
  static constexpr std::size_t nodes = 12; ///< of a panel

  /// Sets the values at the nodes of a panel, index node functions + function.
  using Values = std::function<void(std::span<const double, nodes> at, std::span<double> values)>;

  /// Panels of the width `width` from `from` on, which reach `to`. `values` is called once for each panel, from several
  /// threads.
  PanelPolynomials(double from, double to, double width, std::size_t functions, const Values& values);
  /// No panels yet.
  PanelPolynomials(double from, double width, std::size_t functions);

  /// Adds panels until they reach `to`; those that are there stay as they are.
  void extend(double to, const Values& values);

  std::size_t functions() const { return functions_; }
  double from() const { return from_; }
  /// Values at t, of all functions; beyond the panels those at their ends.
  void evaluate(double t, std::span<double> out) const;

private:
  double from_, width_;
  std::size_t panels_ = 0, functions_;
  std::vector<double> coefficient_; ///< index (panel nodes + power) functions + function; of x in [-1, 1]
};

} // namespace microslip
