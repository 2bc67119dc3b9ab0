#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/quantity_table.hpp"
#include "app/tables.hpp"
#include "campaign/sweep_statistics.hpp"
#include "io/json_result.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct StatisticsArguments {
  fs::path input, folder;
  campaign::StatisticsOptions options;
  bool json = false, no_pictures = false;
};

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

/// Heading of a group's tables, and how many of its cases are left out.
std::string title_of(const campaign::SweepStatistics& statistics, const campaign::CaseGroup& group) {
  std::string title = fmt::format("{} cases", group.cases);
  if (!statistics.group_by.empty())
    title = fmt::format("{} = {}, {}", statistics.group_by,
                        statistics.group_unit.empty() ? group.text
                                                      : fmt::format("{:.6g} {}", group.number, statistics.group_unit),
                        title);
  for (const auto& [status, cases] : group.statuses)
    title += fmt::format(", {} {} ({}) left out", cases, status,
                         percent(static_cast<double>(cases) / static_cast<double>(group.cases)));
  return title;
}

void print_spreads(const campaign::SweepStatistics& statistics, const campaign::CaseGroup& group) {
  std::vector<std::string> heads = {"mean", "deviation"};
  for (const double p : statistics.probabilities) heads.push_back(percent(p));
  QuantityTable table(title_of(statistics, group), heads);
  for (std::size_t q = 0; q < statistics.quantities.size(); ++q) {
    const campaign::Spread& spread = group.quantities[q].spread;
    if (spread.count == 0) continue;
    std::vector<double> values = {spread.mean, spread.standard_deviation};
    for (const campaign::Quantile& quantile : spread.quantiles) values.push_back(quantile.value);
    table.add(statistics.quantities[q].path, values, statistics.quantities[q].unit);
  }
  table.print();
}

void print_indices(const campaign::SweepStatistics& statistics, const campaign::CaseGroup& group) {
  QuantityTable table("Sobol's indices: shares of the variance, with standard errors", {"alone", "in all"});
  for (std::size_t q = 0; q < statistics.quantities.size(); ++q)
    for (std::size_t k = 0; k < statistics.parameters.size(); ++k) {
      const campaign::SobolIndex& index = group.quantities[q].indices[k];
      if (std::isnan(index.first)) continue; // which nothing varies
      table.add(fmt::format("{} by {}", statistics.quantities[q].path, statistics.parameters[k]),
                std::vector<std::string>{fmt::format("{:.3f} +- {:.3f}", index.first, index.first_error),
                                         fmt::format("{:.3f} +- {:.3f}", index.total, index.total_error)});
    }
  table.print();
}

io::Provenance provenance_of(const StatisticsArguments& arguments, const campaign::SweepStatistics& statistics) {
  return {.kind = campaign::statistics_kind,
          .title = statistics.title,
          .command_line = command_line(),
          .case_file = arguments.input.string(),
          .case_text = {}};
}

std::vector<std::string> write_files(const StatisticsArguments& arguments,
                                     const campaign::SweepStatistics& statistics) {
  if (arguments.folder.empty()) return {};
  const fs::path path = arguments.folder / io::result_name;
  io::create_folder(arguments.folder);
  io::ResultFile file(path, provenance_of(arguments, statistics));
  campaign::write_statistics(statistics, file);
  file.commit();
  std::vector<std::string> files = {path.string()};
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

void run(const StatisticsArguments& arguments) {
  if (!arguments.folder.empty()) {
    io::require_other_file(arguments.folder / io::result_name, arguments.input);
    io::require_writable_file_in(arguments.folder, io::result_name);
  }
  const campaign::SweepStatistics statistics = campaign::sweep_statistics(arguments.input, arguments.options);
  if (!arguments.json)
    for (const campaign::CaseGroup& group : statistics.groups) {
      print_spreads(statistics, group);
      if (statistics.has_indices) print_indices(statistics, group);
    }
  const std::vector<std::string> files = write_files(arguments, statistics);
  if (!arguments.json) return print_files(files);
  io::JsonResult result(provenance_of(arguments, statistics), io::JsonFields::kept);
  campaign::write_statistics(statistics, result);
  io::Json document = result.document();
  document["files"] = files;
  print_json(document);
}

constexpr const char* footer =
    R"(Of each quantity, over the cases whose status is ok: mean, standard deviation and quantiles, each with its interval
of 95 % in the files and with --json; of a sample with aim = "sobol_indices" also the share of its variance that each
parameter has alone and together with all others. Pictures: quantiles, over --group-by as bands, and the shares.

Example:
  microslip sweep examples/load_spread.toml -o spread.h5
  microslip statistics spread.h5 --quantity fx --quantity peak_pressure -o results/spread)";

} // namespace

void add_statistics_command(Command& program) {
  Command command = program.add_subcommand(
      "statistics", "Means, quantiles, shares of failures and sensitivities of the cases of a sweep", footer);
  StatisticsArguments& arguments = command.arguments(run);
  command.add_option("SWEEP.h5", arguments.input, "result file of `sweep`").required();
  command
      .add_option("--quantity NAME", arguments.options.quantities,
                  "a quantity, fx or contact/fx; may be given again; default: all")
      .expected(1)
      .take_all();
  command
      .add_option("--quantiles P...", arguments.options.probabilities,
                  "probabilities of the quantiles, between 0 and 1; default: 0.05 0.5 0.95")
      .expected(1, 100);
  command.add_option("--group-by KEY", arguments.options.group_by,
                     "a key that varies over at most 1000 values: statistics for each of them");
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for result.h5 and pictures; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write result.h5 only");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
