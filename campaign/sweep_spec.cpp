#include "campaign/sweep_spec.hpp"

#include "campaign/hash.hpp"
#include "campaign/rows.hpp"
#include "campaign/table_lines.hpp"
#include "io/case_file.hpp"
#include "io/case_origin.hpp"
#include "io/csv_line.hpp"
#include "io/file_beside.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "io/toml_path.hpp"
#include "io/units.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

namespace microslip::campaign {

/// A parameter in the file.
struct SweepSpec::Entry {
  std::string name;
  const toml::node* values;
  toml::source_region location;
};

namespace {

namespace fs = std::filesystem;

std::vector<std::string> keys_of(const std::string& name) {
  std::vector<std::string> keys;
  std::stringstream parts(name);
  for (std::string key; std::getline(parts, key, ',');) keys.emplace_back(io::trimmed(key));
  return keys;
}

bool is_range(const toml::table& table) {
  const auto is_value = [&](const char* key) { return table.contains(key) && table.get(key)->is_value(); };
  return table.empty() || is_value("from") || is_value("to") || is_value("count") || is_value("distribution");
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

/// So that up to 20,000 cases each are kept by themselves.
std::size_t usual_chunk(std::size_t count) {
  constexpr std::size_t fine = 20'000, largest = 64;
  return std::max(std::clamp<std::size_t>((count + fine - 1) / fine, 1, largest),
                  (count + most_chunks - 1) / most_chunks);
}

/// Adds each text among the values of a node.
void add_texts(const toml::node& node, std::set<std::string>& texts) {
  if (const auto* text = node.as_string()) texts.insert(text->get());
  if (const auto* list = node.as_array())
    for (const toml::node& one : *list) add_texts(one, texts);
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table) add_texts(value, texts);
}

/// A file and those that it names. Of one that cannot be read only itself: the cases that need it fail by themselves.
std::vector<fs::path> with_those_it_names(const fs::path& file) {
  try {
    return io::files_of_case(file);
  } catch (const Error&) {
    return {file};
  }
}

/// Files that texts name, whichever keys they belong to, from a folder on, with the slices of a profile that varies.
std::set<fs::path> files_named(const std::set<std::string>& texts, const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code ignored;
  for (const std::string& text : texts)
    for (const fs::path& path : {folder / text, io::file_beside(folder, text)})
      if (!files.contains(path) && fs::is_regular_file(path, ignored))
        for (fs::path& file : with_those_it_names(path)) files.insert(std::move(file));
  return files;
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

void SweepSpec::add(const Entry& entry, const io::TomlSection& root, std::string_view section,
                    SweepAxis (*read)(const io::TomlSection&)) {
  SweepAxis axis;
  bool is_number = true;
  if (const auto* list = entry.values->as_array()) {
    if (list->empty()) fail(entry.location, entry.name + ": must have at least one value");
    axis.list = *list;
    axis.count = list->size();
    axis.location = name_ + ":" + std::to_string(entry.location.begin.line) + ": ";
    is_number = std::all_of(list->begin(), list->end(), [](const toml::node& node) { return node.is_number(); });
  } else if (const auto* table = entry.values->as_table()) {
    axis = read(root.inside(*table, entry.name, section));
    is_number = axis.list.empty();
  } else {
    fail(entry.location, entry.name + ": must be a list of values or { from = ..., to = ... }");
  }
  if (entry.name.starts_with("sweep."))
    fail(entry.location,
         entry.name + ": names no key that cases have; vary the key itself, e.g. wheel" + entry.name.substr(5));
  parameters_.push_back({entry.name, keys_of(entry.name), is_number});
  axes_.push_back(std::move(axis));
}

void SweepSpec::read_grid(const io::TomlSection& root, const toml::table& section) {
  for (const Entry& entry : entries_of(section)) add(entry, root, "grid.KEY", range_of);
  if (axes_.empty()) throw Error(name_ + ": [grid]: names no key that varies");
  count_ = 1;
  for (const SweepAxis& axis : axes_) {
    shape_.push_back(axis.count);
    if (axis.count > std::size_t{most_cases} / count_)
      throw Error(name_ + ": [grid]: more than " + std::to_string(most_cases) + " cases");
    count_ *= axis.count;
  }
}

void SweepSpec::read_sample(const io::TomlSection& root, const toml::table& section) {
  const io::TomlSection sample = root.required_section("sample");
  if (!sample.has("count") || !sample.has("seed")) throw Error(name_ + ": [sample]: needs count and seed");
  const std::string before = "correlations.";
  for (const Entry& entry : entries_of(section))
    if (!sample.is_described(entry.name) && !entry.name.starts_with(before))
      add(entry, root, "sample.KEY", distribution_of);
  if (axes_.empty()) throw Error(name_ + ": [sample]: names no key that varies");
  std::vector<std::string> names;
  for (const SweepParameter& parameter : parameters_) names.push_back(parameter.name);
  const auto aim = option_of<SampleAim>(description::sample_aims, sample.word("aim"));
  const auto points = option_of<PointSet>(description::point_sets, sample.word("points"));
  const std::vector<Correlation> correlations = read_correlations(sample.optional_section("correlations"), section);
  if (aim == SampleAim::sobol_indices && !correlations.empty())
    sample.at("aim", [] { throw Error("sample.aim: sobol_indices need keys that vary without correlations"); });
  sample.at("correlations", [&] {
    sample_.emplace(aim, points, static_cast<std::size_t>(sample.whole("count")),
                    static_cast<std::uint64_t>(sample.whole("seed")), names, correlations);
  });
  count_ = sample_->cases();
  if (count_ > std::size_t{most_cases})
    throw Error(name_ + ": [sample]: " + std::to_string(count_) + " cases, more than " + std::to_string(most_cases));
}

/// Place of the parameter with a name, that of one of its keys too, which a correlation has.
std::size_t SweepSpec::correlated(const std::string& name) const {
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const auto& [whole, keys, is_number, unit] = parameters_[k];
    if (whole != name && std::find(keys.begin(), keys.end(), name) == keys.end()) continue;
    if (!axes_[k].is_ascending()) throw Error(name + ": is a list, whose values have no order");
    return k;
  }
  std::vector<std::string_view> known;
  for (const SweepParameter& parameter : parameters_) known.push_back(parameter.name);
  throw Error(io::printable(name) + " does not vary" + io::suggestion(name, known));
}

std::vector<Correlation> SweepSpec::read_correlations(const io::TomlSection& correlations,
                                                      const toml::table& section) const {
  constexpr std::string_view between = " with ";
  std::vector<Correlation> all;
  const auto* table = section.get_as<toml::table>("correlations");
  if (table == nullptr) return all;
  for (const auto& [key, value] : *table)
    correlations.at(key, [&, &key = key, &value = value] { // as clang wants structured bindings
      const std::string pair(key.str());
      const std::string name = correlations.full(key) + ": ";
      const auto place = pair.find(between);
      if (place == std::string::npos)
        throw Error(name + "must be of the form \"load.normal_force with friction.coefficient\"");
      const auto number = value.value<double>();
      if (!number || !(std::abs(*number) < 1)) throw Error(name + "must be a number between -1 and 1");
      try {
        const std::size_t first = correlated(std::string(io::trimmed(pair.substr(0, place)))),
                          second = correlated(std::string(io::trimmed(pair.substr(place + between.size()))));
        if (first == second) throw Error("are the same");
        all.push_back({first, second, *number});
      } catch (const Error& error) {
        throw Error(name + error.what());
      }
    });
  return all;
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
  const char separator = separator_of(text);
  const bool has_decimal_commas = separator != ',';
  const auto field_of = [&](std::string_view field) {
    return has_decimal_commas && io::parse_number(io::with_decimal_point(field)) ? io::with_decimal_point(field)
                                                                                 : std::string(field);
  };
  std::vector<std::string> units;
  std::size_t rows = 0;
  visit_lines(text, file, [&](const std::vector<std::string_view>& fields, std::size_t) {
    if (rows++ == 0) return read_headings(fields, units);
    io::require_fields(fields.size(), parameters_.size(), separator);
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (!units[k].empty() || !io::parse_number(field_of(fields[k]))) parameters_[k].is_number = false;
  });
  if (rows < 2) throw Error(file + ": has no cases: the first line must name keys, each one that follows is a case");
  count_ = rows - 1;
  if (count_ > std::size_t{most_cases}) throw Error(file + ": more than " + std::to_string(most_cases) + " cases");
  std::vector<SweepAxis> columns(parameters_.size(), SweepAxis{.count = count_, .location = file + ": "});
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
  axes_ = std::move(columns);
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
  if (sample_) return axes_[k].at_fraction(sample_->part(index, k));
  if (shape_.empty()) return axes_[k].at(index);
  std::size_t stride = 1;
  for (std::size_t later = k + 1; later < shape_.size(); ++later) stride *= shape_[later];
  return axes_[k].at(index / stride % shape_[k]);
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
  return std::any_of(axes_.begin(), axes_.end(), [](const auto& axis) { return axis.has_units(); });
}

toml::table SweepSpec::case_as_written(std::size_t index) const {
  toml::table table = base_;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (axes_[k].texts.empty()) {
      put(k, value(index, k), table);
    } else {
      const toml::value<std::string> first(axes_[k].texts.front().text);
      put(k, {.number = 0, .node = &first}, table);
    }
  }
  return table;
}

void SweepSpec::convert(SweepAxis& axis, std::size_t k, const io::TomlSection::KeyUnits& units) const {
  const SweepParameter& parameter = parameters_[k];
  const auto unit = units.find(parameter.keys.front());
  if (unit == units.end()) return; // texts that begin with a digit
  for (const std::string& key : parameter.keys)
    if (const auto other = units.find(key); other == units.end() || other->second != unit->second)
      throw Error(axis.location + parameter.name + ": keys of different units cannot take the same text with a unit");
  const auto converted = [&](const std::string& text, const std::string& to, std::size_t index) {
    try {
      return io::number_in_unit(parameter.name, text, to);
    } catch (const Error& error) {
      throw Error((list_name_.empty() ? axis.location : location(index)) + error.what());
    }
  };
  const std::string of_difference = unit->second == "deg C" ? "K" : unit->second;
  axis.convert([&](const std::string& text, std::size_t i) { return converted(text, unit->second, i); },
               [&](const std::string& text) { return converted(text, of_difference, 0); });
}

void SweepSpec::convert_units(const io::TomlSection::KeyUnits& units) {
  for (SweepParameter& parameter : parameters_)
    if (const auto unit = units.find(parameter.keys.front()); unit != units.end()) parameter.unit = unit->second;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (!axes_[k].has_units()) continue;
    convert(axes_[k], k, units);
    const auto& list = axes_[k].list;
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
  for (const SweepAxis& axis : axes_) hash = hash_of(axis.table, hash);
  std::set<std::string> texts;
  for (const auto& [key, node] : base_)
    if (key != "title") add_texts(node, texts);
  for (const SweepAxis& axis : axes_) add_texts(axis.list, texts);
  for (const fs::path& path : files_named(texts, fs::path(base_name_).parent_path())) {
    const std::string text = read_text(path);
    hash = hash_of(text, hash_of(std::to_string(text.size()) + ":", hash));
  }
  return hash;
}

void SweepSpec::fail(const toml::source_region& location, const std::string& what) const {
  throw Error(name_ + ":" + std::to_string(location.begin.line) + ": " + what);
}

} // namespace microslip::campaign
