// Fast transforms of as many sequences at a time as a vector register has lanes, compiled once for every instruction
// set. Stockham's order: each pass writes its results sorted into other memory.

#include "microslip/numerics/kernel/transform.hpp"

#include "microslip/numerics/lanes.hpp"

namespace microslip::detail {
namespace {

/// A complex number in each lane.
template <class RealType, int lanes> struct Complexes {
  using Real = RealType;
  using Vector = Lanes<Real, lanes>;
  static constexpr int width = lanes;
  Vector re, im;

  MICROSLIP_INLINE static Complexes load(const Real* re, const Real* im) {
    return {Vector::load(re), Vector::load(im)};
  }
  MICROSLIP_INLINE void store(Real* to_re, Real* to_im) const {
    re.store(to_re);
    im.store(to_im);
  }

  MICROSLIP_INLINE friend Complexes operator+(const Complexes& a, const Complexes& b) {
    return {a.re + b.re, a.im + b.im};
  }
  MICROSLIP_INLINE friend Complexes operator-(const Complexes& a, const Complexes& b) {
    return {a.re - b.re, a.im - b.im};
  }
  MICROSLIP_INLINE friend Complexes operator*(Real c, const Complexes& a) { return {c * a.re, c * a.im}; }
  MICROSLIP_INLINE Complexes times(Real c, Real s) const { return {re * c - im * s, re * s + im * c}; }
  MICROSLIP_INLINE Complexes times_minus_i() const { return {im, -re}; }
};

/// z_k = sum_j exp(-2 pi i j k/radix) z_j in place.
template <int radix> struct Butterfly;
template <> struct Butterfly<1> {
  template <class Z> MICROSLIP_INLINE static void apply(Z*) {}
};
template <> struct Butterfly<2> {
  template <class Z> MICROSLIP_INLINE static void apply(Z* z) {
    const Z a = z[0];
    z[0] = a + z[1];
    z[1] = a - z[1];
  }
};
template <> struct Butterfly<3> {
  template <class Z> MICROSLIP_INLINE static void apply(Z* z) {
    constexpr auto sine = static_cast<typename Z::Real>(0.86602540378443864676); // sin(2 pi/3)
    const Z sum = z[1] + z[2], turned = sine * (z[1] - z[2]).times_minus_i();
    const Z mean = z[0] - static_cast<typename Z::Real>(0.5) * sum;
    z[0] = z[0] + sum;
    z[1] = mean + turned;
    z[2] = mean - turned;
  }
};
template <> struct Butterfly<4> {
  template <class Z> MICROSLIP_INLINE static void apply(Z* z) {
    const Z a = z[0] + z[2], b = z[0] - z[2], c = z[1] + z[3], d = (z[1] - z[3]).times_minus_i();
    z[0] = a + c;
    z[1] = b + d;
    z[2] = a - c;
    z[3] = b - d;
  }
};
template <> struct Butterfly<5> {
  template <class Z> MICROSLIP_INLINE static void apply(Z* z) {
    using Real = typename Z::Real;
    constexpr auto cos1 = static_cast<Real>(0.30901699437494742410), cos2 = static_cast<Real>(-0.80901699437494742410);
    constexpr auto sin1 = static_cast<Real>(0.95105651629515357212), sin2 = static_cast<Real>(0.58778525229247312917);
    const Z a = z[1] + z[4], b = z[2] + z[3], c = (z[1] - z[4]).times_minus_i(), d = (z[2] - z[3]).times_minus_i();
    const Z even1 = z[0] + cos1 * a + cos2 * b, even2 = z[0] + cos2 * a + cos1 * b;
    const Z odd1 = sin1 * c + sin2 * d, odd2 = sin2 * c - sin1 * d;
    z[0] = z[0] + a + b;
    z[1] = even1 + odd1;
    z[2] = even2 + odd2;
    z[3] = even2 - odd2;
    z[4] = even1 - odd1;
  }
};
template <> struct Butterfly<8> {
  template <class Z> MICROSLIP_INLINE static void apply(Z* z) {
    constexpr auto root = static_cast<typename Z::Real>(0.70710678118654752440); // cos(pi/4)
    Z even[4] = {z[0], z[2], z[4], z[6]}, odd[4] = {z[1], z[3], z[5], z[7]};
    Butterfly<4>::apply(even);
    Butterfly<4>::apply(odd);
    const Z b = odd[1], d = odd[3];
    odd[1] = {root * (b.re + b.im), root * (b.im - b.re)};
    odd[2] = odd[2].times_minus_i();
    odd[3] = {root * (d.im - d.re), -root * (d.re + d.im)};
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j) {
      z[j] = even[j] + odd[j];
      z[j + 4] = even[j] - odd[j];
    }
  }
};

/// Lines that a pass reads or writes; an exchange of real and imaginary parts makes a transform of its inverse.
template <class Real> struct Lines {
  Real *re, *im;
  std::size_t stride;
  int count; ///< of n: the others are zero, or not wanted

  Lines(const BlockLines<Real>& lines, bool exchanged)
      : re(lines.first + (exchanged ? block_lanes<Real> : 0)), im(lines.first + (exchanged ? 0 : block_lanes<Real>)),
        stride(lines.stride), count(lines.count) {}
};
template <class Real> Lines(const BlockLines<Real>&, bool) -> Lines<Real>;

/// One pass, for `vectors` registers side by side. `inputs` and `outputs` of a butterfly's numbers may be present, all
/// of them unless this is an edge, the first or the last pass.
template <class Z, int radix, int inputs, int outputs, bool edge> class Pass {
public:
  using Real = typename Z::Real;

  Pass(const TransformPass<Real>& pass, const Lines<const Real>& in, const Lines<Real>& out, int vectors)
      : groups_(pass.groups), together_(pass.together), in_(in), out_(out), vectors_(vectors) {
    butterflies<false>(0, nullptr);
    const Real* factors = pass.factors;
    for (int k = 1; k < groups_; ++k, factors += 2 * (radix - 1)) butterflies<true>(k, factors);
  }

private:
  /// Butterflies with the k-th factors.
  template <bool has_factors> MICROSLIP_INLINE void butterflies(int k, const Real* factors) const {
    const std::size_t in_step = static_cast<std::size_t>(together_) * groups_ * in_.stride;
    const std::size_t out_step = static_cast<std::size_t>(together_) * out_.stride;
    for (int t = 0; t < together_; ++t) {
      const int first = t + together_ * k, to = t + together_ * radix * k;
      std::size_t at = first * in_.stride, out = to * out_.stride;
      for (int v = 0; v < vectors_; ++v, at += Z::width, out += Z::width) {
        Z z[radix];
#pragma GCC unroll 8
        for (int j = 0; j < radix; ++j)
          if (j < inputs && (!edge || first + together_ * groups_ * j < in_.count))
            z[j] = Z::load(in_.re + at + j * in_step, in_.im + at + j * in_step);
          else
            z[j] = Z();
        Butterfly<radix>::apply(z);
#pragma GCC unroll 8
        for (int j = 0; j < outputs; ++j) {
          if (edge && to + together_ * j >= out_.count) continue;
          if (has_factors && j > 0) z[j] = z[j].times(factors[2 * j - 2], factors[2 * j - 1]);
          z[j].store(out_.re + out + j * out_step, out_.im + out + j * out_step);
        }
      }
    }
  }

  int groups_, together_;
  Lines<const Real> in_;
  Lines<Real> out_;
  int vectors_;
};

/// Runs one pass. In products with Toeplitz matrices half of the numbers are zero, half not wanted. Even radices first.
template <class Z, int radix, class Real = typename Z::Real>
void run_pass(const TransformPass<Real>& pass, const Lines<const Real>& in, const Lines<Real>& out, int vectors) {
  constexpr int half = (radix + 1) / 2;
  const int n = radix * pass.groups * pass.together, part = half * pass.groups * pass.together;
  if (in.count == n && out.count == n) {
    Pass<Z, radix, radix, radix, false>(pass, in, out, vectors);
    return;
  }
  if constexpr (radix % 2 == 0)
    if (in.count <= part) {
      Pass<Z, radix, half, radix, true>(pass, in, out, vectors);
      return;
    }
  if (out.count <= part && pass.groups == 1)
    Pass<Z, radix, radix, half, true>(pass, in, out, vectors);
  else
    Pass<Z, radix, radix, radix, true>(pass, in, out, vectors);
}

template <class Z, class Real = typename Z::Real>
void run_pass(const TransformPass<Real>& pass, const Lines<const Real>& in, const Lines<Real>& out, int vectors) {
  switch (pass.radix) {
  case 2:
    return run_pass<Z, 2>(pass, in, out, vectors);
  case 3:
    return run_pass<Z, 3>(pass, in, out, vectors);
  case 4:
    return run_pass<Z, 4>(pass, in, out, vectors);
  case 5:
    return run_pass<Z, 5>(pass, in, out, vectors);
  case 8:
    return run_pass<Z, 8>(pass, in, out, vectors);
  default:
    return run_pass<Z, 1>(pass, in, out, vectors);
  }
}

/// Passes write to `odd`, `even`, `odd` ... and the last one to `out`.
template <class Z, class Real = typename Z::Real>
void transform(const TransformPasses<Real>& passes, bool backward, const BlockLines<const Real>& in, Real* odd,
               Real* even, const BlockLines<Real>& out, int vectors) {
  BlockLines<const Real> from = in;
  for (int i = 0; i < passes.count; ++i) {
    const bool first = i == 0, last = i + 1 == passes.count;
    const BlockLines<Real> to = last ? out : BlockLines<Real>{i % 2 == 0 ? odd : even, line_size<Real>, passes.n};
    run_pass<Z>(passes.first[i], Lines(from, first && backward), Lines(to, last && backward), vectors);
    from = {to.first, to.stride, to.count};
  }
}

/// Calls work with the type of the registers for so many lanes, the widest or the narrowest ones, and how many of them
/// that takes.
template <class Real, class Work> void with_registers(int lanes, Work work) {
  constexpr int widest = register_size / static_cast<int>(sizeof(Real)), least = 16 / static_cast<int>(sizeof(Real));
  if constexpr (widest > least)
    if (lanes <= least) return work(Complexes<Real, least>(), 1);
  work(Complexes<Real, widest>(), (lanes + widest - 1) / widest);
}

template <class Real>
void columns_forward(const TransformPasses<Real>& passes, const BlockLines<const Real>& in, int lanes, Real* out,
                     Real* work) {
  const bool ends_on_even = passes.count % 2 == 0;
  with_registers<Real>(lanes, [&](auto z, int vectors) {
    transform<decltype(z)>(passes, false, in, ends_on_even ? work : out, ends_on_even ? out : work,
                           {out, line_size<Real>, passes.n}, vectors);
  });
}

template <class Real>
void columns_backward(const TransformPasses<Real>& passes, Real* in, const BlockLines<Real>& out, int lanes,
                      Real* work) {
  with_registers<Real>(lanes, [&](auto z, int vectors) {
    transform<decltype(z)>(passes, true, {in, line_size<Real>, passes.n}, work, in, out, vectors);
  });
}

/// Rows 2 l and 2 l + 1 are real and imaginary parts of lane l: z = even + i odd has the waves E + i O, of which E and
/// O are the parts with E(-k) = conj E(k).
template <class Z> class RowBatch {
public:
  using Real = typename Z::Real;
  using Vector = typename Z::Vector;

  RowBatch(const TransformPasses<Real>& passes, int rows, int length, int vectors, Real* work)
      : passes_(passes), n_(passes.n), last_(passes.n / 2), rows_(rows), length_(length), vectors_(vectors),
        begin_(work), other_(work + row_work_size<Real>(passes.n) / 2), end_(passes.count % 2 == 0 ? begin_ : other_) {}

  void forward(const RowPairs<const Real>& rows, Real* waves, std::size_t block_stride) const {
    for (int v = 0; v < vectors_; ++v) {
      const auto from = rows.from_pair(static_cast<std::size_t>(v) * width);
      for (int i = 0; i < length_; i += width) {
        Real* to = begin_ + static_cast<std::size_t>(i) * line + v * width;
        gather(from.even + i, from.stride, (rows_ + 1) / 2 - v * width, length_ - i, to);
        gather(from.odd + i, from.stride, rows_ / 2 - v * width, length_ - i, to + lanes);
      }
    }
    transform<Z>(passes_, false, {begin_, line, length_}, other_, begin_, {end_, line, n_}, vectors_);
    for (int v = 0; v < vectors_; ++v)
      for (int k = 0; k <= last_; k += width)
        split(end_ + v * width, k, rows_ - 2 * v * width, waves + of_wave(k, v, block_stride));
  }

  void backward(const Real* waves, std::size_t block_stride, const RowPairs<Real>& rows) const {
    for (int v = 0; v < vectors_; ++v)
      for (int k = 0; k <= last_; k += width)
        join(waves + of_wave(k, v, block_stride), rows_ - 2 * v * width, k, begin_ + v * width);
    transform<Z>(passes_, true, {begin_, line, n_}, other_, begin_, {end_, line, length_}, vectors_);
    for (int v = 0; v < vectors_; ++v) {
      const auto to = rows.from_pair(static_cast<std::size_t>(v) * width);
      for (int i = 0; i < length_; i += width) {
        const Real* from = end_ + static_cast<std::size_t>(i) * line + v * width;
        scatter(from, to.even + i, to.stride, (rows_ + 1) / 2 - v * width, length_ - i);
        scatter(from + lanes, to.odd + i, to.stride, rows_ / 2 - v * width, length_ - i);
      }
    }
  }

private:
  static constexpr int width = Z::width, lanes = block_lanes<Real>, line = line_size<Real>;

  /// Offset of the waves from k on of the rows in the v-th register.
  static std::size_t of_wave(int k, int v, std::size_t block_stride) {
    return k / lanes * block_stride + static_cast<std::size_t>(2 * width * v) * line + k % lanes;
  }

  /// `width` numbers of as many rows, zero beyond those that there are, to a lane for each row.
  MICROSLIP_INLINE static void gather(const Real* from, std::size_t stride, int rows, int length, Real* to) {
    Vector v[width];
    if (rows >= width && length >= width) {
#pragma GCC unroll 16
      for (int i = 0; i < width; ++i) v[i] = Vector::load(from + i * stride);
    } else {
      for (int i = 0; i < width; ++i) {
        v[i] = Vector(0);
        if (i < rows) __builtin_memcpy(&v[i], from + i * stride, (length < width ? length : width) * sizeof(Real));
      }
    }
    transpose(v);
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i) v[i].store(to + i * line);
  }

  MICROSLIP_INLINE static void scatter(const Real* from, Real* to, std::size_t stride, int rows, int length) {
    Vector v[width];
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i) v[i] = Vector::load(from + i * line);
    transpose(v);
    if (rows >= width && length >= width) {
#pragma GCC unroll 16
      for (int i = 0; i < width; ++i) v[i].store(to + i * stride);
    } else {
      for (int i = 0; i < rows && i < width; ++i)
        __builtin_memcpy(to + i * stride, &v[i], (length < width ? length : width) * sizeof(Real));
    }
  }

  /// A square of waves and rows, for the even rows and the odd ones.
  struct Square {
    Vector even_re[width], even_im[width], odd_re[width], odd_im[width];

    MICROSLIP_INLINE void transpose_all() {
      transpose(even_re);
      transpose(even_im);
      transpose(odd_re);
      transpose(odd_im);
    }
  };

  MICROSLIP_INLINE std::size_t mirror(int wave) const {
    return static_cast<std::size_t>(wave == 0 ? 0 : n_ - wave);
  }

  /// Waves from k on of z to those of the rows.
  MICROSLIP_INLINE void split(const Real* z, int k, int rows, Real* to) const {
    Square s;
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i) {
      const int wave = k + i <= last_ ? k + i : last_;
      const Real *at = z + static_cast<std::size_t>(wave) * line, *image = z + mirror(wave) * line;
      const Z a = Z::load(at, at + lanes), b = Z::load(image, image + lanes);
      constexpr auto half = static_cast<Real>(0.5);
      s.even_re[i] = half * (a.re + b.re), s.even_im[i] = half * (a.im - b.im);
      s.odd_re[i] = half * (a.im + b.im), s.odd_im[i] = half * (b.re - a.re);
    }
    s.transpose_all();
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i, to += 2 * line) {
      if (2 * i < rows) Z{s.even_re[i], s.even_im[i]}.store(to, to + lanes);
      if (2 * i + 1 < rows) Z{s.odd_re[i], s.odd_im[i]}.store(to + line, to + line + lanes);
    }
  }

  MICROSLIP_INLINE void join(const Real* from, int rows, int k, Real* z) const {
    Square s;
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i, from += 2 * line) {
      Z even = Z(), odd = Z();
      if (2 * i < rows) even = Z::load(from, from + lanes);
      if (2 * i + 1 < rows) odd = Z::load(from + line, from + line + lanes);
      s.even_re[i] = even.re, s.even_im[i] = even.im, s.odd_re[i] = odd.re, s.odd_im[i] = odd.im;
    }
    s.transpose_all();
#pragma GCC unroll 16
    for (int i = 0; i < width; ++i) {
      if (k + i > last_) break;
      Real *at = z + static_cast<std::size_t>(k + i) * line, *image = z + mirror(k + i) * line;
      Z{s.even_re[i] + s.odd_im[i], s.odd_re[i] - s.even_im[i]}.store(image, image + lanes);
      Z{s.even_re[i] - s.odd_im[i], s.even_im[i] + s.odd_re[i]}.store(at, at + lanes);
    }
  }

  TransformPasses<Real> passes_;
  int n_, last_, rows_, length_, vectors_;
  Real *begin_, *other_, *end_; ///< where transforms begin, and where they end
};

template <class Real>
void rows_forward(const TransformPasses<Real>& passes, const RowPairs<const Real>& rows, int count, int length,
                  Real* waves, std::size_t block_stride, Real* work) {
  with_registers<Real>((count + 1) / 2, [&](auto z, int vectors) {
    RowBatch<decltype(z)>(passes, count, length, vectors, work).forward(rows, waves, block_stride);
  });
}

template <class Real>
void rows_backward(const TransformPasses<Real>& passes, const Real* waves, std::size_t block_stride,
                   const RowPairs<Real>& rows, int count, int length, Real* work) {
  with_registers<Real>((count + 1) / 2, [&](auto z, int vectors) {
    RowBatch<decltype(z)>(passes, count, length, vectors, work).backward(waves, block_stride, rows);
  });
}

template <class Real>
constexpr TransformKernels<Real> kernels = {rows_forward<Real>, rows_backward<Real>, columns_forward<Real>,
                                            columns_backward<Real>};

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

void set_kernels(TransformKernels<double>& to) {
  to = kernels<double>;
}
void set_kernels(TransformKernels<float>& to) {
  to = kernels<float>;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
