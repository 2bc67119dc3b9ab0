#include "campaign/sweep_statistics.hpp"

#include "campaign/sweep_file.hpp"
#include "io/nearest_word.hpp"
#include "io/result_reader.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/status.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string_view>

namespace microslip::campaign {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_groups = 1000;

std::string_view last_name(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

/// A sweep's result file.
class SweepReader {
public:
  explicit SweepReader(const std::filesystem::path& path) : name_(path.string()), reader_(path) {
    if (attribute("kind") != sweep_kind) throw Error(name_ + ": is no result of a sweep");
    std::istringstream names(attribute("parameters"));
    for (std::string name; std::getline(names, name);) parameters.push_back(name);
    has_indices = attribute(sample_aim_name) == description::sample_aims.back();
    statuses = std::get<std::vector<int>>(reader_.read(dataset(status_path())));
  }

  std::string attribute(std::string_view name) const {
    for (const io::StoredAttribute& one : reader_.attributes())
      if (one.group.empty() && one.name == name) return one.value;
    return {};
  }

  /// Quantities that are asked for.
  std::vector<SweepQuantity> quantities(const std::vector<std::string>& wanted) const {
    std::vector<SweepQuantity> all;
    for (const io::StoredDataset& one : reader_.datasets())
      if (is_quantity(one)) all.push_back({one.path(), one.unit, one.description});
    if (wanted.empty()) return all;
    std::vector<SweepQuantity> some;
    for (const std::string& name : wanted) {
      const auto before = some.size();
      std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                   [&](const SweepQuantity& q) { return q.path == name || last_name(q.path) == name; });
      if (some.size() == before) refuse_unknown(name, all);
    }
    return some;
  }

  std::vector<double> numbers(const std::string& path) const {
    return std::get<std::vector<double>>(reader_.read(dataset(path)));
  }
  const io::StoredDataset& dataset(const std::string& path) const {
    for (const io::StoredDataset& one : reader_.datasets())
      if (one.path() == path) return one;
    throw Error(name_ + ": has no " + path);
  }
  /// The values of a parameter that varies.
  io::ResultReader::Values values_of(const std::string& parameter) const {
    if (std::find(parameters.begin(), parameters.end(), parameter) == parameters.end()) {
      const std::vector<std::string_view> known(parameters.begin(), parameters.end());
      throw Error(name_ + ": " + io::printable(parameter) + " does not vary" + io::suggestion(parameter, known) +
                  "; known: " + io::listed(known, "and"));
    }
    return reader_.read(dataset("parameters/" + parameter));
  }
  const std::string& name() const { return name_; }

  std::vector<std::string> parameters;
  bool has_indices = false;
  std::vector<int> statuses; ///< of each case

private:
  std::string status_path() const {
    for (const char* const path : {"contact/status", "wheel/status", "wheelset/status"})
      for (const io::StoredDataset& one : reader_.datasets())
        if (one.path() == path) return path;
    throw Error(name_ + ": has no status of its cases");
  }
  static bool is_quantity(const io::StoredDataset& one) {
    return !one.group.empty() && one.group != "parameters" && one.group != "failures" && one.name != "status" &&
           one.name != warning_name;
  }
  [[noreturn]] void refuse_unknown(const std::string& name, const std::vector<SweepQuantity>& all) const {
    std::vector<std::string_view> names;
    for (const SweepQuantity& q : all) names.push_back(last_name(q.path));
    throw Error(name_ + ": " + io::printable(name) + " is no quantity of its cases" + io::suggestion(name, names));
  }

  std::string name_;
  io::ResultReader reader_;
};

/// The numbers of the cases of each group.
using Members = std::vector<std::vector<std::size_t>>;

template <class Value, class Take>
Members members_by(const std::vector<Value>& values, const std::string& name, const Take& take) {
  std::map<Value, std::vector<std::size_t>> by_value;
  for (std::size_t i = 0; i < values.size(); ++i) {
    by_value[values[i]].push_back(i);
    if (by_value.size() > most_groups)
      throw Error(name + ": has more than " + std::to_string(most_groups) +
                  " values, too many for groups: let it vary by a list");
  }
  Members members;
  for (auto& [value, cases] : by_value) {
    take(value);
    members.push_back(std::move(cases));
  }
  return members;
}

/// Makes the groups of cases.
Members group(const SweepReader& reader, const std::string& by, SweepStatistics& statistics) {
  const auto add_number = [&](double value) { statistics.groups.push_back({.number = value}); };
  if (by.empty()) {
    add_number(nan);
    std::vector<std::size_t> all(reader.statuses.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return {all};
  }
  if (reader.has_indices) throw Error(reader.name() + ": cases for Sobol's indices make no groups");
  const auto values = reader.values_of(by);
  if (const auto* texts = std::get_if<std::vector<std::string>>(&values))
    return members_by(*texts, by, [&](const std::string& text) { statistics.groups.push_back({.text = text}); });
  statistics.group_unit = reader.dataset("parameters/" + by).unit;
  return members_by(std::get<std::vector<double>>(values), by, add_number);
}

/// Cases A and B of each point, which alone are independent of each other.
std::vector<double> of_a_and_b(const std::vector<double>& values, std::size_t cases_of_point) {
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += cases_of_point)
    some.insert(some.end(), values.begin() + static_cast<std::ptrdiff_t>(i),
                values.begin() + static_cast<std::ptrdiff_t>(i + 2));
  return some;
}

void count_statuses(const SweepReader& reader, const std::vector<std::size_t>& cases, CaseGroup& group) {
  group.cases = cases.size();
  for (const std::size_t i : cases)
    if (const auto status = static_cast<Status>(reader.statuses[i]); status != Status::ok)
      ++group.statuses[std::string(to_string(status))];
}

} // namespace

SweepStatistics sweep_statistics(const std::filesystem::path& result_file, const StatisticsOptions& options) {
  for (const double p : options.probabilities)
    if (!(p > 0 && p < 1)) throw Error("probability", p, "-", "between 0 and 1");
  const SweepReader reader(result_file);
  SweepStatistics statistics{.title = reader.attribute("title"),
                             .quantities = reader.quantities(options.quantities),
                             .probabilities = options.probabilities,
                             .parameters = reader.parameters,
                             .group_by = options.group_by,
                             .group_unit = {},
                             .has_indices = reader.has_indices,
                             .groups = {}};
  const Members members = group(reader, options.group_by, statistics);
  for (std::size_t g = 0; g < members.size(); ++g) count_statuses(reader, members[g], statistics.groups[g]);
  const std::size_t cases_of_point = reader.parameters.size() + 2;
  for (const SweepQuantity& quantity : statistics.quantities) {
    std::vector<double> all = reader.numbers(quantity.path);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (static_cast<Status>(reader.statuses[i]) != Status::ok) all[i] = nan;
    for (std::size_t g = 0; g < members.size(); ++g) {
      std::vector<double> values;
      for (const std::size_t i : members[g]) values.push_back(all[i]);
      QuantityStatistics found;
      if (reader.has_indices) found.indices = sobol_indices(values, reader.parameters.size());
      found.spread = spread_of(reader.has_indices ? of_a_and_b(values, cases_of_point) : values, options.probabilities);
      statistics.groups[g].quantities.push_back(std::move(found));
    }
  }
  return statistics;
}

namespace {

/// An array with an entry for each group.
void write(io::ResultWriter& writer, const SweepStatistics& statistics, const std::string& path,
           const std::string& unit, const std::string& description,
           const std::function<double(const CaseGroup&)>& value) {
  std::vector<double> values;
  for (const CaseGroup& group : statistics.groups) values.push_back(value(group));
  writer.array(path, values, unit, description);
}

/// An array with `inner` numbers for each group.
void write(io::ResultWriter& writer, const SweepStatistics& statistics, const std::string& path,
           const std::string& unit, const std::string& description, std::size_t inner,
           const std::function<double(const CaseGroup&, std::size_t)>& value) {
  std::vector<double> values;
  for (const CaseGroup& group : statistics.groups)
    for (std::size_t k = 0; k < inner; ++k) values.push_back(value(group, k));
  writer.array(path, values, unit, description, {statistics.groups.size(), inner});
}

struct SpreadColumn {
  const char* name;
  double Spread::*value;
  const char* description;
};
constexpr SpreadColumn spread_columns[] = {
    {"mean", &Spread::mean, "mean"},
    {"mean_error", &Spread::mean_error, "standard error of the mean"},
    {"standard_deviation", &Spread::standard_deviation, "standard deviation"},
    {"least", &Spread::least, "least value"},
    {"largest", &Spread::largest, "largest value"},
};
struct QuantileColumn {
  const char* name;
  double Quantile::*value;
  const char* description;
};
constexpr QuantileColumn quantile_columns[] = {
    {"quantiles", &Quantile::value, "values below which the probabilities lie"},
    {"quantiles_low", &Quantile::low, "lower end of their interval of 95 %"},
    {"quantiles_high", &Quantile::high, "upper end"},
};
struct IndexColumn {
  const char* name;
  double SobolIndex::*value;
  const char* description;
};
constexpr IndexColumn index_columns[] = {
    {"sobol_first", &SobolIndex::first, "share of the variance that each parameter has alone"},
    {"sobol_first_error", &SobolIndex::first_error, "its standard error"},
    {"sobol_total", &SobolIndex::total, "share of the variance that each parameter has with all others"},
    {"sobol_total_error", &SobolIndex::total_error, "its standard error"},
};

void write_quantity(const SweepStatistics& statistics, std::size_t q, io::ResultWriter& writer) {
  const auto& [path, unit, description] = statistics.quantities[q];
  const auto of = [q](const CaseGroup& group) -> const QuantityStatistics& { return group.quantities[q]; };
  for (const SpreadColumn& column : spread_columns)
    write(writer, statistics, path + "/" + column.name, unit, std::string(column.description) + ": " + description,
          [&](const CaseGroup& group) { return of(group).spread.*column.value; });
  for (const QuantileColumn& column : quantile_columns)
    write(writer, statistics, path + "/" + column.name, unit, column.description, statistics.probabilities.size(),
          [&](const CaseGroup& group, std::size_t k) { return of(group).spread.quantiles[k].*column.value; });
  if (!statistics.has_indices) return;
  for (const IndexColumn& column : index_columns)
    write(writer, statistics, path + "/" + column.name, "-", column.description, statistics.parameters.size(),
          [&](const CaseGroup& group, std::size_t k) { return of(group).indices[k].*column.value; });
}

} // namespace

void write_statistics(const SweepStatistics& statistics, io::ResultWriter& writer) {
  const auto add_line = [](std::string& lines, const std::string& line) {
    lines.append(lines.empty() ? "" : "\n").append(line);
  };
  std::string parameters, quantities, texts;
  for (const std::string& name : statistics.parameters) add_line(parameters, name);
  for (const SweepQuantity& quantity : statistics.quantities) add_line(quantities, quantity.path);
  writer.attribute("/", "parameters", parameters);
  writer.attribute("/", "quantities", quantities);
  writer.array("probabilities", statistics.probabilities, "-", "of the quantiles");
  write(writer, statistics, "cases", "-", "cases of each group",
        [](const CaseGroup& group) { return static_cast<double>(group.cases); });
  for (int code = 1; !to_string(static_cast<Status>(code)).empty(); ++code) {
    const std::string status(to_string(static_cast<Status>(code)));
    write(writer, statistics, "shares/" + status, "-", "share of the cases with this status",
          [&](const CaseGroup& group) {
            const auto found = group.statuses.find(status);
            const std::size_t cases = found == group.statuses.end() ? 0 : found->second;
            return static_cast<double>(cases) / static_cast<double>(group.cases);
          });
  }
  if (!statistics.group_by.empty()) {
    writer.attribute("/", "group_by", statistics.group_by);
    for (const CaseGroup& group : statistics.groups) add_line(texts, group.text);
    if (statistics.group_unit.empty())
      writer.text("groups", texts, "value of " + statistics.group_by + " in each group, a line each");
    else
      write(writer, statistics, "groups", statistics.group_unit, "value of " + statistics.group_by + " in each group",
            [](const CaseGroup& group) { return group.number; });
  }
  for (std::size_t q = 0; q < statistics.quantities.size(); ++q) write_quantity(statistics, q, writer);
}

} // namespace microslip::campaign
