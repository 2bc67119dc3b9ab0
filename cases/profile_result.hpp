#pragma once

#include "io/json.hpp"
#include "io/result_writer.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"

#include <optional>

namespace microslip::cases {

/// Results of `microslip profile` for a profile.
struct ProfileFindings {
  PreparedProfile prepared;
  std::optional<WheelDimensions> wheel;
  std::optional<GaugePoint> gauge;
  double gauge_height = 0; ///< at which that was looked for [m]
};

/// Heights [m] at which profiles are measured.
struct ProfileMeasures {
  std::optional<double> tape_line = {}; ///< y of a wheel's; none: 70 mm from the flange's back
  double gauge_height = 0.014;          ///< of a rail's gauge point below its top
};

/// Throws Error for a tape line or a height that the profile does not have.
ProfileFindings find_dimensions(PreparedProfile prepared, const ProfileMeasures& measures = {});

/// The findings as members of a JSON object: format, role, dimensions, kinks, what was done to the points, `units`.
io::Json profile_document(const ProfileFindings& findings);

/// The points, the curve, kinks and dimensions.
void write_result(const ProfileFindings& findings, io::ResultWriter& file);

} // namespace microslip::cases
