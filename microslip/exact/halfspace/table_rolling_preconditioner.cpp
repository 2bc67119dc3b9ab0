#include "microslip/exact/halfspace/table_rolling_preconditioner.hpp"

namespace microslip {
namespace {

SymmetricToeplitz<double> near_inverse_of(const InfluenceTable& table, const ElementGrid& grid) {
  std::vector<double> xx, xy, yy;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const FullInfluence a = table.find(i, j), b = table.find(-i, j);
      xx.push_back((a.xx + b.xx) / 2);
      xy.push_back((a.xy - b.xy) / 2);
      yy.push_back((a.yy + b.yy) / 2);
    }
  return SymmetricToeplitz<double>::near_inverse(grid.mx, grid.my, {xx, xy, yy});
}

} // namespace

TableRollingPreconditioner::TableRollingPreconditioner(const InfluenceTable& table, const ElementGrid& grid,
                                                       double factor)
    : grid_(grid), factor_(factor), near_inverse_(near_inverse_of(table, grid)), x_(grid.count()), y_(grid.count()) {}

void TableRollingPreconditioner::expect_contact(std::span<const double> pressure, RollingDirection direction) {
  const bool forward = direction == RollingDirection::forward;
  elements_.clear();
  for (int j = 0; j < grid_.my; ++j) {
    bool enters = true;
    for (int n = 0; n < grid_.mx; ++n) {
      const std::size_t k = static_cast<std::size_t>(j) * grid_.mx + (forward ? grid_.mx - 1 - n : n);
      const bool in_contact = pressure[k] > 0;
      if (in_contact) elements_.push_back({k, enters});
      enters = !in_contact;
    }
  }
}

void TableRollingPreconditioner::precondition(std::span<const double> px, std::span<const double> py,
                                              std::span<double> qx, std::span<double> qy) {
  near_inverse_.apply(px, py, factor_, x_, y_);
  double ahead_x = 0, ahead_y = 0;
  for (const auto& [k, leads] : elements_) {
    qx[k] = ahead_x = (leads ? 0 : ahead_x) + x_[k];
    qy[k] = ahead_y = (leads ? 0 : ahead_y) + y_[k];
  }
}

} // namespace microslip
