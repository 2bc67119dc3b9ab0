#include "microslip/numerics/toeplitz_row.hpp"

#include "microslip/numerics/kernel/dispatch.hpp"

#include <algorithm>

namespace microslip {
namespace detail {

MICROSLIP_DECLARE_KERNEL(void set_row_product(RowProduct<double>& product))
MICROSLIP_DECLARE_KERNEL(void set_row_product(RowProduct<float>& product))

template <class Real> RowProduct<Real> row_product(InstructionSet instruction_set) {
  RowProduct<Real> product = nullptr;
  MICROSLIP_CALL_KERNEL(instruction_set, set_row_product(product));
  return product;
}

template RowProduct<double> row_product(InstructionSet);
template RowProduct<float> row_product(InstructionSet);

} // namespace detail

template <class Real>
ToeplitzRow<Real>::ToeplitzRow(std::span<const Real> kernel)
    : mirrored_(kernel.rbegin(), kernel.rend()), in_(kernel.size()) {
  mirrored_.insert(mirrored_.end(), kernel.begin() + 1, kernel.end());
  mirrored_.resize(mirrored_.size() + detail::row_product_padding);
}

template <class Real> void ToeplitzRow<Real>::apply(const Real* in, Real* out) {
  std::copy_n(in, in_.size(), in_.begin());
  product_(mirrored_.data() + in_.size() - 1, static_cast<int>(in_.size()), in_.data(), out);
}

template class ToeplitzRow<double>;
template class ToeplitzRow<float>;

} // namespace microslip
