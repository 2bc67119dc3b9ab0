#pragma once

#include "microslip/simplified/kernel/marching.hpp"

#include <vector>

namespace microslip::detail {

/// The memory behind MarchingRows: arrays over rows, with derivatives and padding to whole groups at the end.
struct RowArrays {
  int stride; ///< from a number to its first derivative, from there to the next
  std::vector<double> rigid_slip_x, rigid_slip_y, rigid_slip_dy, bound_scale;
  std::vector<double> sum_px, sum_py, sum_moment, slip_cells;
  std::vector<double> table_centre, table_middle, table_slope; ///< for one group

  RowArrays(int rows, int cells) : stride((rows + widest_group - 1) / widest_group * widest_group) {
    for (auto* numbers : {&rigid_slip_x, &rigid_slip_y, &rigid_slip_dy, &bound_scale, &sum_px, &sum_py, &sum_moment})
      numbers->resize((1 + row_partials) * std::size_t(stride));
    slip_cells.resize(stride);
    const std::size_t point = (1 + row_partials) * std::size_t(widest_group);
    table_centre.resize((cells + 1) * point);
    table_middle.resize(cells * point);
    table_slope.resize(point);
  }

  /// `count` rows from `first` on, for a kernel.
  MarchingRows view(int first, int count, int cells) {
    MarchingRows rows;
    rows.count = count;
    rows.cells = cells;
    rows.stride = stride;
    rows.rigid_slip_x = rigid_slip_x.data() + first;
    rows.rigid_slip_y = rigid_slip_y.data() + first;
    rows.rigid_slip_dy = rigid_slip_dy.data() + first;
    rows.bound_scale = bound_scale.data() + first;
    rows.table_centre = table_centre.data();
    rows.table_middle = table_middle.data();
    rows.table_slope = table_slope.data();
    rows.sum_px = sum_px.data() + first;
    rows.sum_py = sum_py.data() + first;
    rows.sum_moment = sum_moment.data() + first;
    rows.slip_cells = slip_cells.data() + first;
    return rows;
  }
};

} // namespace microslip::detail
