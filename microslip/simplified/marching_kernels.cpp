#include "microslip/numerics/kernel/dispatch.hpp"
#include "microslip/simplified/kernel/marching.hpp"

namespace microslip::detail {

MICROSLIP_DECLARE_KERNEL(MarchingKernels marching_kernels(MarchingScheme scheme))

MarchingKernels marching_kernels(MarchingScheme scheme, InstructionSet instruction_set) {
  return MICROSLIP_CALL_KERNEL(instruction_set, marching_kernels(scheme));
}

} // namespace microslip::detail
