// Loops over blocks of waves, compiled once for every instruction set.

#include "microslip/numerics/kernel/wave_loops.hpp"

#include "microslip/numerics/lanes.hpp"
#include "microslip/numerics/transforms.hpp"

namespace microslip::detail {
namespace {

template <class Real> void multiply_even(const Real* table, int rows, Real* waves) {
  constexpr int lanes = block_lanes<Real>;
  for (int k = 0; k < rows; ++k, waves += line_size<Real>) {
    const Real* t = table + (k <= rows / 2 ? k : rows - k) * lanes;
#pragma omp simd
    for (int i = 0; i < lanes; ++i) {
      waves[i] *= t[i];
      waves[lanes + i] *= t[i];
    }
  }
}

template <class Real> void multiply_symmetric(const Real* table, int rows, Real* x, Real* y) {
  constexpr int lanes = block_lanes<Real>;
  for (int k = 0; k < rows; ++k, x += line_size<Real>, y += line_size<Real>) {
    const Real* t = table + (k <= rows / 2 ? k : rows - k) * 3 * lanes;
    const Real sign = k <= rows / 2 ? Real(1) : Real(-1);
#pragma omp simd
    for (int i = 0; i < lanes; ++i) {
      const Real xx = t[i], xy = sign * t[lanes + i], yy = t[2 * lanes + i];
      const Real x_re = x[i], x_im = x[lanes + i], y_re = y[i], y_im = y[lanes + i];
      x[i] = xx * x_re + xy * y_re;
      x[lanes + i] = xx * x_im + xy * y_im;
      y[i] = xy * x_re + yy * y_re;
      y[lanes + i] = xy * x_im + yy * y_im;
    }
  }
}

template <class Real> void multiply_coupled(const Real* table, int rows, Real* x, Real* y, Real* z) {
  constexpr int lanes = block_lanes<Real>, line = line_size<Real>;
  for (int k = 0; k < rows; ++k, x += line, y += line, z += line) {
    const Real* t = table + (k <= rows / 2 ? k : rows - k) * 6 * lanes;
    const Real sign = k <= rows / 2 ? Real(1) : Real(-1);
#pragma omp simd
    for (int i = 0; i < lanes; ++i) {
      const Real xx = t[i], xy = sign * t[lanes + i], yy = t[2 * lanes + i];
      const Real xz = t[3 * lanes + i], yz = sign * t[4 * lanes + i], zz = t[5 * lanes + i];
      const Real x_re = x[i], x_im = x[lanes + i], y_re = y[i], y_im = y[lanes + i], z_re = z[i], z_im = z[lanes + i];
      x[i] = xx * x_re + xy * y_re - xz * z_im;
      x[lanes + i] = xx * x_im + xy * y_im + xz * z_re;
      y[i] = xy * x_re + yy * y_re - yz * z_im;
      y[lanes + i] = xy * x_im + yy * y_im + yz * z_re;
      z[i] = zz * z_re + xz * x_im + yz * y_im;
      z[lanes + i] = zz * z_im - xz * x_re - yz * y_re;
    }
  }
}

template <class Real> void add_product(const Real* table, int rows, const Real* waves, Real* to) {
  constexpr int lanes = block_lanes<Real>, line = line_size<Real>;
  for (int k = 0; k < rows; ++k, table += line, waves += line, to += line)
#pragma omp simd
    for (int i = 0; i < lanes; ++i) {
      const Real re = table[i] * waves[i] - table[lanes + i] * waves[lanes + i];
      const Real im = table[i] * waves[lanes + i] + table[lanes + i] * waves[i];
      to[i] += re;
      to[lanes + i] += im;
    }
}

template <class Real>
void filter(const Real* gain, const Real* zero, const Real* pole, Real* first, std::ptrdiff_t step, int pairs) {
  using Vector = Lanes<Real>;
  constexpr int lanes = block_lanes<Real>, width = Vector::width, parts = 4;
  for (int v = 0; v < lanes; v += width) {
    const Vector g = Vector::load(gain + v), z = Vector::load(zero + v), p = Vector::load(pole + v);
    Vector before[parts] = {}, last[parts] = {}; // v_(i-1) and w_(i-1): real and imaginary parts of both lines
    Real* at = first + v;
    for (int i = 0; i < pairs; ++i, at += step)
#pragma GCC unroll 4
      for (int part = 0; part < parts; ++part) {
        const Vector now = Vector::load(at + part * lanes);
        last[part] = now + (p * last[part] - z * before[part]);
        before[part] = now;
        (g * last[part]).store(at + part * lanes);
      }
  }
}

template <class Real>
constexpr WaveLoops<Real> loops = {multiply_even<Real>, multiply_symmetric<Real>, multiply_coupled<Real>,
                                   add_product<Real>, filter<Real>};

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

void set_loops(WaveLoops<double>& to) {
  to = loops<double>;
}
void set_loops(WaveLoops<float>& to) {
  to = loops<float>;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
