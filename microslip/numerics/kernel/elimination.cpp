// Gauss's elimination, compiled once for every instruction set.

#include "microslip/numerics/kernel/elimination.hpp"

#include "microslip/numerics/lanes.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip::detail {
namespace {

using Vector = Lanes<double>;

double* row_of(double* rows, int k, int stride) {
  return rows + static_cast<std::ptrdiff_t>(k) * stride;
}

/// Takes `factor` times a row off another one, from a column on.
void subtract(double* row, const double* other, double factor, int column, int columns) {
  const Vector factors = factor;
  for (; column + Vector::width <= columns; column += Vector::width)
    (Vector::load(row + column) - factors * Vector::load(other + column)).store(row + column);
  for (; column < columns; ++column) row[column] -= factor * other[column];
}

/// The row with the largest number of a column, from the k-th on.
int pivot_of(const double* rows, int k, int order, int stride) {
  int pivot = k;
  double largest = std::abs(rows[k * stride + k]);
  for (int i = k + 1; i < order; ++i) {
    const double size = std::abs(rows[i * stride + k]);
    if (size > largest) largest = size, pivot = i;
  }
  return pivot;
}

void substitute_back(double* rows, int order, int side, int stride) {
  for (int k = order; k-- > 0;) {
    double* const row = row_of(rows, k, stride);
    const double x = row[side] /= row[k];
    for (int i = 0; i < k; ++i) rows[i * stride + side] -= rows[i * stride + k] * x;
  }
}

bool eliminate(double* rows, int order, int sides, int stride) {
  for (int k = 0; k < order; ++k) {
    const int pivot = pivot_of(rows, k, order, stride);
    double* const row = row_of(rows, k, stride);
    if (!(std::abs(rows[pivot * stride + k]) > 0)) return false;
    if (pivot != k)
      for (int j = k; j < stride; ++j) std::swap(row[j], rows[pivot * stride + j]);
    const double inverse = 1 / row[k];
    const int block = k / Vector::width * Vector::width; // columns before k are not used any more
    for (int i = k + 1; i < order; ++i) {
      double* const below = row_of(rows, i, stride);
      subtract(below, row, below[k] * inverse, block, stride);
    }
  }
  for (int side = order; side < order + sides; ++side) substitute_back(rows, order, side, stride);
  return true;
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

EliminateRows eliminate_rows() {
  return eliminate;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
