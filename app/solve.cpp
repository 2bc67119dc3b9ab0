#include "app/commands.hpp"

#include "app/case_run.hpp"
#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/json_document.hpp"
#include "app/measured_points.hpp"
#include "app/pictures.hpp"
#include "app/result_tables.hpp"
#include "app/tables.hpp"
#include "cases/case_document.hpp"
#include "io/csv_tables.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct SolveArguments {
  fs::path case_file;
  fs::path output; ///< a folder, or the name of a table
  fs::path points; ///< measured ones, of two bodies
  bool no_pictures = false, json = false;
};

// Input is a RollingCase, a WheelRailCase or a WheelsetCase, Result what solve_case makes of it.

template <class Input>
io::Provenance provenance_of(const SolveArguments& arguments, const Input& input, const std::string& case_text) {
  return {.kind = cases::kind_of(input),
          .title = input.title,
          .command_line = command_line(),
          .case_file = arguments.case_file.string(),
          .case_text = case_text};
}

/// Files of a result, those that say all of it first.
struct WrittenFiles {
  std::vector<std::string> results, pictures;
};

/// Writes result.h5 into the folder, and the pictures; or the tables.
template <class Input, class Result>
WrittenFiles write(const SolveArguments& arguments, const Input& input, const Result& result,
                   const io::Provenance& provenance) {
  const bool is_table = io::is_csv(arguments.output);
  const fs::path folder = is_table ? arguments.output.parent_path() : arguments.output;
  if (!folder.empty()) io::create_folder(folder);
  const auto write_file = [&](const fs::path& path) { cases::write_result(input, result, provenance, path); };
  std::vector<std::string> results = {(folder / io::result_name).string()};
  if (is_table)
    results = write_tables(arguments.output, write_file);
  else
    write_file(results.front());
  InterruptGuard::throw_if_interrupted();
  if (!arguments.json) print_files(results);
  const bool is_drawn = !is_table && !arguments.no_pictures;
  return {results, is_drawn ? draw_pictures(results.front(), folder) : std::vector<std::string>()};
}

template <class Input, class Result>
void print_document(const Input& input, const Result& result, const io::Provenance& provenance,
                    const WrittenFiles& files, const std::vector<campaign::ComparedCurve>& comparison) {
  io::Json document = cases::case_document(input, result, provenance);
  if (!comparison.empty()) document["measured_points"] = comparison_document(deviations_of(comparison));
  document["files"] = files.results;
  for (const std::string& picture : files.pictures) document["files"].push_back(picture);
  print_json(document);
}

/// Pictures that lie in the folder and were not drawn now show another case.
void warn_of_old_pictures(const fs::path& folder, const std::vector<std::string>& drawn) {
  std::vector<std::string> old;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = (folder / entry.path().filename()).string();
    if (entry.path().extension() == ".png" && std::find(drawn.begin(), drawn.end(), name) == drawn.end())
      old.push_back(entry.path().filename().string());
  }
  if (old.empty()) return;
  std::sort(old.begin(), old.end());
  fmt::print(stderr, "microslip: warning: {}: older than result.h5: {}\n", folder.string(), fmt::join(old, ", "));
}

/// The case beside measured points, if there are any.
template <class Input>
std::vector<campaign::ComparedCurve> compare(const SolveArguments& arguments, const Input& input) {
  if (arguments.points.empty()) return {};
  if (io::is_csv(arguments.output)) throw Error("--points: needs a folder as output");
  if constexpr (std::is_same_v<Input, io::RollingCase>) return compare_with_points(input, arguments.points);
  throw Error(std::string("--points: is for ") + instead_of_wheel);
}

/// Writes and draws a case beside measured points.
void add_comparison(const SolveArguments& arguments, const std::vector<campaign::ComparedCurve>& curves,
                    const io::Provenance& provenance, WrittenFiles& files) {
  const fs::path written = write_comparison(curves, provenance, arguments.output);
  files.pictures.push_back(written.string());
  if (arguments.no_pictures) return;
  for (const auto& picture : draw_pictures(written, arguments.output)) files.pictures.push_back(picture);
}

/// Throws Error unless the output can be written: said before long work.
void require_writable(const fs::path& output) {
  if (io::is_csv(output))
    io::require_writable_file_in(output.parent_path(), output.filename());
  else
    io::require_writable_file_in(output, io::result_name);
}

template <class Input> int solve(const SolveArguments& arguments, const Input& input, const std::string& text) {
  require_writable(arguments.output);
  const auto comparison = compare(arguments, input);
  const auto result = solve_with_progress(input, arguments.case_file.filename().string());
  if (!arguments.json) print_tables(input.title, result_tables(input, result));
  if (!comparison.empty() && !arguments.json) fmt::print("{}\n\n", comparison_text(deviations_of(comparison)));
  const io::Provenance provenance = provenance_of(arguments, input, text);
  WrittenFiles files = write(arguments, input, result, provenance);
  if (!comparison.empty()) add_comparison(arguments, comparison, provenance, files);
  if (arguments.json)
    print_document(input, result, provenance, files, comparison);
  else
    print_files(files.pictures);
  if (!io::is_csv(arguments.output)) warn_of_old_pictures(arguments.output, files.pictures);
  print_warnings(arguments.case_file.string(), result.warnings);
  if (result.status == Status::ok) return ExitCode::done;
  fmt::print(stderr, "microslip: warning: {}: {}\n", arguments.case_file.string(), result.reason);
  return ExitCode::not_met;
}

int solve(const SolveArguments& given) {
  SolveArguments arguments = given;
  if (arguments.output.empty()) arguments.output = fs::path("results") / arguments.case_file.stem();
  const auto text = io::read_case_text(arguments.case_file);
  const auto name = arguments.case_file.string();
  return with_case(text, name, [&](const auto& input) { return solve(arguments, input, text); });
}

constexpr const char* footer =
    R"(Of a wheel on a rail ([track], [rail], [wheelset], [wheel]) finds the patches between the profiles and solves
each. Prints the forces on the wheel in track axes and a column for each patch, or a row for each state of a
[sweep]; with side = "both" those of a wheelset with its height, roll and rolling speed. Of two bodies with
radii ([body1], [body2]) solves Hertz's problem and then the theory that the file
asks for; FASTSIM2 stands beside the exact theory and a creep-force table. Prints forces on body 1, the moment,
areas and the frictional power, in units that fit. Writes result.h5 (SI) and pictures, or with -o NAME.csv all
numbers as tables: NAME.csv and, of fields, patches and curves, NAME.GROUP.csv. With --json the numbers of
result.h5 but its fields, by the names that they have there, and their units. Exit code 1: not converged.

Example:
  microslip solve examples/wheel_on_rail.toml -o results/wheel)";

} // namespace

void add_solve_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand(
      "solve", "Solve a wheel on a rail or a Hertzian contact: forces, fields and pictures", footer);
  auto& arguments = command.arguments<SolveArguments>(exit_code, solve);
  command.add_option("CASE.toml", arguments.case_file, "case file (microslip init writes one)").required();
  command.add_option("-o,--output FOLDER", arguments.output,
                     "folder for result.h5 and the pictures, or NAME.csv for tables; default: results/NAME for "
                     "NAME.toml");
  command.add_option("--points POINTS.csv", arguments.points,
                     "measured creep curves as of `fit`, beside those of a case of two bodies, with rms and bias");
  command.add_flag("--no-pictures", arguments.no_pictures, "write result.h5 only");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
