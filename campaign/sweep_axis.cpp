#include "campaign/sweep_axis.hpp"

#include "campaign/table_lines.hpp"
#include "io/file_beside.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace microslip::campaign {
namespace {

bool begins_with_number(const toml::node& node) {
  double value = 0;
  const std::string_view text = node.value_or(std::string_view());
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

/// Takes a parameter that is there.
void read(const io::TomlSection& section, const char* key, double Distribution::*parameter, SweepAxis& axis) {
  if (section.is_text(key))
    axis.texts.push_back({parameter, section.required_text(key)});
  else
    axis.distribution.*parameter = section.number(key);
}

struct Parameter {
  const char* key;
  double Distribution::*value;
  bool is_needed;
};

std::vector<Parameter> parameters_of(Distribution::Kind kind) {
  const bool has_ends = kind == Distribution::Kind::uniform || kind == Distribution::Kind::triangular;
  std::vector<Parameter> all = {{"from", &Distribution::from, has_ends}, {"to", &Distribution::to, has_ends}};
  if (kind == Distribution::Kind::triangular) all.push_back({"mode", &Distribution::mode, true});
  if (has_ends) return all;
  all.push_back({"mean", &Distribution::mean, true});
  all.push_back({"standard_deviation", &Distribution::standard_deviation, true});
  return all;
}

/// The values of a table in ascending order, as texts in the unit of their heading, if it has one.
SweepAxis values_of(const io::TomlSection& section, SweepAxis axis) {
  const auto path = io::file_beside(std::filesystem::path(section.file()).parent_path(), section.required_text("file"));
  TableColumn column;
  section.at("file", [&] {
    axis.table = read_text(path);
    column = read_column(axis.table, path.string(), section.text("column", ""));
  });
  std::sort(column.numbers.begin(), column.numbers.end());
  if (column.unit.empty())
    axis.numbers = std::move(column.numbers);
  else
    for (const double number : column.numbers) axis.list.push_back(shortest_text(number) + " " + column.unit);
  axis.count = axis.numbers.size() + axis.list.size();
  return axis;
}

/// Even values with the ends as they are given. Where ends and value are whole it is so to the last bit: keys that want
/// a whole number would refuse 60.99999999999999.
double even_value(const Distribution& range, std::size_t i, std::size_t last) {
  if (i == 0) return range.from;
  if (i == last) return range.to;
  if (range.is_logarithmic) return range.quantile(double(i) / double(last));
  const double sum = range.from * double(last - i) + range.to * double(i);
  return std::clamp(sum / double(last), std::min(range.from, range.to), std::max(range.from, range.to));
}

/// Of parameters that are numbers already.
void check(const SweepAxis& axis) {
  if (!axis.texts.empty()) return;
  try {
    axis.distribution.check();
  } catch (const Error& error) {
    throw Error(axis.location + error.what());
  }
}

} // namespace

CaseValue SweepAxis::at(std::size_t i) const {
  if (!list.empty()) return {.number = 0, .node = list.get(i)};
  if (!numbers.empty()) return {.number = numbers[i]};
  return {.number = even_value(distribution, i, count - 1)};
}

CaseValue SweepAxis::at_fraction(double part) const {
  if (count > 0) return at(std::min(count - 1, static_cast<std::size_t>(part * static_cast<double>(count))));
  return {.number = distribution.quantile(part)};
}

bool SweepAxis::has_units() const {
  return !texts.empty() || std::any_of(list.begin(), list.end(), begins_with_number);
}

void SweepAxis::convert(const std::function<double(const std::string&, std::size_t)>& number,
                        const std::function<double(const std::string&)>& deviation) {
  for (const auto& [parameter, text] : std::exchange(texts, {}))
    distribution.*parameter = parameter == &Distribution::standard_deviation ? deviation(text) : number(text, 0);
  if (list.empty() && numbers.empty()) check(*this);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const auto* text = list.get_as<std::string>(i)) {
      const double value = number(text->get(), i);
      list.replace(list.cbegin() + static_cast<std::ptrdiff_t>(i), value);
    }
}

SweepAxis range_of(const io::TomlSection& range) {
  range.allow_described();
  SweepAxis axis;
  read(range, "from", &Distribution::from, axis);
  read(range, "to", &Distribution::to, axis);
  axis.distribution.is_logarithmic = range.word("scale") == description::sweep_scales[1];
  axis.location = range.line_of("scale");
  check(axis);
  axis.count = static_cast<std::size_t>(range.whole("count"));
  return axis;
}

SweepAxis distribution_of(const io::TomlSection& section) {
  section.allow_described();
  SweepAxis axis;
  const std::string kind = section.word("distribution");
  axis.location = section.line_of("distribution");
  if (kind == description::distributions.back()) return values_of(section, std::move(axis));
  axis.distribution.kind = option_of<Distribution::Kind>(description::distributions, kind);
  axis.distribution.is_logarithmic = section.word("scale") == description::sweep_scales[1];
  for (const auto& [key, parameter, is_needed] : parameters_of(axis.distribution.kind))
    if (is_needed || section.has(key)) read(section, key, parameter, axis);
  check(axis);
  return axis;
}

} // namespace microslip::campaign
