#pragma once

#include "app/command.hpp"
#include "io/json.hpp"

#include <string>

namespace microslip::app {

/// Adds the flag --json to a command: one JSON document on standard output instead of text for people.
void add_json_flag(Command& command, bool& json);

/// The beginning of a command's document: `format`, the number of result files and documents, `kind`, this program's
/// `version`, `commit`, `compiler` and `build_type`, and `command_line`.
io::Json json_document(const std::string& kind);
/// Prints it.
void print_json(const io::Json& document);

} // namespace microslip::app
