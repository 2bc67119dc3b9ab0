#include "microslip/exact/halfspace/leading_edge.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

/// Distance from the centre of the leading element, column i, to the edge of row j [m]. An element may be in contact
/// whose centre is just outside the true edge.
double distance_to_edge(const ElementGrid& grid, const LeadingEdge& edge, double direction, int i, int j) {
  if (edge.true_edge.empty()) return edge.theta * grid.dx;
  const double distance = (edge.true_edge[j] - grid.x(i)) * direction;
  if (!(std::abs(distance) <= 2 * grid.dx))
    throw Error("true_edge[" + std::to_string(j) + "]", edge.true_edge[j], "m",
                "within two elements of the leading element's centre");
  return std::max(distance, 0.0);
}

} // namespace

std::vector<EnteringElement> entering_elements(const ElementGrid& grid, std::span<const double> bound, double step,
                                               const LeadingEdge& edge) {
  require_between("leading_edge.theta", edge.theta, "-", 0, 1);
  if (!edge.true_edge.empty() && edge.true_edge.size() != static_cast<std::size_t>(grid.my))
    throw Error("leading_edge.true_edge: must have a value for each of the " + std::to_string(grid.my) + " rows");
  const int ahead = step > 0 ? 1 : -1;
  std::vector<EnteringElement> entering;
  for (int j = 0; j < grid.my; ++j) {
    const auto at = [&](int i) { return static_cast<std::size_t>(j) * grid.mx + i; };
    const auto in_contact = [&](int i) { return i >= 0 && i < grid.mx && bound[at(i)] > 0; };
    for (int lead = 0; lead < grid.mx; ++lead) {
      if (!in_contact(lead) || in_contact(lead + ahead)) continue;
      const bool has_room = lead + 2 * ahead >= 0 && lead + 2 * ahead < grid.mx;
      if (!has_room && edge.where_possible) continue;
      if (!has_room) throw Error("grid: the leading edge's correction needs two elements ahead of the contact");
      const double distance = distance_to_edge(grid, edge, ahead, lead, j);
      for (int i = lead; in_contact(i); i -= ahead) {
        const double share = (distance + std::abs(i - lead) * grid.dx) / std::abs(step);
        if (share >= 1) break;
        entering.push_back({at(i), share, at(lead + ahead), at(lead + 2 * ahead), 1 - distance / grid.dx});
      }
    }
  }
  return entering;
}

LeadingEdgeOperator::LeadingEdgeOperator(SlipOperator& difference, SlipOperator& displacement, double step,
                                         std::vector<EnteringElement> entering)
    : difference_(difference), displacement_(displacement), length_(std::abs(step)), entering_(std::move(entering)) {}

void LeadingEdgeOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                                std::span<double> sy) {
  ux_.resize(px.size()), uy_.resize(py.size());
  difference_.apply(px, py, sx, sy);
  displacement_.apply(px, py, ux_, uy_);
  for (const EnteringElement& e : entering_) {
    const auto since_edge = [&](const std::vector<double>& u) {
      return (u[e.element] - u[e.ahead] - e.extrapolation * (u[e.ahead] - u[e.further_ahead])) / length_;
    };
    sx[e.element] = since_edge(ux_);
    sy[e.element] = since_edge(uy_);
  }
}

} // namespace microslip
