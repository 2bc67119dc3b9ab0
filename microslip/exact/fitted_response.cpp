#include "microslip/exact/fitted_response.hpp"

#include "microslip/exact/offset_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr std::size_t regular = std::numeric_limits<std::size_t>::max();
constexpr double near = 6; // elements along x: corrections end here

/// Lagrange's weights at t for the nodes 0, 1, ..., count - 1.
template <class Weights> void interpolate(double t, int count, Weights& weights) {
  for (int m = 0; m < count; ++m) {
    weights[m] = 1;
    for (int other = 0; other < count; ++other)
      if (other != m) weights[m] *= (t - other) / (m - other);
  }
}

} // namespace

/// The displacements that an element of the grid makes at the centres of others. xx and yy are even in both components
/// of the offset, xy is odd, so a quarter of the offsets is enough.
class QuarterKernel {
public:
  QuarterKernel(const CombinedMaterial& material, const ElementGrid& grid)
      : mx_(grid.mx), xx(grid.count()), xy(grid.count()), yy(grid.count()) {
    for (std::size_t k = 0; k < grid.count(); ++k) {
      const auto i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
      const Influence a = element_influence(material, grid, grid.dx, i * grid.dx, j * grid.dy);
      xx[k] = a.xx, xy[k] = a.xy, yy[k] = a.yy;
    }
  }

  Influence at(int i, int j) const {
    const std::size_t k = static_cast<std::size_t>(std::abs(j)) * mx_ + std::abs(i);
    return {xx[k], (i < 0) == (j < 0) ? xy[k] : -xy[k], yy[k], 0, 0, 0};
  }

private:
  int mx_;

public:
  std::vector<double> xx, xy, yy; ///< at the offsets 0 .. mx - 1, 0 .. my - 1
};

FittedResponse::FittedResponse(const CombinedMaterial& material, const FittedContact& contact)
    : grid_(contact.grid), elements_(contact.elements), nodes_(std::min(most_nodes, contact.grid.mx)),
      grid_px_(grid_.count()), grid_py_(grid_px_), grid_ux_(grid_px_), grid_uy_(grid_px_) {
  const QuarterKernel kernel(material, grid_);
  transform_ = std::make_unique<SymmetricToeplitz>(grid_.mx, grid_.my,
                                                   SymmetricToeplitz::Kernels{kernel.xx, kernel.xy, kernel.yy});
  diagonal_ = (kernel.xx[0] - kernel.xx[1] + kernel.yy[0] - kernel.yy[1]) / (2 * grid_.dx);
  place_points();
  find_moments();
  find_corrections(material, kernel);
  point_ux_.resize(point_x_.size());
  point_uy_.resize(point_x_.size());
}

void FittedResponse::place_points() {
  const auto add = [&](double x, int row, std::size_t cell, bool is_cell_centre) {
    point_x_.push_back(x);
    point_row_.push_back(row);
    point_cell_.push_back(cell);
    stencil_of_.push_back(is_cell_centre ? regular : stencils_.size());
    if (is_cell_centre) return;
    const double place = (x - grid_.x0) / grid_.dx;
    const int first = std::clamp(static_cast<int>(std::floor(place)) - nodes_ / 2 + 1, 0, grid_.mx - nodes_);
    Stencil stencil{static_cast<std::size_t>(row) * grid_.mx + first, {}};
    interpolate(place - first, nodes_, stencil.weight);
    stencils_.push_back(stencil);
  };
  for (const FittedElement& e : elements_) add(e.centre(), e.row, e.cell, !e.fitted);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (elements_[k].leads) add(elements_[k].end, elements_[k].row, elements_[k].cell, false);
    end_point_.push_back(elements_[k].leads ? point_x_.size() - 1 : k + 1);
  }
}

/// The three neighbours of the grid that have the force, its moment and its second moment along x.
void FittedResponse::find_moments() {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const FittedElement& e = elements_[k];
    if (!e.fitted) continue;
    const int column = std::clamp(static_cast<int>(std::lround((e.centre() - grid_.x0) / grid_.dx)), 1, grid_.mx - 2);
    const double from = (e.left - grid_.x(column)) / grid_.dx, to = (e.right - grid_.x(column)) / grid_.dx;
    const double force = to - from, first = (to * to - from * from) / 2;
    const double outer = (to * to * to - from * from * from) / 3 - force / 12;
    moments_.push_back({k,
                        static_cast<std::size_t>(e.row) * grid_.mx + column - 1,
                        {(outer - first) / 2, force - outer, (outer + first) / 2}});
  }
}

/// The difference between what an element does to a point and what the transforms make of it: for a point that is none
/// of the grid's from all elements nearby, for the grid's points from the fitted elements nearby.
void FittedResponse::find_corrections(const CombinedMaterial& material, const QuarterKernel& kernel) {
  std::vector<std::size_t> moments_of(elements_.size(), regular);
  for (std::size_t i = 0; i < moments_.size(); ++i) moments_of[moments_[i].element] = i;

  const auto by_transforms = [&](std::size_t point, std::size_t element) {
    Influence sum{};
    const int row_offset = point_row_[point] - elements_[element].row;
    const auto add = [&](std::size_t to, std::size_t from, double weight) {
      const int offset = static_cast<int>(to % grid_.mx) - static_cast<int>(from % grid_.mx);
      const Influence a = kernel.at(offset, row_offset);
      sum.xx += weight * a.xx;
      sum.xy += weight * a.xy;
      sum.yy += weight * a.yy;
    };
    const auto add_element = [&](std::size_t to, double weight) {
      if (moments_of[element] == regular) return add(to, elements_[element].cell, weight);
      const Moments& m = moments_[moments_of[element]];
      for (std::size_t i = 0; i < 3; ++i) add(to, m.first_cell + i, weight * m.weight[i]);
    };
    if (stencil_of_[point] == regular) {
      add_element(point_cell_[point], 1);
    } else {
      const Stencil& s = stencils_[stencil_of_[point]];
      for (int i = 0; i < nodes_; ++i) add_element(s.first_cell + i, s.weight[i]);
    }
    return sum;
  };
  const auto correct = [&](Corrections& by, std::size_t point, std::size_t element) {
    const FittedElement& e = elements_[element];
    const double x = point_x_[point] - e.centre(), y = (point_row_[point] - e.row) * grid_.dy;
    const Influence exact = element_influence(material, grid_, e.width(), x, y), fast = by_transforms(point, element);
    by.xx.push_back(exact.xx - fast.xx);
    by.xy.push_back(exact.xy - fast.xy);
    by.yy.push_back(exact.yy - fast.yy);
  };
  const int rows = static_cast<int>(std::min(near * grid_.dx / grid_.dy + 1, double(grid_.my)));
  const auto first_of_row = first_elements();
  /// Calls `add` with the elements of each row nearby whose centres are near x.
  const auto each_row = [&](int row, double x, const auto& add) {
    for (int other = std::max(row - rows, 0); other < std::min(row + rows + 1, grid_.my); ++other) {
      const auto end = elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row[other + 1]);
      auto from = std::partition_point(elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row[other]), end,
                                       [&](const auto& e) { return e.centre() < x - near * grid_.dx; });
      const auto to = std::partition_point(from, end, [&](const auto& e) { return e.centre() <= x + near * grid_.dx; });
      if (from != to) add(from - elements_.begin(), to - elements_.begin());
    }
  };
  for (std::size_t point = 0; point < point_x_.size(); ++point) {
    if (stencil_of_[point] == regular) continue;
    each_row(point_row_[point], point_x_[point], [&](std::size_t from, std::size_t to) {
      at_points_.runs.push_back({point, from, to - from});
      for (std::size_t element = from; element < to; ++element) correct(at_points_, point, element);
    });
  }
  for (const Moments& m : moments_) {
    const FittedElement& e = elements_[m.element];
    each_row(e.row, e.centre(), [&](std::size_t from, std::size_t to) {
      for (std::size_t point = from; point < to; ++point) {
        if (stencil_of_[point] != regular) continue;
        if (point == from || stencil_of_[point - 1] != regular) of_elements_.runs.push_back({point, m.element, 0});
        ++of_elements_.runs.back().count;
        correct(of_elements_, point, m.element);
      }
    });
  }
}

/// Of each row, and behind them the number of all.
std::vector<std::size_t> FittedResponse::first_elements() const {
  std::vector<std::size_t> first(grid_.my + 1, elements_.size());
  for (std::size_t k = elements_.size(); k-- > 0;) first[elements_[k].row] = k;
  for (int j = grid_.my; j-- > 0;) first[j] = std::min(first[j], first[j + 1]);
  return first;
}

/// Adds the corrections to the displacements.
void FittedResponse::correct(std::span<const double> px, std::span<const double> py) {
  std::size_t at = 0;
  for (const Run& run : at_points_.runs) {
    const double *xx = &at_points_.xx[at], *xy = &at_points_.xy[at], *yy = &at_points_.yy[at];
    const double *x = &px[run.element], *y = &py[run.element];
    double ux = 0, uy = 0;
#pragma omp simd reduction(+ : ux, uy)
    for (std::size_t i = 0; i < run.count; ++i) {
      ux += xx[i] * x[i] + xy[i] * y[i];
      uy += xy[i] * x[i] + yy[i] * y[i];
    }
    point_ux_[run.point] += ux;
    point_uy_[run.point] += uy;
    at += run.count;
  }
  at = 0;
  for (const Run& run : of_elements_.runs) {
    const double *xx = &of_elements_.xx[at], *xy = &of_elements_.xy[at], *yy = &of_elements_.yy[at];
    const double x = px[run.element], y = py[run.element];
    double *ux = &point_ux_[run.point], *uy = &point_uy_[run.point];
#pragma omp simd
    for (std::size_t i = 0; i < run.count; ++i) {
      ux[i] += xx[i] * x + xy[i] * y;
      uy[i] += xy[i] * x + yy[i] * y;
    }
    at += run.count;
  }
}

void FittedResponse::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                           std::span<double> sy) {
  std::fill(grid_px_.begin(), grid_px_.end(), 0.0);
  std::fill(grid_py_.begin(), grid_py_.end(), 0.0);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (elements_[k].fitted) continue;
    grid_px_[elements_[k].cell] = px[k];
    grid_py_[elements_[k].cell] = py[k];
  }
  for (const Moments& m : moments_)
    for (std::size_t i = 0; i < 3; ++i) {
      grid_px_[m.first_cell + i] += m.weight[i] * px[m.element];
      grid_py_[m.first_cell + i] += m.weight[i] * py[m.element];
    }
  transform_->apply(grid_px_, grid_py_, grid_ux_, grid_uy_);
  for (std::size_t point = 0; point < point_x_.size(); ++point) {
    if (stencil_of_[point] == regular) {
      point_ux_[point] = grid_ux_[point_cell_[point]];
      point_uy_[point] = grid_uy_[point_cell_[point]];
      continue;
    }
    const Stencil& s = stencils_[stencil_of_[point]];
    double ux = 0, uy = 0;
    for (int i = 0; i < nodes_; ++i) {
      ux += s.weight[i] * grid_ux_[s.first_cell + i];
      uy += s.weight[i] * grid_uy_[s.first_cell + i];
    }
    point_ux_[point] = ux;
    point_uy_[point] = uy;
  }
  correct(px, py);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const double way = elements_[k].end - elements_[k].centre();
    sx[k] = (point_ux_[k] - point_ux_[end_point_[k]]) / way;
    sy[k] = (point_uy_[k] - point_uy_[end_point_[k]]) / way;
  }
}

} // namespace microslip
