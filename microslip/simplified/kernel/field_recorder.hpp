#pragma once

#include "microslip/simplified/kernel/row_motion.hpp"

namespace microslip::detail {

/// What the recording kernel leaves of one vector of rows, and its way into ContactFields.
class FieldRecorder {
public:
  FieldRecorder(int cells, int width)
      : cells_(cells), width_(width), px_(std::size_t(cells) * width), py_(px_), slip_x_(px_), slip_y_(px_),
        sliding_(px_) {}

  void attach(MarchingRows& rows) {
    rows.px = px_.data();
    rows.py = py_.data();
    rows.slip_x = slip_x_.data();
    rows.slip_y = slip_y_.data();
    rows.sliding = sliding_.data();
  }

  /// Positions, tractions, slip and state of row j. Slip comes back from flexibility 1 and the cell's length: s = L
  /// S/cell.
  void copy_row(ContactFields& f, int j, int lane, const RowGeometry& at, double travel, const Flexibilities& l) const {
    for (int i = 0; i < cells_; ++i) {
      const int to = j * cells_ + i, from = i * width_ + lane;
      f.x[to] = at.leading + travel * (i + 0.5) * at.cell;
      f.y[to] = at.y;
      f.px[to] = px_[from];
      f.py[to] = py_[from];
      f.sx[to] = slip_x_[from] * l.longitudinal / at.cell;
      f.sy[to] = slip_y_[from] * l.lateral / at.cell;
      f.state[to] = sliding_[from] > 0 ? CellState::slip : CellState::adhesion;
    }
  }

  /// The bound of row j from a table of plain numbers.
  void copy_bound(ContactFields& f, int j, int lane, const std::vector<double>& table_centre) const {
    for (int i = 0; i < cells_; ++i) f.bound[j * cells_ + i] = table_centre[(i + 1) * width_ + lane];
  }

private:
  int cells_, width_;
  std::vector<double> px_, py_, slip_x_, slip_y_, sliding_;
};

/// -V sum of area p.s.
inline double frictional_power(const ContactFields& f, double rolling_speed) {
  double power = 0;
  for (std::size_t k = 0; k < f.area.size(); ++k) power -= f.area[k] * (f.px[k] * f.sx[k] + f.py[k] * f.sy[k]);
  return power * rolling_speed;
}

} // namespace microslip::detail
