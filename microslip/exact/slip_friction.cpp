#include "microslip/exact/slip_friction.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace microslip {

SlipFriction::SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
                           const InterfaceLayer& layer, Passage passage)
    : grid_(grid), laws_(laws.begin(), laws.end()), memory_(memory), layer_(layer), passage_(std::move(passage)) {
  if (laws_.size() != 1 && laws_.size() != static_cast<std::size_t>(grid.my))
    throw Error("friction: must have one law or one for each of the " + std::to_string(grid.my) + " rows");
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("friction_memory.distance", memory.distance, "m", 0, largest);
  require_between("friction_memory.slowest", memory.slowest, "m/s", 0, largest);
  check(layer);
}

bool SlipFriction::is_constant() const {
  return std::all_of(laws_.begin(), laws_.end(),
                     [](const FrictionLaw& law) { return law.kind() == FrictionLaw::Kind::coulomb; });
}

std::vector<double> SlipFriction::static_coefficients() const {
  std::vector<double> mu;
  mu.reserve(grid_.count());
  for (int j = 0; j < grid_.my; ++j) mu.insert(mu.end(), static_cast<std::size_t>(grid_.mx), law(j).static_coefficient());
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

std::vector<double> SlipFriction::coefficients(std::span<const double> slip_velocity) const {
  std::vector<double> mu = static_coefficients();
  if (is_constant()) return mu;
  double before = 0;
  for_particles([&](int row, std::size_t k, bool first) {
    const FrictionLaw& of_row = law(row);
    if (first) before = of_row.static_coefficient();
    if (!passage_.along_rows && !passage_.before.empty()) before = passage_.before[k];
    const double s = slip_velocity[k], way = passage_.time * std::max(s, memory_.slowest);
    const double theta = memory_.distance > 0 ? memory_.distance / (memory_.distance + way) : 0;
    mu[k] = theta * before + (1 - theta) * of_row.coefficient(s);
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
