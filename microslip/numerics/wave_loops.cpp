#include "microslip/numerics/kernel/wave_loops.hpp"

#include "microslip/numerics/kernel/dispatch.hpp"

namespace microslip::detail {

MICROSLIP_DECLARE_KERNEL(void set_loops(WaveLoops<double>& loops))
MICROSLIP_DECLARE_KERNEL(void set_loops(WaveLoops<float>& loops))

template <class Real> WaveLoops<Real> wave_loops(InstructionSet instruction_set) {
  WaveLoops<Real> loops{};
  MICROSLIP_CALL_KERNEL(instruction_set, set_loops(loops));
  return loops;
}

template WaveLoops<double> wave_loops(InstructionSet);
template WaveLoops<float> wave_loops(InstructionSet);

} // namespace microslip::detail
