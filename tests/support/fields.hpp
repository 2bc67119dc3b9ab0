#pragma once

#include "microslip/contact/element_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace microslip {

using Field = std::vector<double>;

/// f(x, y) at the centres of a grid's elements.
template <class F> Field over_grid(const ElementGrid& grid, F f) {
  Field values;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) values.push_back(f(grid.x(i), grid.y(j)));
  return values;
}

/// Numbers in [-size, size), the same everywhere for a seed.
inline Field random_field(std::size_t count, unsigned seed, double size = 1) {
  std::mt19937 engine(seed);
  Field field(count);
  for (double& value : field) value = size * (static_cast<double>(engine()) * 0x1p-31 - 1);
  return field;
}

/// The largest size of a value.
inline double largest(const Field& field) {
  double most = 0;
  for (const double value : field) most = std::max(most, std::abs(value));
  return most;
}

inline double sum(const Field& field) {
  return std::accumulate(field.begin(), field.end(), 0.0);
}

} // namespace microslip
