#include "microslip/numerics/hankel_nodes.hpp"

#include "microslip/numerics/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr double panel_angle = 7, fade_middle = 66, fade_width = 11, fade_end = 132; // [rad]
constexpr int graded_panels = 18;                                                    // 4^-18 = 1e-11

std::vector<double> panel_ends(double width, double end) {
  std::vector<double> ends = {0};
  for (int k = graded_panels; k > 0; --k) ends.push_back(std::min(width, end) * std::exp2(-2 * k));
  const auto count = static_cast<int>(std::ceil(end / width));
  for (int k = 1; k <= count; ++k) ends.push_back(end * k / count);
  return ends;
}

} // namespace

std::vector<WaveNode> hankel_nodes(double r_min, double r_max, double k_max) {
  static const GaussLegendre rule(16);
  const double end = r_min * k_max > fade_end ? fade_end / r_min : k_max;
  const std::vector<double> ends = panel_ends(panel_angle / r_max, end);
  std::vector<WaveNode> nodes;
  for (std::size_t p = 1; p < ends.size(); ++p)
    for (std::size_t k = 0; k < rule.count(); ++k) {
      const double at = rule.node(k, ends[p - 1], ends[p]);
      const double fade = std::erfc((at * r_min - fade_middle) / fade_width) / 2;
      nodes.push_back({at, fade * rule.weight(k, ends[p - 1], ends[p])});
    }
  return nodes;
}

} // namespace microslip
