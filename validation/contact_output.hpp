#pragma once

#include <istream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace microslip::validation {

/// A number as the program CONTACT printed it.
struct PrintedNumber {
  double value = 0;
  double rounding = 0; ///< half a unit of its last digit
};

/// None if the text is not a number.
std::optional<PrintedNumber> printed_number(const std::string& text);

/// Numbers by the names that stand above them.
using PrintedNumbers = std::map<std::string, PrintedNumber>;

/// Contents of CONTACT's output file for a case.
struct PrintedCase {
  std::string label; ///< "Case 3", with result elements "Case 3, result element 2"
  int number = 0;
  PrintedNumbers totals = {}; ///< of module 3, or of all of a wheel's patches
  std::vector<PrintedNumbers> patches = {};
};

/// All cases of an output file, in its order.
std::vector<PrintedCase> read_contact_output(std::istream& in);

} // namespace microslip::validation
