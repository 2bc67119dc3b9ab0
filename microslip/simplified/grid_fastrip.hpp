#pragma once

#include "microslip/simplified/fastrip.hpp"
#include "microslip/simplified/grid_fastsim.hpp"

namespace microslip {

/// Form of FaStrip.
enum class FastripForm {
  modified,      ///< CONTACT's: strip theory in each run of elements, over its length
  first,         ///< as published (Sichani, Enblom & Berg 2016): strips as long as the ellipse's rows; for a < b forces
                 ///< are raised by 1 + (1 - a/b)^4
  first_bounded, ///< the same; all slides where phi' >= 1, and forces are raised no further than friction
};

/// FaStrip on the rows of a grid in steady rolling: FASTSIM, then strip theory where that adheres.
/// docs/theory-fastsim2.md, section 11. `ellipse` is that whose linear theory the strips are scaled to, with load,
/// material and creepages: those of the contact with the first forms, else an equivalent one. Slip is FASTSIM's, and
/// zero where strip theory adheres. Throws Error as GridFastsim does. Cost O(elements).
ContactSolution solve_fastrip(const GridFastsim& fastsim, FastripForm form, const EllipticContact& ellipse,
                              const Flexibilities& flexibilities, std::span<const double> friction,
                              const GridRolling& rolling);

} // namespace microslip
