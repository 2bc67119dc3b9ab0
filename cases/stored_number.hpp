#pragma once

#include <string>

namespace microslip::cases {

/// A number of a result file.
struct StoredNumber {
  std::string path; ///< e.g. "hertz/a"
  double value;
  const char* unit;
  std::string description;
};

} // namespace microslip::cases
