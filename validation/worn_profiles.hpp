#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"

#include <string>
#include <vector>

namespace microslip::validation {

/// A wheel on a rail by name.
struct ProfilePair {
  std::string name;
  WheelRailBodies bodies; ///< the left side, straight track; friction is to be set
};

/// S1002 and 60E1 as they run: new; a wheel that is hollow by 3 mm; a rail whose head is worn flat by 1 mm; both of
/// these; both profiles with white noise of 10 um on points every 0.25 mm, smoothed with a wavelength of 3 mm. Made
/// from the profiles of the examples, the same with every standard library.
std::vector<ProfilePair> worn_pairs();

} // namespace microslip::validation
