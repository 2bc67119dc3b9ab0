#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace microslip::validation {

/// A number as the program CONTACT printed it.
struct PrintedNumber {
  double value = 0;
  double rounding = 0; ///< half a unit of its last digit
};

/// Numbers by the names that stand above them.
using PrintedNumbers = std::map<std::string, PrintedNumber>;

/// What CONTACT's output file has of a case of module 1.
struct PrintedWheel {
  PrintedNumbers totals;
  std::vector<PrintedNumbers> patches;
};

/// By number of the case. Empty if the file cannot be read.
std::map<int, PrintedWheel> read_contact_output(const std::filesystem::path& path);

} // namespace microslip::validation
