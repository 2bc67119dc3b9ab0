#pragma once

namespace microslip {

/// Tanh-sinh quadrature (Takahasi & Mori 1974) with 37 nodes: indifferent to singularities at the ends of the interval.
class TanhSinh {
public:
  TanhSinh();

  static constexpr int count = 37;

  /// The nodes of [from, to], ascending, right to rounding relative to the nearer end, and their weights.
  double node(int k, double from, double to) const {
    const double inside = (to - from) / 2 * distance_[k];
    return k < count / 2 ? from + inside : to - inside;
  }
  double weight(int k, double from, double to) const { return (to - from) / 2 * weight_[k]; }

private:
  double distance_[count]; ///< of a node from the nearer end, in units of the half interval
  double weight_[count];
};

} // namespace microslip
