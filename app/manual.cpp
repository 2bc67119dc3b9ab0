#include "app/commands.hpp"

#include "app/exit_code.hpp"
#include "app/option_text.hpp"
#include "microslip/version.hpp"

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// Text as roff takes it, with the characters that a reader may copy as they are.
std::string roff(const std::string& text) {
  static const std::map<char, const char*> escapes = {
      {'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'^', "\\(ha"},
      {'~', "\\(ti"}, {'`', "\\(ga"}, {'|', "|\\:"}}; // where a long list of words may be broken
  std::string result = text.starts_with('.') ? "\\&" : "";
  for (const char letter : text) {
    const auto escape = escapes.find(letter);
    if (escape != escapes.end())
      result += escape->second;
    else
      result += letter;
  }
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A footer's paragraphs, and its example as it is.
std::string footer(const std::string& text) {
  const std::string before_example = "Example:\n";
  const auto example = text.find(before_example);
  std::string page;
  for (const auto& line : lines_of(text.substr(0, example))) page += line.empty() ? ".P\n" : roff(line) + "\n";
  if (example == std::string::npos) return page;
  page += page.ends_with(".P\n") ? "" : ".P\n";
  page += "Example:\n.P\n.EX\n";
  for (const auto& line : lines_of(text.substr(example + before_example.size()))) page += roff(line) + "\n";
  return page + ".EE\n";
}

std::string option(const OptionText& option) {
  std::string head;
  for (const auto& name : option.dashed_names) head += (head.empty() ? "" : ", ") + bold(name);
  if (head.empty())
    head = italic(option.name);
  else if (option.takes_value())
    head += " " + italic(option.value_name);
  return ".TP\n" + head + "\n" + roff(option.description) + "\n";
}

std::string command(const CommandText& command) {
  auto page = ".SS \"" + roff("microslip " + command.name + " [OPTIONS]");
  for (const OptionText& argument : command.arguments) page += " " + roff(argument.usage());
  page += "\"\n" + roff(command.description) + ".\n";
  for (const OptionText& argument : command.arguments) page += option(argument);
  for (const OptionText& named : command.options) page += option(named);
  return page + ".P\n" + footer(command.footer);
}

constexpr auto description_text =
    R"(microslip computes the forces, tractions and slip between two bodies that roll over each other with dry friction, by
the simplified theory (FASTSIM, FASTSIM2) and by the exact theory of elastic half-spaces. Files are in SI units; what
is printed for people has its unit beside it. Forces act on body 1.
.P
A file appears when it is complete, or not at all. Long work shows a progress bar on standard error if that is a
terminal. Errors and warnings are text on standard error, also with \fB\-\-json\fR.
)";

constexpr auto json_text_of_manual =
    R"(With \fB\-\-json\fR a command prints one JSON document on standard output and nothing else: \fIkind\fR, the program's
\fIversion\fR, \fIcommit\fR, \fIcompiler\fR and \fIbuild_type\fR, the \fIcommand_line\fR, what was computed, and the
\fIfiles\fR that were written. Numbers of result files have the names of the groups and datasets there and SI units;
\fIunits\fR has the unit of each by its path. Numbers that are not finite are the words "inf", "\-inf" and "nan". An error
leaves standard output empty; its text is on standard error and the exit status is that below.
)";

constexpr auto environment =
    R"(.TP
MICROSLIP_PYTHON
The Python that draws the pictures; it needs h5py, matplotlib and numpy. Default: the one found when the program was
built.
.TP
OMP_NUM_THREADS
Threads of a single large solution by the exact theory. Default: one for each processor.
)";

std::string manual(const CommandText& program) {
  auto page = fmt::format(".TH MICROSLIP 1 \"\" \"microslip {}\" \"User Commands\"\n", build_info().version);
  page += ".SH NAME\nmicroslip \\- frictional rolling contact of two bodies\n";
  page += ".SH SYNOPSIS\n\\fBmicroslip\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n";
  page += std::string(".SH DESCRIPTION\n") + description_text;
  page += ".SH OPTIONS\n";
  for (const OptionText& named : program.options) page += option(named);
  page += ".SH COMMANDS\n";
  for (const CommandText& one : program.commands) page += command(one);
  page += std::string(".SH JSON\n") + json_text_of_manual;
  page += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_code_meanings) page += fmt::format(".TP\n{}\n{}\n", code, roff(meaning));
  return page + ".SH ENVIRONMENT\n" + environment;
}

constexpr const char* manual_footer =
    R"(The man page has all commands with their options, the exit codes and the environment. It is installed with the
program, for man microslip.

Example:
  microslip manual | man -l -)";

} // namespace

void add_manual_command(Command& program) {
  Command command = program.add_subcommand("manual", "Print the man page of this program", manual_footer);
  command.callback([&program] { fmt::print("{}", manual(command_text(program.parser()))); });
}

} // namespace microslip::app
