#pragma once

#include "microslip/numerics/lanes.hpp"
#include "microslip/numerics/vector_log.hpp"

#include <cmath>

namespace microslip::detail {

/// ln x for x > 0.
MICROSLIP_INLINE double logarithm(double x) {
  return vector_log(x);
}
template <class Real, int count> MICROSLIP_INLINE Lanes<Real, count> logarithm(const Lanes<Real, count>& x) {
  Real numbers[count];
  x.store(numbers);
#pragma omp simd
  for (int i = 0; i < count; ++i) numbers[i] = vector_log(numbers[i]);
  return Lanes<Real, count>::load(numbers);
}

/// The influence of a row of semi-elliptic pressure on another one, in lanes or for a single pair. A row carries a load
/// of q for each unit of width with p = 2 q/(pi b) sqrt(1 - x^2/b^2); on a row of half-length a that is a distance y
/// away its displacement has the mean, with the weight of a semi-ellipse as well,
///   C q dy E[(Z^2 + y^2)^(-1/2)],  Z = a S - b T,
/// C = (1 - nu)/(pi G), S and T independent with the density 2/pi sqrt(1 - t^2) on [-1, 1]. Over a strip that is
///   P = E[asinh(D/|Z|)]                                                                                     (W7)
/// between the distances D of its edges. P depends on delta = D/c, c^2 = (a^2 + b^2)/2, in which Z has the same
/// variance whatever a/b, and little on rho = (a^2 - b^2)/(a^2 + b^2), which is 0 for equal rows:
///   P = sum of rho^(2 n) P_n(delta), P_n = h (A_n(m) + ln(delta^2) B_n(m)), h = delta/sqrt(1 + delta^2), m = h^2,
/// n = 0 to 3. Coefficients are those that tools/fit_row_influence.py prints, with errors of 3e-4; where rho^2 is none
/// of 0, 0.25, 0.64 and 1 P errs by 0.4 % at delta = 0.01, 0.2 % at 0.2, 0.1 % from 1 on.
template <class Number> struct RowPair {
  /// P and its derivatives with respect to ln a and ln b; odd in the distance.
  Number p, by_a, by_b, by_aa, by_ab;

  /// Pair of the strip between two distances.
  MICROSLIP_INLINE static RowPair between(const Number& low, const Number& high, const Number& a, const Number& b);

private:
  static constexpr int terms = 4, degree = 5, count = 2 * (degree + 1);
  static constexpr double coefficients[terms][count] = {
      {1.55853554545, 1.8287948439, 5.46349039002, -15.5689210524, 9.30685049187, -0.951655319084, -0.540131623437,
       -0.166137916873, 3.26100024605, -0.295427086874, -3.19234966137, 1.43299193385},
      {0.190846455463, 0.107744169411, -4.88149165242, 7.11089648992, -2.20371149034, -0.498225601671, 0.229873574211,
       0.620568959859, -1.01865319782, -1.49363097167, 2.4739320962, -0.812058908115},
      {-0.386267645131, -0.535923100245, 7.68413888159, -10.2002478861, 2.57238427442, 0.996796945641, -0.257638039367,
       -1.01925046718, 1.28647023229, 2.64627559853, -3.88120389892, 1.22529824369},
      {0.199369802843, 0.325659874708, -3.91933169513, 5.06828522189, -1.18974049403, -0.537869935857, 0.117930146244,
       0.524426163687, -0.612171505474, -1.39114229944, 1.97914860618, -0.618166618986}};

  /// A and B with their derivatives.
  struct Series {
    Number a[3], b[3];

    /// The first `derivatives` of them at m; `c` are the coefficients of both.
    template <int derivatives> MICROSLIP_INLINE void find(const Number* c, const Number& m) {
      find<derivatives>(c, m, a), find<derivatives>(c + degree + 1, m, b);
    }

  private:
    template <int derivatives> MICROSLIP_INLINE static void find(const Number* c, const Number& m, Number (&value)[3]) {
      value[0] = c[degree], value[1] = value[2] = Number(0);
#pragma GCC unroll 8
      for (int k = degree - 1; k >= 0; --k) {
        if constexpr (derivatives > 1) value[2] = value[2] * m + value[1];
        if constexpr (derivatives > 0) value[1] = value[1] * m + value[0];
        value[0] = value[0] * m + c[k];
      }
    }
  };

  /// P, S = dP/d ln(delta) and dS/d ln(delta), and derivatives with respect to rho^2.
  struct Edge {
    Number p, s, ss, p1, s1, p2;
  };
  MICROSLIP_INLINE static Edge edge(const Number& delta, const Number* c0, const Number* c1, const Number* c2);
};

template <class Number>
MICROSLIP_INLINE auto RowPair<Number>::edge(const Number& delta, const Number* c0, const Number* c1, const Number* c2)
    -> Edge {
  using std::sqrt;
  constexpr double tiny = 1e-30; // where delta is 0 so is h
  const Number square = delta * delta + Number(tiny), rate = Number(1) / (Number(1) + square), m = square * rate,
               h = delta * sqrt(rate), l = logarithm(square);
  const Number dm = Number(2) * m * rate, ddm = Number(2) * (rate - m) * dm;
  Series f;
  Edge out;
  f.template find<2>(c0, m);
  {
    const Number q = f.a[0] + l * f.b[0], dq = (f.a[1] + l * f.b[1]) * dm + Number(2) * f.b[0];
    const Number ddq =
        Number(2) * (f.a[2] + l * f.b[2]) * dm * dm + (f.a[1] + l * f.b[1]) * ddm + Number(4) * f.b[1] * dm;
    out.p = h * q, out.s = h * (rate * q + dq);
    out.ss = h * ((rate * rate - dm) * q + Number(2) * rate * dq + ddq);
  }
  f.template find<1>(c1, m);
  {
    const Number q = f.a[0] + l * f.b[0], dq = (f.a[1] + l * f.b[1]) * dm + Number(2) * f.b[0];
    out.p1 = h * q, out.s1 = h * (rate * q + dq);
  }
  f.template find<0>(c2, m);
  out.p2 = h * (f.a[0] + l * f.b[0]);
  return out;
}

/// P is a function of delta and rho, d ln c/d ln a = (1 + rho)/2, d rho/d ln a = 1 - rho^2; and of distances and
/// lengths alike, so that its derivatives with respect to ln a and ln b add up to -S.
template <class Number>
MICROSLIP_INLINE RowPair<Number> RowPair<Number>::between(const Number& low, const Number& high, const Number& a,
                                                          const Number& b) {
  using std::sqrt;
  const Number a2 = a * a, b2 = b * b, sum = a2 + b2, rho = (a2 - b2) / sum, e = rho * rho,
               scale = Number(1) / sqrt(Number(0.5) * sum);
  Number c0[count], c1[count], c2[count];
#pragma GCC unroll 16
  for (int k = 0; k < count; ++k) {
    const double *f0 = coefficients[0] + k, *f1 = coefficients[1] + k, *f2 = coefficients[2] + k,
                 *f3 = coefficients[3] + k;
    c0[k] = Number(*f0) + e * (Number(*f1) + e * (Number(*f2) + e * Number(*f3)));
    c1[k] = Number(*f1) + e * (Number(2 * *f2) + e * Number(3 * *f3));
    c2[k] = Number(2 * *f2) + e * Number(6 * *f3);
  }
  const Edge outer = edge(high * scale, c0, c1, c2), inner = edge(low * scale, c0, c1, c2);
  const Number s = outer.s - inner.s, ss = outer.ss - inner.ss, p1 = outer.p1 - inner.p1, p2 = outer.p2 - inner.p2;
  const Number p_rho = Number(2) * rho * p1, s_rho = Number(2) * rho * (outer.s1 - inner.s1),
               p_rho_rho = Number(2) * p1 + Number(4) * e * p2;
  const Number share = Number(0.5) * (Number(1) + rho), turn = Number(1) - e;
  RowPair out;
  out.p = outer.p - inner.p;
  out.by_a = turn * p_rho - share * s;
  out.by_b = -s - out.by_a;
  out.by_aa = share * share * ss - Number(2) * share * turn * s_rho - Number(0.5) * turn * s +
              turn * (turn * p_rho_rho - Number(2) * rho * p_rho);
  out.by_ab = share * ss - turn * s_rho - out.by_aa;
  return out;
}

} // namespace microslip::detail
