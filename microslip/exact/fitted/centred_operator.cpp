#include "microslip/exact/fitted/centred_operator.hpp"

#include <utility>

namespace microslip {

CentredOperator::CentredOperator(SlipOperator& uncentred, CentredSlip<double> centred)
    : uncentred_(uncentred), centred_(std::move(centred)) {}

void CentredOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                            std::span<double> sy) {
  uncentred_.apply(px, py, sx, sy);
  centred_.move(sx);
  centred_.move(sy);
}

void CentredOperator::apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                                    std::span<double> sy) {
  uncentred_.apply_roughly(px, py, sx, sy);
  centred_.move(sx);
  centred_.move(sy);
}

bool CentredOperator::precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                   std::span<double> qy) {
  undone_x_.assign(px.begin(), px.end());
  undone_y_.assign(py.begin(), py.end());
  centred_.nearly_undo(undone_x_);
  centred_.nearly_undo(undone_y_);
  return uncentred_.precondition(undone_x_, undone_y_, qx, qy);
}

} // namespace microslip
