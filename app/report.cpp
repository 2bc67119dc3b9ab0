#include "app/commands.hpp"

#include "app/case_run.hpp"
#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/json_document.hpp"
#include "app/python_module.hpp"
#include "app/result_tables.hpp"
#include "app/sweep.hpp"
#include "io/case_origin.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  fs::path case_file, output;
  std::string template_file, purpose, date;
  bool json = false;
};

constexpr const char* module = "microslip.report";

/// Throws Error with the module's message, or with what Python lacks.
void run_module(const std::vector<std::string>& arguments) {
  const PythonRun run = run_python_module(module, arguments);
  if (run.code == 0) return;
  if (const std::string text = run.said_of_input(module); !text.empty()) throw Error(text);
  const std::string why = run.code < 0           ? std::generic_category().message(-run.code)
                          : run.messages.empty() ? fmt::format("it ended with code {}", run.code)
                                                 : run.messages.back();
  throw Error(fmt::format("the report cannot be made by {}: {}", python(), why));
}

/// Value of an input as text, and its unit.
class InputText {
public:
  explicit InputText(std::string unit) : unit_(std::move(unit)) {}

  std::pair<std::string, std::string> operator()(double value) const { return (*this)(std::vector{value}); }
  std::pair<std::string, std::string> operator()(const std::string& value) const { return {value, ""}; }
  std::pair<std::string, std::string> operator()(const std::vector<double>& values) const {
    const auto [name, factor] = readable_unit(unit_, values);
    std::vector<std::string> texts;
    texts.reserve(values.size());
    for (const double value : values) texts.push_back(fmt::format("{:.6g}", factor * value));
    return {fmt::format("{}", fmt::join(texts, ", ")), std::string(name)};
  }
  std::pair<std::string, std::string> operator()(const std::vector<std::string>& values) const {
    return {fmt::format("{}", fmt::join(values, ", ")), ""};
  }

private:
  std::string unit_;
};

/// What was read of a case: names, values with units, texts of the table, and the lines of the file where they stand.
io::Json inputs_json(const io::ReadInputs& inputs, const description::InputTable& table, const std::string& case_text,
                     const std::string& name) {
  const auto lines = io::value_lines(case_text, name);
  io::Json rows = io::Json::array();
  for (const auto& [path, read] : inputs) {
    const std::size_t end = path.rfind('.'); // of the section's name
    const description::Input* input =
        end == std::string::npos ? table.find("", path) : table.find(path.substr(0, end), path.substr(end + 1));
    if (input == nullptr || (input->is_state && !read.is_given) || path == "title") continue;
    const auto [value, unit] = std::visit(InputText(read.unit), read.value);
    const auto line = lines.find(path);
    rows.push_back({{"name", path},
                    {"value", value},
                    {"unit", unit},
                    {"text", input->text},
                    {"line", read.is_given && line != lines.end() ? io::Json(line->second) : io::Json()}});
  }
  return rows;
}

const description::InputTable& inputs_of(const io::RollingCase&) {
  return description::rolling_inputs();
}
const description::InputTable& inputs_of(const io::WheelRailCase&) {
  return description::wheel_inputs();
}
const description::InputTable& inputs_of(const io::WheelsetCase&) {
  return description::wheelset_inputs();
}

/// The beginning of the document that the module makes the report of: the case's files and what the user says.
io::Json document_of(const ReportArguments& arguments, const std::string& kind) {
  io::Json document = json_document(kind);
  document["case_file"] = arguments.case_file.string();
  document["purpose"] = arguments.purpose;
  document["date"] = arguments.date;
  for (const fs::path& file : io::files_of_case(arguments.case_file)) document["files"].push_back(file.string());
  return document;
}

/// Makes the report of a document and a result file.
void write(const ReportArguments& arguments, io::Json document, const fs::path& result_file) {
  document["result_file"] = result_file.string();
  io::OutputFile text(fs::path(arguments.output).replace_extension(".json")), report(arguments.output);
  text.write(io::json_text(document));
  run_module({text.temporary().string(), "--output", report.temporary().string(), "--format",
              arguments.output.extension().string().substr(1), "--template", arguments.template_file});
  report.commit();
}

struct Outcome {
  bool is_ok = true;
  std::vector<std::string> warnings;
};

template <class Input>
Outcome report_case(const ReportArguments& arguments, const Input& input, const std::string& text) {
  const std::string name = arguments.case_file.string();
  const auto result = solve_with_progress(input, arguments.case_file.filename().string());
  const io::Provenance provenance = {.kind = cases::kind_of(input),
                                     .title = input.title,
                                     .command_line = command_line(),
                                     .case_file = name,
                                     .case_text = text};
  io::Json document = document_of(arguments, provenance.kind);
  document["title"] = input.title;
  document["theory"] = io::to_word(input.method.theory);
  document["inputs"] = inputs_json(input.inputs, inputs_of(input), text, name);
  document["status"] = to_string(result.status);
  document["reason"] = result.reason;
  document["warnings"] = result.warnings;
  for (const ResultTable& table : result_tables(input, result))
    document["tables"].push_back(std::visit([](const auto& one) { return one.json(); }, table));
  with_result_file(
      arguments.output, [&](const fs::path& file) { cases::write_result(input, result, provenance, file); },
      [&](const fs::path& file) { write(arguments, document, file); });
  return {result.status == Status::ok, result.warnings};
}

Outcome report_sweep([[maybe_unused]] const ReportArguments& arguments) {
#ifdef _WIN32
  throw Error(arguments.case_file.string() + ": is a sweep, which this system does not have");
#else
  const io::Json document = document_of(arguments, "sweep");
  const auto count =
      run_sweep(arguments.case_file, arguments.output, [&](const fs::path& file) { write(arguments, document, file); });
  return {count.failed == 0, count.warnings};
#endif
}

/// Throws Error unless the report can be made: said before long work.
void require_possible(const ReportArguments& arguments) {
  const std::string ending = arguments.output.extension().string();
  if (ending != ".html" && ending != ".pdf")
    throw Error(arguments.output.string() + ": a report's name must end with .html or .pdf");
  io::require_other_file(arguments.output, arguments.case_file);
  io::require_writable_file_in(arguments.output.parent_path(), arguments.output.filename());
  run_module({"--check", "--format", ending.substr(1), "--template", arguments.template_file});
}

int report(const ReportArguments& arguments) {
  const std::string text = io::read_case_text(arguments.case_file), name = arguments.case_file.string();
  require_possible(arguments);
  if (arguments.output.has_parent_path()) io::create_folder(arguments.output.parent_path());
  const Outcome outcome =
      io::is_sweep(text, name)
          ? report_sweep(arguments)
          : with_case(text, name, [&](const auto& input) { return report_case(arguments, input, text); });
  if (arguments.json) {
    io::Json document = json_document("report");
    document["files"] = {arguments.output.string()};
    document["warnings"] = outcome.warnings;
    print_json(document);
  } else {
    print_files({arguments.output.string()});
  }
  print_warnings(name, outcome.warnings);
  return outcome.is_ok ? ExitCode::done : ExitCode::not_met;
}

constexpr const char* footer =
    R"(Solves a case, or the cases of a sweep, and writes what an engineer files: inputs with the lines of the file that
they come from, method and its limits, results, errors, checks of equilibrium and energy, pictures, warnings, and the
SHA-256 of each file that was read. HTML is one file. PDF needs the Debian package weasyprint. There is no time in
it unless --date, or SOURCE_DATE_EPOCH, gives one: the same inputs make the same file. A template (Jinja2) extends
report.html, see the page "Tables and reports". Exit code 1: not converged, which the report says, too.

Example:
  microslip report examples/hertzian_contact.toml -o contact.pdf --purpose "Check of the braking force")";

} // namespace

void add_report_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand("report", "Solve a case and write a report of it: HTML or PDF", footer);
  ReportArguments& arguments = command.arguments(exit_code, report);
  command.add_option("CASE.toml", arguments.case_file, "case file of solve, or file of sweep").required();
  command.add_option("-o,--output REPORT", arguments.output, "name that ends with .html or .pdf").required();
  command.add_option("--purpose TEXT", arguments.purpose, "what the report is for, below its title");
  command.add_option("--date DATE", arguments.date, "date on it; default: that of SOURCE_DATE_EPOCH, else none");
  command.add_option("--template FILE.html", arguments.template_file, "head, foot and style of a company");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
