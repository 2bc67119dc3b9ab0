#include "microslip/exact/offset_kernel.hpp"

#include "microslip/elasticity/influence.hpp"

#include <cmath>

namespace microslip {
namespace {

/// The influence of an element on a point at an offset, of endless strips for a line contact.
Influence influence_at(const CombinedMaterial& material, const ElementGrid& grid, double x, double y) {
  if (!grid.line) return influence(material, grid.dx, grid.dy, x, y);
  return line_influence(material, grid.dx, x, grid.mx * grid.dx);
}

/// Calls at(i, j, x, y) for all offsets of a grid.
template <class At> void for_offsets(const ElementGrid& grid, At at) {
  for (int j = 1 - grid.my; j < grid.my; ++j)
    for (int i = 1 - grid.mx; i < grid.mx; ++i) at(i, j, i * grid.dx, j * grid.dy);
}

/// `influence_of` gives the influence at an offset.
template <class InfluenceOf> TangentialKernel tangential_kernel(const ElementGrid& grid, InfluenceOf influence_of) {
  check(grid);
  const OffsetTable empty(grid);
  TangentialKernel kernel{empty, empty, empty};
  for_offsets(grid, [&](int i, int j, double x, double y) {
    const Influence a = influence_of(x, y);
    kernel.xx.at(i, j) = a.xx;
    kernel.xy.at(i, j) = a.xy;
    kernel.yy.at(i, j) = a.yy;
  });
  return kernel;
}

} // namespace

OffsetTable normal_kernel(const CombinedMaterial& material, const ElementGrid& grid) {
  check(grid);
  OffsetTable zz(grid);
  for_offsets(grid, [&](int i, int j, double, double) { zz.at(i, j) = normal_coefficient(material, grid, i, j); });
  return zz;
}

double normal_coefficient(const CombinedMaterial& material, const ElementGrid& grid, int i, int j) {
  return influence_at(material, grid, i * grid.dx, j * grid.dy).zz;
}

TangentialKernel TangentialKernel::displacement(const CombinedMaterial& material, const ElementGrid& grid, double shift,
                                                double length) {
  return tangential_kernel(grid, [&](double x, double y) {
    const Influence a = influence_at(material, grid, x + shift, y);
    return Influence{a.xx / length, a.xy / length, a.yy / length, 0, 0, 0};
  });
}

TangentialKernel TangentialKernel::growth(const CombinedMaterial& material, const ElementGrid& grid, double step) {
  return tangential_kernel(grid, [&](double x, double y) {
    const Influence now = influence_at(material, grid, x, y);
    const Influence before = influence_at(material, grid, x + step, y);
    const double rate = 1 / std::abs(step);
    return Influence{(now.xx - before.xx) * rate, (now.xy - before.xy) * rate, (now.yy - before.yy) * rate, 0, 0, 0};
  });
}

} // namespace microslip
