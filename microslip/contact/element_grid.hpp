#pragma once

#include <cstddef>

namespace microslip {

/// Interpolation of tractions and pressures between the elements' centres.
enum class ElementShape {
  constant, ///< the same all over an element
  bilinear, ///< from a centre's value linearly to zero at the next centres along x and y; so they reach half an element
            ///< beyond the outermost elements
};

/// The potential contact: mx x my equal rectangles. Element (i, j) has index j mx + i, x and y ascending.
struct ElementGrid {
  int mx = 0, my = 0;
  double x0 = 0, y0 = 0; ///< centre of the first element [m]
  double dx = 0, dy = 0; ///< sides of an element [m]

  bool line = false; ///< line contact: one row, endless in y; dy is the length that forces are counted for
  ElementShape shape = ElementShape::constant;

  std::size_t count() const { return static_cast<std::size_t>(mx) * my; }
  double x(int i) const { return x0 + i * dx; }
  double y(int j) const { return y0 + j * dy; }
  double element_area() const { return dx * dy; }

  /// n x m elements across an ellipse with its centre at the origin, and `margin` more on each side.
  static ElementGrid across_ellipse(double a, double b, int n, int m, int margin);
  static ElementGrid across_ellipse(double a, double b, int n, int margin = 0) {
    return across_ellipse(a, b, n, n, margin);
  }
  /// n elements across a line contact of half-width a, and `margin` more on each side; forces per `length` [m].
  static ElementGrid across_line(double a, int n, int margin = 0, double length = 1);

  friend bool operator==(const ElementGrid&, const ElementGrid&) = default;
};

/// Throws Error unless the grid has elements of positive size, at most 1e8 along an axis.
void check(const ElementGrid& grid);

} // namespace microslip
