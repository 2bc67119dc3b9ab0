#pragma once

#include "io/csv_text.hpp"

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

} // namespace microslip::io
