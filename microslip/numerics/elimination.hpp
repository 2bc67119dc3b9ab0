#pragma once

#include <initializer_list>
#include <span>

namespace microslip {

/// Solves A x = b by Gauss's elimination with row exchange for each of the right-hand sides, in place; `matrix` is A
/// row by row and is overwritten, its order is the size of the sides. False for a matrix that is singular. Cost some
/// n^3/3 multiplications.
bool eliminate(std::span<double> matrix, std::initializer_list<std::span<double>> sides);

} // namespace microslip
