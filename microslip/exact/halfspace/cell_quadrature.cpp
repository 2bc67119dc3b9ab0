#include "microslip/exact/halfspace/cell_quadrature.hpp"

#include <array>

namespace microslip {
namespace {

constexpr double forgotten = 40; // exp(-40) is below rounding

} // namespace

const GaussLegendre& rule_for(double size_over_scale, bool fading) {
  static const std::array<GaussLegendre, 3> even{GaussLegendre(6), GaussLegendre(4), GaussLegendre(3)};
  static const std::array<GaussLegendre, 3> with_fading{GaussLegendre(9), GaussLegendre(6), GaussLegendre(4)};
  return (fading ? with_fading : even)[size_over_scale > 0.33 ? 0 : size_over_scale > 0.1 ? 1 : 2];
}

std::vector<double> fading_weights(const GaussLegendre& rule, double width, double length) {
  static const GaussLegendre fine(24);
  const double end = std::min(width, forgotten * length);
  std::vector<double> weights(rule.count());
  for (std::size_t k = 0; k < fine.count(); ++k) {
    const double x = fine.node(k, 0, end), weight = fine.weight(k, 0, end) * std::exp(-x / length);
    for (std::size_t g = 0; g < rule.count(); ++g) {
      double basis = 1;
      for (std::size_t o = 0; o < rule.count(); ++o)
        if (o != g) basis *= (x - rule.node(o, 0, width)) / (rule.node(g, 0, width) - rule.node(o, 0, width));
      weights[g] += weight * basis;
    }
  }
  return weights;
}

std::vector<Cell> columns_beyond(double begin, double dx, const std::vector<double>& lengths) {
  std::vector<Cell> columns;
  if (lengths.empty()) return columns;
  const double end = begin + forgotten * *std::max_element(lengths.begin(), lengths.end());
  double x = begin;
  while (x < end) {
    columns.push_back({x, 0, std::max(dx, x / 2), 0});
    x += columns.back().width;
  }
  return columns;
}

} // namespace microslip
