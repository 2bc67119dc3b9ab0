#include "microslip/exact/classical/coupled_forecast.hpp"

#include "microslip/exact/halfspace/traction_shares.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

using Field = CoupledForecast::Field;

/// Centre and half-widths of a pressure: means of its coordinates and of the squares of their distances from it.
struct Place {
  double x, y, width_x, width_y;
};

Place place_of(const ElementGrid& grid, const Field& pressure) {
  double sum = 0, x = 0, y = 0, xx = 0, yy = 0;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const double p = pressure[k], at_x = grid.x(static_cast<int>(k % static_cast<std::size_t>(grid.mx))),
                 at_y = grid.y(static_cast<int>(k / static_cast<std::size_t>(grid.mx)));
    sum += p, x += p * at_x, y += p * at_y, xx += p * at_x * at_x, yy += p * at_y * at_y;
  }
  x /= sum, y /= sum;
  return {x, y, std::sqrt(std::max(0.0, xx / sum - x * x)), std::sqrt(std::max(0.0, yy / sum - y * y))};
}

bool is_anywhere(const Field& pressure) {
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p > 0; });
}

} // namespace

void CoupledForecast::remember(TangentialState solution, Field pressure_alone) {
  last_ = std::move(solution);
  pressure_alone_ = std::move(pressure_alone);
}

std::optional<TangentialState> CoupledForecast::next(const ElementGrid& grid, std::span<const double> friction,
                                                     const TangentialState& now, const Field& pressure_alone) const {
  if (pressure_alone_.size() != pressure_alone.size() || pressure_alone_ == pressure_alone ||
      last_.pressure != now.pressure || last_.traction.x != now.traction.x || !is_anywhere(pressure_alone_))
    return {};
  const Place before = place_of(grid, pressure_alone_), after = place_of(grid, pressure_alone);
  const auto stretch = [](double from, double to) { return from > 0 && to > 0 ? from / to : 1; };
  const double along = stretch(before.width_x, after.width_x), across = stretch(before.width_y, after.width_y);
  Field bound = now.pressure;
  for (std::size_t k = 0; k < bound.size(); ++k) bound[k] *= friction[k];
  const TractionShares of_pressure(grid, pressure_alone_, now.pressure, now.pressure),
      of_tractions(grid, bound, now.traction.x, now.traction.y);
  TangentialState out{.traction = VectorField(bound.size()), .pressure = Field(bound.size())};
  for (std::size_t k = 0; k < bound.size(); ++k) {
    if (!(pressure_alone[k] > 0)) continue;
    const double x = before.x + along * (grid.x(static_cast<int>(k % static_cast<std::size_t>(grid.mx))) - after.x),
                 y = before.y + across * (grid.y(static_cast<int>(k / static_cast<std::size_t>(grid.mx))) - after.y);
    const double pressure = pressure_alone[k] * of_pressure.at(x, y).x;
    const Vec2 share = of_tractions.at(x, y);
    out.pressure[k] = pressure;
    out.traction.x[k] = friction[k] * pressure * share.x;
    out.traction.y[k] = friction[k] * pressure * share.y;
  }
  return out;
}

} // namespace microslip
