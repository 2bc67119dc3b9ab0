#pragma once

#include "microslip/friction/friction_law.hpp"
#include "microslip/numerics/dual.hpp"
#include "microslip/simplified/kernel/row_arrays.hpp"
#include "microslip/simplified/options.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::detail {

/// Number of plain numbers in a number: itself and its derivatives.
template <class Real> constexpr int numbers_of = 1;
template <int N> constexpr int numbers_of<Dual<double, N>> = 1 + N;

/// The plain number k of them.
inline double number(double of, int) {
  return of;
}
template <int N> double number(const Dual<double, N>& of, int k) {
  return k == 0 ? of.value : of.partial[k - 1];
}

template <class Real> void put(const Real& value, double* to, int stride) {
  for (int k = 0; k < numbers_of<Real>; ++k) to[std::ptrdiff_t(k) * stride] = number(value, k);
}

/// The direction of a particle's travel along x: against the rolling direction.
inline double travel_of(RollingDirection direction) {
  return direction == RollingDirection::forward ? -1 : 1;
}
inline RollingDirection direction_of(double travel) {
  return travel < 0 ? RollingDirection::forward : RollingDirection::backward;
}

/// Effective rigid slip (F18): x component along - y turn, y component across + x turn. Or a derivative of it.
struct EffectiveSlip {
  double along, across, turn;
};

struct RowGeometry {
  double y, leading, cell; ///< centre, x of the leading edge, length of a cell
};

/// Puts the rigid slip of a row, or its derivative number k - 1, in the kernels' units.
inline void put_row(RowArrays& rows, int row, int k, const EffectiveSlip& w, const RowGeometry& at, double travel) {
  const int index = row + k * rows.stride;
  rows.rigid_slip_x[index] = (w.along - w.turn * at.y) * at.cell;
  rows.rigid_slip_y[index] = (w.across + w.turn * at.leading) * at.cell;
  rows.rigid_slip_dy[index] = w.turn * (travel * at.cell * at.cell);
}

/// mu at the velocity of the rigid slip, V |w| with w = (xi - phi y, eta + phi x) (F3), (S12).
template <class Real>
Real friction_coefficient(const FrictionLaw& law, const Drive<Real>& drive, double rolling_speed, double x, double y) {
  using std::sqrt;
  const Real wx = drive.xi - drive.phi * y, wy = drive.eta + drive.phi * x;
  const Real w2 = wx * wx + wy * wy;
  return law.coefficient(value_of(w2) > 0 ? sqrt(w2) * rolling_speed : Real(0.0));
}

/// Sums over the contact: fx, fy, mz, or a derivative of them.
struct RowSums {
  double fx = 0, fy = 0, mz = 0;

  /// Adds what a row's kernel has left, or its derivative number k - 1.
  void add_row(const RowArrays& rows, int row, int k, const RowGeometry& at, double travel) {
    const int index = row + k * rows.stride;
    const double px = rows.sum_px[index], py = rows.sum_py[index], moment = rows.sum_moment[index];
    fx += px * at.cell;
    fy += py * at.cell;
    mz += (py * at.leading + moment * (travel * at.cell) - px * at.y) * at.cell;
  }
};

/// Forces from sums and areas; what input beyond all bounds makes of them is left to `conclude`.
inline ContactForces forces_of(const RowSums& totals, double slip_area, double area) {
  slip_area = std::clamp(slip_area, 0.0, area);
  return {totals.fx, totals.fy, totals.mz, area - slip_area, slip_area, Status::ok};
}

} // namespace microslip::detail
