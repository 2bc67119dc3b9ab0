#pragma once

#include "io/json.hpp"

#include <filesystem>

namespace microslip::io {

/// Contents of a result file, except its fields, as a JSON object: groups are objects and datasets numbers, texts or
/// arrays of the same names; text attributes of the root and of groups are members beside them. `units` has the unit of
/// every dataset by its path, e.g. `"exact/fx": "N"`. Left out: datasets of more than one dimension and all of the
/// groups `fields`, `elements`, `interior`, `profiles` and `outlines`, which have a value for each cell or point. Error
/// if the file cannot be read.
Json result_json(const std::filesystem::path& result_file);

} // namespace microslip::io
