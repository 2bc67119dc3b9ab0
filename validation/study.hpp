#pragma once

#include "microslip/progress.hpp"
#include "validation/report.hpp"

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

namespace microslip::validation {

struct StudyOptions {
  std::filesystem::path output = "results"; ///< folder for HDF5 files and pictures; created if it is not there
  int threads = 1;
  std::filesystem::path cases = {}; ///< of `contact`: folder of CONTACT's input files; empty: those beside the data
  bool thorough = false;            ///< minutes longer where a study samples what it could do in full
  Progress progress = {};           ///< when it asks to stop, the study writes nothing more and returns false
  std::vector<Figure>* figures = nullptr; ///< gets the figures that are printed, unless it is nullptr
};

/// Progress of a part of some work, which lasts from the fraction `begin` to `end` of the whole.
Progress part_of(const Progress& whole, double begin, double end);

/// Computed figures beside published ones.
struct Study {
  std::string_view name;
  std::string_view summary; ///< one line
  /// Prints the figures; true if all of them are as stated: met, or within a known limit. Throws Error if the output
  /// folder cannot be written.
  bool (*run)(const StudyOptions& options, std::ostream& out);
};

/// All studies, in the order of their names.
std::span<const Study> studies();

/// nullptr if there is none of that name.
const Study* find_study(std::string_view name);

} // namespace microslip::validation
