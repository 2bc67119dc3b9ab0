#pragma once

#include "validation/relative_forces.hpp"

#include <vector>

namespace microslip::validation {

/// One of 112 of the 3,220 cases with the forces that CONTACT computes.
struct Reference112 {
  EllipticContact contact;
  RelativeForces coarse; ///< on 31 x 31 elements
  RelativeForces limit;  ///< extrapolated from that and 63 x 63
};

/// All of them, from exact_theory_112.csv in the build's folder MICROSLIP_REFERENCE_DATA; none if the file is not
/// there. Throws Error for a line that cannot be read, and unless the creepages are those of our test set.
std::vector<Reference112> read_reference_112();

/// Text of a study that has no file to read.
inline constexpr const char* reference_112_skipped =
    "SKIPPED: the file exact_theory_112.csv is not in the folder MICROSLIP_REFERENCE_DATA of the build";

} // namespace microslip::validation
