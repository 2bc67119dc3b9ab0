#include "io/csv_line.hpp"

#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "microslip/error.hpp"

#include <charconv>

#include <csv.h>

namespace microslip {

struct CsvLine::Parser {
  Parser() { csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser() { csv_free(&parser); }

  csv_parser parser{};
};

CsvLine::CsvLine() : parser_(std::make_unique<Parser>()) {}
CsvLine::~CsvLine() = default;

const std::vector<std::string_view>& CsvLine::split(std::string_view line) {
  // The parser would take it for the end of a row.
  if (line.find('\r') != std::string_view::npos) throw Error("a carriage return inside a line");
  text_.clear();
  ends_.clear();
  const auto add_field = [](void* bytes, std::size_t size, void* self) {
    auto& splitter = *static_cast<CsvLine*>(self);
    splitter.text_.append(static_cast<const char*>(bytes), size);
    splitter.ends_.push_back(splitter.text_.size());
  };
  csv_parser* const parser = &parser_->parser;
  const auto length = csv_parse(parser, line.data(), line.size(), add_field, nullptr, this);
  if (length != line.size() || csv_fini(parser, add_field, nullptr, this) != 0)
    throw Error("a quote is not closed or inside a field");
  fields_.clear();
  std::size_t begin = 0;
  for (const auto end : ends_) {
    fields_.push_back(trimmed(std::string_view(text_).substr(begin, end - begin)));
    begin = end;
  }
  return fields_;
}

double csv_number(std::string_view label, std::string_view field) {
  const auto fail = [&](const std::string& what) { throw Error(std::string(label) + ": " + what); };
  if (field.empty()) fail("there is nothing");
  const auto digits = field.front() == '+' ? field.substr(1) : field;
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) fail(printable(field) + " is too large or too small");
  if (error != std::errc() || stop != end || digits.front() == '+') fail(printable(field) + " is not a number");
  return value;
}

} // namespace microslip
