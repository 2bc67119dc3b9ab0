#pragma once

#include "io/profile_file.hpp"

#include <filesystem>

namespace microslip::app {

struct SlicesArguments {
  std::filesystem::path file;
  io::ProfileFileOptions options;
  std::filesystem::path folder; ///< of result.h5 and its picture; empty: none are written
  bool no_pictures = false, json = false;
};

/// Reads and checks a file of slices with the profiles it names, prints what it holds, as a table or as JSON, and
/// writes its surface.
void show_slices(const SlicesArguments& arguments);

} // namespace microslip::app
