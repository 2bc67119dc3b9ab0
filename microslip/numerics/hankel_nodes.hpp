#pragma once

#include <vector>

namespace microslip {

/// A node of a quadrature over wavenumbers.
struct WaveNode {
  double wavenumber; ///< k [rad/m]
  double weight;     ///< [rad/m]
};

/// Nodes for integrals of f(k) J_m(k r) over k from 0 to infinity, for distances r between r_min >= 0 and r_max > 0,
/// where f is negligible beyond k_max and analytic for |Im k| < |k|/2, as responses of elastic bodies at rest are.
/// Panels are a quarter of the next one towards 0 and elsewhere 7/r_max wide, with 16 nodes of Gauss's. Waves shorter
/// than about r_min/20, of which nothing is left at a distance, are faded out by erfc((k r_min - 66)/11)/2, of which
/// exp(-30) = 1e-13 reaches r_min. So the number of nodes does not grow with r.
std::vector<WaveNode> hankel_nodes(double r_min, double r_max, double k_max);

} // namespace microslip
