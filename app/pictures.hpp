#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::app {

/// Pictures of a result file.
struct Pictures {
  std::vector<std::string> files = {}; ///< names, in the order they were drawn
  std::string problem = {}; ///< one line on why there are none or not all, and what helps; empty if all is well
};

/// Draws pictures of an HDF5 result file with the Python package microslip.plot and any arguments of it, the file's
/// name first. Python is what the environment variable MICROSLIP_PYTHON names, or the one found at build time. Never
/// throws for what Python lacks.
Pictures draw_pictures(const std::vector<std::string>& arguments);
/// All that a file has, into a folder: the names of those that could be drawn. Warns of a problem on standard error.
std::vector<std::string> draw_pictures(const std::filesystem::path& result_file, const std::filesystem::path& folder);

} // namespace microslip::app
