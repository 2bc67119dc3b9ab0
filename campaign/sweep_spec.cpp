#include "campaign/sweep_spec.hpp"

#include "campaign/hash.hpp"
#include "campaign/rows.hpp"
#include "io/case_file.hpp"
#include "io/csv_line.hpp"
#include "io/text_line.hpp"
#include "io/toml_path.hpp"
#include "io/units.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace microslip::campaign {

/// The values of a parameter: those of a list, or a range.
struct SweepSpec::Axis {
  toml::array list = {};            ///< or else
  std::vector<double> numbers = {}; ///< a column of numbers, or else
  double from = 0, to = 0;
  std::string from_text = {}, to_text = {}; ///< the ends as texts with units, until these are converted
  bool is_logarithmic = false;
  std::size_t count = 0;     ///< 0: any number between the ends
  std::string location = {}; ///< for messages: file and line

  CaseValue at(std::size_t i) const {
    if (!list.empty()) return {.number = 0, .node = list.get(i)};
    if (!numbers.empty()) return {.number = numbers[i]};
    return {.number = i + 1 == count && count > 1 ? to : between(count > 1 ? double(i) / double(count - 1) : 0)};
  }
  /// Value below which a fraction `part` of them lies.
  CaseValue at_fraction(double part) const {
    if (count > 0) return at(std::min(count - 1, static_cast<std::size_t>(part * static_cast<double>(count))));
    return {.number = between(part)};
  }

  bool has_units() const {
    return !from_text.empty() || !to_text.empty() || std::any_of(list.begin(), list.end(), begins_with_number);
  }
  void check_ends() const {
    if (is_logarithmic && from_text.empty() && to_text.empty() && !(from * to > 0))
      throw Error(location + "a logarithmic scale needs ends of one sign");
  }

private:
  static bool begins_with_number(const toml::node& node) {
    double value = 0;
    const std::string_view text = node.value_or(std::string_view());
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
  }
  double between(double part) const {
    return is_logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
  }
};

/// A parameter in the file.
struct SweepSpec::Entry {
  std::string name;
  const toml::node* values;
  toml::source_region location;
};

namespace {

namespace fs = std::filesystem;

/// SplitMix64 (Steele, Lea and Flood 2014): numbers by their index, without a state.
std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// Random number in [0, 1) of a case and a parameter.
double random_part(std::uint64_t seed, const std::string& name, std::size_t index) {
  const std::uint64_t stream = scrambled(hash_of(name) ^ scrambled(seed));
  return static_cast<double>(scrambled(stream + index * 0x9e3779b97f4a7c15) >> 11) * 0x1p-53;
}

std::vector<std::string> keys_of(const std::string& name) {
  std::vector<std::string> keys;
  std::stringstream parts(name);
  for (std::string key; std::getline(parts, key, ',');) keys.emplace_back(io::trimmed(key));
  return keys;
}

bool is_range(const toml::table& table) {
  const auto is_value = [&](const char* key) { return table.contains(key) && table.get(key)->is_value(); };
  return table.empty() || is_value("from") || is_value("to") || is_value("count");
}

/// A number as case files may have it: keys that want a number take a whole one, too.
void insert(toml::table& table, std::string_view key, const CaseValue& value) {
  constexpr double largest_whole = 9e15;
  if (value.node != nullptr)
    value.node->visit([&](const auto& node) { table.insert_or_assign(key, node); });
  else if (value.number == std::floor(value.number) && std::abs(value.number) < largest_whole)
    table.insert_or_assign(key, static_cast<std::int64_t>(value.number));
  else
    table.insert_or_assign(key, value.number);
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file || fs::is_directory(path)) throw Error(path.string() + ": cannot be read");
  return text;
}

/// So that up to 20,000 cases each are kept by themselves.
std::size_t usual_chunk(std::size_t count) {
  constexpr std::size_t fine = 20'000, largest = 64;
  return std::max(std::clamp<std::size_t>((count + fine - 1) / fine, 1, largest),
                  (count + most_chunks - 1) / most_chunks);
}

/// Calls `add` with fields and number of each line of a table that is not blank; its errors have file and line.
template <class Add> void visit_lines(std::string_view text, const std::string& file, const Add& add) {
  std::size_t number = 0;
  std::optional<io::CsvLine> line;
  while (!text.empty()) {
    const auto next = io::take_line(text);
    ++number;
    if (io::trimmed(next).empty()) continue;
    try {
      if (!line) line.emplace(io::csv_separator(next));
      add(line->split(next), number);
    } catch (const Error& error) {
      throw Error(file + ":" + std::to_string(number) + ": " + error.what());
    }
  }
}

} // namespace

SweepSpec::SweepSpec(const std::string& text, const std::string& name) : text_(text), name_(name) {
  const auto table = io::parse_toml(text, name);
  const io::TomlSection root = io::TomlSection(table, name_).described_by(description::sweep_inputs());
  root.allow_described({"grid", "list", "sample", "output"});
  title_ = root.text("title", "");
  read_base(root);
  const int ways = root.has("grid") + root.has("list") + root.has("sample");
  if (ways != 1) throw Error(name_ + ": needs one of [grid], [list] and [sample]");
  for (const char* way : {"grid", "list", "sample"}) root.optional_section(way); // tables
  if (root.has("grid")) read_grid(root, *table.get("grid")->as_table());
  if (root.has("sample")) read_sample(root, *table.get("sample")->as_table());
  if (root.has("list")) read_list(root.required_section("list"));
  require_distinct_keys();
  read_chunk(root);
  const io::TomlSection output = root.optional_section("output");
  output.allow_described();
  quantities_ = output.texts("quantities");
  patches_ = output.whole("patches");
}

void SweepSpec::read_base(const io::TomlSection& root) {
  if (!root.has("case")) throw Error(name_ + ": case is missing: a case file's name, or its sections below [case]");
  const auto table = io::parse_toml(text_, name_);
  if (const auto* inside = table.get("case")->as_table()) {
    base_ = *inside;
    base_name_ = name_;
  } else {
    const auto path = fs::path(name_).parent_path() / root.required_text("case");
    base_name_ = path.string();
    root.at("case", [&] { base_text_ = io::read_case_text(path); });
    base_ = io::parse_toml(base_text_, base_name_);
  }
  for (const char* section : {"sweep", "interior"})
    if (base_.contains(section))
      throw Error(base_name_ + ": [" + section + "]: must be left out of a case that varies in another sweep");
}

/// Entries in the order of the file. A key may be quoted, or open tables by its dots.
std::vector<SweepSpec::Entry> SweepSpec::entries_of(const toml::table& section) const {
  std::vector<Entry> entries;
  const std::function<void(const toml::table&, const std::string&)> collect = [&](const auto& table,
                                                                                  const std::string& before) {
    for (const auto& [key, node] : table) {
      const std::string name = before + std::string(key.str());
      const auto* inside = node.as_table();
      if (inside != nullptr && !is_range(*inside))
        collect(*inside, name + ".");
      else
        entries.push_back({name, &node, key.source()});
    }
  };
  collect(section, "");
  std::sort(entries.begin(), entries.end(),
            [](const Entry& e, const Entry& f) { return e.location.begin < f.location.begin; });
  return entries;
}

void SweepSpec::add(const Entry& entry, const io::TomlSection& root, std::string_view range_keys) {
  Axis axis;
  bool is_number = true;
  const std::string location = name_ + ":" + std::to_string(entry.location.begin.line) + ": ";
  if (const auto* list = entry.values->as_array()) {
    if (list->empty()) fail(entry.location, entry.name + ": must have at least one value");
    axis.list = *list;
    axis.count = list->size();
    axis.location = location;
    is_number = std::all_of(list->begin(), list->end(), [](const toml::node& node) { return node.is_number(); });
  } else if (const auto* table = entry.values->as_table()) {
    axis = range_of(root.inside(*table, entry.name, range_keys));
  } else {
    fail(entry.location, entry.name + ": must be a list of values or { from = ..., to = ... }");
  }
  if (entry.name.starts_with("sweep."))
    fail(entry.location,
         entry.name + ": names no key that cases have; vary the key itself, e.g. wheel" + entry.name.substr(5));
  parameters_.push_back({entry.name, keys_of(entry.name), is_number});
  axes_.push_back(std::make_shared<Axis>(std::move(axis)));
}

SweepSpec::Axis SweepSpec::range_of(const io::TomlSection& range) {
  range.allow_described();
  Axis axis;
  const auto read_end = [&](const char* key, double& value, std::string& text) {
    if (range.is_text(key))
      text = range.required_text(key);
    else
      value = range.number(key);
  };
  read_end("from", axis.from, axis.from_text);
  read_end("to", axis.to, axis.to_text);
  axis.is_logarithmic = range.word("scale") == description::sweep_scales[1];
  axis.location = range.line_of("scale");
  axis.check_ends();
  if (range.is_described("count")) axis.count = static_cast<std::size_t>(range.whole("count"));
  return axis;
}

void SweepSpec::read_grid(const io::TomlSection& root, const toml::table& section) {
  for (const Entry& entry : entries_of(section)) add(entry, root, "grid.KEY");
  if (axes_.empty()) throw Error(name_ + ": [grid]: names no key that varies");
  count_ = 1;
  for (const auto& axis : axes_) {
    shape_.push_back(axis->count);
    if (axis->count > std::size_t{most_cases} / count_)
      throw Error(name_ + ": [grid]: more than " + std::to_string(most_cases) + " cases");
    count_ *= axis->count;
  }
}

void SweepSpec::read_sample(const io::TomlSection& root, const toml::table& section) {
  const io::TomlSection sample = root.required_section("sample");
  if (!sample.has("count") || !sample.has("seed")) throw Error(name_ + ": [sample]: needs count and seed");
  const int count = sample.whole("count"), seed = sample.whole("seed");
  for (const Entry& entry : entries_of(section))
    if (entry.name != "count" && entry.name != "seed") add(entry, root, "sample.KEY");
  if (axes_.empty()) throw Error(name_ + ": [sample]: names no key that varies");
  is_sample_ = true;
  count_ = static_cast<std::size_t>(count);
  seed_ = static_cast<std::uint64_t>(seed);
}

void SweepSpec::read_list(const io::TomlSection& list) {
  list.allow({"file"});
  const auto path = fs::path(name_).parent_path() / list.required_text("file");
  list.at("file", [&] { list_text_ = read_text(path); });
  list_name_ = path.string();
  parse_rows(list_text_, list_name_);
}

/// A table of cases: keys in the first line, with units where these follow in brackets, a case in each one that
/// follows. The first pass finds which columns are numbers, the second one keeps them.
void SweepSpec::parse_rows(std::string_view text, const std::string& file) {
  text = io::csv_start(text, file);
  const bool has_decimal_commas = io::csv_separator(text.substr(0, text.find('\n'))) != ',';
  const auto field_of = [&](std::string_view field) {
    return has_decimal_commas && io::parse_number(io::with_decimal_point(field)) ? io::with_decimal_point(field)
                                                                                 : std::string(field);
  };
  std::vector<std::string> units;
  std::size_t rows = 0;
  visit_lines(text, file, [&](const std::vector<std::string_view>& fields, std::size_t) {
    if (rows++ == 0) return read_headings(fields, units);
    if (fields.size() != parameters_.size())
      throw Error(std::to_string(fields.size()) + " fields, not " + std::to_string(parameters_.size()));
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (!units[k].empty() || !io::parse_number(field_of(fields[k]))) parameters_[k].is_number = false;
  });
  if (rows < 2) throw Error(file + ": has no cases: the first line must name keys, each one that follows is a case");
  count_ = rows - 1;
  if (count_ > std::size_t{most_cases}) throw Error(file + ": more than " + std::to_string(most_cases) + " cases");
  std::vector<Axis> columns(parameters_.size(), Axis{.count = count_, .location = file + ": "});
  rows = 0;
  visit_lines(text, file, [&](const std::vector<std::string_view>& fields, std::size_t) {
    for (std::size_t k = 0; rows > 0 && k < fields.size(); ++k) {
      const std::string field = field_of(fields[k]);
      const auto number = io::parse_number(field);
      if (parameters_[k].is_number)
        columns[k].numbers.push_back(number.value());
      else if (number && units[k].empty())
        columns[k].list.push_back(*number);
      else
        columns[k].list.push_back(units[k].empty() ? field : field + " " + units[k]);
    }
    ++rows;
  });
  for (Axis& column : columns) axes_.push_back(std::make_shared<Axis>(std::move(column)));
}

std::string SweepSpec::location(std::size_t index) const {
  if (list_name_.empty()) return {};
  std::size_t rows = 0, line = 0;
  visit_lines(io::csv_start(list_text_, list_name_), list_name_, [&](const auto&, std::size_t number) {
    if (rows++ == index + 1) line = number; // keys come first
  });
  return list_name_ + ":" + std::to_string(line) + ": ";
}

void SweepSpec::read_headings(const std::vector<std::string_view>& fields, std::vector<std::string>& units) {
  for (const auto field : fields) {
    const auto [name, unit] = io::name_and_unit(field);
    if (name.empty()) throw Error("column " + std::to_string(parameters_.size() + 1) + " has no name");
    parameters_.push_back({std::string(name), keys_of(std::string(name)), true});
    units.emplace_back(unit == "-" ? "" : unit);
  }
}

void SweepSpec::require_distinct_keys() const {
  std::set<std::string_view> keys;
  for (const SweepParameter& parameter : parameters_)
    for (const std::string& key : parameter.keys)
      if (!keys.insert(key).second)
        throw Error((list_name_.empty() ? name_ : list_name_) + ": " + key + ": is varied twice");
}

void SweepSpec::read_chunk(const io::TomlSection& root) {
  chunk_ = usual_chunk(count_);
  int chunk = static_cast<int>(chunk_);
  root.count("chunk", static_cast<int>((count_ + most_chunks - 1) / most_chunks), most_sweep_chunk, chunk);
  chunk_ = static_cast<std::size_t>(chunk);
}

CaseValue SweepSpec::value(std::size_t index, std::size_t k) const {
  if (is_sample_) return axes_[k]->at_fraction(random_part(seed_, parameters_[k].name, index));
  if (shape_.empty()) return axes_[k]->at(index);
  std::size_t stride = 1;
  for (std::size_t later = k + 1; later < shape_.size(); ++later) stride *= shape_[later];
  return axes_[k]->at(index / stride % shape_[k]);
}

std::string SweepSpec::text_of(std::size_t index, std::size_t k) const {
  const toml::node& node = *value(index, k).node;
  if (const auto* word = node.as_string()) return word->get();
  std::ostringstream text;
  node.visit([&](const auto& printed) { text << printed; });
  return text.str();
}

void SweepSpec::set(std::size_t index, std::size_t k, toml::table& table) const {
  put(k, value(index, k), table);
}

void SweepSpec::put(std::size_t k, const CaseValue& value, toml::table& table) const {
  for (const std::string& key : parameters_[k].keys) put(key, value, table);
}

void SweepSpec::put(const std::string& path, const CaseValue& value, toml::table& table) const {
  const auto [section, key] = io::section_and_key(path);
  try {
    insert(io::table_at(table, section), key, value);
  } catch (const Error& error) {
    throw Error(base_name_ + ": " + path + ": " + error.what());
  }
}

bool SweepSpec::has_units() const {
  return std::any_of(axes_.begin(), axes_.end(), [](const auto& axis) { return axis->has_units(); });
}

toml::table SweepSpec::case_as_written(std::size_t index) const {
  toml::table table = base_;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const toml::value<std::string> from(axes_[k]->from_text);
    if (axes_[k]->from_text.empty())
      put(k, value(index, k), table);
    else
      put(k, {.number = 0, .node = &from}, table);
  }
  return table;
}

void SweepSpec::convert(Axis& axis, std::size_t k, const io::TomlSection::KeyUnits& units) const {
  const SweepParameter& parameter = parameters_[k];
  const auto unit = units.find(parameter.keys.front());
  if (unit == units.end()) return; // texts that begin with a digit
  for (const std::string& key : parameter.keys)
    if (const auto other = units.find(key); other == units.end() || other->second != unit->second)
      throw Error(axis.location + parameter.name + ": keys of different units cannot take the same text with a unit");
  const auto number = [&](const std::string& text, std::size_t index) {
    try {
      return io::number_in_unit(parameter.name, text, unit->second);
    } catch (const Error& error) {
      throw Error((list_name_.empty() ? axis.location : location(index)) + error.what());
    }
  };
  if (!axis.from_text.empty()) axis.from = number(std::exchange(axis.from_text, {}), 0);
  if (!axis.to_text.empty()) axis.to = number(std::exchange(axis.to_text, {}), 0);
  axis.check_ends();
  for (std::size_t i = 0; i < axis.list.size(); ++i)
    if (const auto* text = axis.list.get_as<std::string>(i)) {
      const double value = number(text->get(), i);
      axis.list.replace(axis.list.cbegin() + static_cast<std::ptrdiff_t>(i), value);
    }
}

void SweepSpec::convert_units(const io::TomlSection::KeyUnits& units) {
  for (SweepParameter& parameter : parameters_)
    if (const auto unit = units.find(parameter.keys.front()); unit != units.end()) parameter.unit = unit->second;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (!axes_[k]->has_units()) continue;
    convert(*axes_[k], k, units);
    const auto& list = axes_[k]->list;
    parameters_[k].is_number = std::all_of(list.begin(), list.end(), [](const auto& node) { return node.is_number(); });
  }
  for (const auto& [key, unit] : units)
    if (const auto* text = base_.at_path(key).as_string())
      put(key, {.number = io::number_in_unit(key, text->get(), unit)}, base_);
}

std::uint64_t SweepSpec::identity() const {
  const auto build = build_info();
  std::uint64_t hash = hash_of(build.version);
  for (const std::string_view part :
       {build.commit, std::string_view(text_), std::string_view(base_text_), std::string_view(list_text_)})
    hash = hash_of(std::to_string(part.size()) + ":", hash_of(part, hash));
  const auto add_file = [&](const toml::node* path) {
    std::ifstream file(fs::path(base_name_).parent_path() / path->value_or(std::string()), std::ios::binary);
    hash = hash_of(std::string((std::istreambuf_iterator<char>(file)), {}), hash);
  };
  for (const std::string key : {"rail.profile", "wheelset.profile", "solution.table", "friction.table"}) {
    if (const auto* path = base_.at_path(key).node()) add_file(path);
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      if (std::find(parameters_[k].keys.begin(), parameters_[k].keys.end(), key) != parameters_[k].keys.end())
        for (const auto& path : axes_[k]->list) add_file(&path);
  }
  return hash;
}

void SweepSpec::fail(const toml::source_region& location, const std::string& what) const {
  throw Error(name_ + ":" + std::to_string(location.begin.line) + ": " + what);
}

} // namespace microslip::campaign
