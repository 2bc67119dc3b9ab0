#include "validation/models/exactly_rolled.hpp"

#include "microslip/exact/fitted/patch_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace microslip::validation {
namespace {

/// The mean over elements of length dx of a semi-elliptic pressure with the load of the strip.
void add_pressures(const Strip& strip, const ElementGrid& grid, std::vector<double>& pressure) {
  const auto part = [&](double x) { // of the load, below x
    const double t = std::clamp(x / strip.half_length, -1.0, 1.0);
    return (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
  };
  for (int i = 0; i < grid.mx; ++i) {
    const double x = grid.x(i), load = strip.load * (part(x + grid.dx / 2) - part(x - grid.dx / 2));
    pressure.push_back(load / grid.element_area());
  }
}

} // namespace

std::optional<Vec2> exactly_rolled(const NormalPatch& patch, const CombinedMaterial& material, const Creepage& creepage,
                                   double friction, int elements) {
  constexpr int margin = 4;
  const NormalPatch rows = patch.with_rows(elements);
  if (rows.strips.empty()) return {};
  const double dx = rows.length() / elements;
  const int half = elements / 2 + margin;
  const ElementGrid grid{.mx = 2 * half + 1,
                         .my = int(rows.strips.size()),
                         .x0 = -half * dx,
                         .y0 = rows.strips.front().y,
                         .dx = dx,
                         .dy = rows.strips.front().width};
  NormalSolution normal;
  for (const Strip& strip : rows.strips) add_pressures(strip, grid, normal.pressure);
  normal.normal_force = rows.force();
  normal.gap.assign(normal.pressure.size(), 0), normal.displacement = normal.gap;
  normal.contact_elements =
      int(std::count_if(normal.pressure.begin(), normal.pressure.end(), [](double p) { return p > 0; }));
  PatchRolling rolling(material, grid, std::move(normal));
  PatchRollingMotion motion;
  motion.friction = friction, motion.creepage = creepage;
  const ContactSolution solution = rolling.solve(motion);
  if (solution.report.status != Status::ok) return {};
  return Vec2{solution.totals.fx, solution.totals.fy};
}

} // namespace microslip::validation
