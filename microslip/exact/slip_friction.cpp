#include "microslip/exact/slip_friction.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace microslip {

SlipFriction::SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
                           Passage passage)
    : grid_(grid), laws_(laws.begin(), laws.end()), memory_(memory), passage_(std::move(passage)) {
  if (laws_.size() != 1 && laws_.size() != static_cast<std::size_t>(grid.my))
    throw Error("friction: must have one law or one for each of the " + std::to_string(grid.my) + " rows");
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("friction_memory.distance", memory.distance, "m", 0, largest);
  require_between("friction_memory.slowest", memory.slowest, "m/s", 0, largest);
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

std::vector<double> SlipFriction::coefficients(std::span<const double> slip_velocity) const {
  std::vector<double> mu = static_coefficients();
  if (is_constant()) return mu;
  for (int j = 0; j < grid_.my; ++j) {
    const FrictionLaw& of_row = law(j);
    double before = of_row.static_coefficient();
    for (int n = 0; n < grid_.mx; ++n) {
      const int i = passage_.from_high_x ? grid_.mx - 1 - n : n;
      const auto k = static_cast<std::size_t>(j) * grid_.mx + i;
      const double s = slip_velocity[k];
      if (!passage_.along_rows && !passage_.before.empty()) before = passage_.before[k];
      const double way = passage_.time * std::max(s, memory_.slowest);
      const double theta = memory_.distance > 0 ? memory_.distance / (memory_.distance + way) : 0;
      mu[k] = theta * before + (1 - theta) * of_row.coefficient(s);
      if (passage_.along_rows) before = mu[k];
    }
  }
  return mu;
}

} // namespace microslip
