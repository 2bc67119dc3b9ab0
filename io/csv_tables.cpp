#include "io/csv_tables.hpp"

#include "io/csv_line.hpp"
#include "io/output_file.hpp"
#include "io/result_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;
using Values = ResultReader::Values;

constexpr std::size_t block = 4096; ///< rows, or the fewest more that HDF5 reads at a time

/// A column of a table: a dataset with the table's shape, or the coordinate along one of the table's dimensions.
struct Column {
  std::string name;
  const StoredDataset* dataset;
  std::optional<std::size_t> axis = {};

  std::string heading() const {
    return csv_field(dataset->unit == "-" ? name : fmt::format("{} [{}]", name, dataset->unit));
  }
};

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_place(const Column& column) {
  return is_one_of(column.name, {"x", "y", "z"});
}

struct Table {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<Column> columns = {};
};

std::string_view last_part(std::string_view group) {
  return group.substr(group.rfind('/') + 1);
}

/// Which table has which dataset.
class Layout {
public:
  explicit Layout(const std::vector<StoredDataset>& datasets) {
    find_cases(datasets);
    std::set<std::string> groups_with_numbers;
    for (const StoredDataset& d : datasets)
      if (d.shape.empty() && !d.group.empty()) groups_with_numbers.insert(d.group);
    std::map<std::string, std::vector<const StoredDataset*>> of_groups;
    for (const StoredDataset& d : datasets) {
      const bool is_list = d.shape.size() == 1 && groups_with_numbers.contains(d.group);
      if (is_sweep_ && (d.group == "failures" || d.path() == "shape")) continue;
      if (d.shape.empty() || is_list)
        numbers.push_back(&d);
      else if (is_by_case(d))
        cases->columns.push_back({d.path(), &d});
      else
        of_groups[d.group].push_back(&d);
    }
    if (cases)
      std::stable_partition(cases->columns.begin(), cases->columns.end(),
                            [&](const Column& column) { return column.dataset->group == inputs_; });
    for (auto& [group, arrays] : of_groups) add_group(group, arrays);
  }

  std::vector<const StoredDataset*> numbers;
  std::optional<Table> cases;
  std::vector<Table> others;

private:
  void find_cases(const std::vector<StoredDataset>& datasets) {
    for (const StoredDataset& d : datasets) {
      if (d.shape.size() != 1 || !is_one_of(d.group, {"parameters", "states", "cases"})) continue;
      is_sweep_ = d.group == "parameters";
      inputs_ = d.group;
      cases = Table{"", d.shape};
      return;
    }
  }

  bool is_by_case(const StoredDataset& d) const {
    return cases && d.shape == cases->shape &&
           (is_sweep_ || is_one_of(last_part(d.group), {"states", "cases", "wheel", "wheelset"}));
  }

  void add_group(const std::string& group, std::vector<const StoredDataset*>& arrays) {
    const std::size_t first = others.size();
    std::ranges::stable_sort(arrays, [](const auto* a, const auto* b) { return a->shape.size() > b->shape.size(); });
    for (const StoredDataset* array : arrays) {
      const auto begin = others.begin() + static_cast<std::ptrdiff_t>(first);
      if (begin != others.end() && add_axis(*begin, *array)) continue;
      auto table = std::find_if(begin, others.end(), [&](const Table& t) { return t.shape == array->shape; });
      if (table == others.end()) {
        const bool is_first = begin == others.end() && !group.empty();
        table = others.insert(others.end(), Table{is_first ? group : array->path(), array->shape});
      }
      table->columns.push_back({array->name, array});
    }
    for (auto table = others.begin() + static_cast<std::ptrdiff_t>(first); table != others.end(); ++table)
      std::stable_partition(table->columns.begin(), table->columns.end(), is_place);
  }

  /// Returns whether an array has the coordinates along a dimension of a table of several: x along the last one.
  static bool add_axis(Table& table, const StoredDataset& array) {
    constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
    const auto k = static_cast<std::size_t>(std::ranges::find(names, array.name) - names.begin());
    const std::size_t dimensions = table.shape.size();
    if (dimensions < 2 || array.shape.size() != 1 || k >= std::min(dimensions, names.size())) return false;
    const std::size_t axis = dimensions - 1 - k;
    if (table.shape[axis] != array.shape[0]) return false;
    const auto place = std::ranges::find_if(table.columns, [](const Column& column) { return !column.axis; });
    table.columns.insert(place, {array.name, &array, axis});
    return true;
  }

  bool is_sweep_ = false;
  std::string inputs_;
};

std::string cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}
std::string cell(int value) {
  return fmt::format("{}", value);
}
std::string cell(const std::string& text) {
  return csv_field(text);
}
std::string cell(const Values& values, std::size_t k) {
  return std::visit([k](const auto& numbers) { return cell(numbers[k]); }, values);
}

class Writer {
public:
  Writer(const fs::path& result_file, const fs::path& csv) : reader_(result_file), csv_(csv) {}

  std::vector<fs::path> write() {
    const Layout layout(reader_.datasets());
    if (layout.cases) write(*layout.cases, reasons());
    if (!layout.cases || !layout.numbers.empty()) write_numbers(layout.cases ? "numbers" : "", layout.numbers);
    for (const Table& table : layout.others)
      if (std::ranges::find(table.shape, 0u) == table.shape.end()) write(table);
    for (const auto& file : files_) file->commit();
    return names_;
  }

private:
  using Reasons = std::map<std::size_t, std::string>;

  OutputFile& open(const std::string& table) {
    std::string ending = table.empty() ? ".csv" : "." + table + ".csv";
    std::ranges::replace(ending, '/', '.');
    names_.push_back(csv_.parent_path() / (csv_.stem().string() + ending));
    return *files_.emplace_back(std::make_unique<OutputFile>(names_.back()));
  }

  void write_numbers(const std::string& name, const std::vector<const StoredDataset*>& numbers) {
    OutputFile& file = open(name);
    file.write("name,value,unit,description\n");
    for (const StoredDataset* d : numbers) {
      const Values values = reader_.read(*d);
      for (std::size_t k = 0; k < d->size(); ++k)
        file.write(fmt::format("{},{},{},{}\n",
                               csv_field(d->shape.empty() ? d->path() : fmt::format("{}[{}]", d->path(), k)),
                               cell(values, k), csv_field(d->unit), csv_field(d->description)));
    }
  }

  /// Why cases of a sweep have another status than ok.
  std::optional<Reasons> reasons() const {
    std::vector<int> cases;
    std::vector<std::string> texts;
    bool is_there = false;
    for (const StoredDataset& d : reader_.datasets()) {
      if (d.group != "failures") continue;
      is_there = true;
      if (d.name == "case") cases = std::get<std::vector<int>>(reader_.read(d));
      if (d.name == "reason") texts = std::get<std::vector<std::string>>(reader_.read(d));
    }
    if (!is_there) return std::nullopt;
    Reasons reasons;
    for (std::size_t k = 0; k < std::min(cases.size(), texts.size()); ++k)
      reasons[static_cast<std::size_t>(cases[k])] = texts[k];
    return reasons;
  }

  void write(const Table& table, const std::optional<Reasons>& reasons = std::nullopt) {
    OutputFile& file = open(table.name);
    std::string line;
    for (const Column& column : table.columns) line += (line.empty() ? "" : ",") + column.heading();
    file.write(line + (reasons ? ",failures/reason\n" : "\n"));
    const std::size_t outer = table.shape.front();
    std::size_t inner = 1;
    for (std::size_t d = 1; d < table.shape.size(); ++d) inner *= table.shape[d];
    const std::size_t most = std::max<std::size_t>(1, block / inner);
    for (std::size_t first = 0; first < outer; first += most)
      write_rows(file, table, reasons, first, std::min(most, outer - first), inner);
  }

  void write_rows(OutputFile& file, const Table& table, const std::optional<Reasons>& reasons, std::size_t first,
                  std::size_t count, std::size_t inner) {
    std::vector<Values> values;
    for (const Column& column : table.columns)
      values.push_back(column.axis ? reader_.read(*column.dataset) : reader_.read(*column.dataset, first, count));
    std::string text;
    for (std::size_t k = 0; k < count * inner; ++k) {
      for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const auto& axis = table.columns[c].axis;
        text += (c == 0 ? "" : ",") + cell(values[c], axis ? index_along(table, *axis, first * inner + k) : k);
      }
      if (reasons) {
        const auto reason = reasons->find(first + k);
        text += "," + (reason == reasons->end() ? "" : csv_field(reason->second));
      }
      text += "\n";
    }
    file.write(text);
  }

  /// Index along a dimension of the entry at a place in the table.
  static std::size_t index_along(const Table& table, std::size_t axis, std::size_t place) {
    for (std::size_t d = table.shape.size() - 1; d > axis; --d) place /= table.shape[d];
    return place % table.shape[axis];
  }

  ResultReader reader_;
  fs::path csv_;
  std::vector<fs::path> names_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

} // namespace

std::vector<fs::path> write_csv_tables(const fs::path& result_file, const fs::path& csv) {
  return Writer(result_file, csv).write();
}

bool is_csv(const fs::path& name) {
  return name.extension() == ".csv";
}

} // namespace microslip::io
