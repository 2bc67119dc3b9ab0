// Logarithms and roots at the corners of half strips, compiled once for every instruction set.

#include "microslip/elasticity/kernel/half_strip_corners.hpp"

#include "microslip/numerics/vector_log.hpp"

#include <cmath>

namespace microslip::detail {
namespace {

void find_corners(const double* x, std::size_t count, double y, double* j1, double* j2, double* r) {
  const double twice_log_y = 2 * vector_log(y);
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = std::abs(x[k]), root = std::sqrt(x[k] * x[k] + y * y);
    const double log = vector_log(distance + root); // without cancellation: (x + r)(r - x) = y^2
    j1[k] = y * (x[k] >= 0 ? log : twice_log_y - log);
    j2[k] = x[k] * vector_log(y + root);
    r[k] = root;
  }
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

FindCorners corners_of_half_strips() {
  return find_corners;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
