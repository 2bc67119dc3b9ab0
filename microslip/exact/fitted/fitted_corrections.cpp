#include "microslip/exact/fitted/fitted_corrections.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/numerics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace microslip {
namespace {

using Product = FittedProduct<double>;
using Vector = WideLanes<double, Product::lanes>;

constexpr double near = 6;         // elements along x: corrections end here
constexpr double rounding = 1e-10; // of lengths in units of dx
constexpr int farthest = 16;       // columns between an element of the grid and one that stands for one nearby
constexpr std::size_t most_together =
    32; // leading elements: vectors that fill registers, tables that stay in the cache
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Displacements by half strips for the rows nearby, in units of dx/G; readable a block further.
class StripTable {
public:
  StripTable(double poisson_ratio, const ElementGrid& grid, std::vector<double> x, int first_row, int rows)
      : size_(x.size()) {
    for (auto& values : of_) values.resize(size_ * static_cast<std::size_t>(rows) + Product::lanes);
    HalfStrips strips = half_strips(grid, std::move(x));
    for (int j = 0; j < rows; ++j) {
      const HalfStrips::Row row = strips.at(first_row + j);
      const auto to = static_cast<std::ptrdiff_t>(size_) * j;
      std::copy(row.xx.begin(), row.xx.end(), of_[component::xx].begin() + to);
      std::copy(row.yy.begin(), row.yy.end(), of_[component::yy].begin() + to);
      std::copy(row.xy.begin(), row.xy.end(), of_[component::xy].begin() + to);
    }
    combine_integrals(poisson_ratio, of_[component::xx], of_[component::yy], of_[component::xy]);
  }

  const double* row(std::size_t c, int j) const { return of_[c].data() + size_ * static_cast<std::size_t>(j); }

private:
  std::size_t size_;
  std::array<std::vector<double>, 3> of_;
};

/// The grid's kernel near its centre, for offsets of both signs along x; readable a block further.
class NearKernel {
public:
  NearKernel(const GridKernel& kernel, int rows) : most_(std::min(farthest, kernel.mx() - 1)) {
    for (std::size_t c = 0; c < 3; ++c)
      for (int j = 0; j < rows; ++j) {
        const double *row = kernel.row(c, j), side = c == component::xy ? -1 : 1;
        for (int i = -most_; i <= most_; ++i) of_[c].push_back(i < 0 ? side * row[-i] : row[i]);
      }
    for (auto& values : of_) values.resize(values.size() + Product::lanes);
  }

  /// Table from the offset on, |offset| <= 16 and < mx.
  const double* from(std::size_t c, int row, int offset) const {
    return of_[c].data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(2 * most_ + 1) +
           static_cast<std::size_t>(most_ + offset);
  }

private:
  int most_;
  std::array<std::vector<double>, 3> of_;
};

/// Numbers of `count` elements, by components, from blocks of them; and up to a block more.
using Block = std::array<std::array<double, std::size_t{2} * farthest>, 3>;
template <class Of> void fill(int count, std::size_t c, Block& out, const Of& of) {
  for (int k = 0; k < count; k += static_cast<int>(Product::lanes)) of(k).store(&out[c][k]);
}

class CorrectionBuilder {
public:
  CorrectionBuilder(double poisson_ratio, const FittedContact& contact, const GridKernel& kernel,
                    std::vector<LeadingElement> leading, Product::Tables& tables, const Progress& progress)
      : poisson_ratio_(poisson_ratio), grid_(contact.grid), elements_(contact.elements),
        rows_(static_cast<int>(std::min(near * grid_.dx / grid_.dy + 1 + rounding, double(grid_.my)))),
        table_rows_(std::min(rows_, grid_.my - 1) + 1), kernel_(kernel, table_rows_), leading_(std::move(leading)),
        tables_(tables), progress_(progress), leading_of_(elements_.size(), none) {
    std::sort(leading_.begin(), leading_.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.right, a.left, a.element) < std::tuple(b.right, b.left, b.element);
    });
    for (std::size_t k = 0; k < leading_.size(); ++k) leading_of_[leading_[k].element] = k;
    first_of_row_.assign(static_cast<std::size_t>(grid_.my) + 1, elements_.size());
    for (std::size_t k = elements_.size(); k-- > 0;) first_of_row_[elements_[k].row] = k;
    for (int j = grid_.my; j-- > 0;) first_of_row_[j] = std::min(first_of_row_[j], first_of_row_[j + 1]);
    for (const FittedElement& e : elements_) {
      centre_.push_back((e.centre() - grid_.x0) / grid_.dx);
      lowest_ = std::min(lowest_, column(e)), highest_ = std::max(highest_, column(e));
    }
  }

  void build() {
    for (std::size_t begin = 0; begin < leading_.size(); begin += most_together) {
      const std::size_t end = std::min(begin + most_together, leading_.size());
      find_strips(begin, end);
      find_pairs(begin, end);
      for (std::size_t k = begin; k < end; ++k) {
        for (std::size_t which = 0; which < 2; ++which) {
          go_on(progress_, 0);
          correct_point(k, which);
        }
        go_on(progress_, 0);
        correct_element(k);
      }
    }
  }

private:
  /// Positions in the strip table of half strips that end at the sides of the grid's columns, from `first` on.
  struct Shape {
    int first, last; ///< columns
    /// Index of the leading element's point; of the end of its slip; of its sides, half an element further ahead, as
    /// they then are as far from an end as from the middle of the column behind.
    std::array<std::size_t, 4> in_table;
  };
  enum : std::size_t { from_point, from_end, from_left, from_right };

  int column(const FittedElement& e) const { return static_cast<int>(e.cell % static_cast<std::size_t>(grid_.mx)); }

  /// Calls `act` with the elements of each row nearby whose centres are near x.
  template <class Act> void each_row(int row, double x, const Act& act) const {
    for (int other = std::max(row - rows_, 0); other < std::min(row + rows_ + 1, grid_.my); ++other) {
      const auto begin = centre_.begin();
      const auto end = begin + static_cast<std::ptrdiff_t>(first_of_row_[other + 1]);
      const auto from = std::lower_bound(begin + static_cast<std::ptrdiff_t>(first_of_row_[other]), end, x - near);
      const auto to = std::upper_bound(from, end, x + near);
      if (from != to) act(other, static_cast<std::size_t>(from - begin), static_cast<std::size_t>(to - begin));
    }
  }

  /// The half strips for some leading elements, once for those in the same position, as in rows that mirror one
  /// another.
  void find_strips(std::size_t begin, std::size_t end) {
    shapes_.clear();
    shape_of_.clear();
    std::vector<double> x;
    for (std::size_t k = begin; k < end; ++k) {
      const LeadingElement& e = leading_[k];
      if (k == begin || e.right - leading_[k - 1].right > rounding ||
          std::abs(e.left - leading_[k - 1].left) > rounding) {
        Shape shape{.first = std::max(static_cast<int>(std::floor(e.left - near)), lowest_),
                    .last = std::min(static_cast<int>(std::ceil(e.right + 0.5 + near)), highest_),
                    .in_table = {}};
        const auto add = [&](double place) {
          const std::size_t at = x.size();
          for (int i = shape.first; i <= shape.last + 1; ++i) x.push_back(place - (i - 0.5));
          return at;
        };
        const double way_end = e.points[1].x, right = e.right + 0.5;
        shape.in_table[from_point] = add(e.points[0].x);
        shape.in_table[from_end] = add(way_end);
        shape.in_table[from_left] = add(e.left + 0.5);
        shape.in_table[from_right] = std::abs(way_end - right) < rounding ? shape.in_table[from_end] : add(right);
        shapes_.push_back(shape);
      }
      shape_of_.push_back(shapes_.size() - 1);
    }
    strips_.emplace(poisson_ratio_, grid_, std::move(x), 0, table_rows_);
    first_ = begin;
  }
  const Shape& shape(std::size_t k) const { return shapes_[shape_of_[k - first_]]; }

  /// Finds influences of leading elements at one another's points, row offset by row offset.
  void find_pairs(std::size_t begin, std::size_t end) {
    std::vector<std::vector<double>> x(static_cast<std::size_t>(table_rows_));
    for (std::size_t k = begin; k < end; ++k)
      for (const LeadingElement::Point& point : leading_[k].points)
        each_row(leading_[k].row, point.x, [&](int other, std::size_t from, std::size_t to) {
          for (std::size_t element = from; element < to; ++element) {
            if (leading_of_[element] == none) continue;
            const LeadingElement& source = leading_[leading_of_[element]];
            auto& of_row = x[std::abs(leading_[k].row - other)];
            of_row.push_back(point.x - source.left);
            of_row.push_back(point.x - source.right);
          }
        });
    pairs_.clear();
    for (int j = 0; j < table_rows_; ++j) pairs_.emplace_back(poisson_ratio_, grid_, std::move(x[j]), j, 1);
    next_pair_.assign(static_cast<std::size_t>(table_rows_), 0);
  }

  /// Makes space for one more run, a multiple of the lanes; behind what is not needed there are zeros.
  std::array<double*, 3> add_run(Product::Corrections& to, std::size_t point, std::size_t element, std::size_t count) {
    const std::size_t whole = (count + Product::lanes - 1) / Product::lanes * Product::lanes, size = to.xx.size();
    to.runs.push_back({point, element, whole});
    for (auto* weights : {&to.xx, &to.xy, &to.yy}) weights->resize(size + whole);
    std::array<double*, 3> out;
    out[component::xx] = &to.xx[size], out[component::yy] = &to.yy[size], out[component::xy] = &to.xy[size];
    return out;
  }

  /// The number of elements from k on, below `end`, that are the grid's.
  int count_regular(std::size_t k, std::size_t end) const {
    std::size_t to = k;
    while (to < end && leading_of_[to] == none) ++to;
    return static_cast<int>(to - k);
  }

  /// A point that is none of the grid's, from all elements nearby.
  void correct_point(std::size_t k, std::size_t which) {
    const LeadingElement::Point& point = leading_[k].points[which];
    each_row(leading_[k].row, point.x, [&](int other, std::size_t from, std::size_t to) {
      const int offset = leading_[k].row - other;
      auto out = add_run(tables_.at_points, point.point, from, to - from);
      for (std::size_t element = from; element < to;) {
        int count = count_regular(element, to);
        Block block;
        if (count > 0)
          correct_by_regular(shape(k), which, point, std::abs(offset), column(elements_[element]), count, block);
        else
          correct_by_leading(point, leading_[leading_of_[element]], std::abs(offset), block), count = 1;
        put(block, offset, count, out);
        element += static_cast<std::size_t>(count);
      }
    });
  }

  /// Writes to the results; for negative offsets in y with the opposite sign of xy.
  static void put(const Block& block, int offset, int count, std::array<double*, 3>& out) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double side = c == component::xy && offset < 0 ? -1 : 1;
      for (int i = 0; i < count; ++i) out[c][i] = side * block[c][i];
      out[c] += count;
    }
  }

  /// Corrects the influence of `count` elements of the grid.
  void correct_by_regular(const Shape& shape, std::size_t which, const LeadingElement::Point& point, int offset,
                          int first_column, int count, Block& out) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const double* strips = strips_->row(c, offset) + shape.in_table[which] + (first_column - shape.first);
      const double* kernel = kernel_.from(c, offset, first_column - point.first_node); // from node to element:
      const double side = c == component::xy ? 1 : -1;                                 // in the opposite direction
      fill(count, c, out, [&](int k) {
        Vector sum = Vector::load(strips + k) - Vector::load(strips + k + 1);
        for (int i = 0; i < tables_.nodes; ++i) sum += side * point.nodes[i] * Vector::load(kernel + k - i);
        return sum;
      });
    }
  }

  /// Corrects the influence of a leading element, which stands in the transforms as three of the grid's.
  void correct_by_leading(const LeadingElement::Point& point, const LeadingElement& source, int offset, Block& out) {
    const std::size_t at = next_pair_[offset];
    next_pair_[offset] += 2;
    std::array<double, Product::most_nodes + 2> weights = {}; // from the last moment to the first node on
    for (int m = 0; m < 3; ++m)
      for (int i = 0; i < tables_.nodes; ++i) weights[2 - m + i] += source.moments[m] * point.nodes[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const double* pair = pairs_[offset].row(c, 0) + at;
      const double* kernel = kernel_.from(c, offset, point.first_node - source.first_moment - 2);
      out[c][0] = pair[0] - pair[1];
      for (int i = 0; i < tables_.nodes + 2; ++i) out[c][0] -= weights[i] * kernel[i];
    }
  }

  /// The grid's points nearby, from a leading element.
  void correct_element(std::size_t k) {
    const LeadingElement& e = leading_[k];
    each_row(e.row, centre_[e.element], [&](int other, std::size_t from, std::size_t to) {
      const int offset = other - e.row;
      for (std::size_t point = from; point < to; ++point) {
        const int count = count_regular(point, to);
        if (count == 0) continue;
        auto out = add_run(tables_.of_elements, point, e.element, static_cast<std::size_t>(count));
        Block block;
        correct_for_regular(shape(k), e, std::abs(offset), column(elements_[point]), count, block);
        put(block, offset, count, out);
        point += static_cast<std::size_t>(count);
      }
    });
  }

  /// Corrects the influence at `count` of the grid's points. The strip table has the leading element's sides from
  /// there: in the opposite order, where xx and yy are the same and xy changes its sign.
  void correct_for_regular(const Shape& shape, const LeadingElement& e, int offset, int first_column, int count,
                           Block& out) const {
    const int first = first_column - shape.first + 1;
    for (std::size_t c = 0; c < 3; ++c) {
      const double* right = strips_->row(c, offset) + shape.in_table[from_right] + first;
      const double* left = strips_->row(c, offset) + shape.in_table[from_left] + first;
      const double* kernel = kernel_.from(c, offset, first_column - e.first_moment);
      const double side = c == component::xy ? -1 : 1;
      fill(count, c, out, [&](int k) {
        Vector sum = side * (Vector::load(right + k) - Vector::load(left + k));
        for (int m = 0; m < 3; ++m) sum -= e.moments[m] * Vector::load(kernel + k - m);
        return sum;
      });
    }
  }

  double poisson_ratio_;
  const ElementGrid& grid_;
  const std::vector<FittedElement>& elements_;
  int rows_, table_rows_; ///< nearby on one side; with offsets from 0 on
  NearKernel kernel_;
  std::vector<LeadingElement> leading_;
  Product::Tables& tables_;
  const Progress& progress_;
  std::vector<std::size_t> leading_of_;   ///< each element's index in leading_
  std::vector<std::size_t> first_of_row_; ///< elements, and behind them the number of all
  std::vector<double> centre_;            ///< of all elements, in units of dx from the first column's
  int lowest_ = std::numeric_limits<int>::max(), highest_ = 0; ///< columns with elements
  // Of some leading elements, from first_ on:
  std::size_t first_ = 0;
  std::vector<Shape> shapes_;
  std::vector<std::size_t> shape_of_;
  std::optional<StripTable> strips_;
  std::vector<StripTable> pairs_;      ///< of each row offset: the sources' trailing and leading sides in turn
  std::vector<std::size_t> next_pair_; ///< as they are used
};

} // namespace

void find_corrections(double poisson_ratio, const FittedContact& contact, const GridKernel& kernel,
                      std::vector<LeadingElement> leading, FittedProduct<double>::Tables& tables,
                      const Progress& progress) {
  CorrectionBuilder(poisson_ratio, contact, kernel, std::move(leading), tables, progress).build();
}

} // namespace microslip
