#include "microslip/elasticity/shore_hardness.hpp"

#include "microslip/error.hpp"

namespace microslip {
namespace {

constexpr double scale = 0.0981e6 / 0.137505;  // [Pa]
constexpr double preload = 56, load = 7.62336; // of the spring: at S = 0, per unit of S [gf]
constexpr double depth = 2.54;                 // of the indentation, per unit of 100 - S [0.01 mm]

constexpr double gent(double hardness) {
  return scale * (preload + load * hardness) / (depth * (100 - hardness));
}

} // namespace

double young_modulus_of_shore_a(double hardness) {
  return gent(require_between("shore_a", hardness, "-", softest_shore_a, hardest_shore_a));
}

double shore_a_of_young_modulus(double young_modulus) {
  require_between("young_modulus", young_modulus, "Pa", gent(softest_shore_a), gent(hardest_shore_a));
  const double relative = depth * young_modulus / scale;
  return (100 * relative - preload) / (load + relative);
}

} // namespace microslip
