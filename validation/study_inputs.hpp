#pragma once

#include <filesystem>
#include <vector>

namespace microslip::validation {

/// The files of published results and of CONTACT's cases that the studies of this build read where they are there,
/// those of another folder of CONTACT's cases besides; sorted.
std::vector<std::filesystem::path> study_inputs(const std::filesystem::path& other_cases);

} // namespace microslip::validation
