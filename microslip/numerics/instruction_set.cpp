#include "microslip/numerics/instruction_set.hpp"

namespace microslip {

bool is_available(InstructionSet instruction_set) {
#ifdef MICROSLIP_AVX2
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
