#pragma once

// FASTSIM and FASTSIM2 as one would write them down first: one particle at a time, one cell after the other, straight
// from the paper. The oracle of the tests, and what the benchmarks compare with.

#include "microslip/simplified/ellipse_grid.hpp"
#include "microslip/simplified/options.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip::plain {

struct Forces {
  double fx = 0, fy = 0, mz = 0, slip_area = 0;
};

/// One row of an ellipse with Coulomb friction and flexibility 1 (F18).
struct Row {
  double leading, cell, travel; // x of the leading edge, cell length, -1 or +1
  double wx, wy, turn;          // w = (wx, wy + turn x)
  double bound_peak;            // g in the middle of the row
  bool parabolic;
  double half;

  double rigid_y(double position) const { return wy + turn * (leading + travel * position); }
  double bound(double position) const {
    const double t = position / half - 1;
    const double profile = 1 - t * t;
    return bound_peak * (parabolic ? profile : std::sqrt(std::max(profile, 0.0)));
  }
};

struct RowSum {
  double px = 0, py = 0, moment = 0, slip = 0; // moment: of position * py
};

/// (F16) with a full or a half first step.
inline RowSum march_fastsim(const Row& row, int mx, bool half_first_step) {
  RowSum sum;
  double px = 0, py = 0;
  for (int i = 1; i <= mx; ++i) {
    const double end = (i - 0.5) * row.cell;
    const double length = half_first_step && i == 1 ? row.cell / 2 : row.cell;
    const double place = half_first_step ? end - length / 2 : end;
    px -= length * row.wx;
    py -= length * row.rigid_y(place);
    const double g = row.bound(end);
    const double size2 = px * px + py * py;
    const bool slides = size2 > g * g;
    if (slides) {
      const double back = g / std::sqrt(size2);
      px *= back;
      py *= back;
      sum.slip += length;
    }
    sum.px += px;
    sum.py += py;
    sum.moment += end * py;
    if (i == mx && half_first_step && slides) sum.slip += row.cell / 2;
  }
  return sum;
}

/// (F35)-(F40).
inline RowSum march_fastsim2(const Row& row, int mx) {
  RowSum sum;
  double px = 0, py = 0, sx = 0, sy = 0, start = 0;
  bool sliding = false;
  if (row.parabolic) { // slip at the leading edge (F40)
    const double slope = 2 * row.bound_peak / row.half, wx = row.wx, wy = row.rigid_y(0), w = std::hypot(wx, wy);
    if (w > slope) {
      sliding = true;
      sx = (w - slope) * wx / w;
      sy = (w - slope) * wy / w;
    }
  }
  for (int i = 1; i <= mx; ++i) {
    const double end = (i - 0.5) * row.cell, length = end - start;
    const double ax = px + length / 2 * sx - length * row.wx;
    const double ay = py + length / 2 * sy - length * row.rigid_y((start + end) / 2);
    const double g = row.bound(end), size = std::sqrt(ax * ax + ay * ay);
    if (size > g) {
      double nx = ax / size, ny = ay / size;
      if (sliding) { // (F38)
        sx = 2 * (g - size) / length * nx;
        sy = 2 * (g - size) / length * ny;
        sum.slip += length;
      } else { // (F39), from the parabola through three values of |p| - g
        const double mx2 = px - length / 2 * row.wx, my2 = py - length / 2 * row.rigid_y(start + length / 4);
        const double f0 = std::min(0.0, std::hypot(px, py) - row.bound(start));
        const double fm = std::hypot(mx2, my2) - row.bound(start + length / 2), f1 = size - g;
        const double c = 2 * (f0 + f1 - 2 * fm), b = 4 * fm - 3 * f0 - f1, root = std::sqrt(b * b - 4 * c * f0);
        const double t = b > 0 ? -2 * f0 / (b + root) : (root - b) / (2 * c);
        const bool grows = b + 2 * c > 0;
        const double mean = b + c * (1 + t), slope = grows ? b + 2 * c * t : mean, end_slope = grows ? b + 2 * c : mean;
        // Traction where f is zero; the slip there is slope/length against it, and acts over half of the rest.
        const double bx = px - t * length * row.wx, by = py - t * length * row.rigid_y(start + t * length / 2);
        const double g0 = row.bound(start), gm = row.bound(start + length / 2);
        const double boundary = g0 + t * (4 * gm - 3 * g0 - g + 2 * t * (g0 + g - 2 * gm)); // |(bx, by)|
        const double pull = boundary > 0 ? (1 - t) * slope / 2 / boundary : 0;
        const double turned_x = ax - pull * bx, turned_y = ay - pull * by;
        const double turned = std::hypot(turned_x, turned_y);
        nx = turned_x / turned;
        ny = turned_y / turned;
        sx = -end_slope / length * nx;
        sy = -end_slope / length * ny;
        sum.slip += (1 - t) * length;
      }
      px = g * nx;
      py = g * ny;
      sliding = true;
    } else {
      px = ax;
      py = ay;
      if (sliding) { // (F36)
        const double nx = size > 0 ? ax / size : 0, ny = size > 0 ? ay / size : 0;
        const double tx = 2 * (g - size) / length * nx, ty = 2 * (g - size) / length * ny;
        const bool along_x = std::abs(sx) >= std::abs(sy);
        const double first = along_x ? sx : sy, last = along_x ? tx : ty;
        const double t = first * last < 0 ? first / (first - last) : 1;
        px = ax - (1 - t) * length / 2 * sx;
        py = ay - (1 - t) * length / 2 * sy;
        const double p = std::hypot(px, py);
        if (p > g) {
          px *= g / p;
          py *= g / p;
        }
        sum.slip += t * length;
      }
      sx = sy = 0;
      sliding = false;
    }
    sum.px += px;
    sum.py += py;
    sum.moment += end * py;
    start = end;
  }
  if (sliding) sum.slip += row.cell / 2;
  return sum;
}

/// A whole ellipse: scheme is 0 for FASTSIM, 1 for FASTSIM with a half first step, 2 for FASTSIM2.
inline Forces solve(int scheme, const SimplifiedOptions& options, const EllipticContact& contact) {
  const Flexibilities l = flexibilities(options.flexibility, options.slope_reduction, contact);
  const bool parabolic = options.bound == TractionBound::parabolic;
  const double travel = options.direction == RollingDirection::forward ? -1 : 1;
  const double mu = contact.friction.static_coefficient();
  const double peak = mu * contact.normal_force * (parabolic ? 2 : 1.5) / (std::numbers::pi * contact.a * contact.b);
  Forces f;
  double bound_sum = 0, length_sum = 0;
  for (int j = 0; j < options.my; ++j) {
    const double v = (2 * j + 1.0) / options.my - 1, h = std::sqrt(1 - v * v), y = v * contact.b;
    Row row;
    row.half = contact.a * h;
    row.cell = 2 * row.half / options.mx;
    row.travel = travel;
    row.leading = -travel * row.half;
    row.wx = contact.creepage.longitudinal / l.longitudinal - y * contact.creepage.spin / l.spin;
    row.wy = contact.creepage.lateral / l.lateral;
    row.turn = contact.creepage.spin / l.spin;
    row.parabolic = parabolic;
    row.bound_peak = peak * (parabolic ? h * h : h);
    const RowSum sum = scheme == 2 ? march_fastsim2(row, options.mx) : march_fastsim(row, options.mx, scheme == 1);
    f.fx += sum.px * row.cell;
    f.fy += sum.py * row.cell;
    f.mz += (row.leading * sum.py + travel * sum.moment - y * sum.px) * row.cell;
    f.slip_area += sum.slip;
    double row_bound = 0;
    for (int i = 1; i <= options.mx; ++i) row_bound += row.bound((i - 0.5) * row.cell);
    bound_sum += row_bound * row.cell;
    length_sum += 2 * row.half;
  }
  const double exact = bound_sum > 0 ? mu * contact.normal_force / bound_sum : 0;
  return {f.fx * exact, f.fy * exact, f.mz * exact,
          f.slip_area / length_sum * std::numbers::pi * contact.a * contact.b};
}

} // namespace microslip::plain
