#include "microslip/exact/fitted/contact_edges.hpp"

#include "microslip/exact/fitted/pressure_curvature.hpp"
#include "microslip/numerics/elimination.hpp"
#include "microslip/numerics/fade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace microslip {
namespace {

constexpr double window = 2, window_in_line_contact = 4; // times the square root of the contact's length [elements]
constexpr double window_across = 1.6;                    // times that of its number of rows
constexpr double inward_window = 1.3;                    // times the window outward
constexpr double smallest_window = 3;                    // elements
constexpr double rim_weight = 0.05;                      // of elements beside one without pressure
constexpr double inner_square =
    0.5;                       // p_n^2 of the neighbours, over its own, from which on an element is not on the rim
constexpr double ridge = 1e-6; // of the fit's coefficients, over the sum of its weights
constexpr double all_moments = 0.5, all_fit = 1.5; // half-lengths of runs [elements]
constexpr double connecting_load = 0.02;           // of the mean row's, from which on a row connects those beside it

/// Elements of a row in contact with the edges of the semi-ellipse that has their load, centre and second moment.
struct Run {
  ContactRun elements;
  double load = 0;          ///< sum of pressures
  double low = 0, high = 0; ///< [columns]

  double centre() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
  double peak() const { return 2 / std::numbers::pi * load / half(); }
};

/// A semi-ellipse of half-length a has the variance a^2/4, and a constant element 1/12.
Run run_from(const ElementGrid& grid, std::span<const double> pressure, int row, int first) {
  const double* p = &pressure[static_cast<std::size_t>(row) * grid.mx];
  Run found{{row, first, first, 0, 0}};
  double sum = 0, squares = 0;
  for (int i = first; i < grid.mx && p[i] > 0; ++i) {
    const double x = i - first;
    found.load += p[i], sum += p[i] * x, squares += p[i] * x * x;
    found.elements.last = i;
  }
  const double centre = sum / found.load;
  const double half = 2 * std::sqrt(std::max(squares / found.load - centre * centre, 0.0) + 1.0 / 12);
  found.low = first + centre - half, found.high = first + centre + half;
  return found;
}

/// A weighted least-squares fit by a cubic polynomial, drawn a little towards zero: so it exists for any points.
class CubicFit {
public:
  void add(double u, double value, double weight) {
    double power = weight;
    for (std::size_t k = 0; k < weights_.size(); ++k, power *= u) {
      weights_[k] += power;
      if (k < values_.size()) values_[k] += power * value;
    }
  }

  std::array<double, 4> coefficients() const {
    constexpr std::size_t n = 4;
    std::array<double, n * n> matrix{};
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t c = 0; c < n; ++c) matrix[r * n + c] = weights_[r + c];
      matrix[r * n + r] += ridge * weights_[0];
    }
    return solve_linear<n>(matrix, values_).value_or(std::array<double, n>{});
  }

private:
  std::array<double, 7> weights_{}; ///< sums of w u^k
  std::array<double, 4> values_{};  ///< of w z u^k
};

/// Zero near 0 of a falling polynomial: steps of Newton's method, whose number and least slope are fixed so
/// that it is a continuous function of the coefficients.
double falling_zero(const std::array<double, 4>& c) {
  constexpr int steps = 6;
  constexpr double least_slope = 0.3, farthest = 1;
  double u = 0;
  for (int k = 0; k < steps; ++k) {
    const double slope = std::min(c[1] + u * (2 * c[2] + u * 3 * c[3]), -least_slope);
    u = std::clamp(u - (c[0] + u * (c[1] + u * (c[2] + u * c[3]))) / slope, -farthest, farthest);
  }
  return u;
}

/// 1 at 0, falling to 0 at +-1.
double bell(double t) {
  const double s = std::max(1 - t * t, 0.0);
  return s * s;
}

/// Finds the edges of the runs of one contact.
class EdgeSearch {
public:
  EdgeSearch(const ElementGrid& grid, std::span<const double> pressure)
      : grid_(grid), line_(grid.my == 1), square_(pressure.size()), weight_(pressure.size()) {
    find_runs(pressure);
    const double peak = *std::max_element(pressure.begin(), pressure.end());
    const std::vector<double> curvature = pressure_curvature(grid, pressure);
    for (std::size_t k = 0; k < pressure.size(); ++k) {
      if (!(pressure[k] > 0)) continue;
      const double p = pressure[k] / peak, all = line_ ? p * p * p * p : p;
      square_[k] = pressure[k] * (pressure[k] + curvature[k] / 12);
      weight_[k] = all * std::lerp(rim_weight, 1, inside(pressure, k));
    }
  }

  const std::vector<Run>& runs() const { return runs_; }

  /// Position of the edge of a run [columns] (`side` 1: high x, -1: low).
  double edge(const Run& run, int side) const {
    constexpr double largest_share = 0.7, largest_of_none = 0.5, largest_growth = 0.1; // limits of the correction
    const double half = run.half(), share = 1 - fade(half, all_moments, all_fit);
    const double from = side > 0 ? run.high : run.low;
    if (!(share > 0)) return from;
    const double width = half_window(length_, line_ ? window_in_line_contact : window);
    CubicFit fit;
    add_elements(fit, run, run, side, width, 1);
    if (!line_)
      for (const int direction : {-1, 1}) add_neighbours(fit, run, direction, side, width);
    std::array<double, 4> c = fit.coefficients();
    c[1] -= 1, c[2] -= width / (2 * half);
    const double limit = std::min(largest_share * half, largest_of_none + largest_growth * half);
    return from + side * share * std::clamp(falling_zero(c) * width, -limit, limit);
  }

private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * grid_.mx + i; }
  static double half_window(double elements, double factor) {
    return std::max(smallest_window, factor * std::sqrt(elements));
  }

  /// The contact's length is the mean of its runs' by their loads; the number of rows that of a parabola, as loads of
  /// rows are for Hertz, with as large a sum of squares.
  void find_runs(std::span<const double> pressure) {
    double load = 0, lengths = 0, squares = 0;
    for (int j = 0; j < grid_.my; ++j) {
      first_.push_back(runs_.size());
      double of_row = 0;
      for (int i = 0; i < grid_.mx; ++i) {
        if (!(pressure[at(i, j)] > 0)) continue;
        const Run& run = runs_.emplace_back(run_from(grid_, pressure, j, i));
        i = run.elements.last;
        of_row += run.load, lengths += run.load * 2 * run.half();
      }
      load += of_row, squares += of_row * of_row;
    }
    first_.push_back(runs_.size());
    length_ = lengths / load, rows_ = 1.2 * load * load / squares, mean_load_ = squares / load;
  }

  /// 0 of an element on the rim of the contact, 1 further inside.
  double inside(std::span<const double> pressure, std::size_t k) const {
    const auto loaded = [&](std::size_t neighbour) {
      const double ratio = pressure[neighbour] / pressure[k];
      return 1 - fade(ratio * ratio, 0, inner_square);
    };
    const std::size_t mx = grid_.mx, i = k % mx;
    double share = i > 0 && i + 1 < mx ? loaded(k - 1) * loaded(k + 1) : 0;
    if (!line_) share *= k >= mx && k + mx < pressure.size() ? loaded(k - mx) * loaded(k + mx) : 0;
    return share;
  }

  /// Adds what p_n^2 of a run differs from its semi-ellipse's, stretched to the length of the run whose edge is sought.
  /// With u the distance beyond the edge over the window's width w, and a the half-length, the semi-ellipse has
  /// p_n^2/p_0^2 a/(2 w) = -u - w/(2 a) u^2.
  void add_elements(CubicFit& fit, const Run& of, const Run& run, int side, double width, double weight) const {
    const double half = run.half(), stretch = half / (of.half() * width), bend = width / (2 * half);
    const double edge = side > 0 ? of.high : of.low, scale = half / (2 * width * of.peak() * of.peak());
    const double reach = (side > 0 ? inward_window : 1) / stretch,
                 other_reach = (side > 0 ? 1 : inward_window) / stretch;
    const int low = std::max(of.elements.first, static_cast<int>(std::ceil(edge - reach)));
    const int high = std::min(of.elements.last, static_cast<int>(std::floor(edge + other_reach)));
    for (int i = low; i <= high; ++i) {
      const std::size_t k = at(i, of.elements.row);
      const double u = side * (i - edge) * stretch;
      fit.add(u, square_[k] * scale + u + bend * u * u, weight * weight_[k] * bell(u < 0 ? u / inward_window : u));
    }
  }

  /// Adds runs of the rows to one side, as far as rows with load connect them and they lie beside the run.
  void add_neighbours(CubicFit& fit, const Run& run, int direction, int side, double width) const {
    const double rows = half_window(rows_, window_across);
    double connected = 1;
    for (int distance = 1; distance < rows && connected > 0; ++distance) {
      const int j = run.elements.row + direction * distance;
      if (j < 0 || j >= grid_.my) return;
      double borne = 0;
      for (std::size_t k = first_[static_cast<std::size_t>(j)]; k < first_[static_cast<std::size_t>(j) + 1]; ++k) {
        const Run& other = runs_[k];
        const double common = std::min(run.high, other.high) - std::max(run.low, other.low);
        const double beside = 1 - fade(common / (2 * std::min(run.half(), other.half())), 0.1, 0.5);
        if (beside > 0) add_elements(fit, other, run, side, width, connected * beside * bell(distance / rows));
        borne += beside * other.load;
      }
      connected *= 1 - fade(borne, 0, connecting_load * mean_load_);
    }
  }

  const ElementGrid& grid_;
  bool line_; ///< one row
  std::vector<Run> runs_;
  std::vector<std::size_t> first_;      ///< run of each row
  double length_ = 0, rows_ = 0;        ///< of the contact [elements]
  double mean_load_ = 0;                ///< of its rows, by their load
  std::vector<double> square_, weight_; ///< p_n squared at the centres, what is fitted
};

} // namespace

std::vector<ContactRun> contact_runs(const ElementGrid& grid, std::span<const double> pressure) {
  const EdgeSearch search(grid, pressure);
  std::vector<ContactRun> runs;
  for (const Run& run : search.runs()) {
    ContactRun found = run.elements;
    found.low = grid.x0 + search.edge(run, -1) * grid.dx;
    found.high = grid.x0 + search.edge(run, 1) * grid.dx;
    if (!runs.empty() && runs.back().row == found.row) {
      const double between = grid.x0 + (runs.back().last + found.first) / 2.0 * grid.dx;
      runs.back().high = std::min(runs.back().high, between), found.low = std::max(found.low, between);
    }
    runs.push_back(found);
  }
  return runs;
}

} // namespace microslip
