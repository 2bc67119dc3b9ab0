#include "microslip/railway/rows/equivalent_contact.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {

/// A round wheel on a prismatic rail, with its rows.
struct EquivalentContact::Round {
  WheelRailBodies bodies;
  std::optional<EquivalentRail> equivalent;
  RowContact rows;

  Round(const WheelRailBodies& given, const WheelRailMethod& method, const NominalPlacement& nominal)
      : bodies(given), rows(bodies, method, nominal) {}
  Round(const WheelRailBodies& given, const WheelRailMethod& method, const NominalPlacement& nominal,
        EquivalentRail rail)
      : bodies(given), equivalent(std::move(rail)), rows(with_profiles(), method, nominal, &*equivalent) {}

private:
  const WheelRailBodies& with_profiles() {
    bodies.rail = equivalent->rail(), bodies.wheel = equivalent->wheel();
    return bodies;
  }
};

EquivalentContact::EquivalentContact(const WheelRailBodies& bodies, const WheelRailMethod& method,
                                     const NominalPlacement& nominal)
    : given_(bodies), method_(method), nominal_(nominal),
      varies_(bodies.rail_surface || bodies.wheel_surface || bodies.track.roller_radius != 0),
      round_(std::make_unique<Round>(bodies, method, nominal)) {}
EquivalentContact::~EquivalentContact() = default;

RowContact& EquivalentContact::rows() {
  return round_->rows;
}
const WheelRailBodies& EquivalentContact::bodies() const {
  return round_->bodies;
}

bool EquivalentContact::move_to(const WheelState<double>& state, bool where_it_touches) {
  if (!varies_) return true;
  std::optional<EquivalentRail> rail = equivalent_rail(state, where_it_touches);
  if (!rail) return false;
  round_ = std::make_unique<Round>(given_, method_, nominal_, std::move(*rail));
  return true;
}

std::optional<EquivalentRail> EquivalentContact::equivalent_rail(const WheelState<double>& given,
                                                                 bool where_it_touches) const {
  constexpr int most_descents = 2;  // the second one from where the first one has found it nearly
  constexpr double searched = 3e-4; // [m]
  const TrueSurfaces surfaces{{&given_.rail, given_.rail_surface.get()}, {&given_.wheel, given_.wheel_surface.get()}};
  WheelState<double> state = given;
  for (int descents = where_it_touches ? most_descents : 0;; --descents) {
    const WheelPlacement<double> placement = place(nominal_, state);
    std::optional<EquivalentRail> rail;
    try {
      rail.emplace(surfaces, placement);
    } catch (const Error&) { // interrupted
      return {};
    }
    if (descents == 0) return rail;
    double clearance = std::numeric_limits<double>::infinity();
    ContactSearch search(rail->rail(), rail->wheel());
    for (const ContactPoint& point : search.find(placement, searched)) clearance = std::min(clearance, point.gap);
    if (!std::isfinite(clearance)) return rail;
    state.vertical -= clearance;
  }
}

} // namespace microslip
