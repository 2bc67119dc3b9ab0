#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Lines of a TOML file, from 1 on, where its values stand, by their paths: "load.normal_force",
/// "body2.layers.1.thickness". Throws Error for text that is no TOML; `name` is the file's name for messages.
std::map<std::string, int, std::less<>> value_lines(std::string_view text, const std::string& name);

/// A case file or that of a sweep, and the files that it names: profiles, slices with theirs, a creep-force table, a
/// case, a list. Any text in it that is the name of a file, from its folder on, counts; each file once. Throws Error if
/// it cannot be read.
std::vector<std::filesystem::path> files_of_case(const std::filesystem::path& file);

/// Returns whether a text is that of a sweep: it has one of the tables grid, list and sample.
bool is_sweep(std::string_view text, const std::string& name);

} // namespace microslip::io
