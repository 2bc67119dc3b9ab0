#pragma once

#include "microslip/numerics/populating_allocator.hpp"
#include "microslip/table/creep_coordinates.hpp"
#include "microslip/table/creep_table_nodes.hpp"
#include "microslip/table/uniform_spline.hpp"

#include <span>
#include <vector>

namespace microslip::detail {

/// The spline through the nodes of one Poisson's ratio: of forces (F + q (1 - t)^2)/t^2, where -q are those of linear
/// theory, and of the share of adhesion. Quadratic in ln(a/b), t and e, trigonometric in alpha. Its derivative is
/// continuous everywhere, also across the borders of the quarter of the sphere and at its pole, pure spin.
///
/// Coefficients by a/b, level, elevation, azimuth, channel, the last one fastest; those of three neighbours from a
/// node's number on make the spline around the node, of the level from number t `levels` on. They are multiples of
/// 2^-20, which single precision holds exactly, such that at the pole the spline is as independent of alpha as without
/// rounding.
using CreepSpline = PopulatedVector<float>;

/// A spline for each list of weights: its values are those of the nodes' Poisson's ratios, times the weights. Some
/// hundredths of a second for each of a table of usual size.
std::vector<CreepSpline> creep_splines(const CreepTableNodes& nodes, std::span<const std::vector<double>> weights);

/// Number of coefficients along the axes.
struct CreepSplineSize {
  int ratios, levels, elevations, azimuths;

  explicit CreepSplineSize(const CreepTableAxes& axes)
      : ratios(axes.ratios + 2), levels(axes.levels + 3), elevations(axes.elevations + 2), azimuths(axes.azimuths + 2) {
  }
};

} // namespace microslip::detail
