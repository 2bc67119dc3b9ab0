#include "microslip/railway/hertzian_rows.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/numerics/fade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;

/// An ellipse E11 x^2 + 2 E12 x s + E22 s^2 = 1.
struct Ellipse {
  double e11, e12, e22;
};

/// Hertz's contact under the paraboloid A (x - m s)^2 + B s^2, whose axes are turned where it is skew.
struct TurnedHertz {
  Ellipse ellipse;
  HertzContact contact;
};
template <class Solve> TurnedHertz turned_hertz(double a, double b, double skew, Solve&& solve) {
  const double xx = a, xs = -a * skew, ss = a * skew * skew + b;
  const double turn = 0.5 * std::atan2(2 * xs, xx - ss), c = std::cos(turn), s = std::sin(turn);
  const double first = xx * c * c + 2 * xs * c * s + ss * s * s, second = xx * s * s - 2 * xs * c * s + ss * c * c;
  const HertzContact contact = solve(GapCurvatures{first, second});
  const double p = 1 / (contact.a * contact.a), r = 1 / (contact.b * contact.b);
  return {{p * c * c + r * s * s, (p - r) * c * s, p * s * s + r * c * c}, contact};
}

/// Integral of 1 - t^2 over the part of [low, high] that lies in [-1, 1].
double parabola_between(double low, double high) {
  const auto integral = [](double t) {
    const double u = std::clamp(t, -1.0, 1.0);
    return u - u * u * u / 3;
  };
  return integral(high) - integral(low);
}

} // namespace

HertzianRows::HertzianRows(std::size_t most_rows)
    : weight_(most_rows), load_(most_rows), half_length_(most_rows), centre_(most_rows), place_(most_rows) {}

/// The squared overlap times the width, where the overlap of a row counts as far as there is as much all the way to the
/// deepest row: so rows beyond a hole count as it closes. Returns the largest overlap that does not count, over the
/// greatest one.
double HertzianRows::find_weights(std::span<const ContactRow> rows) {
  std::size_t deepest = 0;
  for (std::size_t k = 1; k < count_; ++k)
    if (rows[k].normal.gap < rows[deepest].normal.gap) deepest = k;
  const double most = std::max(-rows[deepest].normal.gap, 0.0);
  double least = most, other = 0;
  const auto add = [&](std::size_t k, bool joined) {
    const double overlap = std::max(-rows[k].normal.gap, 0.0);
    least = joined ? std::min(least, overlap) : 0;
    other = std::max(other, overlap - least);
    weight_[k] = least * least * rows[k].normal.width;
  };
  add(deepest, true);
  for (std::size_t k = deepest; k-- > 0;) add(k, rows[k + 1].joined);
  least = most;
  for (std::size_t k = deepest + 1; k < count_; ++k) add(k, rows[k].joined);
  return most > 0 ? other / most : 0;
}

double HertzianRows::fit(std::span<const ContactRow> rows) {
  count_ = rows.size();
  if (count_ == 0) return 0;
  const double other = find_weights(rows);

  // Means of powers of s about the mean, and the normal equations of a parabola with orthogonal polynomials.
  double sum = 0, mean = 0, x_mean = 0, gap_mean = 0, along = 0, cosine = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const NormalRow& row = rows[k].normal;
    place_[k] = rows[k].at.s;
    sum += weight_[k], mean += weight_[k] * place_[k], x_mean += weight_[k] * row.place.x;
    gap_mean += weight_[k] * row.gap, along += weight_[k] * row.curvature, cosine += weight_[k] * std::cos(row.angle);
  }
  if (!(sum > 0)) return 0;
  for (double* value : {&mean, &x_mean, &gap_mean, &along, &cosine}) *value /= sum;
  double m2 = 0, m3 = 0, gap1 = 0, x1 = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double t = place_[k] - mean, w = weight_[k] / sum;
    m2 += w * t * t, m3 += w * t * t * t, gap1 += w * t * rows[k].normal.gap, x1 += w * t * rows[k].normal.place.x;
  }
  if (!(m2 > 0)) return 0;
  double square = 0, gap2 = 0; // of the polynomial t^2 - m3/m2 t - m2
  for (std::size_t k = 0; k < count_; ++k) {
    const double t = place_[k] - mean, w = weight_[k] / sum, polynomial = t * t - m3 / m2 * t - m2;
    square += w * polynomial * polynomial, gap2 += w * polynomial * rows[k].normal.gap;
  }
  across_ = gap2 / square;
  constexpr double flattest = 1e-6;
  if (!(square > 0) || !(across_ > flattest * along)) return 0;
  const double slope = gap1 / m2 - across_ * m3 / m2, t0 = -slope / (2 * across_);
  s0_ = mean + t0, skew_ = x1 / m2, x0_ = x_mean + skew_ * t0, along_ = along, cosine_ = cosine;
  // A paraboloid that is all but a cylinder, for being skew or flat, is none of Hertz's.
  constexpr double slenderest = 1e-8;
  const double trace = along * (1 + skew_ * skew_) + across_;
  if (!(along * across_ > slenderest * trace * trace)) return 0;
  overlap_ = -(gap_mean - across_ * m2 + slope * t0 + across_ * t0 * t0);
  if (!(overlap_ > 0)) return 0;

  double off = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double t = place_[k] - s0_, x = rows[k].normal.place.x - x0_ - skew_ * t;
    const double gap = rows[k].normal.gap + overlap_ - across_ * t * t;
    // Half the overlap is A a^2: what other curvatures and middles of rows change of the gap there.
    const double by_length = (rows[k].normal.curvature / along_ - 1) * overlap_ / 2;
    off += weight_[k] / sum * (gap * gap + by_length * by_length + 2 * along_ * overlap_ * x * x);
  }
  if (!std::isfinite(off)) return 0;
  return fade(std::sqrt(off) / overlap_, 0.015, 0.03) * fade(other, 0.1, 0.3) *
         fade(std::abs(t0) / std::sqrt(m2), 0.1, 0.3);
}

double HertzianRows::load(const CombinedMaterial& material, std::span<const NormalRow> rows,
                          std::optional<double> vertical_force) {
  const auto put = [&](const TurnedHertz& hertz) {
    const Ellipse& e = hertz.ellipse;
    half_width_ = 1 / std::sqrt(e.e22 - e.e12 * e.e12 / e.e11), length_ = 1 / std::sqrt(e.e11);
    double vertical = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const double t = place_[k] - s0_, half = rows[k].width / 2;
      const double part = weight_[k] > 0 ? parabola_between((t - half) / half_width_, (t + half) / half_width_) *
                                               half_width_ / (2 * half)
                                         : 0;
      load_[k] = pi / 2 * hertz.contact.peak_pressure * length_ * part;
      half_length_[k] = length_ * std::sqrt(part);
      centre_[k] = x0_ - e.e12 / e.e11 * t;
      vertical += load_[k] * rows[k].vertical_weight();
    }
    return vertical;
  };
  if (!vertical_force) {
    const TurnedHertz hertz = turned_hertz(
        along_, across_, skew_, [&](const GapCurvatures& gap) { return hertz_from_approach(gap, material, overlap_); });
    put(hertz);
    stiffness_ = hertz.contact.stiffness * cosine_;
    return 0;
  }
  // The share of the normal force that is vertical hardly changes with it: two steps are exact.
  double force = *vertical_force / cosine_;
  TurnedHertz hertz{};
  for (int step = 0; step < 3; ++step) {
    hertz = turned_hertz(along_, across_, skew_,
                         [&](const GapCurvatures& gap) { return hertz_from_load(gap, material, force); });
    const double vertical = put(hertz), factor = *vertical_force / vertical;
    if (!(vertical > 0)) { // friction on a flank pulls the wheel down
      stiffness_ = 0;
      return 0;
    }
    if (step == 2) {
      for (std::size_t k = 0; k < count_; ++k) load_[k] *= factor;
    }
    force *= factor;
  }
  stiffness_ = hertz.contact.stiffness * cosine_;
  return (hertz.contact.approach - overlap_) / cosine_;
}

} // namespace microslip
