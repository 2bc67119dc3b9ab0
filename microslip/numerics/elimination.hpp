#pragma once

#include "microslip/numerics/instruction_set.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace microslip {

/// Solves A x = b for a number of right-hand sides by Gauss's elimination with row exchange, in place: `rows` are A's
/// rows of `order` numbers, each with one number of every side behind, and any numbers that fill it up: rows of a
/// multiple of 8 numbers are the fastest. The sides become the solutions, A is overwritten. False for a matrix that is
/// singular. Cost some order^3/3 multiplications.
bool eliminate(std::span<double> rows, std::size_t order, std::size_t sides,
               InstructionSet instruction_set = best_instruction_set());

/// Solves A x = b of a few unknowns; nothing for a matrix that is singular.
template <std::size_t n>
std::optional<std::array<double, n>> solve_linear(const std::array<double, n * n>& a, const std::array<double, n>& b) {
  std::array<double, n*(n + 1)> rows;
  for (std::size_t i = 0; i < n; ++i) std::copy_n(&a[n * i], n, &rows[(n + 1) * i]), rows[(n + 1) * i + n] = b[i];
  if (!eliminate(rows, n, 1)) return {};
  std::array<double, n> x;
  for (std::size_t i = 0; i < n; ++i) x[i] = rows[(n + 1) * i + n];
  return x;
}

} // namespace microslip
