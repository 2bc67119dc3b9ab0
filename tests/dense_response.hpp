#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/bilinear_influence.hpp"
#include "tests/support/fields.hpp"

#include <vector>

namespace microslip {

/// A field for each direction of the contact plane.
struct PlaneFields {
  Field x, y;
};

/// Of an element of the grid on the point (x, y) from its centre.
inline Influence element_influence(const CombinedMaterial& material, const ElementGrid& grid, double x, double y) {
  const double far = grid.mx * grid.dx;
  if (grid.shape == ElementShape::bilinear)
    return grid.line ? bilinear_line_influence(material, grid.dx, x, far)
                     : bilinear_influence(material, grid.dx, grid.dy, x, y);
  return grid.line ? line_influence(material, grid.dx, x, far) : influence(material, grid.dx, grid.dy, x, y);
}

/// Calls add(I, J, influence of element J on the centre of element I moved by `shift` along x) for all pairs.
template <class Add> void for_pairs(const CombinedMaterial& material, const ElementGrid& grid, double shift, Add add) {
  for (int rows = 1 - grid.my; rows < grid.my; ++rows)
    for (int columns = 1 - grid.mx; columns < grid.mx; ++columns) {
      const Influence a = element_influence(material, grid, columns * grid.dx + shift, rows * grid.dy);
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          if (const int l = j - rows, k = i - columns; l >= 0 && l < grid.my && k >= 0 && k < grid.mx)
            add(static_cast<std::size_t>(j) * grid.mx + i, static_cast<std::size_t>(l) * grid.mx + k, a);
    }
}

/// u = A p at the elements' centres moved by `shift` along x, summed pair by pair.
inline PlaneFields dense_displacement(const CombinedMaterial& material, const ElementGrid& grid, const Field& px,
                                      const Field& py, double shift = 0) {
  PlaneFields u{Field(px.size(), 0.0), Field(px.size(), 0.0)};
  for_pairs(material, grid, shift, [&](std::size_t to, std::size_t from, const Influence& a) {
    u.x[to] += a.xx * px[from] + a.xy * py[from];
    u.y[to] += a.xy * px[from] + a.yy * py[from];
  });
  return u;
}

inline Field dense_normal_displacement(const CombinedMaterial& material, const ElementGrid& grid,
                                       const Field& pressure) {
  Field u(pressure.size(), 0.0);
  for_pairs(material, grid, 0,
            [&](std::size_t to, std::size_t from, const Influence& a) { u[to] += a.zz * pressure[from]; });
  return u;
}

} // namespace microslip
