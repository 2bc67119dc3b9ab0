#include "microslip/exact/fitted/fitted_response.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using Product = FittedProduct<double>;

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
  QuarterKernel(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress)
      : mx_(grid.mx), xx_(grid.count()), xy_(grid.count()), yy_(grid.count()) {
    for (std::size_t k = 0; k < grid.count(); ++k) {
      const auto i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
      if (i == 0) go_on(progress, 0);
      const Influence a = element_influence(material, grid, grid.dx, i * grid.dx, j * grid.dy);
      xx_[k] = a.xx, xy_[k] = a.xy, yy_[k] = a.yy;
    }
  }

  SymmetricToeplitz<double> transform(const ElementGrid& grid) const { return {grid.mx, grid.my, {xx_, xy_, yy_}}; }

  /// The mean of D_xx and D_yy of an element in the midst of the contact.
  double diagonal(double dx) const { return (xx_[0] - xx_[1] + yy_[0] - yy_[1]) / (2 * dx); }

  Influence at(int i, int j) const {
    const std::size_t k = static_cast<std::size_t>(std::abs(j)) * mx_ + std::abs(i);
    return {xx_[k], (i < 0) == (j < 0) ? xy_[k] : -xy_[k], yy_[k], 0, 0, 0};
  }

private:
  int mx_;
  std::vector<double> xx_, xy_, yy_; ///< at the offsets 0 .. mx - 1, 0 .. my - 1
};

namespace {

/// Finds what FittedProduct needs.
class TableFinder {
public:
  /// `stride`: of rows in the transforms' field.
  TableFinder(const CombinedMaterial& material, const FittedContact& contact, const QuarterKernel& kernel,
              std::size_t stride, const Progress& progress)
      : material_(material), grid_(contact.grid), elements_(contact.elements), kernel_(kernel), stride_(stride),
        progress_(progress) {
    find_rows();
    place_points();
    find_moments();
    find_corrections();
  }

  Product::Tables take() { return std::move(tables_); }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::size_t cell(int row, int column) const { return static_cast<std::size_t>(row) * stride_ + column; }

  void find_rows();
  void place_points();
  void find_moments();
  void find_corrections();
  void correct_point(std::size_t point);
  void correct_element(const Product::Moments& moments);
  void correct(Product::Corrections& by, std::size_t point, std::size_t element) const;
  static void fill_lanes(Product::Corrections& by);
  Influence by_transforms(std::size_t point, std::size_t element) const;
  template <class Add> void each_row(int row, double x, const Add& add) const;

  const CombinedMaterial& material_;
  const ElementGrid& grid_;
  const std::vector<FittedElement>& elements_;
  const QuarterKernel& kernel_;
  std::size_t stride_;
  const Progress& progress_;
  std::vector<std::size_t> first_of_row_; ///< elements, and behind them the number of all
  std::vector<double> point_x_;
  std::vector<int> point_row_;
  std::vector<std::size_t> point_cell_; ///< the grid's point, for points of the grid
  std::vector<std::size_t> stencil_of_; ///< the stencil, for others
  std::vector<std::size_t> moments_of_; ///< of the fitted elements
  Product::Tables tables_;
};

void TableFinder::place_points() {
  tables_.nodes = std::min(Product::most_nodes, grid_.mx);
  const auto add = [&](double x, const FittedElement& e, bool is_cell_centre) {
    const std::size_t point = point_x_.size();
    point_x_.push_back(x);
    point_row_.push_back(e.row);
    point_cell_.push_back(cell(e.row, static_cast<int>(e.cell % grid_.mx)));
    stencil_of_.push_back(is_cell_centre ? none : tables_.stencils.size());
    if (is_cell_centre) return;
    const double place = (x - grid_.x0) / grid_.dx;
    const int first =
        std::clamp(static_cast<int>(std::floor(place)) - tables_.nodes / 2 + 1, 0, grid_.mx - tables_.nodes);
    tables_.stencils.push_back({point, cell(e.row, first), {}});
    interpolate(place - first, tables_.nodes, tables_.stencils.back().weight);
  };
  for (const FittedElement& e : elements_) {
    add(e.centre(), e, !e.fitted);
    if (!e.fitted) tables_.places.push_back({point_x_.size() - 1, point_cell_.back()});
    tables_.way.push_back(e.end - e.centre());
  }
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (elements_[k].leads) add(elements_[k].end, elements_[k], false);
    tables_.end_point.push_back(elements_[k].leads ? point_x_.size() - 1 : k + 1);
  }
  tables_.points = point_x_.size();
}

/// The three neighbours of the grid that have the force, its moment and its second moment along x.
void TableFinder::find_moments() {
  moments_of_.assign(elements_.size(), none);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const FittedElement& e = elements_[k];
    if (!e.fitted) continue;
    const int column = std::clamp(static_cast<int>(std::lround((e.centre() - grid_.x0) / grid_.dx)), 1, grid_.mx - 2);
    const double from = (e.left - grid_.x(column)) / grid_.dx, to = (e.right - grid_.x(column)) / grid_.dx;
    const double force = to - from, first = (to * to - from * from) / 2;
    const double outer = (to * to * to - from * from * from) / 3 - force / 12;
    moments_of_[k] = tables_.moments.size();
    tables_.moments.push_back({k, cell(e.row, column - 1), {(outer - first) / 2, force - outer, (outer + first) / 2}});
  }
}

/// What the transforms make of an element's influence on a point.
Influence TableFinder::by_transforms(std::size_t point, std::size_t element) const {
  Influence sum{};
  const FittedElement& e = elements_[element];
  const auto add = [&](std::size_t to, std::size_t from, double weight) {
    const int offset = static_cast<int>(to % stride_) - static_cast<int>(from % stride_);
    const Influence a = kernel_.at(offset, point_row_[point] - e.row);
    sum.xx += weight * a.xx;
    sum.xy += weight * a.xy;
    sum.yy += weight * a.yy;
  };
  const auto add_element = [&](std::size_t to, double weight) {
    if (moments_of_[element] == none) return add(to, cell(e.row, static_cast<int>(e.cell % grid_.mx)), weight);
    const Product::Moments& m = tables_.moments[moments_of_[element]];
    for (std::size_t i = 0; i < 3; ++i) add(to, m.first_cell + i, weight * m.weight[i]);
  };
  if (stencil_of_[point] == none) {
    add_element(point_cell_[point], 1);
  } else {
    const Product::Stencil& s = tables_.stencils[stencil_of_[point]];
    for (int i = 0; i < tables_.nodes; ++i) add_element(s.first_cell + i, s.weight[i]);
  }
  return sum;
}

void TableFinder::correct(Product::Corrections& by, std::size_t point, std::size_t element) const {
  const FittedElement& e = elements_[element];
  const double x = point_x_[point] - e.centre(), y = (point_row_[point] - e.row) * grid_.dy;
  const Influence exact = element_influence(material_, grid_, e.width(), x, y), fast = by_transforms(point, element);
  by.xx.push_back(exact.xx - fast.xx);
  by.xy.push_back(exact.xy - fast.xy);
  by.yy.push_back(exact.yy - fast.yy);
}

/// Makes the last run as long as whole sets of lanes.
void TableFinder::fill_lanes(Product::Corrections& by) {
  const std::size_t lacking = (Product::lanes - by.xx.size() % Product::lanes) % Product::lanes;
  if (lacking == 0) return;
  by.runs.back().count += lacking;
  for (auto* weights : {&by.xx, &by.xy, &by.yy}) weights->resize(weights->size() + lacking);
}

/// Calls `add` with the elements of each row nearby whose centres are near x.
template <class Add> void TableFinder::each_row(int row, double x, const Add& add) const {
  const int rows = static_cast<int>(std::min(near * grid_.dx / grid_.dy + 1, double(grid_.my)));
  for (int other = std::max(row - rows, 0); other < std::min(row + rows + 1, grid_.my); ++other) {
    const auto end = elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row_[other + 1]);
    auto from = std::partition_point(elements_.begin() + static_cast<std::ptrdiff_t>(first_of_row_[other]), end,
                                     [&](const auto& e) { return e.centre() < x - near * grid_.dx; });
    const auto to = std::partition_point(from, end, [&](const auto& e) { return e.centre() <= x + near * grid_.dx; });
    if (from != to) add(from - elements_.begin(), to - elements_.begin());
  }
}

/// A point that is none of the grid's, from all elements nearby.
void TableFinder::correct_point(std::size_t point) {
  each_row(point_row_[point], point_x_[point], [&](std::size_t from, std::size_t to) {
    tables_.at_points.runs.push_back({point, from, to - from});
    for (std::size_t element = from; element < to; ++element) correct(tables_.at_points, point, element);
    fill_lanes(tables_.at_points);
  });
}

/// The grid's points nearby, from a fitted element.
void TableFinder::correct_element(const Product::Moments& moments) {
  const FittedElement& e = elements_[moments.element];
  auto& runs = tables_.of_elements.runs;
  each_row(e.row, e.centre(), [&](std::size_t from, std::size_t to) {
    for (std::size_t point = from; point < to; ++point) {
      if (stencil_of_[point] != none) continue;
      if (point == from || stencil_of_[point - 1] != none) {
        fill_lanes(tables_.of_elements);
        runs.push_back({point, moments.element, 0});
      }
      ++runs.back().count;
      correct(tables_.of_elements, point, moments.element);
    }
    fill_lanes(tables_.of_elements);
  });
}

/// The difference between what an element does to a point and what the transforms make of it.
void TableFinder::find_corrections() {
  for (const Product::Stencil& s : tables_.stencils) {
    go_on(progress_, 0);
    correct_point(s.point);
  }
  for (const Product::Moments& m : tables_.moments) {
    go_on(progress_, 0);
    correct_element(m);
  }
}

void TableFinder::find_rows() {
  first_of_row_.assign(grid_.my + 1, elements_.size());
  for (std::size_t k = elements_.size(); k-- > 0;) first_of_row_[elements_[k].row] = k;
  for (int j = grid_.my; j-- > 0;) first_of_row_[j] = std::min(first_of_row_[j], first_of_row_[j + 1]);
}

Product make_product(const CombinedMaterial& material, const FittedContact& contact, const QuarterKernel& kernel,
                     const Progress& progress) {
  SymmetricToeplitz<double> transform = kernel.transform(contact.grid);
  TableFinder finder(material, contact, kernel, transform.stride(), progress);
  return {finder.take(), std::move(transform)};
}

} // namespace

FittedResponse::FittedResponse(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress)
    : FittedResponse(material, contact, QuarterKernel(material, contact.grid, progress), progress) {}

FittedResponse::FittedResponse(const CombinedMaterial& material, const FittedContact& contact,
                               const QuarterKernel& kernel, const Progress& progress)
    : elements_(contact.elements.size()), product_(make_product(material, contact, kernel, progress)),
      diagonal_(kernel.diagonal(contact.grid.dx)) {}

} // namespace microslip
