#include "app/commands.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/tables.hpp"
#include "compat/contact/toml.hpp"
#include "io/csv_tables.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/vtk_surfaces.hpp"
#include "microslip/error.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ConvertArguments {
  fs::path input, output;
  bool json = false;
};

/// Letters that need no care in a TOML string.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) result += c >= ' ' && c != '"' && c != '\\' && c != '\x7f' ? c : '_';
  return result;
}

void save(const fs::path& path, const std::string& text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

void print_document(const ConvertArguments& arguments, const io::Json& written, const io::Json& refused) {
  auto document = json_document("convert");
  document["input"] = arguments.input.string();
  document["files"] = written;
  document["cases_not_written"] = refused;
  print_json(document);
}

int convert_result(const ConvertArguments& arguments) {
  const fs::path output =
      arguments.output.empty() ? fs::path(arguments.input).replace_extension(".csv") : arguments.output;
  if (!io::is_csv(output) && !io::is_vtk(output))
    throw Error(output.string() + ": needs a name that ends with .csv, for tables, or .vtp, for surfaces with fields");
  std::vector<std::string> names;
  for (const fs::path& file : io::is_csv(output) ? io::write_csv_tables(arguments.input, output)
                                                 : io::write_vtk_surfaces(arguments.input, output))
    names.push_back(file.string());
  if (arguments.json)
    print_document(arguments, names, io::Json::array());
  else
    print_files(names);
  return ExitCode::done;
}

int convert_cases(const ConvertArguments& arguments) {
  std::ifstream input = io::open_input(arguments.input);
  contact_program::InputReader reader(input, arguments.input.string());
  const fs::path folder = arguments.output.empty() ? "results" : arguments.output;
  io::create_folder(folder);
  const std::string name = arguments.input.stem().string();
  auto written = io::Json::array(), refused = io::Json::array();
  while (const contact_program::Case* c = reader.next()) {
    InterruptGuard::throw_if_interrupted();
    try {
      const auto path = folder / fmt::format("{}.{:04}.toml", name, c->number);
      save(path, contact_program::to_toml(*c, fmt::format("{}, case {}", plain(name), c->number)));
      written.push_back(path.string());
      if (!arguments.json) fmt::print("{}\n", path.string());
    } catch (const Error& error) {
      refused.push_back({{"case", c->number}, {"line", c->line}, {"reason", error.what()}});
      fmt::print(stderr, "microslip: warning: {}:{}: case {} is not written: {}\n", arguments.input.string(), c->line,
                 c->number, error.what());
    }
  }
  if (arguments.json) print_document(arguments, written, refused);
  return refused.empty() ? ExitCode::done : ExitCode::not_met;
}

int convert(const ConvertArguments& arguments) {
  return arguments.input.extension() == ".h5" ? convert_result(arguments) : convert_cases(arguments);
}

constexpr const char* footer =
    R"(Of a result file (.h5) of any command writes all numbers as tables of CSV, as exactly as they are: NAME.csv with a
row for each case or number, and NAME.GROUP.csv for patches, fields and curves; or its fields as surfaces for ParaView,
NAME.GROUP.vtp for each contact. Of an input file of the program CONTACT writes a case file for microslip solve for
each case that is an independent contact with an elliptic area. Cases that go on from others, and other areas, are
named; microslip run runs them. Exit code 1: some are not written.

Example:
  microslip convert results/wheel/result.h5 -o wheel.csv
  microslip convert results/wheel/result.h5 -o wheel.vtp
  microslip convert examples/sphere_on_plane.inp -o results)";

} // namespace

void add_convert_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand(
      "convert", "Write a result file as tables (CSV) or surfaces (VTK), or cases of the program CONTACT as TOML",
      footer);
  ConvertArguments& arguments = command.arguments(exit_code, convert);
  command.add_option("FILE", arguments.input, "result file (.h5), or input file of module 3").required();
  command.add_option(
      "-o,--output PATH", arguments.output,
      "NAME.csv or NAME.vtp; default: FILE.csv beside FILE.h5. Of cases the folder for FILE.0001.toml, ...; default: "
      "results");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
