#pragma once

#include "microslip/railway/rows/row_contact.hpp"

namespace microslip {

/// Limits of a wheel by its profiles, material and friction, before it runs.
struct WheelLimits {
  std::optional<double> nadal_limit; ///< of Y/Q where the flange is steepest [-]; empty without a flange
  std::optional<double> nose;        ///< flange_nose() [m]
  Warnings warnings;                 ///< of the bodies
};
WheelLimits limits_of(const WheelRailBodies& bodies, const RowContact& rows);

/// Adds to a left wheel's solution what its forces do to the surfaces and to its guidance, and what makes them
/// doubtful: damage of the patches, Y/Q and its limit, warnings, and the status that a decisive one has.
void assess(const WheelRailBodies& bodies, const WheelLimits& limits, PatchShape surface, WheelRailSolution& out);

} // namespace microslip
