#pragma once

#include "microslip/numerics/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// Gauss's rules for cells by how large they are: errors of 1e-9. Weights that fade are exact for polynomials of half
/// the degree only, and need more nodes.
const GaussLegendre& rule_for(double size_over_scale, bool fading);

/// Weights that integrate polynomials times exp(-x/l) over [0, width], through the nodes of a rule.
std::vector<double> fading_weights(const GaussLegendre& rule, double width, double length);

/// A rectangle over which kernels are integrated [m].
struct Cell {
  double x, y, width, height; ///< x, y: of its corner towards minus infinity

  double distance() const {
    const auto outside = [](double low, double size) { return std::max({low, -low - size, 0.0}); };
    return std::hypot(outside(x, width), outside(y, height));
  }
};

/// Integrals over a cell of each part's kernel, and of that times exp(-(x' - x)/l), x the cell's begin.
template <class Value> struct CellIntegrals {
  std::vector<Value> whole, fading;

  explicit CellIntegrals(std::size_t parts) : whole(parts), fading(parts) {}
};

/// Integrates kernels over cells, by Gauss's rule on parts that are halved until they are smaller than 0.7 times the
/// kernels' scale there. `Lines` are the kernels of all parts, summed along a line across a cell: Value, with
/// add(Value&, double, const Value&); parts(), exact_across if that is in closed form, smooth_distance(), the scale at
/// the origin [m], and find(x, cell, rule, values). An object for each thread.
template <class Lines> class CellQuadrature {
public:
  using Value = typename Lines::Value;

  CellQuadrature(Lines lines, std::vector<double> lengths)
      : lines_(std::move(lines)), lengths_(std::move(lengths)), line_(lines_.parts()) {}

  void integrate(const Cell& cell, CellIntegrals<Value>& out) {
    std::fill(out.whole.begin(), out.whole.end(), Value{});
    std::fill(out.fading.begin(), out.fading.end(), Value{});
    add_cell(cell, cell.x, out);
  }

private:
  void add_cell(const Cell& cell, double begin, CellIntegrals<Value>& out) {
    const double scale = std::hypot(lines_.smooth_distance(), cell.distance()), largest = 0.7 * scale;
    const double height = Lines::exact_across ? 0 : cell.height;
    if (cell.width > largest && cell.width >= height) {
      const double half = cell.width / 2;
      add_cell({cell.x, cell.y, half, cell.height}, begin, out);
      add_cell({cell.x + half, cell.y, half, cell.height}, begin, out);
    } else if (height > largest) {
      const double half = cell.height / 2;
      add_cell({cell.x, cell.y, cell.width, half}, begin, out);
      add_cell({cell.x, cell.y + half, cell.width, half}, begin, out);
    } else {
      add_points(cell, rule_for(std::max(cell.width, height) / scale, !lengths_.empty()), begin, out);
    }
  }

  void add_points(const Cell& cell, const GaussLegendre& rule, double begin, CellIntegrals<Value>& out) {
    const std::vector<std::vector<double>>& fading = fading_of(rule, cell.width);
    for (std::size_t g = 0; g < rule.count(); ++g) {
      lines_.find(rule.node(g, cell.x, cell.x + cell.width), cell, rule, line_);
      for (std::size_t m = 0; m < line_.size(); ++m) {
        add(out.whole[m], rule.weight(g, 0, cell.width), line_[m]);
        if (m == 0) continue;
        const double faded = cell.x > begin ? std::exp((begin - cell.x) / lengths_[m - 1]) : 1;
        add(out.fading[m], faded * fading[m - 1][g], line_[m]);
      }
    }
  }

  const std::vector<std::vector<double>>& fading_of(const GaussLegendre& rule, double width) {
    const auto [found, is_new] = fading_.try_emplace({width, rule.count()});
    if (is_new)
      for (const double length : lengths_) found->second.push_back(fading_weights(rule, width, length));
    return found->second;
  }

  Lines lines_;
  std::vector<double> lengths_; ///< V T of the retarded parts [m]
  /// Weights of each length and node, by width and number of nodes.
  std::map<std::pair<double, std::size_t>, std::vector<std::vector<double>>> fading_;
  std::vector<Value> line_;
};

/// Columns beyond elements that end at `begin`, from nearest to farthest, as far as the longest memory reaches: each is
/// half as wide as it is far from the middle.
std::vector<Cell> columns_beyond(double begin, double dx, const std::vector<double>& lengths);

/// Rows of elements of rolled bodies, whose sums S (L6) run from the far end towards minus x. An object for each
/// thread.
template <class Lines> class RolledRows {
public:
  using Value = typename Lines::Value;

  /// `lengths` [m] of the memory of the parts 1, 2 ..., `beyond`: columns_beyond.
  RolledRows(const Lines& lines, const std::vector<double>& lengths, std::vector<Cell> beyond)
      : lengths_(lengths), beyond_(std::move(beyond)), quadrature_(lines, lengths), integrals_(lines.parts()),
        sums_(lines.parts()) {}

  /// Calls found(i, u) with the influence of an element of sides dx, dy on points at x_first + i dx and y from it, i =
  /// count - 1 ... 0. The columns beyond begin at most where the last point's element ends.
  template <class Found> void find(double x_first, int count, double y, double dx, double dy, const Found& found) {
    const double low = y - dy / 2;
    std::fill(sums_.begin(), sums_.end(), Value{});
    for (auto cell = beyond_.rbegin(); cell != beyond_.rend(); ++cell) {
      quadrature_.integrate({cell->x, low, cell->width, dy}, integrals_);
      continue_sums(cell->width);
    }
    for (int i = count - 1; i >= 0; --i) {
      quadrature_.integrate({x_first + (i - 0.5) * dx, low, dx, dy}, integrals_);
      found(i, displacement(dx));
      continue_sums(dx);
    }
  }

private:
  Value displacement(double dx) const {
    Value sum = integrals_.whole[0];
    for (std::size_t m = 1; m < sums_.size(); ++m) {
      add(sum, 1, integrals_.whole[m]);
      add(sum, -1, integrals_.fading[m]);
      add(sum, -std::expm1(-dx / lengths_[m - 1]), sums_[m]);
    }
    return sum;
  }
  void continue_sums(double width) {
    for (std::size_t m = 1; m < sums_.size(); ++m) {
      Value next = integrals_.fading[m];
      add(next, std::exp(-width / lengths_[m - 1]), sums_[m]);
      sums_[m] = next;
    }
  }

  std::vector<double> lengths_;
  std::vector<Cell> beyond_;
  CellQuadrature<Lines> quadrature_;
  CellIntegrals<Value> integrals_;
  std::vector<Value> sums_; ///< S
};

} // namespace microslip
