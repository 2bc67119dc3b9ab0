// The marching kernels, compiled once for every instruction set.

#include "microslip/simplified/kernel/fastsim2_step.hpp"
#include "microslip/simplified/kernel/fastsim_step.hpp"
#include "microslip/simplified/kernel/marching.hpp"

#include <algorithm>
#include <cstddef>

namespace microslip::detail {
namespace {

using Doubles = Lanes<double>;
using Floats = Lanes<float>;

/// A number for each lane, or with its derivatives; `Plain` are the lanes below it.
template <class Real> struct Numbers;
template <class Number, int lanes> struct Numbers<Lanes<Number, lanes>> {
  using Plain = Lanes<Number, lanes>;
  using Mask = LaneMask<Number, lanes>;
  static constexpr int count = 1;
  MICROSLIP_INLINE static Plain load(const double* from, std::ptrdiff_t) { return Plain::load(from); }
  MICROSLIP_INLINE static void store(const Plain& number, double* to, std::ptrdiff_t) { number.store(to); }
};
template <class Vector, int N> struct Numbers<Dual<Vector, N>> : Numbers<Vector> {
  static constexpr int count = 1 + N;
  MICROSLIP_INLINE static Dual<Vector, N> load(const double* from, std::ptrdiff_t stride) {
    return Dual<Vector, N>::combine(Vector::load(from), [&](int k) { return Vector::load(from + (k + 1) * stride); });
  }
  MICROSLIP_INLINE static void store(const Dual<Vector, N>& number, double* to, std::ptrdiff_t stride) {
    number.value.store(to);
    for (int k = 0; k < N; ++k) number.partial[k].store(to + (k + 1) * stride);
  }
};

/// Traction bound as scale times a common profile; nothing that is differentiated moves it.
template <class Vector> struct ProfileBound {
  using Value = Vector;
  const MarchingRows* rows;
  Vector scale;

  void start(const MarchingRows& all, int first) {
    rows = &all;
    scale = Vector::load(all.bound_scale + first);
  }
  MICROSLIP_INLINE Value centre(int i) const { return scale * Vector(rows->profile_centre[i]); }
  MICROSLIP_INLINE Value middle(int i) const { return scale * Vector(rows->profile_middle[i]); }
  MICROSLIP_INLINE Value slope() const { return scale * Vector(rows->profile_slope); }
};

/// Traction bound of one vector of rows from tables.
template <class Real> struct TableBound {
  using Value = Real;
  static constexpr int width = Numbers<Real>::Plain::width;
  static constexpr std::ptrdiff_t point = Numbers<Real>::count * width;
  const MarchingRows* rows;

  void start(const MarchingRows& all, int) { rows = &all; }
  MICROSLIP_INLINE Value centre(int i) const { return load(rows->table_centre + i * point); }
  MICROSLIP_INLINE Value middle(int i) const { return load(rows->table_middle + i * point); }
  MICROSLIP_INLINE Value slope() const { return load(rows->table_slope); }

private:
  MICROSLIP_INLINE static Value load(const double* from) { return Numbers<Real>::load(from, width); }
};

/// Rigid slip of a vector of rows: constant in x, linear in y.
template <class Real> struct RigidSlip {
  using Plain = typename Numbers<Real>::Plain;
  Real x, y, dy;
  void start(const MarchingRows& rows, int first) {
    x = Numbers<Real>::load(rows.rigid_slip_x + first, rows.stride);
    y = Numbers<Real>::load(rows.rigid_slip_y + first, rows.stride);
    dy = Numbers<Real>::load(rows.rigid_slip_dy + first, rows.stride);
  }
  MICROSLIP_INLINE Real y_at(double position) const { return y + dy * Plain(position); }
};

constexpr bool has_half_first_step(MarchingScheme scheme) {
  return scheme != MarchingScheme::fastsim;
}

/// The step that ends at the centre of cell i.
template <MarchingScheme scheme, class Real, class Bound>
MICROSLIP_INLINE Step<Real, typename Bound::Value> step_to(int i, const RigidSlip<Real>& w, const Bound& bound) {
  const double end = i - 0.5;
  const double length = i == 1 && has_half_first_step(scheme) ? 0.5 : 1.0;
  // Backward Euler with a full first step takes w at the step's end (F16), the others over the step.
  using Plain = typename Numbers<Real>::Plain;
  const double position = scheme == MarchingScheme::fastsim ? end : end - length / 2;
  Step<Real, typename Bound::Value> step;
  step.length = length;
  step.rigid_x = w.x * Plain(length);
  step.rigid_y = w.y_at(position) * Plain(length);
  step.bound = bound.centre(i);
  if constexpr (scheme == MarchingScheme::fastsim2) {
    const Plain half_length(length / 2);
    step.half_rigid_x = w.x * half_length;
    step.half_rigid_y = w.y_at(end - 0.75 * length) * half_length;
    step.bound_before = bound.centre(i - 1);
    step.bound_middle = bound.middle(i - 1);
  }
  return step;
}

/// A vector of rows on its path through the contact.
template <MarchingScheme scheme, class Real, class Bound> class March {
  using Vector = typename Numbers<Real>::Plain;
  using Mask = typename Numbers<Real>::Mask;

public:
  void start(const MarchingRows& rows, int first) {
    w_.start(rows, first);
    bound_.start(rows, first);
    at_ = {};
    sum_px_ = sum_py_ = sum_moment_ = Vector(0.0);
    slip_cells_ = Vector(0.0);
    if constexpr (scheme == MarchingScheme::fastsim2)
      start_sliding<Real, Vector, Mask, typename Bound::Value>(at_, w_.x, w_.y, bound_.slope());
  }

  MICROSLIP_INLINE void step(int i) {
    const auto step = step_to<scheme>(i, w_, bound_);
    if constexpr (scheme == MarchingScheme::fastsim2)
      slip_cells_ += fastsim2_step(at_, step);
    else
      slip_cells_ += fastsim_step(at_, step);
    sum_px_ += at_.px;
    sum_py_ += at_.py;
    sum_moment_ += at_.py * Vector(i - 0.5);
  }

  void record(const MarchingRows& rows, int i) const {
    const int index = (i - 1) * Vector::width;
    at_.px.store(rows.px + index);
    at_.py.store(rows.py + index);
    at_.slip_x.store(rows.slip_x + index);
    at_.slip_y.store(rows.slip_y + index);
    select(at_.sliding, Vector(1.0), Vector(0.0)).store(rows.sliding + index);
  }

  void finish(const MarchingRows& rows, int first) {
    const Vector last_half(has_half_first_step(scheme) ? 0.5 : 0.0);
    slip_cells_ += select(at_.sliding, last_half, Vector(0.0));
    Numbers<Real>::store(sum_px_, rows.sum_px + first, rows.stride);
    Numbers<Real>::store(sum_py_, rows.sum_py + first, rows.stride);
    Numbers<Real>::store(sum_moment_, rows.sum_moment + first, rows.stride);
    slip_cells_.store(rows.slip_cells + first);
  }

private:
  RigidSlip<Real> w_;
  Bound bound_;
  Particles<Real, Vector, Mask> at_;
  Real sum_px_, sum_py_, sum_moment_;
  Vector slip_cells_;
};

/// Marches all rows, a few vectors taking their steps in turn: the processor works on one while another waits for its
/// roots.
template <MarchingScheme scheme, class Real, int interleaved> void march(const MarchingRows& rows) {
  using Vector = typename Numbers<Real>::Plain;
  static_assert(interleaved * Vector::width <= widest_group);
  for (int first = 0; first < rows.count; first += interleaved * Vector::width) {
    const int vectors = std::min(interleaved, (rows.count - first + Vector::width - 1) / Vector::width);
    March<scheme, Real, ProfileBound<Vector>> marches[interleaved];
    for (int k = 0; k < vectors; ++k) marches[k].start(rows, first + k * Vector::width);
    for (int i = 1; i <= rows.cells; ++i)
      for (int k = 0; k < vectors; ++k) marches[k].step(i);
    for (int k = 0; k < vectors; ++k) marches[k].finish(rows, first + k * Vector::width);
  }
}

/// Marches one vector of rows, with the bound from tables.
template <MarchingScheme scheme, class Real, bool recording> void march_with_table(const MarchingRows& rows) {
  March<scheme, Real, TableBound<Real>> one;
  one.start(rows, 0);
  for (int i = 1; i <= rows.cells; ++i) {
    one.step(i);
    if constexpr (recording) one.record(rows, i);
  }
  one.finish(rows, 0);
}

template <MarchingScheme scheme> MarchingKernels kernels() {
  using Gradient = Dual<Doubles, creepage_partials>;
  using FullGradient = Dual<Doubles, row_partials>;
  constexpr int gradients_interleaved = register_size == 32 ? 2 : 1; // measured: two need more registers than there are
  return {Doubles::width,
          march<scheme, Doubles, 4>,
          march<scheme, Floats, 4>,
          march<scheme, Gradient, gradients_interleaved>,
          march_with_table<scheme, Doubles, false>,
          march_with_table<scheme, FullGradient, false>,
          march_with_table<scheme, Doubles, true>};
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

MarchingKernels marching_kernels(MarchingScheme scheme) {
  switch (scheme) {
  case MarchingScheme::fastsim:
    return kernels<MarchingScheme::fastsim>();
  case MarchingScheme::fastsim_half_step:
    return kernels<MarchingScheme::fastsim_half_step>();
  case MarchingScheme::fastsim2:
    break;
  }
  return kernels<MarchingScheme::fastsim2>();
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
