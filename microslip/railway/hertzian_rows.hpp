#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/railway/contact_rows.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The loads of a contact's rows after Hertz, where the gap is a paraboloid: h = A (x - x0 - m (s - s0))^2 + B (s -
/// s0)^2
/// - delta in the rows' surface, fitted with the squared overlap as weight.
class HertzianRows {
public:
  explicit HertzianRows(std::size_t most_rows);

  /// Fits the paraboloid to the rows about the deepest one. Returns how far Hertz's solution holds: 1 where the rows
  /// are off by less than 1.5 % of the overlap (weighted rms), 0 beyond 3 %, where the fit is not about its middle, or
  /// where the bodies overlap elsewhere by more than 0.3 of the greatest overlap, smooth in between. Cost some 10 ns a
  /// row.
  double fit(std::span<const ContactRow> rows);

  /// Loads and half-lengths of the rows that were fitted; by how much the wheel is to be lowered [m] for a vertical
  /// force [N], 0 without it. Each row has what the ellipse loads of its width. Cost below a microsecond.
  double load(const CombinedMaterial& material, std::span<const NormalRow> rows, std::optional<double> vertical_force);
  /// Change of the vertical force with the lowering in the last load() [N/m].
  double stiffness() const { return stiffness_; }

  /// Size of the ellipse in the last load(): half the length of its middle row, half its width [m].
  double half_length() const { return length_; }
  double half_width() const { return half_width_; }
  /// Returns whether a row is one of those that were fitted.
  bool has(std::size_t row) const { return weight_[row] > 0; }

  std::span<const double> loads() const { return {load_.data(), count_}; }
  std::span<const double> half_lengths() const { return {half_length_.data(), count_}; }
  /// x of the rows' middles [m].
  std::span<const double> centres() const { return {centre_.data(), count_}; }

private:
  double find_weights(std::span<const ContactRow> rows);

  std::size_t count_ = 0;
  std::vector<double> weight_, load_, half_length_, centre_, place_;
  double s0_ = 0, x0_ = 0, skew_ = 0, along_ = 0, across_ = 0, overlap_ = 0, cosine_ = 1, stiffness_ = 0;
  double length_ = 0, half_width_ = 0;
};

} // namespace microslip
