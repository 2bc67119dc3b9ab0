#pragma once

#include "microslip/elasticity/material.hpp"

#include <string>
#include <vector>

namespace microslip {

/// Shape of the gap between two bodies in first contact: h(x, y) = A x^2 + B y^2.
struct GapCurvatures {
  double x; ///< A [1/m], along the rolling direction
  double y; ///< B [1/m], lateral

  /// Returns whether the bodies are cylinders that touch in a line.
  bool is_line() const { return y == 0; }
};

/// Principal radii of two bodies: positive convex, negative concave, infinite flat [m].
struct PrincipalRadii {
  double rolling1, rolling2;       ///< in the plane of rolling (x-z), body 1 (wheel) and body 2 (rail)
  double transverse1, transverse2; ///< in the lateral plane (y-z)
};

/// A = (1/rolling1 + 1/rolling2)/2, B = (1/transverse1 + 1/transverse2)/2. Throws Error for a radius that is zero or
/// not a number, and unless A and B are positive: the bodies then touch along a line or at more than one point.
GapCurvatures gap_curvatures(const PrincipalRadii& radii);

/// A Hertzian contact: everything that follows from shape, material and load.
struct HertzContact {
  double a;             ///< semi-axis along x, the rolling direction [m]
  double b;             ///< semi-axis along y [m]
  double normal_force;  ///< Fn [N]
  double approach;      ///< delta [m], relative approach of distant points
  double peak_pressure; ///< p0 = 3 Fn/(2 pi a b) [Pa]
  double stiffness;     ///< dFn/d(approach) = 3 Fn/(2 delta) [N/m]
  GapCurvatures gap;    ///< [1/m]

  /// p_n(x, y) = p0 sqrt(1 - (x/a)^2 - (y/b)^2), 0 outside the ellipse (F11) [Pa].
  double pressure(double x, double y) const;
};

/// Ellipse, approach and pressure from the load (Johnson 1985, section 4.2; formulas in docs/theory-hertz.md).
/// Relative error below 1e-12 for a/b from 1e-4 to 1e4, either axis the longer one. Throws Error for load or material
/// out of range and for A/B outside [1e-9, 1e9], which is a/b of about 1e-5 to 1e5: such a contact is one along a line.
/// Cost: below a microsecond.
HertzContact hertz_from_load(const GapCurvatures& gap, const CombinedMaterial& material, double normal_force);
/// Contact from the approach [m] instead of the load.
HertzContact hertz_from_approach(const GapCurvatures& gap, const CombinedMaterial& material, double approach);
/// Contact from the ellipse and the load: finds the curvatures. Throws Error for a/b outside [1e-5, 1e5].
HertzContact hertz_from_ellipse(double a, double b, const CombinedMaterial& material, double normal_force);

/// Two cylinders with parallel axes (line contact), per unit length.
struct LineContact {
  double half_width;       ///< a [m], along the rolling direction
  double force_per_length; ///< fn [N/m]
  double peak_pressure;    ///< p0 = 2 fn/(pi a) [Pa]
  double curvature;        ///< A = 1/(2R) of the gap h = A x^2 [1/m]

  /// p_n(x) = p0 sqrt(1 - (x/a)^2), 0 outside [Pa].
  double pressure(double x) const;
};

/// a = sqrt(4 R fn/(pi E*)), R = 1/(2A) (Johnson 1985, section 4.2c). There is no approach: it grows with the bodies'
/// size.
LineContact line_contact_from_load(double curvature, const CombinedMaterial& material, double force_per_length);
/// Line contact from its half-width.
LineContact line_contact_from_half_width(double curvature, const CombinedMaterial& material, double half_width);

} // namespace microslip
