#include "campaign/table_lines.hpp"

#include "io/csv_line.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

namespace microslip::campaign {
namespace {

/// Place of the column with a name among the headings.
std::size_t place_of(const std::string& name, const std::vector<std::string_view>& headings) {
  std::vector<std::string_view> names(headings.size());
  std::transform(headings.begin(), headings.end(), names.begin(),
                 [](std::string_view heading) { return io::name_and_unit(heading).first; });
  if (name.empty() && names.size() == 1) return 0;
  if (name.empty()) throw Error("has " + std::to_string(names.size()) + " columns: column must name one");
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("has no column " + io::printable(name) + io::suggestion(name, names) +
                "; known: " + io::listed(names, "and"));
  return static_cast<std::size_t>(found - names.begin());
}

} // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file || std::filesystem::is_directory(path)) throw Error(path.string() + ": cannot be read");
  return text;
}

char separator_of(std::string_view text) {
  std::string_view line;
  while (!text.empty() && io::trimmed(line).empty()) line = io::take_line(text);
  return io::csv_separator(line);
}

void visit_lines(std::string_view text, const std::string& file,
                 const std::function<void(const std::vector<std::string_view>&, std::size_t)>& take) {
  std::size_t number = 0;
  io::CsvLine line(separator_of(text));
  while (!text.empty()) {
    const auto next = io::take_line(text);
    ++number;
    if (io::trimmed(next).empty()) continue;
    try {
      take(line.split(next), number);
    } catch (const Error& error) {
      throw Error(file + ":" + std::to_string(number) + ": " + error.what());
    }
  }
}

TableColumn read_column(std::string_view text, const std::string& file, const std::string& name) {
  text = io::csv_start(text, file);
  const char separator = separator_of(text);
  TableColumn column;
  std::optional<std::size_t> place;
  std::size_t headings = 0;
  visit_lines(text, file, [&](const std::vector<std::string_view>& fields, std::size_t) {
    if (!place) {
      place = place_of(name, fields), headings = fields.size();
      if (const auto unit = io::name_and_unit(fields[*place]).second; unit != "-") column.unit = unit;
      return;
    }
    io::require_fields(fields.size(), headings, separator);
    column.numbers.push_back(io::csv_number(name.empty() ? "value" : name, fields[*place], separator != ','));
  });
  if (column.numbers.empty()) throw Error(file + ": has no values: the first line must be headings");
  return column;
}

} // namespace microslip::campaign
