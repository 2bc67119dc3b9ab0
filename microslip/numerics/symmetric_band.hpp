#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Symmetric positive definite matrix with `width` diagonals on either side of its own one, then its factors L D L'
/// without pivoting. Cost O(n width^2), of a solution O(n width).
template <std::size_t width> class SymmetricBand {
public:
  /// Entries of a column from its diagonal downwards; of the factors a pivot and the column of L below it.
  using Column = std::array<double, width + 1>;

  explicit SymmetricBand(std::size_t size = 0) : columns_(size) {}
  std::size_t size() const { return columns_.size(); }
  Column& operator[](std::size_t j) { return columns_[j]; }

  void factorise() {
    for (std::size_t j = 0; j < size(); ++j) {
      Column& column = columns_[j];
      for (std::size_t before = 1; before <= std::min(j, width); ++before) {
        const Column& done = columns_[j - before];
        for (std::size_t offset = 0; before + offset <= width; ++offset)
          column[offset] -= done[before] * done[before + offset] * done[0];
      }
      for (std::size_t offset = 1; offset <= width; ++offset) column[offset] /= column[0];
    }
  }

  /// Solves with the factors, in place.
  void solve(std::span<double> x) const {
    for (std::size_t j = 0; j < size(); ++j)
      for (std::size_t before = 1; before <= std::min(j, width); ++before)
        x[j] -= columns_[j - before][before] * x[j - before];
    for (std::size_t j = size(); j-- > 0;) {
      x[j] /= columns_[j][0];
      for (std::size_t after = 1; after <= width && j + after < size(); ++after)
        x[j] -= columns_[j][after] * x[j + after];
    }
  }

  /// The diagonal of the inverse, from the factors and the inverse's own band, last column first (Takahashi, Fagan and
  /// Chin 1973).
  std::vector<double> inverse_diagonal() const {
    std::vector<Column> inverse(size());
    const auto entry = [&](std::size_t i, std::size_t j) { return i < j ? inverse[i][j - i] : inverse[j][i - j]; };
    std::vector<double> diagonal(size());
    for (std::size_t j = size(); j-- > 0;) {
      const Column& factor = columns_[j];
      const std::size_t below = std::min(width, size() - 1 - j);
      for (std::size_t row = below; row > 0; --row)
        for (std::size_t k = 1; k <= below; ++k) inverse[j][row] -= factor[k] * entry(j + k, j + row);
      inverse[j][0] = 1 / factor[0];
      for (std::size_t k = 1; k <= below; ++k) inverse[j][0] -= factor[k] * inverse[j][k];
      diagonal[j] = inverse[j][0];
    }
    return diagonal;
  }

private:
  std::vector<Column> columns_;
};

} // namespace microslip
