#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace microslip::io {

/// A text attribute of the root of a result file; none if there is no such file or attribute.
std::optional<std::string> result_attribute(const std::filesystem::path& result_file, const std::string& name);

} // namespace microslip::io
