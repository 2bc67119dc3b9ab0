#pragma once

#include "microslip/vec2.hpp"
#include "validation/report.hpp"

#include <array>
#include <string>
#include <vector>

namespace microslip::validation {

/// The horizontal force on a wheel by CONTACT and by our theories, each of which differs from the one before by one
/// rule.
struct ManchesterForces {
  std::string name; ///< side and lateral displacement
  double capacity;  ///< mu Fn [N]
  Vec2 contact;     ///< CONTACT's [N]
  Vec2 planes;      ///< the exact theory on planes: other elements, a gap without interpolation, one patch or two
  Vec2 surface;     ///< on the true surfaces
  Vec2 table;       ///< rows for the normal problem
  Vec2 fastsim2;    ///< and FASTSIM2 for the tangential one

  static constexpr std::array steps = {"elements, gap, patches", "planes or surfaces", "normal problem by rows",
                                       "FASTSIM2"};
  /// By how much each rule changes the force, over mu Fn.
  std::array<double, 4> changes() const;
  double difference() const; ///< of `fastsim2` from CONTACT, the larger component over mu Fn
};

/// For the states where `fastsim2` is further than 0.005 of mu Fn from CONTACT: what each rule has to do with that.
void report_steps(Report& report, const std::vector<ManchesterForces>& all);

} // namespace microslip::validation
