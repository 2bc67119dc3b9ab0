#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace microslip::io {

/// A JSON value whose members keep the order in which they are added.
using Json = nlohmann::ordered_json;

/// A number; JSON knows only finite ones, so others are the words "inf", "-inf" and "nan".
Json json_number(double value);

/// Its text, indented by two blanks, with a newline at the end. Numbers read back as the same; bytes that are not UTF-8
/// become U+FFFD.
std::string json_text(const Json& value);

} // namespace microslip::io
