#include "app/bench_comparison.hpp"

#include "app/bench_rows.hpp"
#include "io/input_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// The line with a name; nullptr if there is none.
const io::Json* line_of(const io::Json& document, const std::string& name) {
  const io::Json& rows = document.at("rows");
  const auto found = std::ranges::find_if(rows, [&](const io::Json& row) { return row.at("name") == name; });
  return found == rows.end() ? nullptr : &*found;
}

bool has_times(const io::Json& document) {
  if (!document.is_object() || !document.contains("rows") || !document["rows"].is_array()) return false;
  return std::ranges::all_of(document["rows"], [](const io::Json& row) {
    return row.is_object() && row.contains("name") && row["name"].is_string() && row.contains("seconds") &&
           row["seconds"].is_number() && row["seconds"].get<double>() > 0;
  });
}

std::string origin_of(const io::Json& document) {
  const auto text = [&](const char* key) { return document.value(key, std::string("?")); };
  return fmt::format("microslip {}, commit {}, {}", text("version"), text("commit"), text("machine"));
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

} // namespace

io::Json read_bench(const std::filesystem::path& path) {
  std::ifstream file = io::open_input(path);
  io::Json document = io::Json::parse(file, nullptr, false);
  if (!has_times(document))
    throw Error(path.string() + ": not what `microslip bench --json` prints: lines with a time");
  return document;
}

void add_comparison(io::Json& document, const io::Json& older) {
  for (io::Json& row : document["rows"])
    if (const io::Json* before = line_of(older, row["name"])) {
      const double then = before->at("seconds"), now = row["seconds"];
      row.update(io::Json{{"before", then}, {"new_over_old", now / then}});
    }
}

void print_comparison(const io::Json& compared, const io::Json& older) {
  fmt::print("old: {}\nnew: {}\n\n{:<42}{:>10}{:>10}{:>11}\n", origin_of(older), origin_of(compared), "a contact",
             "old", "new", "new / old");
  std::vector<double> ratios;
  for (const io::Json& row : compared.at("rows")) {
    const std::string name = row["name"], now = time_text(row["seconds"]);
    if (!row.contains("before")) {
      fmt::print("{:<42}{:>10}{:>10}\n", name, "-", now);
      continue;
    }
    ratios.push_back(row["new_over_old"]);
    fmt::print("{:<42}{:>10}{:>10}{:>11.2f}\n", name, time_text(row["before"]), now, ratios.back());
  }
  for (const io::Json& row : older.at("rows"))
    if (!line_of(compared, row["name"]))
      fmt::print("{:<42}{:>10}{:>10}\n", row["name"].get<std::string>(), time_text(row["seconds"]), "-");
  if (!ratios.empty()) fmt::print("\nmedian of {} ratios {:.2f}\n", ratios.size(), median(ratios));
}

} // namespace microslip::app
