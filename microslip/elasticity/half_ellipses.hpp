#pragma once

namespace microslip {

/// A contact of two half ellipses that meet along x, with different semi-axes along y: the pressure of simple
/// double-elliptical contact (SDEC; Piotrowski, Liu & Bruni 2017), (H13). With b = (b+ + b-)/2 and y0 = (b- - b+)/2 the
/// area is |y| <= b; its rows are longest at y0, x_l(y) = a sqrt(1 - (y - y0)^2/b±^2), b+ for y > y0, and p_n = p0/a
/// sqrt(x_l^2 - x^2) with p0 = 3 Fn/(2 pi a b), of the same force Fn. b+ = b- is Hertz's ellipse.
struct HalfEllipses {
  double a = 0;                          ///< semi-axis along x [m], > 0
  double b_negative = 0, b_positive = 0; ///< b-, b+: towards -y and +y [m], > 0
  double normal_force = 0;               ///< Fn [N]

  /// b [m].
  double half_width() const { return (b_negative + b_positive) / 2; }
  /// p_n(x, y) [Pa], 0 outside.
  double pressure(double x, double y) const;
};

} // namespace microslip
