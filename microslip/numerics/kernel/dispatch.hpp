#pragma once

#include "microslip/numerics/instruction_set.hpp"

// Functions that are compiled once for every instruction set, each time in a namespace with its name; which ones there
// are is up to CMake.

#ifdef MICROSLIP_AVX2
#define MICROSLIP_AVX2_CODE avx2
#else
#define MICROSLIP_AVX2_CODE baseline
#endif
#ifdef MICROSLIP_AVX512
#define MICROSLIP_AVX512_CODE avx512
#else
#define MICROSLIP_AVX512_CODE baseline
#endif

/// Declares such a function, inside of the namespace `detail`.
#define MICROSLIP_DECLARE_KERNEL(declaration)                                                                          \
  namespace baseline {                                                                                                 \
  declaration;                                                                                                         \
  }                                                                                                                    \
  namespace MICROSLIP_AVX2_CODE {                                                                                      \
  declaration;                                                                                                         \
  }                                                                                                                    \
  namespace MICROSLIP_AVX512_CODE {                                                                                    \
  declaration;                                                                                                         \
  }

/// Calls it in the version for an instruction set.
#define MICROSLIP_CALL_KERNEL(instruction_set, call)                                                                   \
  ((instruction_set) == InstructionSet::avx512 ? MICROSLIP_AVX512_CODE::call                                           \
   : (instruction_set) == InstructionSet::avx2 ? MICROSLIP_AVX2_CODE::call                                             \
                                               : baseline::call)
