#pragma once

#include <version>

/// microslip::simd: std::experimental::simd where the standard library has all of it, as libstdc++ has; else ours.
#ifdef __GLIBCXX__
#include <experimental/simd>
namespace microslip {
namespace simd = std::experimental;
}
#else
#include "microslip/numerics/vector_simd.hpp"
namespace microslip {
namespace simd = vector_simd;
}
#endif
