#include "microslip/numerics/transforms.hpp"

#include <algorithm>
#include <array>

namespace microslip {

int quick_size(int n) {
  // By trial: other even sizes take as long as the next of these, or longer.
  constexpr std::array small = {2, 4, 8, 12, 16, 20, 24, 32, 40, 48, 50, 64, 72, 80, 96, 100, 108};
  if (n <= small.back()) return *std::lower_bound(small.begin(), small.end(), n);
  const auto has_small_factors = [](int size) {
    for (const int factor : {2, 3, 5})
      while (size % factor == 0) size /= factor;
    return size == 1;
  };
  int eighth = (n + 7) / 8;
  while (!has_small_factors(eighth)) ++eighth;
  return 8 * eighth;
}

} // namespace microslip
