#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace microslip::io {

/// Input as read under a key: numbers in their unit; whole ones and texts have none.
struct ReadInput {
  using Value = std::variant<double, std::string, std::vector<double>, std::vector<std::string>>;
  Value value;
  std::string unit = {};
  bool is_given = false; ///< else it is the default of a key that the file leaves out
};

/// Inputs by the full names of keys: "load.normal_force".
using ReadInputs = std::map<std::string, ReadInput, std::less<>>;

} // namespace microslip::io
