#include "io/receptance_file.hpp"

#include "io/csv_line.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

struct Column {
  std::string_view name, unit;
};
constexpr std::array<Column, 3> columns = {
    {{"frequency", "Hz"}, {"receptance_real", "m/N"}, {"receptance_imaginary", "m/N"}}};

std::string label_of(const Column& column) {
  return "column " + std::string(column.name);
}

/// Where the columns are.
class Header {
public:
  explicit Header(std::string_view line) : separator_(csv_separator(line)) {
    CsvLine splitter(separator_);
    const auto& fields = splitter.split(line);
    fields_ = fields.size();
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto is_it = [&](std::string_view field) { return name_and_unit(field).first == columns[k].name; };
      const auto found = std::find_if(fields.begin(), fields.end(), is_it);
      if (found == fields.end()) throw Error("must have a " + label_of(columns[k]));
      if (std::any_of(found + 1, fields.end(), is_it)) throw Error(label_of(columns[k]) + ": is there twice");
      position_[k] = static_cast<std::size_t>(found - fields.begin());
      if (const auto unit = name_and_unit(*found).second; !unit.empty() && unit != columns[k].unit)
        throw Error(label_of(columns[k]) + ": must be in " + std::string(columns[k].unit));
    }
  }

  char separator() const { return separator_; }
  std::array<double, columns.size()> numbers(const std::vector<std::string_view>& fields) const {
    if (fields.size() != fields_)
      throw Error(std::to_string(fields.size()) + " fields, not " + std::to_string(fields_));
    std::array<double, columns.size()> out{};
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = csv_number(label_of(columns[k]), fields[position_[k]], separator_ != ',');
    return out;
  }

private:
  char separator_;
  std::size_t fields_ = 0;
  std::array<std::size_t, columns.size()> position_{};
};

} // namespace

Receptance read_receptance(std::string_view text, const std::string& name) {
  std::vector<double> frequencies;
  std::vector<std::complex<double>> values;
  std::optional<Header> header;
  std::optional<CsvLine> splitter;
  read_csv_lines(text, name, [&](std::string_view line) {
    if (header) {
      const auto [frequency, real, imaginary] = header->numbers(splitter->split(line));
      if (frequency < 0 || (!frequencies.empty() && !(frequency > frequencies.back())))
        throw Error(label_of(columns[0]) + ": must ascend from 0 on");
      frequencies.push_back(frequency), values.emplace_back(real, imaginary);
    } else {
      header.emplace(line);
      splitter.emplace(header->separator());
    }
  });
  try {
    return {std::move(frequencies), std::move(values)};
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

} // namespace microslip::io
