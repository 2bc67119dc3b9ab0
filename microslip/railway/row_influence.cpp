#include "microslip/railway/row_influence.hpp"

#include "microslip/numerics/elimination.hpp"
#include "microslip/numerics/tanh_sinh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array<double, 4> squares = {0, 0.25, 0.64, 1}; // rho^2 at which the influence is exact

/// Density of S or T.
double semicircle(double t) {
  return 2 / pi * std::sqrt(std::max(1 - t * t, 0.0));
}

/// |Z| of rows with c = 1 at the nodes of a quadrature, with its density times their weights.
class Difference {
public:
  explicit Difference(double square) : a_(std::sqrt(1 + std::sqrt(square))), b_(std::sqrt(1 - std::sqrt(square))) {
    add(0, a_ - b_), add(a_ - b_, a_ + b_);
  }
  /// E[asinh(delta/|Z|)] and its derivative.
  std::array<double, 2> at(double delta) const {
    std::array<double, 2> sum{};
    for (std::size_t k = 0; k < z_.size(); ++k) {
      sum[0] += weight_[k] * std::asinh(delta / z_[k]);
      sum[1] += weight_[k] / std::sqrt(z_[k] * z_[k] + delta * delta);
    }
    return sum;
  }

private:
  void add(double from, double to) {
    if (!(to > from)) return;
    for (int k = 0; k < TanhSinh::count; ++k) {
      const double z = rule_.node(k, from, to);
      z_.push_back(z), weight_.push_back(2 * rule_.weight(k, from, to) * density(z));
    }
  }
  /// Of Z at z >= 0: b T = y and a S = z + y.
  double density(double z) const {
    if (!(b_ > 0)) return semicircle(z / a_) / a_;
    const double high = std::max(std::min(b_, a_ - z), -b_);
    double sum = 0;
    for (int k = 0; k < TanhSinh::count; ++k) {
      const double y = rule_.node(k, -b_, high);
      sum += rule_.weight(k, -b_, high) * semicircle((z + y) / a_) * semicircle(y / b_);
    }
    return sum / (a_ * b_);
  }

  TanhSinh rule_;
  double a_, b_;
  std::vector<double> z_, weight_;
};

/// Values and derivatives of P_n at a distance.
struct Terms {
  std::array<double, squares.size()> value{}, slope{};
};

Terms terms_at(std::span<const Difference> differences, double delta) {
  constexpr std::size_t n = squares.size();
  Terms terms;
  std::array<double, n * n> matrix{};
  for (std::size_t k = 0; k < n; ++k) {
    const std::array<double, 2> exact = differences[k].at(delta);
    terms.value[k] = exact[0], terms.slope[k] = exact[1];
    double power = 1;
    for (std::size_t m = 0; m < n; ++m, power *= squares[k]) matrix[k * n + m] = power;
  }
  eliminate(matrix, {terms.value, terms.slope});
  return terms;
}

} // namespace

RowInfluence::RowInfluence() {
  std::vector<Difference> differences;
  for (const double square : squares) differences.emplace_back(square);
  const std::uint64_t last = bit_cast<std::uint64_t>(largest) >> bits_dropped;
  Terms here = terms_at(differences, smallest);
  at_smallest_ = here.value, slope_at_smallest_ = here.slope;
  for (std::uint64_t k = first_segment; k < last; ++k) {
    const double start = bit_cast<double>(k << bits_dropped), end = bit_cast<double>((k + 1) << bits_dropped);
    const Terms after = terms_at(differences, end);
    const double h = end - start;
    Segment& segment = segments_.emplace_back();
    segment.start = start;
    for (std::size_t n = 0; n < terms; ++n) {
      const double secant = (after.value[n] - here.value[n]) / h, s0 = here.slope[n], s1 = after.slope[n];
      segment.powers[0][n] = here.value[n], segment.powers[1][n] = s0;
      segment.powers[2][n] = (3 * secant - 2 * s0 - s1) / h, segment.powers[3][n] = (s0 + s1 - 2 * secant) / (h * h);
    }
    here = after;
  }
  at_largest_ = here.value;
}

/// P_n = delta (A - B ln(delta)) + O(delta^2).
RowInfluence::Series RowInfluence::near(double delta) const {
  Series series{};
  if (!(delta > 0)) return series;
  for (std::size_t n = 0; n < terms; ++n) {
    const double mean = at_smallest_[n] / smallest, fall = mean - slope_at_smallest_[n];
    const double value = mean - fall * std::log(delta / smallest);
    series.p[n] = delta * value, series.s[n] = delta * (value - fall), series.ss[n] = delta * (value - 2 * fall);
  }
  return series;
}

/// P_0 = ln(delta) + constant + O(delta^-2), the others are constants.
RowInfluence::Series RowInfluence::far(double delta) const {
  Series series{at_largest_, {1}, {}};
  series.p[0] += std::log(delta / largest);
  return series;
}

RowInfluence::Series RowInfluence::series(double delta) const {
  if (!(delta >= smallest)) return near(delta);
  if (!(delta < largest)) return far(delta);
  // The first bits of a number's mantissa and its exponent count the segments, some of each octave.
  const Segment& segment =
      segments_[static_cast<std::size_t>((bit_cast<std::uint64_t>(delta) >> bits_dropped) - first_segment)];
  const double t = delta - segment.start;
  const auto& [c0, c1, c2, c3] = segment.powers;
  Series series;
  for (std::size_t n = 0; n < terms; ++n) {
    const double slope = c1[n] + t * (2 * c2[n] + t * 3 * c3[n]);
    series.p[n] = c0[n] + t * (c1[n] + t * (c2[n] + t * c3[n]));
    series.s[n] = delta * slope, series.ss[n] = delta * (slope + delta * (2 * c2[n] + t * 6 * c3[n]));
  }
  return series;
}

/// With S = delta dP/d(delta): P is a function of delta and rho, d ln c/d ln a = (1 + rho)/2, d rho/d ln a = 1 - rho^2;
/// and of distances and lengths alike, so that its derivatives with respect to ln a and ln b add up to -S.
RowInfluence::Values RowInfluence::at(double distance, double a, double b) const {
  const double sum = a * a + b * b, rho = (a * a - b * b) / sum, e = rho * rho;
  const Series f = series(std::abs(distance) / std::sqrt(sum / 2));
  const auto value = [e](const std::array<double, terms>& c) { return c[0] + e * (c[1] + e * (c[2] + e * c[3])); };
  const auto by_rho = [e, rho](const std::array<double, terms>& c) {
    return 2 * rho * (c[1] + e * (2 * c[2] + e * 3 * c[3]));
  };
  const double p_rho = by_rho(f.p), p_rho_rho = 2 * f.p[1] + e * (12 * f.p[2] + e * 30 * f.p[3]);
  const double s = value(f.s), s_rho = by_rho(f.s), ss = value(f.ss);
  const double scale = (1 + rho) / 2, turn = 1 - e;
  Values v;
  v.p = value(f.p);
  v.by_a = turn * p_rho - scale * s, v.by_b = -s - v.by_a;
  v.by_aa = scale * scale * ss - 2 * scale * turn * s_rho - turn * s / 2 + turn * (turn * p_rho_rho - 2 * rho * p_rho);
  v.by_ab = scale * ss - turn * s_rho - v.by_aa;
  if (distance < 0)
    for (double* value_of : {&v.p, &v.by_a, &v.by_b, &v.by_aa, &v.by_ab}) *value_of = -*value_of;
  return v;
}

} // namespace microslip
