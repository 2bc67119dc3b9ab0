#include "microslip/elasticity/bilinear_interior_influence.hpp"

#include "microslip/numerics/tanh_sinh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

struct Node {
  double at, weight;
};
using Rule = std::vector<Node>; ///< of a mean: weights with the sum 1

// Gauss-Legendre rules on [-1, 1], the positive nodes.
constexpr std::array<Node, 2> gauss4 = {
    {{0.33998104358485626480, 0.65214515486254614263}, {0.86113631159405257522, 0.34785484513745385737}}};
constexpr std::array<Node, 3> gauss6 = {{{0.23861918608319690863, 0.46791393457269104739},
                                         {0.66120938646626451366, 0.36076157304813860757},
                                         {0.93246951420315202781, 0.17132449237917034504}}};
constexpr std::array<Node, 6> gauss12 = {{{0.12523340851146891547, 0.24914704581340278500},
                                          {0.36783149899818019375, 0.23349253653835480876},
                                          {0.58731795428661744730, 0.20316742672306592175},
                                          {0.76990267419430468704, 0.16007832854334622633},
                                          {0.90411725637047485668, 0.10693932599531843096},
                                          {0.98156063424671925069, 0.04717533638651182719}}};

template <std::size_t N> Rule gauss(const std::array<Node, N>& nodes, double x, double side) {
  Rule rule;
  for (const Node& n : nodes)
    for (const int sign : {-1, 1}) rule.push_back({x + sign * n.at * side / 2, n.weight / 2});
  return rule;
}

/// Over x - side/2 to x + side/2, split at the edges -side/2, side/2.
Rule split_at_edges(double x, double side) {
  static const TanhSinh tanh_sinh;
  std::vector<double> breaks = {x - side / 2, x + side / 2};
  for (const double edge : {-side / 2, side / 2})
    if (edge > breaks[0] && edge < breaks[1]) breaks.push_back(edge);
  std::sort(breaks.begin(), breaks.end());
  Rule rule;
  for (std::size_t b = 1; b < breaks.size(); ++b)
    for (int k = 0; k < TanhSinh::count; ++k)
      rule.push_back(
          {tanh_sinh.node(k, breaks[b - 1], breaks[b]), tanh_sinh.weight(k, breaks[b - 1], breaks[b]) / side});
  return rule;
}

/// Mean over the side around x of what is singular at a distance from there.
Rule rule_for(double x, double side, double distance) {
  if (distance >= 8 * side) return gauss(gauss4, x, side);
  if (distance >= 2 * side) return gauss(gauss6, x, side);
  if (distance >= side / 2) return gauss(gauss12, x, side);
  return split_at_edges(x, side);
}

/// Gap between the points within a side from x and an element around 0.
double gap(double x, double side) {
  return std::max(0.0, std::abs(x) - side);
}

} // namespace

InteriorInfluence bilinear_interior_influence(const Material& material, Body body, double dx, double dy, double x,
                                              double y, double depth) {
  const double distance = std::hypot(gap(x, dx), gap(y, dy), depth);
  const Rule along_x = rule_for(x, dx, distance), along_y = rule_for(y, dy, distance);
  InteriorInfluence sum;
  for (const Node& v : along_y)
    for (const Node& u : along_x)
      add(sum, u.weight * v.weight, interior_influence(material, body, dx, dy, u.at, v.at, depth));
  return sum;
}

InteriorInfluence bilinear_line_interior_influence(const Material& material, Body body, double dx, double x,
                                                   double depth, double far) {
  InteriorInfluence sum;
  for (const Node& u : rule_for(x, dx, std::hypot(gap(x, dx), depth)))
    add(sum, u.weight, line_interior_influence(material, body, dx, u.at, depth, far));
  return sum;
}

} // namespace microslip
