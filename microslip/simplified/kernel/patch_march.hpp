#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/simplified/kernel/marching.hpp"

namespace microslip::detail {

/// Marches the rows of a patch of any outline; `travel` is -1 or +1, the direction of a particle along x.
ContactSolution march_patch(const MarchingKernels& kernels, double travel, const PatchRows& patch,
                            const PatchMotion& motion);

} // namespace microslip::detail
