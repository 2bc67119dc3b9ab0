#include "microslip/exact/fitted/contact_edges.hpp"

#include "microslip/exact/fitted/pressure_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace microslip {
namespace {

constexpr double window = 1.2, window_in_line_contact = 3; // times the square root of the patch's number of elements
constexpr double inward_window = 1.3;                      // times that
constexpr int smallest_window = 3;                         // elements
constexpr double rim_weight = 0.05;                        // of elements on the rim of the contact
constexpr double pivot_limit = 1e-9; // of the normal equations, scaled to a unit diagonal: below, no unique fit
constexpr double farthest_outward = 1.5, farthest_inward = 0.5; // from the outermost element's centre [elements]

/// A set of elements in contact that share sides.
struct Patch {
  int first_column, last_column, first_row, last_row;

  int columns() const { return last_column - first_column + 1; }
  int rows() const { return last_row - first_row + 1; }
};

int half_window(int elements, double factor) {
  return std::max(smallest_window, static_cast<int>(std::lround(factor * std::sqrt(elements))));
}

/// Which patch each element is part of; -1 without pressure.
struct Patches {
  std::vector<int> of;
  std::vector<Patch> list;
};

Patches find_patches(const ElementGrid& grid, std::span<const double> pressure) {
  Patches patches{std::vector<int>(grid.count(), -1), {}};
  std::vector<std::size_t> open;
  for (std::size_t seed = 0; seed < grid.count(); ++seed) {
    if (!(pressure[seed] > 0) || patches.of[seed] >= 0) continue;
    const int label = static_cast<int>(patches.list.size());
    Patch patch{grid.mx, 0, grid.my, 0};
    const auto visit = [&](std::size_t k) {
      if (!(pressure[k] > 0) || patches.of[k] >= 0) return;
      patches.of[k] = label;
      open.push_back(k);
    };
    visit(seed);
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      const int i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
      patch.first_column = std::min(patch.first_column, i), patch.last_column = std::max(patch.last_column, i);
      patch.first_row = std::min(patch.first_row, j), patch.last_row = std::max(patch.last_row, j);
      if (i > 0) visit(k - 1);
      if (i + 1 < grid.mx) visit(k + 1);
      if (j > 0) visit(k - grid.mx);
      if (j + 1 < grid.my) visit(k + grid.mx);
    }
    patches.list.push_back(patch);
  }
  return patches;
}

/// The polynomials that are fitted, by their number of coefficients.
enum class Polynomial { quadratic_in_u = 3, cubic_in_u = 4, cubic_in_u_and_v = 10 };

/// A weighted least-squares fit.
class EdgeFit {
public:
  explicit EdgeFit(Polynomial polynomial)
      : functions_(static_cast<std::size_t>(polynomial)), spare_(polynomial == Polynomial::cubic_in_u_and_v ? 2 : 0) {}

  /// Sums along a row of points: of w u^k and of w z u^k for the values z and weights w.
  struct RowSums {
    std::array<double, 7> weights{};
    std::array<double, 4> values{};
    std::size_t points = 0;

    void add(double u, double value, double weight) {
      double power = weight;
      for (std::size_t k = 0; k < weights.size(); ++k, power *= u) {
        weights[k] += power;
        if (k < values.size()) values[k] += power * value;
      }
      ++points;
    }
  };

  void add(double v, const RowSums& row) {
    points_ += row.points;
    double power = 1;
    for (std::size_t j = 0; j < weights_.size(); ++j, power *= v) {
      for (std::size_t i = 0; i + j < weights_.size(); ++i) weights_[j][i] += power * row.weights[i];
      for (std::size_t i = 0; i + j < values_.size(); ++i) values_[j][i] += power * row.values[i];
    }
  }

  /// The coefficients of 1, u, u^2, u^3 at v = 0; nothing if there are too few points or they do not determine it.
  std::optional<std::array<double, 4>> along_row() const {
    if (points_ < functions_ + spare_) return {};
    std::array<std::array<double, most_functions + 1>, most_functions> a{};
    std::array<double, most_functions> diagonal{};
    for (std::size_t r = 0; r < functions_; ++r) {
      const auto [ru, rv] = exponents[r];
      for (std::size_t c = 0; c < functions_; ++c) a[r][c] = weights_[rv + exponents[c].v][ru + exponents[c].u];
      a[r][most_functions] = values_[rv][ru];
      diagonal[r] = a[r][r];
    }
    for (std::size_t k = 0; k < functions_; ++k) {
      if (!(a[k][k] > pivot_limit * diagonal[k])) return {};
      for (std::size_t r = 0; r < functions_; ++r) {
        if (r == k) continue;
        const double factor = a[r][k] / a[k][k];
        for (std::size_t c = k; c <= most_functions; ++c) a[r][c] -= factor * a[k][c];
      }
    }
    std::array<double, 4> coefficients{};
    for (std::size_t k = 0; k < std::min<std::size_t>(functions_, 4); ++k)
      coefficients[k] = a[k][most_functions] / a[k][k];
    return coefficients;
  }

private:
  static constexpr std::size_t most_functions = 10;
  struct Exponents {
    std::size_t u, v;
  };
  static constexpr std::array<Exponents, most_functions> exponents = {
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {0, 2}, {1, 1}, {2, 1}, {1, 2}, {0, 3}}};

  std::size_t functions_, spare_, points_ = 0;
  std::array<std::array<double, 7>, 7> weights_{}; ///< sums of w u^i v^j in [j][i], i + j <= 6
  std::array<std::array<double, 4>, 4> values_{};  ///< of w z u^i v^j, i + j <= 3
};

/// Where a polynomial falls through zero, by Newton's method from 0 on.
std::optional<double> falling_zero(const std::array<double, 4>& c) {
  double u = 0;
  for (int k = 0; k < 50; ++k) {
    const double slope = c[1] + u * (2 * c[2] + u * 3 * c[3]);
    if (!(slope < 0)) return {};
    const double step = (c[0] + u * (c[1] + u * (c[2] + u * c[3]))) / slope;
    u -= step;
    if (std::abs(step) < 1e-12) return u;
  }
  return {};
}

/// Finds the edges of the runs of one contact.
class EdgeSearch {
public:
  EdgeSearch(const ElementGrid& grid, std::span<const double> pressure)
      : grid_(grid), line_(grid.my == 1), patches_(find_patches(grid, pressure)), square_(pressure.size()),
        weight_(pressure.size()) {
    const double weight_power = line_ ? 4 : 0.5;
    const double peak = *std::max_element(pressure.begin(), pressure.end());
    const std::vector<double> curvature = pressure_curvature(grid, pressure);
    for (std::size_t k = 0; k < pressure.size(); ++k) {
      if (!(pressure[k] > 0)) continue;
      const double p = pressure[k] / peak;
      square_[k] = p * (p + curvature[k] / peak / 12);
      weight_[k] = std::pow(p, weight_power) * (on_rim(grid, pressure, k) ? rim_weight : 1);
    }
  }

  /// How far the edge is outward of the centre of the run's outermost element (`side` 1: high x, -1: low) [elements].
  double edge(const ContactRun& run, int side) const {
    const int column = side > 0 ? run.last : run.first;
    const Patch& patch = patches_.list[static_cast<std::size_t>(patches_.of[at(column, run.row)])];
    const Polynomial first = line_ ? Polynomial::cubic_in_u : Polynomial::cubic_in_u_and_v;
    for (const Polynomial polynomial : {first, Polynomial::quadratic_in_u}) {
      const auto place = fitted_edge(column, run.row, side, patch, polynomial);
      if (place && *place >= -2 * farthest_outward && *place <= 2 * farthest_outward)
        return std::clamp(*place, -farthest_inward, farthest_outward);
    }
    return 0.5;
  }

private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * grid_.mx + i; }

  std::optional<double> fitted_edge(int column, int row, int side, const Patch& patch, Polynomial polynomial) const {
    const int label = patches_.of[at(column, row)];
    const int columns = half_window(patch.columns(), line_ ? window_in_line_contact : window);
    const int rows = polynomial == Polynomial::cubic_in_u_and_v ? half_window(patch.rows(), window) : 0;
    const int inward = column - side * static_cast<int>(std::lround(inward_window * columns)),
              outward = column + side * columns;
    const int low = std::max(std::min(inward, outward), 0), high = std::min(std::max(inward, outward), grid_.mx - 1);
    EdgeFit fit(polynomial);
    for (int j = std::max(row - rows, 0); j <= std::min(row + rows, grid_.my - 1); ++j) {
      EdgeFit::RowSums sums;
      for (int i = low; i <= high; ++i)
        if (patches_.of[at(i, j)] == label)
          sums.add(double(side * (i - column)) / columns, square_[at(i, j)], weight_[at(i, j)]);
      fit.add(rows > 0 ? double(j - row) / rows : 0, sums);
    }
    const auto c = fit.along_row();
    const auto zero = c ? falling_zero(*c) : std::nullopt;
    if (!zero) return {};
    return *zero * columns;
  }

  const ElementGrid& grid_;
  bool line_; ///< one row
  Patches patches_;
  std::vector<double> square_, weight_; ///< p_n squared at the centres, what is fitted; both of the peak pressure's
};

} // namespace

std::vector<ContactRun> contact_runs(const ElementGrid& grid, std::span<const double> pressure) {
  const EdgeSearch search(grid, pressure);
  std::vector<ContactRun> runs;
  for (int j = 0; j < grid.my; ++j) {
    const auto in_contact = [&](int i) {
      return i < grid.mx && pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
    };
    for (int i = 0; i < grid.mx; ++i) {
      if (!in_contact(i)) continue;
      ContactRun run{j, i, i, 0, 0};
      while (in_contact(run.last + 1)) ++run.last;
      run.low = grid.x(run.first) - search.edge(run, -1) * grid.dx;
      run.high = grid.x(run.last) + search.edge(run, 1) * grid.dx;
      if (!runs.empty() && runs.back().row == j) run.low = std::max(run.low, runs.back().high);
      if (run.high - run.low < 0.5 * grid.dx) { // hardly in contact
        run.low = grid.x(run.first) - grid.dx / 2;
        run.high = grid.x(run.last) + grid.dx / 2;
      }
      runs.push_back(run);
      i = run.last;
    }
  }
  return runs;
}

} // namespace microslip
