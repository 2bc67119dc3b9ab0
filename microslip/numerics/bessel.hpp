#pragma once

#include <cmath>

#ifdef _WIN32 // its C library has Bessel's functions, which headers leave out in standard C++
extern "C" double j0(double);
extern "C" double j1(double);
#endif

namespace microslip {

/// Bessel's functions J0, J1 and J2 at x >= 0.
struct BesselFunctions {
  double j0, j1, j2;
};
inline BesselFunctions bessel_functions(double x) {
  const double j0 = ::j0(x), j1 = ::j1(x);
  return {j0, j1, x > 0 ? 2 * j1 / x - j0 : 0};
}

/// J3(x) from the others, below 1/2 by its series, where the recursion would lose digits.
inline double bessel_j3(double x, const BesselFunctions& of_x) {
  if (x > 0.5) return 4 * of_x.j2 / x - of_x.j1;
  const double q = x * x;
  return x * q / 48 * (1 - q / 16 * (1 - q / 40 * (1 - q / 72 * (1 - q / 112))));
}

} // namespace microslip
