#pragma once

#include "compat/contact/case.hpp"
#include "compat/contact/wheel_rail/rigid_slip.hpp"
#include "compat/contact/wheel_rail/undeformed_distance.hpp"
#include "compat/contact/wheel_rail/wheel_outcome.hpp"

namespace microslip::contact_program {

/// The set of friction data at a station, where sets differ with the inclination or along the track: straight lines
/// between them, and the outer ones beyond.
std::vector<double> friction_at(const FrictionData& friction, double station);

PatchLocation locate(const PatchFrame& frame, const Placement& placement);

/// A patch as a case of module 3 with the approach and creepages given; `c` is the wheel's. Points inside are left to
/// those who want them.
Case patch_case(const Case& c, const PatchFrame& frame, const UndeformedDistance& distance, const PatchMotion& motion,
                const PatchLocation& location);

} // namespace microslip::contact_program
