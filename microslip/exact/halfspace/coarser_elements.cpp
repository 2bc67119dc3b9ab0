#include "microslip/exact/halfspace/coarser_elements.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

/// Elements along an axis in a coarser one.
int step_of(int m) {
  return m > 1 ? 2 : 1;
}
int coarser(int m) {
  return (m + 1) / 2;
}

/// The coarser element around an element, its neighbour on the side where the element lies, and that one's share.
struct Interpolation {
  int around, beside;
  double share;
};
Interpolation interpolation_at(int i, int m) {
  if (m == 1) return {0, 0, 0};
  return {i / 2, std::clamp(i / 2 + (i % 2 == 0 ? -1 : 1), 0, coarser(m) - 1), 0.25};
}

} // namespace

ElementGrid coarser_grid(const ElementGrid& grid) {
  const int sx = step_of(grid.mx), sy = step_of(grid.my);
  ElementGrid coarse = grid;
  coarse.mx = coarser(grid.mx);
  coarse.my = coarser(grid.my);
  coarse.x0 += (sx - 1) * grid.dx / 2;
  coarse.y0 += (sy - 1) * grid.dy / 2;
  coarse.dx *= sx;
  coarse.dy *= sy;
  return coarse;
}

std::vector<double> mean_on_coarser(const ElementGrid& grid, std::span<const double> field) {
  if (field.empty()) return {};
  const int mx = coarser(grid.mx), my = coarser(grid.my), sx = step_of(grid.mx), sy = step_of(grid.my);
  std::vector<double> coarse(static_cast<std::size_t>(mx) * my);
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i) {
      const int rows = std::min(sy, grid.my - sy * j), columns = std::min(sx, grid.mx - sx * i);
      double& mean = coarse[static_cast<std::size_t>(j) * mx + i];
      for (int l = 0; l < rows; ++l)
        for (int k = 0; k < columns; ++k)
          mean += field[(static_cast<std::size_t>(sy) * j + l) * grid.mx + static_cast<std::size_t>(sx) * i + k] /
                  (rows * columns);
    }
  return coarse;
}

std::vector<double> pressure_from_coarser(const ElementGrid& grid, std::span<const double> coarse_pressure) {
  const int mx = coarser(grid.mx);
  const double peak = *std::max_element(coarse_pressure.begin(), coarse_pressure.end());
  const auto square = [&](int i, int j) { // of p_n over the peak, so that it does not overflow
    const double p = coarse_pressure[static_cast<std::size_t>(j) * mx + i] / peak;
    return p * p;
  };
  std::vector<double> fine(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const Interpolation x = interpolation_at(i, grid.mx), y = interpolation_at(j, grid.my);
      const double around = (1 - x.share) * square(x.around, y.around) + x.share * square(x.beside, y.around);
      const double beside = (1 - x.share) * square(x.around, y.beside) + x.share * square(x.beside, y.beside);
      fine[static_cast<std::size_t>(j) * grid.mx + i] = peak * std::sqrt((1 - y.share) * around + y.share * beside);
    }
  return fine;
}

} // namespace microslip
