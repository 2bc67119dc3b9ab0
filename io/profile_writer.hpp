#pragma once

#include "io/profile_file.hpp"

#include <filesystem>
#include <string>

namespace microslip::io {

/// The points of a profile as the text of a file, in mm: Simpack with z down, MiniProf with x to the gauge side for
/// rails, to the field side for wheels and y down, columns in the profile's axes. Numbers read back to 1e-16 m.
/// Line ends in the comment of its report, and quotes where the format has them, become blanks.
std::string profile_text(const PreparedProfile& profile, ProfileFormat format);

/// The format of a file by its ending: .prr, .prw, .ban and .whl, columns for others. Throws Error for the ending of
/// the other role.
ProfileFormat format_of_ending(const std::filesystem::path& path, ProfileRole role);

} // namespace microslip::io
