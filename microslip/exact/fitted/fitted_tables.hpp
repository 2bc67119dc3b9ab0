#pragma once

#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/fitted_product.hpp"
#include "microslip/exact/fitted/grid_kernel.hpp"
#include "microslip/progress.hpp"

#include <cstddef>

namespace microslip {

/// Contact on the part of its grid that FittedProduct uses: columns and rows with elements, and those beside
/// them by which fitted elements and their points are represented. The whole grid for a line contact, whose
/// displacements are 0 at a distance that the grid tells.
FittedContact without_spare_elements(const FittedContact& contact);

/// Tables of FittedProduct in addition to the transforms, for similar bodies. `memory`: tables that are not needed any
/// more. Throws Stopped if `progress` returns false.
FittedProduct<double>::Tables fitted_tables(double poisson_ratio, const FittedContact& contact,
                                            const GridKernel& kernel, const Progress& progress,
                                            FittedProduct<double>::Tables memory = {});

} // namespace microslip
