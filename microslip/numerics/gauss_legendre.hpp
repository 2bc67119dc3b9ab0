#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// Gauss's quadrature with n nodes: exact for polynomials up to the degree 2 n - 1.
class GaussLegendre {
public:
  /// Nodes are the zeros of Legendre's polynomial, by Newton's method from cos(pi (k + 3/4)/(n + 1/2)).
  explicit GaussLegendre(int n);

  std::size_t count() const { return node_.size(); }
  double node(std::size_t k, double from, double to) const { return (from + to) / 2 + (to - from) / 2 * node_[k]; }
  double weight(std::size_t k, double from, double to) const { return (to - from) / 2 * weight_[k]; }

private:
  std::vector<double> node_, weight_; ///< of [-1, 1], ascending
};

} // namespace microslip
