#include "microslip/exact/classical/slip_friction.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace microslip {
namespace {

void require_for_rows(const char* field, std::size_t count, int rows) {
  if (count != 1 && count != static_cast<std::size_t>(rows))
    throw Error(std::string(field) + ": must have one law or one for each of the " + std::to_string(rows) + " rows");
}

/// The elements of a row as particles come through them, each warmed by the heat of those ahead and by its own.
class HeatedRow {
public:
  HeatedRow(const ElementGrid& grid, const FrictionHeating& heating)
      : flash_(grid.mx, grid.dx, heating.rolling_speed, heating.bodies) {}

  void begin() { heat_.clear(); }
  double mean_temperature() const { return flash_.mean(); }
  /// The coefficient of the next element, TemperatureEffect::coefficient; `power` is its heat for mu = 1 [W/m^2].
  double next(const TemperatureEffect& effect, double base, double share, double power) {
    const double ahead = flash_.mean() + flash_.rise(heat_, static_cast<int>(heat_.size()));
    const double mu = effect.coefficient(base, share, ahead, flash_.rise(0) * power);
    heat_.push_back(mu * power);
    return mu;
  }

private:
  FlashTemperature flash_;
  std::vector<double> heat_;
};

} // namespace

SlipFriction::SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
                           const InterfaceLayer& layer, Passage passage, std::optional<FrictionHeating> heating)
    : grid_(grid), laws_(laws.begin(), laws.end()), memory_(memory), layer_(layer), passage_(std::move(passage)),
      heating_(std::move(heating)) {
  require_for_rows("friction", laws_.size(), grid.my);
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("friction_memory.distance", memory.distance, "m", 0, largest);
  require_between("friction_memory.slowest", memory.slowest, "m/s", 0, largest);
  check(layer);
  if (!heating_) return;
  require_for_rows("temperature_effect", heating_->effects.size(), grid.my);
  require_positive("rolling_speed", heating_->rolling_speed, "m/s");
  check(heating_->bodies);
  for (int j = 0; j < grid.my; ++j) {
    check(effect(j));
    require_between("temperature_effect.change", effect(j).change, "-", -law(j).kinetic_coefficient(),
                    FrictionLaw::largest_coefficient - law(j).static_coefficient());
  }
}

bool SlipFriction::is_constant() const {
  if (heating_) return false;
  return std::all_of(laws_.begin(), laws_.end(),
                     [](const FrictionLaw& law) { return law.kind() == FrictionLaw::Kind::coulomb; });
}

std::vector<double> SlipFriction::static_coefficients() const {
  std::vector<double> mu;
  mu.reserve(grid_.count());
  for (int j = 0; j < grid_.my; ++j)
    mu.insert(mu.end(), static_cast<std::size_t>(grid_.mx), law(j).static_coefficient());
  return mu;
}

/// Calls at(row, element, first in its row) in the order in which particles come through.
template <class At> void SlipFriction::for_particles(At at) const {
  for (int j = 0; j < grid_.my; ++j)
    for (int n = 0; n < grid_.mx; ++n) {
      const int i = passage_.from_high_x ? grid_.mx - 1 - n : n;
      at(j, static_cast<std::size_t>(j) * grid_.mx + i, n == 0);
    }
}

std::vector<double> SlipFriction::coefficients(std::span<const double> slip_velocity,
                                               std::span<const double> pressure) const {
  std::vector<double> mu = static_coefficients();
  if (is_constant()) return mu;
  std::optional<HeatedRow> heated;
  if (heating_) heated.emplace(grid_, *heating_);
  double before = 0;
  for_particles([&](int row, std::size_t k, bool first) {
    const FrictionLaw& of_row = law(row);
    if (first) {
      before = of_row.static_coefficient();
      if (heated) {
        heated->begin();
        before += effect(row).at(heated->mean_temperature());
      }
    }
    if (!passage_.along_rows && !passage_.before.empty()) before = passage_.before[k];
    const double s = slip_velocity[k], way = passage_.time * std::max(s, memory_.slowest);
    const double theta = memory_.distance > 0 ? memory_.distance / (memory_.distance + way) : 0;
    mu[k] = theta * before + (1 - theta) * of_row.coefficient(s);
    if (heated) mu[k] = heated->next(effect(row), mu[k], 1 - theta, pressure[k] * s);
    if (passage_.along_rows) before = mu[k];
  });
  return mu;
}

std::vector<double> SlipFriction::plastic_deformation(std::span<const double> slip_velocity,
                                                      std::span<const char> yields) const {
  std::vector<double> deformation(grid_.count());
  double before = 0;
  for_particles([&](int, std::size_t k, bool first) {
    if (first) before = 0;
    if (!passage_.along_rows && !passage_.deformation_before.empty()) before = passage_.deformation_before[k];
    deformation[k] = before + (yields[k] ? passage_.time * slip_velocity[k] : 0);
    if (passage_.along_rows) before = deformation[k];
  });
  return deformation;
}

void SlipFriction::limit(std::span<double> friction, std::span<const double> pressure,
                         std::span<const double> deformation, std::span<char> yields) const {
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const double stress = layer_.yield_stress_after(deformation[k]);
    yields[k] = pressure[k] > 0 && stress < friction[k] * pressure[k];
    if (yields[k]) friction[k] = stress / pressure[k];
  }
}

} // namespace microslip
