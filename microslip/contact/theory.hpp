#pragma once

namespace microslip {

/// Theories for a contact.
enum class Theory {
  fastsim,           ///< simplified theory at first order
  fastsim_half_step, ///< the same with half a step from the leading edge
  fastsim2,          ///< simplified theory at second order; of a wheel on a rail on the rows of its patches
  exact,             ///< half-spaces, by elements
  fastrip,           ///< strips of Carter's theory with FASTSIM's directions
  table,             ///< forces from a creep-force table; of a wheel those of its patches' equivalent ellipses
};

} // namespace microslip
