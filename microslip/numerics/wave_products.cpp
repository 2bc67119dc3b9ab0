#include "microslip/numerics/kernel/wave_products.hpp"

#include "microslip/numerics/kernel/dispatch.hpp"

namespace microslip::detail {

MICROSLIP_DECLARE_KERNEL(void set_products(WaveProducts<double>& products))
MICROSLIP_DECLARE_KERNEL(void set_products(WaveProducts<float>& products))

template <class Real> WaveProducts<Real> wave_products(InstructionSet instruction_set) {
  WaveProducts<Real> products{};
  MICROSLIP_CALL_KERNEL(instruction_set, set_products(products));
  return products;
}

template WaveProducts<double> wave_products(InstructionSet);
template WaveProducts<float> wave_products(InstructionSet);

} // namespace microslip::detail
