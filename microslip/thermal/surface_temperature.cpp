#include "microslip/thermal/surface_temperature.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace microslip {
namespace {

void check(const char* name, const ThermalBody& body) {
  const auto field = [&](const char* member) { return std::string(name) + "." + member; };
  require_finite(field("bulk_temperature"), body.bulk_temperature, "deg C");
  require_positive(field("conductivity"), body.conductivity, "W/(m K)");
  require_positive(field("density"), body.density, "kg/m^3");
  require_positive(field("heat_capacity"), body.heat_capacity, "J/(kg K)");
}

/// The path of particles through a row, from element to element.
class ThermalRow {
public:
  ThermalRow(int elements, double dx, double rolling_speed, const ThermalBodies& bodies)
      : n_(elements), flash_(elements, dx, rolling_speed, bodies), t1_(bodies.body1.bulk_temperature),
        t2_(bodies.body2.bulk_temperature), touches_(n_), heat_(n_) {
    const double beta1 = bodies.body1.effusivity(), beta2 = bodies.body2.effusivity();
    share1_ = beta1 / (beta1 + beta2);
    share2_ = beta2 / (beta1 + beta2);
  }

  void set(int i, bool touches, double heat) {
    touches_[i] = touches;
    heat_[i] = touches ? heat : 0;
  }

  void solve() {
    first_ = static_cast<int>(std::find(touches_.begin(), touches_.end(), 1) - touches_.begin());
    last_ = static_cast<int>(std::find(touches_.begin() + first_, touches_.end(), 0) - touches_.begin());
    exchange_.assign(n_, 0);
    temperature1_.assign(n_, t1_);
    temperature2_.assign(n_, t2_);
    for (int i = first_; i < n_; ++i) {
      const double difference = difference_at(i), rise = flash_.rise(heat_, i);
      // Elements that touch again behind a gap exchange what makes the bodies equal.
      if (touches_[i] && i >= last_) exchange_[i] = difference / flash_.rise(0);
      const double left = touches_[i] ? 0 : difference;
      temperature1_[i] = flash_.mean() - share2_ * left + rise;
      temperature2_[i] = flash_.mean() + share1_ * left + rise;
    }
  }

  double temperature1(int i) const { return temperature1_[i]; }
  double temperature2(int i) const { return temperature2_[i]; }

private:
  /// T2 - T1 (T3) at element i as the first interval of contact and all exchange behind it leave it: what is left of
  /// the bulk temperatures' difference behind an interval is 1 - (2/pi) asin sqrt(its length over the distance since
  /// its beginning).
  double difference_at(int i) const {
    if (i < last_) return 0;
    const double share = static_cast<double>(last_ - first_) / (i - first_ + 0.5);
    return (t2_ - t1_) * (1 - 2 / std::numbers::pi * std::asin(std::sqrt(share))) - flash_.rise(exchange_, i);
  }

  int n_, first_ = 0, last_ = 0; ///< the first interval of contact
  FlashTemperature flash_;
  double t1_, t2_, share1_ = 0, share2_ = 0;
  std::vector<char> touches_;
  std::vector<double> heat_;
  std::vector<double>
      exchange_; ///< behind the first interval, from body 2 to body 1, times sum^2/(beta1 beta2) [W/m^2]
  std::vector<double> temperature1_, temperature2_;
};

} // namespace

double ThermalBody::effusivity() const {
  return std::sqrt(conductivity * density * heat_capacity);
}

void check(const ThermalBodies& bodies) {
  check("body1", bodies.body1);
  check("body2", bodies.body2);
}

FlashTemperature::FlashTemperature(int elements, double dx, double rolling_speed, const ThermalBodies& bodies) {
  const auto& [body1, body2] = bodies;
  const double beta1 = body1.effusivity(), beta2 = body2.effusivity(), sum = beta1 + beta2;
  const double per_heat = 1 / (sum * std::sqrt(std::numbers::pi * rolling_speed));
  mean_ = (beta1 * body1.bulk_temperature + beta2 * body2.bulk_temperature) / sum;
  for (int k = 0; k < elements; ++k)
    rise_.push_back(2 * per_heat * (std::sqrt((k + 0.5) * dx) - std::sqrt(std::max(k - 0.5, 0.0) * dx)));
}

double FlashTemperature::rise(std::span<const double> heat, int i) const {
  double sum = 0;
  const int count = std::min(i + 1, static_cast<int>(heat.size()));
  for (int k = 0; k < count; ++k) sum += heat[static_cast<std::size_t>(k)] * rise(i - k);
  return sum;
}

SurfaceTemperature surface_temperature(const ElementGrid& grid, RollingDirection direction, double rolling_speed,
                                       const ThermalBodies& bodies, std::span<const double> pressure,
                                       std::span<const double> heat) {
  check(grid);
  check(bodies);
  require_positive("rolling_speed", rolling_speed, "m/s");
  if (pressure.size() != grid.count() || heat.size() != grid.count())
    throw Error("pressure, heat: must have mx times my = " + std::to_string(grid.count()) + " values");
  SurfaceTemperature result;
  result.highest = -std::numeric_limits<double>::infinity();
  result.body1.resize(grid.count());
  result.body2.resize(grid.count());
  ThermalRow row(grid.mx, grid.dx, rolling_speed, bodies);
  for (int j = 0; j < grid.my; ++j) {
    const auto element = [&](int i) {
      return static_cast<std::size_t>(j) * grid.mx + (direction == RollingDirection::forward ? grid.mx - 1 - i : i);
    };
    for (int i = 0; i < grid.mx; ++i) row.set(i, pressure[element(i)] > 0, heat[element(i)]);
    row.solve();
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = element(i);
      result.body1[k] = row.temperature1(i);
      result.body2[k] = row.temperature2(i);
      if (pressure[k] > 0) result.highest = std::max(result.highest, result.body1[k]);
    }
  }
  return result;
}

} // namespace microslip
