#include "microslip/exact/halfspace/memory_need.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/numerics/gmres.hpp"
#include "microslip/numerics/toeplitz.hpp"

#include <algorithm>
#include <string>

#ifdef _WIN32
#include <windows.h>
#else
#include <unistd.h>
#endif

namespace microslip {
namespace {

std::string gibibytes(double bytes) {
  return rounded_text(bytes / 0x1p30, 3) + " GiB";
}

std::string size_of(const ElementGrid& grid) {
  return std::to_string(grid.mx) + " x " + std::to_string(grid.my) + " elements";
}

ElementGrid scaled(ElementGrid grid, double scale) {
  grid.mx = std::max(1, static_cast<int>(scale * grid.mx));
  grid.my = std::max(1, static_cast<int>(scale * grid.my));
  return grid;
}

} // namespace

double memory_need(ContactProblem problem, const ElementGrid& grid) {
  const double elements = double(grid.mx) * grid.my, real = sizeof(double);
  const double transform = 2 * real * static_cast<double>(ToeplitzTransform::padded_size(grid.mx, grid.my));
  const double table = real * (2.0 * grid.mx - 1) * (2.0 * grid.my - 1);
  if (problem == ContactProblem::normal) return 3 * transform + table + 8 * real * elements;
  if (problem == ContactProblem::second_order)
    return 4.0 / 3 * (4 * transform + 64 * real * elements + 100 * 2 * real * elements);
  if (problem == ContactProblem::coupled)
    return 33 * transform + 17 * table + 88 * real * elements + 3 * real * elements * (most_gmres_products + 1);
  const double basis = 2 * real * elements * (most_gmres_products + 1);
  return 18 * transform + 4 * table + 50 * real * elements + basis;
}

ElementGrid largest_grid(ContactProblem problem, const ElementGrid& grid, double memory) {
  if (memory_need(problem, grid) <= memory) return grid;
  double fits = 0, too_large = 1;
  while (too_large - fits > 1e-12) {
    const double scale = (fits + too_large) / 2;
    (memory_need(problem, scaled(grid, scale)) <= memory ? fits : too_large) = scale;
  }
  return scaled(grid, fits);
}

double physical_memory() {
#ifdef _WIN32
  MEMORYSTATUSEX memory{};
  memory.dwLength = sizeof memory;
  return GlobalMemoryStatusEx(&memory) ? static_cast<double>(memory.ullTotalPhys) : 0.0;
#else
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
#endif
}

const ElementGrid& require_memory(ContactProblem problem, const ElementGrid& grid) {
  check(grid);
  const double need = memory_need(problem, grid), memory = physical_memory();
  if (need <= memory) return grid;
  throw Error("grid: the " + std::string(problem == ContactProblem::normal ? "normal" : "tangential") + " problem on " +
              size_of(grid) + " needs " + gibibytes(need) + " of memory, and this machine has " + gibibytes(memory) +
              "; the largest grid of this shape that fits has " + size_of(largest_grid(problem, grid, memory)));
}

} // namespace microslip
