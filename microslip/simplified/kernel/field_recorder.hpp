#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/simplified/kernel/row_motion.hpp"

namespace microslip::detail {

/// Output of the recording kernel for one vector of rows, and its transfer to a solution.
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

  /// Positions, tractions, slip and state of row j, whose cells count from the leading edge. Slip comes back from
  /// flexibility 1 and the cell's length: s = L S/cell.
  void copy_row(ContactSolution& to, int j, int lane, const RowGeometry& at, double travel,
                const Flexibilities& l) const {
    Elements& e = to.elements;
    SurfaceFields& f = to.fields;
    for (int i = 0; i < cells_; ++i) {
      const std::size_t k = e.behind_leading_edge(i, j, direction_of(travel));
      const int from = i * width_ + lane;
      e.x[k] = at.leading + travel * (i + 0.5) * at.cell;
      e.y[k] = at.y;
      e.width[k] = at.cell;
      f.traction.x[k] = px_[from];
      f.traction.y[k] = py_[from];
      f.slip.x[k] = slip_x_[from] * l.longitudinal / at.cell;
      f.slip.y[k] = slip_y_[from] * l.lateral / at.cell;
      f.state[k] = sliding_[from] > 0 ? CellState::slip : CellState::adhesion;
    }
  }

  /// The bound of row j from a table of plain numbers.
  void copy_bound(ContactSolution& to, int j, int lane, double travel, const std::vector<double>& table_centre) const {
    for (int i = 0; i < cells_; ++i)
      to.fields.bound[to.elements.behind_leading_edge(i, j, direction_of(travel))] =
          table_centre[(i + 1) * width_ + lane];
  }

private:
  int cells_, width_;
  std::vector<double> px_, py_, slip_x_, slip_y_, sliding_;
};

/// Work of the tractions per metre rolled, on the rigid slip that drives them [N], (S22): that on the slip, without the
/// error of slip that lies between two centres.
inline double work_on_rigid_slip(const ContactSolution& s, const Flexibilities& l) {
  const auto& [xi, eta, phi] = s.creepage;
  double work = 0;
  for (std::size_t k = 0; k < s.elements.size(); ++k) {
    const double wx = xi - phi * s.elements.y[k] * l.longitudinal / l.spin;
    const double wy = eta + phi * s.elements.x[k] * l.lateral / l.spin;
    work -= s.elements.area[k] * (s.fields.traction.x[k] * wx + s.fields.traction.y[k] * wy);
  }
  return work;
}

/// The totals of a solution whose fields are there: forces and areas are those of the march, which knows the positions
/// within a cell where slip begins and ends.
inline void set_totals(ContactSolution& solution, const ContactForces& forces, double rolling_speed) {
  solution.totals = find_totals(solution.elements, solution.fields, solution.creepage, rolling_speed);
  Totals& t = solution.totals;
  t.fx = forces.fx;
  t.fy = forces.fy;
  t.mz = forces.mz;
  t.adhesion_area = forces.adhesion_area;
  t.slip_area = forces.slip_area;
  solution.report.status = forces.status;
}

} // namespace microslip::detail
