#include "microslip/numerics/rational_fit.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace microslip {

using Complex = std::complex<double>;
using Field = std::vector<double>;

Complex RationalFit::value(std::size_t function, Complex s) const {
  Complex sum = constants[function];
  for (std::size_t n = 0; n < poles.size(); ++n) {
    const Complex p = poles[n], r = residues[function][n];
    sum += r / (s - p);
    if (p.imag() > 0) sum += std::conj(r) / (s - std::conj(p));
  }
  return sum;
}

namespace {

/// Rows of a linear least-squares problem.
class Matrix {
public:
  Matrix(std::size_t rows, std::size_t columns) : columns_(columns), values_(rows * columns) {}

  std::size_t rows() const { return values_.size() / columns_; }
  std::size_t columns() const { return columns_; }
  double& at(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }

  /// Puts a complex number into two rows, its real and its imaginary part.
  void put(std::size_t pair, std::size_t column, Complex value) {
    at(2 * pair, column) = value.real(), at(2 * pair + 1, column) = value.imag();
  }
  /// Makes it upper triangular by Householder's reflections.
  void triangularise() {
    for (std::size_t c = 0; c < columns_ && c + 1 < rows(); ++c) {
      double square = 0;
      for (std::size_t r = c; r < rows(); ++r) square += at(r, c) * at(r, c);
      if (!(square > 0)) continue;
      const double diagonal = at(c, c) > 0 ? -std::sqrt(square) : std::sqrt(square);
      const double first = at(c, c) - diagonal, factor = -1 / (diagonal * first);
      Field reflection(rows() - c);
      for (std::size_t r = c; r < rows(); ++r) reflection[r - c] = r == c ? first : at(r, c);
      for (std::size_t k = c; k < columns_; ++k) {
        double product = 0;
        for (std::size_t r = c; r < rows(); ++r) product += reflection[r - c] * at(r, k);
        for (std::size_t r = c; r < rows(); ++r) at(r, k) -= factor * product * reflection[r - c];
      }
    }
  }
  /// The least-squares solution with the last column as the right side; unknowns that nothing determines are 0.
  Field solution() {
    Field scale(columns_ - 1);
    for (std::size_t c = 0; c + 1 < columns_; ++c) {
      for (std::size_t r = 0; r < rows(); ++r) scale[c] = std::hypot(scale[c], at(r, c));
      for (std::size_t r = 0; r < rows() && scale[c] > 0; ++r) at(r, c) /= scale[c];
    }
    triangularise();
    Field x(columns_ - 1);
    for (std::size_t c = x.size(); c-- > 0;) {
      if (c >= rows() || !(std::abs(at(c, c)) > 1e-14)) continue;
      double value = at(c, columns_ - 1);
      for (std::size_t k = c + 1; k < x.size(); ++k) value -= at(c, k) * x[k];
      x[c] = value / at(c, c);
    }
    for (std::size_t c = 0; c < x.size(); ++c) x[c] = scale[c] > 0 ? x[c] / scale[c] : 0;
    return x;
  }

private:
  std::size_t columns_;
  Field values_;
};

/// The functions of s by which a rational one is a sum with real coefficients: 1/(s - p), of a pair of poles sum and
/// difference; and 1 as the last one.
std::vector<Complex> basis(const std::vector<Complex>& poles, Complex s) {
  std::vector<Complex> out;
  for (const Complex p : poles) {
    const Complex here = 1.0 / (s - p), there = 1.0 / (s - std::conj(p));
    if (p.imag() > 0)
      out.insert(out.end(), {here + there, Complex(0, 1) * (here - there)});
    else
      out.push_back(here);
  }
  out.push_back(1);
  return out;
}

/// Residues of coefficients in that basis.
std::vector<Complex> residues_of(const std::vector<Complex>& poles, std::span<const double> coefficients) {
  std::vector<Complex> out;
  std::size_t k = 0;
  for (const Complex p : poles) {
    const double real = coefficients[k++];
    out.emplace_back(real, p.imag() > 0 ? coefficients[k++] : 0);
  }
  return out;
}

/// All poles, the conjugates too.
std::vector<Complex> all_of(const std::vector<Complex>& poles) {
  std::vector<Complex> out;
  for (const Complex p : poles) {
    out.push_back(p);
    if (p.imag() > 0) out.push_back(std::conj(p));
  }
  return out;
}

/// Zeros of d + sum of r_n/(s - p_n), all at once (Aberth 1973): of the polynomial that it is times all (s - p_n).
std::vector<Complex> zeros_of(const std::vector<Complex>& poles, const std::vector<Complex>& residues, double d) {
  constexpr int most_steps = 200;
  const std::vector<Complex> all = all_of(poles);
  std::vector<Complex> r;
  for (std::size_t n = 0; n < poles.size(); ++n) {
    r.push_back(residues[n]);
    if (poles[n].imag() > 0) r.push_back(std::conj(residues[n]));
  }
  std::vector<Complex> z = all;
  for (std::size_t i = 0; i < z.size(); ++i) // beside the poles, and no two of them conjugate
    z[i] += 1e-2 * (std::abs(z[i]) + 1e-3) * std::polar(1.0, 0.7 + static_cast<double>(i));
  for (int step = 0; step < most_steps; ++step) {
    double farthest = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      Complex value = d, slope = 0, sum = 0;
      for (std::size_t n = 0; n < all.size(); ++n) {
        const Complex inverse = 1.0 / (z[i] - all[n]);
        value += r[n] * inverse, slope -= r[n] * inverse * inverse, sum += inverse;
      }
      for (std::size_t j = 0; j < z.size(); ++j)
        if (j != i) sum -= 1.0 / (z[i] - z[j]);
      const Complex move = value / (slope + value * sum);
      if (!std::isfinite(std::abs(move))) continue;
      z[i] -= move;
      farthest = std::max(farthest, std::abs(move) / std::abs(z[i]));
    }
    if (farthest < 1e-15) break;
  }
  return z;
}

/// Stable poles from zeros that come in conjugate pairs or are real, up to rounding: as many as there are zeros, with
/// pairs counted twice. A zero is real if no other one is as near to its conjugate as itself.
std::vector<Complex> stable_poles(std::vector<Complex> zeros) {
  std::sort(zeros.begin(), zeros.end(),
            [](Complex a, Complex b) { return std::abs(a.imag()) > std::abs(b.imag()); }); // surest pairs first
  std::vector<Complex> out;
  while (!zeros.empty()) {
    const Complex z = zeros.front();
    zeros.erase(zeros.begin());
    const auto distance = [z](Complex other) { return std::abs(other - std::conj(z)); };
    const auto partner =
        std::min_element(zeros.begin(), zeros.end(), [&](Complex a, Complex b) { return distance(a) < distance(b); });
    const bool is_real = partner == zeros.end() || distance(*partner) >= distance(z);
    if (!is_real) zeros.erase(partner);
    out.emplace_back(-std::max(std::abs(z.real()), 1e-12 * std::abs(z)), is_real ? 0 : std::abs(z.imag()));
  }
  return out;
}

/// Pairs with weak damping over the frequencies, as Gustavsen & Semlyen advise, and a real one where the order is odd.
std::vector<Complex> first_poles(std::span<const double> omega, int order) {
  const double most = omega.back(), least = std::max(omega.front(), most / 100);
  std::vector<Complex> poles;
  const int pairs = order / 2;
  for (int k = 0; k < pairs; ++k) {
    const double at = pairs > 1 ? least + (most - least) * k / (pairs - 1) : most / 2;
    poles.emplace_back(-at / 100, at);
  }
  if (order % 2 != 0) poles.emplace_back(-most / 2, 0);
  return poles;
}

/// One iteration: the zeros of sigma(s), for which sigma and sigma h have the same poles.
std::vector<Complex> moved(const std::vector<Complex>& poles, std::span<const double> omega,
                           const std::vector<std::vector<Complex>>& values) {
  const std::size_t n = all_of(poles).size() + 1, samples = omega.size(); // n: basis functions
  Matrix together(n * values.size() + 1, n + 1);
  for (std::size_t f = 0; f < values.size(); ++f) {
    Matrix single(2 * samples, 2 * n);
    for (std::size_t k = 0; k < samples; ++k) {
      const std::vector<Complex> functions = basis(poles, Complex(0, omega[k]));
      for (std::size_t c = 0; c < n; ++c)
        single.put(k, c, functions[c]), single.put(k, n + c, -values[f][k] * functions[c]);
    }
    single.triangularise();
    for (std::size_t r = 0; r < n && n + r < single.rows(); ++r)
      for (std::size_t c = 0; c < n; ++c) together.at(f * n + r, c) = single.at(n + r, n + c);
  }
  // Relaxed: sigma is 1 in the mean of its real part over the frequencies, and not at infinity.
  const std::size_t last = together.rows() - 1;
  const double weight = 1.0 / static_cast<double>(samples);
  for (const double at : omega) {
    const std::vector<Complex> functions = basis(poles, Complex(0, at));
    for (std::size_t c = 0; c < n; ++c) together.at(last, c) += weight * functions[c].real();
  }
  together.at(last, n) = 1;
  Field sigma = together.solution();
  constexpr double least_constant = 1e-8; // sigma must not vanish at infinity
  if (std::abs(sigma.back()) < least_constant) sigma.back() = std::copysign(least_constant, sigma.back());
  return stable_poles(zeros_of(poles, residues_of(poles, sigma), sigma.back()));
}

void find_residues(std::span<const double> omega, const std::vector<Complex>& values, RationalFit& fit) {
  const std::size_t n = all_of(fit.poles).size() + 1;
  Matrix matrix(2 * omega.size(), n + 1);
  for (std::size_t k = 0; k < omega.size(); ++k) {
    const std::vector<Complex> functions = basis(fit.poles, Complex(0, omega[k]));
    for (std::size_t c = 0; c < n; ++c) matrix.put(k, c, functions[c]);
    matrix.put(k, n, values[k]);
  }
  const Field coefficients = matrix.solution();
  fit.residues.push_back(residues_of(fit.poles, coefficients));
  fit.constants.push_back(coefficients.back());
}

double largest(const std::vector<Complex>& values) {
  double most = 0;
  for (const Complex value : values) most = std::max(most, std::abs(value));
  return most;
}

double largest_error(const RationalFit& fit, std::size_t function, std::span<const double> omega,
                     const std::vector<Complex>& values) {
  double most = 0;
  for (std::size_t k = 0; k < omega.size(); ++k)
    most = std::max(most, std::abs(fit.value(function, Complex(0, omega[k])) - values[k]));
  return most;
}

void check(std::span<const double> omega, const std::vector<std::vector<Complex>>& values, int order) {
  require_count("order", order, 1, 100);
  if (omega.size() < static_cast<std::size_t>(order) + 1 || !(omega.back() > 0))
    throw Error("fit: " + std::to_string(order) + " poles need at least " + std::to_string(order + 1) +
                " frequencies up to one that is not 0");
  for (std::size_t k = 0; k < omega.size(); ++k) {
    require_finite("omega", omega[k], "-");
    if (omega[k] < 0 || (k > 0 && !(omega[k] > omega[k - 1]))) throw Error("fit: frequencies must ascend from 0 on");
  }
  for (const std::vector<Complex>& function : values) {
    if (function.size() != omega.size()) throw Error("fit: a function must have a value for each frequency");
    for (const Complex value : function)
      require_finite("value", value.real(), "-"), require_finite("value", value.imag(), "-");
  }
}

} // namespace

RationalFit fit_rational(std::span<const double> omega, const std::vector<std::vector<Complex>>& values, int order) {
  constexpr int iterations = 30;
  check(omega, values, order);
  const double unit = omega.back(); // of s
  Field scaled;
  for (const double at : omega) scaled.push_back(at / unit);
  std::vector<std::vector<Complex>> weighted = values;
  for (std::vector<Complex>& function : weighted)
    if (const double size = largest(function); size > 0)
      for (Complex& value : function) value /= size;
  RationalFit best;
  double least = 0;
  std::vector<Complex> poles = first_poles(scaled, order);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    poles = moved(poles, scaled, weighted);
    RationalFit fit;
    fit.poles = poles;
    double sum = 0;
    for (std::size_t f = 0; f < weighted.size(); ++f) {
      find_residues(scaled, weighted[f], fit);
      fit.errors.push_back(largest_error(fit, f, scaled, weighted[f]));
      sum += fit.errors.back();
    }
    if (!best.poles.empty() && !(sum < least)) continue;
    least = sum;
    best = std::move(fit);
  }
  for (Complex& p : best.poles) p *= unit;
  for (std::size_t f = 0; f < values.size(); ++f) {
    const double size = largest(values[f]);
    best.constants[f] *= size;
    for (Complex& r : best.residues[f]) r *= size * unit;
  }
  return best;
}

} // namespace microslip
