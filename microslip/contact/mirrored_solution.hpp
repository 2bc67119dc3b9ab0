#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace microslip {

/// Mirrors a contact in the plane x, z: turns one of a left wheel into one of a right wheel and back.
/// Fields that are odd (field_quantities()), lateral components, spin and the moment change their sign; rows are
/// reversed, so that y ascends again.
void mirror(ContactSolution& solution);

/// Changes the sign of the numbers that a table of quantities has as odd.
template <class Of, class Table> void mirror_numbers(Of& of, const Table& table) {
  for (const auto& quantity : table)
    if (double* odd = quantity.odd(of)) *odd = -*odd;
}

/// Reverses the order of a field's rows of mx elements; an empty field stays.
template <class Value> void reverse_rows(std::vector<Value>& field, int mx) {
  const auto row = static_cast<std::ptrdiff_t>(mx);
  for (auto low = field.begin(), high = field.end(); high - low >= 2 * row; low += row, high -= row)
    std::swap_ranges(low, low + row, high - row);
}

} // namespace microslip
