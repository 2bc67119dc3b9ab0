#pragma once

#include "io/result_writer.hpp"
#include "microslip/railway/profile/profile_surface.hpp"

#include <span>

namespace microslip::cases {

/// The surface of a profile that varies: y and z of lines of equal v at stations along u [m], of wheels [rad], some
/// between two slices; no numbers where it is interrupted.
void write_result(const ProfileSurface& surface, ProfileRole role, std::span<const double> slices,
                  io::ResultWriter& file);

} // namespace microslip::cases
