#pragma once

#include "microslip/table/creep_coordinates.hpp"
#include "microslip/table/creep_table_nodes.hpp"
#include "microslip/table/uniform_spline.hpp"

#include <vector>

namespace microslip::detail {

/// The spline through the nodes of one Poisson's ratio: of forces (F + q (1 - t)^2)/t^2, where -q are those of linear
/// theory, and of the share of adhesion. Cubic in ln(a/b), t and theta, trigonometric in alpha. Its derivative is
/// continuous everywhere, also across the borders of the quarter of the sphere and at its pole, pure spin.
class CreepSpline {
public:
  /// `material` is the number of the Poisson's ratio. Cost some tenths of a second for a table of usual size.
  CreepSpline(const CreepTableNodes& nodes, std::size_t material);

  /// Coefficients by a/b, level, elevation, azimuth, channel, the last one fastest; the first node of an interval's
  /// stencil has the interval's number.
  const std::vector<double>& coefficients() const { return coefficients_; }

private:
  std::vector<double> coefficients_;
};

/// How many coefficients there are along the axes.
struct CreepSplineSize {
  int ratios, levels, elevations, azimuths;

  explicit CreepSplineSize(const CreepTableAxes& axes)
      : ratios(axes.ratios + 2), levels(axes.levels + 3), elevations(axes.elevations + 2), azimuths(axes.azimuths + 2) {
  }
};

} // namespace microslip::detail
