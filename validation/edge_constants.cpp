#include "validation/studies.hpp"

#include "microslip/exact/fitted/edge_element.hpp"
#include "validation/half_line.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using std::numbers::pi;
using Matrix = std::vector<std::vector<double>>;

constexpr std::array widths = {0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7};
constexpr std::array elements = {25, 50, 100, 200, 400, 800};
constexpr int degree = 12;
constexpr double finest = 0.15, coarser = 0.25; ///< spacings of HalfLine

struct Interval {
  double left, right;
};

/// Growth of the displacement from the right to the left of an interval by a unit traction on an element, for the
/// kernel -ln|x|/pi. Far away by Gauss's formula, for the closed form cancels there.
double growth(const Interval& interval, const Interval& element) {
  const auto [x, end] = interval;
  const double middle = (element.left + element.right) / 2, half = (element.right - element.left) / 2;
  if (std::abs(x - middle) > 10) {
    constexpr std::array node = {0.0, 0.53846931010568309, 0.90617984593866399};
    constexpr std::array weight = {0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
    double sum = weight[0] * std::log1p((end - x) / (x - middle));
    for (std::size_t i = 1; i < node.size(); ++i)
      for (const double s : {middle - half * node[i], middle + half * node[i]})
        sum += weight[i] * std::log1p((end - x) / (x - s));
    return half * sum / pi;
  }
  const auto antiderivative = [](double t) { return t == 0 ? 0 : t * std::log(std::abs(t)); };
  return (antiderivative(end - element.left) - antiderivative(end - element.right) - antiderivative(x - element.left) +
          antiderivative(x - element.right)) /
         pi;
}

/// Gauss elimination of rows that hold the matrix and after it the right sides, which become the solutions. The
/// matrices here need no pivots: a symmetric part that is positive definite, or functions in order of their decay.
void solve(Matrix& rows) {
  const std::size_t n = rows.size();
  const auto subtract = [&rows](std::size_t to, std::size_t from, std::size_t begin, double factor) {
    for (std::size_t j = begin; j < rows[from].size(); ++j) rows[to][j] -= factor * rows[from][j];
  };
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) subtract(i, k, k, rows[i][k] / rows[k][k]);
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = n; j < rows[k].size(); ++j) rows[k][j] /= rows[k][k];
    for (std::size_t i = 0; i < k; ++i) subtract(i, k, n, rows[i][k]);
  }
}

Interval regular_element(int m) {
  return {double(-m), double(1 - m)};
}

/// Finite systems: a leading element on 0 < x < omega and `count` regular ones behind it adhere under a growth of 1, so
/// that p = sqrt((d - x)/(x - c)) but for the discretisation, and d - c is 2/pi times the force. One for each of
/// `widths`. The elements from the second regular one on are eliminated once for all widths.
std::vector<double> finite_lengths(int count) {
  const std::size_t far = static_cast<std::size_t>(count) - 1;
  Matrix rows(far);
  for (std::size_t i = 0; i < far; ++i) {
    const int m = static_cast<int>(i) + 2;
    const Interval slip = {0.5 - m, 1.5 - m};
    for (int other = 2; other <= count; ++other) {
      const double k = m - other;
      rows[i].push_back(growth({-k, 1 - k}, {-0.5, 0.5}));
    }
    rows[i].push_back(1);
    rows[i].push_back(growth(slip, regular_element(1)));
    for (const double omega : widths) rows[i].push_back(growth(slip, {0, omega}));
  }
  solve(rows);

  std::vector<double> lengths;
  for (std::size_t w = 0; w < widths.size(); ++w) {
    const double omega = widths[w];
    const Interval leading = {0, omega};
    const std::array<Interval, 2> slip = {{{-0.5, omega / 2}, {omega / 2, omega + 0.5}}};
    std::array<std::array<double, 3>, 2> a{}; // the two slips: growth wanted, by the first regular one, by the leading
    std::array<double, 3> force = {0, 1, omega};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t column = far + (c == 2 ? 2 + w : c);
      for (std::size_t s = 0; s < 2; ++s) {
        a[s][c] = c == 0   ? slip[s].right - slip[s].left
                  : c == 1 ? growth(slip[s], regular_element(1))
                           : growth(slip[s], leading);
        for (std::size_t i = 0; i < far; ++i)
          a[s][c] -= growth(slip[s], regular_element(static_cast<int>(i) + 2)) * rows[i][column];
      }
      for (std::size_t i = 0; i < far; ++i) force[c] += (c == 0 ? 1 : -1) * rows[i][column];
    }
    const double determinant = a[0][1] * a[1][2] - a[0][2] * a[1][1];
    const double first = (a[0][0] * a[1][2] - a[0][2] * a[1][0]) / determinant;
    const double lead = (a[0][1] * a[1][0] - a[0][0] * a[1][1]) / determinant;
    lengths.push_back(2 / pi * (force[0] + first * force[1] + lead * force[2]));
  }
  return lengths;
}

/// Limits of (d - c) - count for each of `widths`, from systems of growing size whose errors are like 1/n, 1/n^2, ...
/// and, by the singularity of the symbol, ln(n)/n^2, ...
std::vector<double> limits_of_lengths(const Progress& progress) {
  Matrix rows;
  for (const int n : elements) {
    const double x = 1.0 / n, log = std::log(double(n));
    rows.push_back({1, x, x * x * log, x * x, x * x * x * log, x * x * x});
    for (const double length : finite_lengths(n)) rows.back().push_back(length - n);
    if (progress && !progress(double(n) / elements.back())) return {};
  }
  solve(rows);
  return {rows[0].begin() + elements.size(), rows[0].end()};
}

/// Coefficients of the Chebyshev polynomial that interpolates beta(omega).
std::array<double, degree + 1> chebyshev_coefficients(const HalfLine& line) {
  std::array<double, degree + 1> coefficient{};
  for (int i = 0; i <= degree; ++i) {
    const double angle = pi * (i + 0.5) / (degree + 1);
    const double omega = std::midpoint(narrowest_leading_element, widest_leading_element) +
                         (widest_leading_element - narrowest_leading_element) / 2 * std::cos(angle);
    const double beta = line.distance(omega) - omega;
    for (int k = 0; k <= degree; ++k)
      coefficient[static_cast<std::size_t>(k)] += (k == 0 ? 1.0 : 2.0) / (degree + 1) * beta * std::cos(k * angle);
  }
  return coefficient;
}

/// Largest error of edge_inset() over its range.
double error_of_polynomial(const HalfLine& line) {
  constexpr int steps = 130;
  double largest = 0;
  for (int i = 0; i <= steps; ++i) {
    const double omega = std::lerp(narrowest_leading_element, widest_leading_element, double(i) / steps);
    largest = std::max(largest, std::abs(edge_inset(omega) - (line.distance(omega) - omega)));
  }
  return largest;
}

std::string scientific(double value) {
  return fmt::format("{:.1e}", value);
}

/// The width of a leading element in steps of transient rolling: displacements at 1/2 and 3/2.
double width_of_step(const HalfLine& line, double distance) {
  double low = 0.9, high = widest_leading_element; // the distance grows from 1.28 to 2.41
  while (high - low > 1e-9) {
    const double middle = std::midpoint(low, high);
    (line.distance(middle, {0.5, 1.5}) < distance ? low : high) = middle;
  }
  return low;
}

void report_widths_of_steps(Report& report, const HalfLine& line) {
  constexpr int intervals = 20;
  report.heading("Widths of leading elements in steps, at the distances 1.3, 1.35, ... 2.3");
  for (int i = 0; i <= intervals;) {
    std::string row;
    for (const int end = std::min(i + 7, intervals + 1); i < end; ++i)
      row += fmt::format("{:.6f}  ", width_of_step(line, nearest_edge_of_step + double(i) / intervals));
    report.line(row);
  }
  double largest = 0;
  for (int i = 0; i <= 3 * intervals; ++i) {
    const double distance = nearest_edge_of_step + double(i) / (3 * intervals);
    largest = std::max(largest, std::abs(leading_element_width_of_step(distance) - width_of_step(line, distance)));
  }
  report.figure("largest error of leading_element_width_of_step()", scientific(largest), "<= 1e-3", largest <= 1e-3);
}

} // namespace

bool run_edge_constants(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const std::vector<double> length = limits_of_lengths(options.progress);
  if (length.empty()) return false;
  const HalfLine fine(finest), coarse(coarser);
  // The trailing edge lies 1/2 - beta(1) inside the last element: p ~ n^(-1/2) has the generating function
  // G (1 - z)^(-1/2), with the same kappa.
  const auto full = static_cast<std::size_t>(std::find(widths.begin(), widths.end(), 1.0) - widths.begin());
  const double trailing = (length[full] - 1.5) / 2;

  report.heading("omega, beta, its estimated error, beta of finite systems minus it, of edge_inset() minus it");
  double quadrature = 0, finite = 0;
  for (std::size_t w = 0; w < widths.size(); ++w) {
    const double omega = widths[w], beta = fine.distance(omega) - omega;
    const double estimate = std::abs(coarse.distance(omega) - omega - beta);
    const double difference = length[w] - trailing - omega - beta;
    report.line(fmt::format("{:.1f}  {:.13f}  {:>7.0e}  {:>8.1e}  {:>8.1e}", omega, beta, estimate, difference,
                            edge_inset(omega) - beta));
    quadrature = std::max(quadrature, estimate);
    finite = std::max(finite, std::abs(difference));
  }
  report.heading("Coefficients of the Chebyshev polynomial");
  for (const double c : chebyshev_coefficients(fine)) report.line(fmt::format("{:.11f}", c));

  report.heading("Computed, expected");
  report.line(fmt::format("beta(1) = {:.15f}", fine.full_width_inset()));
  const double identity = std::abs(fine.distance(1) - 1 - fine.full_width_inset());
  report.figure("beta(1) as of any omega, and by its integral", scientific(identity), "<= 1e-13", identity <= 1e-13);
  report.figure("estimated error of the quadratures", scientific(quadrature), "<= 1e-12", quadrature <= 1e-12);
  report.figure("largest difference to finite systems", scientific(finite), "<= 1e-9", finite <= 1e-9);
  const double polynomial = error_of_polynomial(fine);
  report.figure("largest error of edge_inset()", scientific(polynomial), "<= 1e-9", polynomial <= 1e-9);
  report_widths_of_steps(report, coarse);
  return report.all_as_stated();
}

} // namespace microslip::validation
