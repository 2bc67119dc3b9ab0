#include "microslip/numerics/elimination.hpp"

#include "microslip/numerics/kernel/dispatch.hpp"
#include "microslip/numerics/kernel/elimination.hpp"

namespace microslip {
namespace detail {
MICROSLIP_DECLARE_KERNEL(EliminateRows eliminate_rows())
} // namespace detail

bool eliminate(std::span<double> rows, std::size_t order, std::size_t sides, InstructionSet instruction_set) {
  using namespace detail;
  if (order == 0) return true;
  return MICROSLIP_CALL_KERNEL(instruction_set, eliminate_rows())(
      rows.data(), static_cast<int>(order), static_cast<int>(sides), static_cast<int>(rows.size() / order));
}

} // namespace microslip
