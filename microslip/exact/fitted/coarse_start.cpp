#include "microslip/exact/fitted/coarse_start.hpp"

#include "microslip/vec2.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// Traction over bound of a solution, along its rows.
class RelativeTractions {
public:
  RelativeTractions(const FittedContact& contact, std::span<const double> bound, const FrictionSolution& solution)
      : contact_(contact), bound_(bound), solution_(solution), first_(contact.grid.my + 1, contact.elements.size()) {
    for (std::size_t k = contact.elements.size(); k-- > 0;) first_[contact.elements[k].row] = k;
    for (int row = contact.grid.my; row-- > 0;) first_[row] = std::min(first_[row], first_[row + 1]);
  }

  /// Beyond the outermost elements their values.
  Vec2 at(double x, double y) const {
    const ElementGrid& grid = contact_.grid;
    const double place = std::clamp((y - grid.y0) / grid.dy, 0.0, grid.my - 1.0);
    const int row = std::min(static_cast<int>(place), std::max(grid.my - 2, 0));
    const double t = place - row;
    const Vec2 low = in_row(row, x), high = in_row(std::min(row + 1, grid.my - 1), x);
    return {(1 - t) * low.x + t * high.x, (1 - t) * low.y + t * high.y};
  }

private:
  Vec2 value(std::size_t k) const {
    return bound_[k] > 0 ? Vec2{solution_.px[k] / bound_[k], solution_.py[k] / bound_[k]} : Vec2{};
  }

  Vec2 in_row(int row, double x) const {
    const auto begin = contact_.elements.begin() + static_cast<std::ptrdiff_t>(first_[row]);
    const auto end = contact_.elements.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]);
    if (begin == end) return {};
    const auto next = std::partition_point(begin, end, [&](const FittedElement& e) { return e.centre() <= x; });
    const auto k = static_cast<std::size_t>(next - contact_.elements.begin());
    if (next == begin) return value(k);
    if (next == end) return value(k - 1);
    const double before = (next - 1)->centre(), t = (x - before) / (next->centre() - before);
    const Vec2 a = value(k - 1), b = value(k);
    return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
  }

  const FittedContact& contact_;
  std::span<const double> bound_;
  const FrictionSolution& solution_;
  std::vector<std::size_t> first_; ///< element of each row
};

} // namespace

VectorField start_from_coarser(const FittedContact& coarse, std::span<const double> coarse_bound,
                               const FrictionSolution& solution, const FittedContact& fine,
                               std::span<const double> bound) {
  const RelativeTractions relative(coarse, coarse_bound, solution);
  VectorField start;
  for (std::size_t k = 0; k < fine.elements.size(); ++k) {
    const FittedElement& e = fine.elements[k];
    const Vec2 p = relative.at(e.centre(), fine.grid.y(e.row));
    start.x.push_back(bound[k] * p.x);
    start.y.push_back(bound[k] * p.y);
  }
  return start;
}

} // namespace microslip
