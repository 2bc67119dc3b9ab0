#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/simplified/loaded_rows.hpp"

#include <cmath>

namespace microslip {

/// The ellipse that stands for a patch: the middles of its rows lie on x = slant y.
struct PatchEllipse {
  double a = 0, b = 0; ///< half the length of its middle row, half its width [m]
  double slant = 0;    ///< [-]
  double skewness = 0; ///< of the patch's load across: third central moment over the 3/2 power of the second [-]

  /// Ratio of its length along x to that of its middle row. An ellipse without slant, so much longer and narrower, has
  /// nearly its forces.
  double stretch() const { return std::sqrt(1 + slant * slant * b * b / (a * a)); }
};

/// Rows of a patch as strips that do not feel each other: what the strips of a patch carry, less what those of its
/// ellipse do, is what the patch's shape and the creepages of its rows change in the forces of the ellipse,
/// (C4) of docs/creep-force-tables.md.
///
/// A strip of half-length l and width s, whose friction carries at most Q, has at x the scaled slip
///
///   sigma = u (xi, eta + phi (x + m l/(1 + u^2 |w(x)|^2))),   u = K s l^alpha/(Q sum s l^alpha),
///
/// w = (xi, eta + phi x), and the traction -sigma/sqrt(1 + |sigma|^2) times its bound, semi-elliptic along x. K = G a b
/// C11 is the stiffness of the ellipse, and a patch's is greater by 0.06 g^2/(1 + g^2/4) of it, g the skewness of its
/// load. So a patch is about as stiff as its ellipse but at other points: the exponent alpha = 1.3 + 2 r/(r + 5), r the
/// ellipse's ratio of axes, was chosen such that the centre of the stiffness is that of the exact theory on patches
/// between wheel and rail, and so was the gain of stiffness. m gives the strips of the ellipse the lateral force by
/// spin that C23 does: tractions grow from the leading edge, and so come from a slip further ahead; where a strip
/// slides they do not.
class RowStrips {
public:
  RowStrips() = default;
  /// `capacity` is mu Fn of the patch [N].
  RowStrips(const CombinedMaterial& material, const PatchEllipse& ellipse, double capacity);

  /// s l^alpha, to be summed over the rows of a patch [m].
  double stiffness(const LoadedRow& row) const noexcept;
  /// Forces of a row in a patch with that sum, about (0, y); its slip area is left at 0.
  RowForces row(const LoadedRow& row, double sum) const noexcept;
  /// Forces of all strips of the ellipse, about its centre, for the creepages there.
  RowForces ellipse(const Creepage& at_centre) const noexcept;

private:
  RowForces strip(double scale, double centre, double half_length, const Creepage& creepage,
                  double capacity) const noexcept;

  PatchEllipse shape_;
  double capacity_ = 0, exponent_ = 0;
  double stiffness_ = 0; ///< K [N]
  double memory_ = 0;    ///< m [-]
};

} // namespace microslip
