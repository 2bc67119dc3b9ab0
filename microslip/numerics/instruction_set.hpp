#pragma once

namespace microslip {

/// Vector instructions that kernels, the loops where most time goes, are compiled for.
enum class InstructionSet { baseline, avx2, avx512 };

/// The widest one that this processor has.
InstructionSet best_instruction_set();
/// Returns whether this processor, and this build of the library, have it.
bool is_available(InstructionSet instruction_set);

} // namespace microslip
