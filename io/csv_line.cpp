#include "io/csv_line.hpp"

#include "io/text_line.hpp"
#include "microslip/error.hpp"

#include <csv.h>

namespace microslip::io {

struct CsvLine::Parser {
  explicit Parser(char separator) {
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_delim(&parser, static_cast<unsigned char>(separator));
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser() { csv_free(&parser); }

  csv_parser parser{};
};

CsvLine::CsvLine(char separator) : parser_(std::make_unique<Parser>(separator)) {}
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
  if (length != line.size() || csv_fini(parser, add_field, nullptr, this) != 0) {
    // It still holds what it has read of the field, which would come before the next line's.
    parser_ = std::make_unique<Parser>(static_cast<char>(csv_get_delim(parser)));
    throw Error("a quote is not closed or inside a field");
  }
  fields_.clear();
  std::size_t begin = 0;
  for (const auto end : ends_) {
    fields_.push_back(trimmed(std::string_view(text_).substr(begin, end - begin)));
    begin = end;
  }
  return fields_;
}

} // namespace microslip::io
