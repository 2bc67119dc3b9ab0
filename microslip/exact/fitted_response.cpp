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

/// Where each row begins in a list ordered by rows, and the list's end.
template <class RowOf> std::vector<std::size_t> first_indices(int rows, std::size_t count, const RowOf& row_of) {
  std::vector<std::size_t> first(rows + 1, count);
  for (std::size_t k = count; k-- > 0;) first[row_of(k)] = k;
  for (int j = rows; j-- > 0;) first[j] = std::min(first[j], first[j + 1]);
  return first;
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

/// The difference between what an element does to a point and what the transforms make of it.
void FittedResponse::find_corrections(const CombinedMaterial& material, const QuarterKernel& kernel) {
  std::vector<std::size_t> moments_of(elements_.size(), regular);
  for (std::size_t i = 0; i < moments_.size(); ++i) moments_of[moments_[i].element] = i;
  const auto first_of_row = first_indices(grid_.my, elements_.size(), [&](std::size_t k) { return elements_[k].row; });
  const auto first_moments_of_row =
      first_indices(grid_.my, moments_.size(), [&](std::size_t i) { return elements_[moments_[i].element].row; });

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
  const auto correct = [&](std::size_t point, std::size_t element) {
    const FittedElement& e = elements_[element];
    const double x = point_x_[point] - e.centre(), y = (point_row_[point] - e.row) * grid_.dy;
    if (std::abs(x) > near * grid_.dx) return;
    const Influence exact = element_influence(material, grid_, e.width(), x, y), fast = by_transforms(point, element);
    corrections_.push_back({static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(element), exact.xx - fast.xx,
                            exact.xy - fast.xy, exact.yy - fast.yy});
  };
  // On a regular point the fitted elements nearby, on another one all elements nearby.
  const int rows = static_cast<int>(std::min(near * grid_.dx / grid_.dy + 1, double(grid_.my)));
  for (std::size_t point = 0; point < point_x_.size(); ++point) {
    const int low = std::max(point_row_[point] - rows, 0), high = std::min(point_row_[point] + rows + 1, grid_.my);
    if (stencil_of_[point] == regular) {
      for (std::size_t i = first_moments_of_row[low]; i < first_moments_of_row[high]; ++i)
        correct(point, moments_[i].element);
      continue;
    }
    for (int row = low; row < high; ++row) {
      const auto begin = elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row[row]);
      const auto end = elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row[row + 1]);
      const double from = point_x_[point] - (near + 2) * grid_.dx, to = point_x_[point] + (near + 2) * grid_.dx;
      for (auto e = std::partition_point(begin, end, [&](const auto& other) { return other.right < from; });
           e != end && e->left <= to; ++e)
        correct(point, static_cast<std::size_t>(e - elements_.begin()));
    }
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
  for (const Correction& c : corrections_) {
    point_ux_[c.point] += c.xx * px[c.element] + c.xy * py[c.element];
    point_uy_[c.point] += c.xy * px[c.element] + c.yy * py[c.element];
  }
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const double way = elements_[k].end - elements_[k].centre();
    sx[k] = (point_ux_[k] - point_ux_[end_point_[k]]) / way;
    sy[k] = (point_uy_[k] - point_uy_[end_point_[k]]) / way;
  }
}

} // namespace microslip
