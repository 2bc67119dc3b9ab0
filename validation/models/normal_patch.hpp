#pragma once

#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/material.hpp"

#include <vector>

namespace microslip::validation {

/// A row of a patch with a pressure that is semi-elliptic along x.
struct Strip {
  double y = 0, width = 0; ///< centre, width [m]
  double half_length = 0;  ///< [m]
  double load = 0;         ///< [N]

  double peak() const; ///< 2 load/(pi half_length width) [Pa]
};

/// What a model of the normal problem finds: rows, y ascending from the point where the bodies touch.
struct NormalPatch {
  std::vector<Strip> strips;

  double force() const;  ///< [N]
  double area() const;   ///< [m^2]
  double peak() const;   ///< [Pa]
  double length() const; ///< of the longest row [m]
  double width() const;  ///< of all rows, the ends where squared lengths vanish [m]
  /// The same load on `most` rows or fewer: each the sum of some, with their mean squared length.
  NormalPatch with_rows(int most) const;
};

/// Width of rows next to each other, each `width` wide, of which half the lengths are known: at both ends squares of
/// lengths fall linearly, at most over one row.
double width_of_rows(const std::vector<double>& half_lengths, double width);

/// Hertz's ellipse in rows, its centre at y.
NormalPatch in_rows(const HertzContact& hertz, double y = 0);

/// The pressure c sqrt(l^2 - x^2) in all strips of half-length l, with c such that the half-space is pressed in by the
/// approach [m] at the origin (Kik & Piotrowski 1996; 2008, (13)):
/// approach = c/(pi E*) sum over strips of the integral of sqrt(l^2 - x^2)/sqrt(x^2 + y^2).
NormalPatch pressed_at_point(std::vector<Strip> strips, const CombinedMaterial& material, double approach);

} // namespace microslip::validation
