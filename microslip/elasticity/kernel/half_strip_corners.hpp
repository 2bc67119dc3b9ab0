#pragma once

#include <cstddef>

namespace microslip::detail {

/// J1, J2 and r of HalfStrips at corners (x, y), y > 0, where only that of x = y = 0 would be of zero, which never
/// occurs. The same bits for every instruction set.
using FindCorners = void (*)(const double* x, std::size_t count, double y, double* j1, double* j2, double* r);

} // namespace microslip::detail
