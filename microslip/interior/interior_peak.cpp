#include "microslip/interior/interior_peak.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace microslip {
namespace {

void check_depths(std::span<const double> depths) {
  if (depths.empty()) throw Error("number of depths", 0, "-", "at least 1");
  for (std::size_t d = 1; d < depths.size(); ++d)
    if (!(depths[d] > depths[d - 1])) throw Error("depths", depths[d], "m", "ascending");
}

/// Half the distance from a plane to the next one.
double half_way(std::span<const double> depths, std::size_t d) {
  if (depths.size() == 1) return 0;
  return d + 1 < depths.size() ? (depths[d + 1] - depths[d]) / 2 : (depths[d] - depths[d - 1]) / 2;
}

struct Start {
  InteriorPoint point;
  double step = 0; ///< in depth
};

/// The best point of the planes.
Start best_of_planes(InteriorLayers& layers, std::span<const double> depths, StressMeasure measure,
                     const Progress& progress) {
  const ElementGrid& grid = layers.grid();
  Start best;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < depths.size(); ++d) {
    const std::vector<InteriorState> states = layers.at_depth(depths[d], progress);
    for (std::size_t k = 0; k < states.size(); ++k) {
      const double value = measure(states[k].stress);
      if (value <= largest) continue;
      largest = value;
      best.point = {grid.x(static_cast<int>(k % grid.mx)), grid.y(static_cast<int>(k / grid.mx)), depths[d]};
      best.step = half_way(depths, d);
    }
  }
  return best;
}

/// Steps of a pattern search: to the best neighbour, and with half the step where there is none.
class PatternSearch {
public:
  PatternSearch(const InteriorLayers& layers, std::span<const double> depths, StressMeasure measure,
                const Progress& progress)
      : field_(layers.field()), grid_(layers.grid()), low_(depths.front()), high_(depths.back()), measure_(measure),
        progress_(progress) {}

  InteriorPeak at(const InteriorPoint& point) const {
    const InteriorState state = field_.at(point, progress_);
    return {measure_(state.stress), point, state};
  }

  /// Goes to the best of the six neighbours at a step, if it is better; whether it was.
  bool improve(InteriorPeak& best, const InteriorPoint& step) const {
    const InteriorPoint from = best.point;
    for (const double sign : {-1.0, 1.0})
      for (const InteriorPoint& move : {InteriorPoint{sign * step.x, 0, 0}, InteriorPoint{0, sign * step.y, 0},
                                        InteriorPoint{0, 0, sign * step.depth}}) {
        const InteriorPeak there = at(inside({from.x + move.x, from.y + move.y, from.depth + move.depth}));
        if (there.value > best.value) best = there;
      }
    return best.point.x != from.x || best.point.y != from.y || best.point.depth != from.depth;
  }

private:
  InteriorPoint inside(const InteriorPoint& p) const {
    return {std::clamp(p.x, grid_.x(0), grid_.x(grid_.mx - 1)), std::clamp(p.y, grid_.y(0), grid_.y(grid_.my - 1)),
            std::clamp(p.depth, low_, high_)};
  }

  const InteriorField& field_;
  const ElementGrid& grid_;
  double low_, high_;
  StressMeasure measure_;
  const Progress& progress_;
};

} // namespace

InteriorPeak find_largest(InteriorLayers& layers, std::span<const double> depths, StressMeasure measure,
                          const Progress& progress) {
  check_depths(depths);
  const auto [start, depth_step] = best_of_planes(layers, depths, measure, progress);
  const PatternSearch search(layers, depths, measure, progress);
  InteriorPeak best = search.at(start);
  for (double size = 1; size > 1e-3;)
    if (!search.improve(best, {size * layers.grid().dx / 2, size * layers.grid().dy / 2, size * depth_step})) size /= 2;
  return best;
}

} // namespace microslip
