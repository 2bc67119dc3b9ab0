#include "microslip/simplified/instruction_set.hpp"

#include "microslip/simplified/kernel/marching.hpp"

namespace microslip {
namespace detail {

MarchingKernels marching_kernels_baseline(MarchingScheme scheme);
#ifdef MICROSLIP_X86_64
MarchingKernels marching_kernels_avx2(MarchingScheme scheme);
#endif
#ifdef MICROSLIP_AVX512
MarchingKernels marching_kernels_avx512(MarchingScheme scheme);
#endif

MarchingKernels marching_kernels(MarchingScheme scheme, InstructionSet instruction_set) {
  switch (instruction_set) {
#ifdef MICROSLIP_X86_64
  case InstructionSet::avx2:
    return marching_kernels_avx2(scheme);
#endif
#ifdef MICROSLIP_AVX512
  case InstructionSet::avx512:
    return marching_kernels_avx512(scheme);
#endif
  default:
    return marching_kernels_baseline(scheme);
  }
}

} // namespace detail

bool is_available(InstructionSet instruction_set) {
#ifdef MICROSLIP_X86_64
  if (instruction_set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
#endif
#ifdef MICROSLIP_AVX512
  if (instruction_set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
  return instruction_set == InstructionSet::baseline;
}

InstructionSet best_instruction_set() {
  if (is_available(InstructionSet::avx512)) return InstructionSet::avx512;
  if (is_available(InstructionSet::avx2)) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

} // namespace microslip
