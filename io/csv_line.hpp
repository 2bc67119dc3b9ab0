#pragma once

#include "io/csv_text.hpp"
#include "io/text_line.hpp"
#include "microslip/error.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Splits lines of CSV into their fields: quotes as in RFC 4180, blanks around fields taken away.
class CsvLine {
public:
  explicit CsvLine(char separator = ',');
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;
  ~CsvLine();

  /// The fields of a line; they are valid until the next call. Throws Error if they cannot be told apart.
  const std::vector<std::string_view>& split(std::string_view line);

private:
  struct Parser;

  std::unique_ptr<Parser> parser_;
  std::string text_;
  std::vector<std::size_t> ends_;
  std::vector<std::string_view> fields_;
};

/// Calls read(line) with each line of a table that is neither empty nor a comment; what that throws names the line.
template <class Read> void read_csv_lines(std::string_view text, const std::string& name, const Read& read) {
  text = csv_start(text, name);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto line = take_line(text);
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    try {
      read(line);
    } catch (const Error& error) {
      throw Error(name + ":" + std::to_string(number) + ": " + error.what());
    }
  }
}

} // namespace microslip::io
