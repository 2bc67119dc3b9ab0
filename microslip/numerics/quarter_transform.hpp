#pragma once

#include <vector>

namespace microslip {

/// Of a function on the plane, in both components of its argument.
enum class Parity { even, odd };

/// Fourier transform of a periodic function that is even in both directions, or odd in both, from its values on a
/// quarter of the period, in place: rows x columns values at the offsets 0 .. half the period of 2 (columns - 1) and 2
/// (rows - 1), index j columns + i. Such a transform is real, has the same symmetry and is known on a quarter of the
/// wave numbers. Unscaled: the sum of the function over its period is the value at 0. A single row or column is not
/// transformed across (even functions only). Cost O(N log N).
void transform_quarter(int columns, int rows, Parity parity, std::vector<double>& quarter);

} // namespace microslip
