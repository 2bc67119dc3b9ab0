#include "app/validate.hpp"

#include "app/child_process.hpp"
#include "app/json_document.hpp"
#include "io/program_files.hpp"
#include "microslip/error.hpp"

#include <system_error>

namespace microslip::app {

int go_on_as_studies() {
  std::filesystem::path file = io::program_file();
  file.replace_filename("microslip-validate" + file.extension().string());
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw Error("the studies are not built: " + file.string() + " is missing; tools/build makes it from the sources");
  const int code = go_on_as(file);
  if (code < 0) throw Error(file.string() + " cannot be started: " + std::generic_category().message(-code));
  return code;
}

int run_studies_program(const ValidateArguments&) {
  return go_on_as_studies();
}

constexpr const char* footer =
    R"(Runs studies that compute what has been published and print both, each figure with its unit. With --json a
list of the same figures, as they are printed. Exit code: 0 all figures are as stated: met, or within a
known limit that a page of the documentation explains; 1 some are not; 2 bad input.

Example:
  microslip validate model-problem -o results)";

void add_validate_command(Command& program, int& exit_code, int (*run)(const ValidateArguments& arguments)) {
  Command command = program.add_subcommand("validate", "Print computed figures beside published ones", footer);
  ValidateArguments& arguments = command.arguments(exit_code, run);
  command.add_option("STUDY", arguments.names, "studies to run; default: all");
  command.add_flag("--list", arguments.list, "print the names of the studies and what they show");
  command.add_option("-o,--output FOLDER", arguments.output, "folder for the result files and the pictures")
      .capture_default_str();
  command.add_option("--cases FOLDER", arguments.cases,
                     "contact: folder of CONTACT's input files, with its output FILE.ref_out beside each FILE.inp");
  command.add_option("--threads COUNT", arguments.threads, "threads, 1 to 1024; default: one for each processor");
  command.add_flag(
      "--thorough", arguments.thorough,
      "do in full what studies sample: wheel-rail sweeps all displacements with the exact theory, for 20 minutes");
  command.add_flag("--no-pictures", arguments.no_pictures, "write the result files only");
  add_json_flag(command, arguments.json);
  command
      .add_option("--report FOLDER", arguments.report,
                  "write a report to be signed into this folder, validation.html, and as PDF where Chromium is at\n"
                  "hand: a verdict on each clause, all figures and pictures, digests; result files, too")
      .excludes("--json")
      .excludes("--output");
  command.add_option("--purpose TEXT", arguments.purpose, "what the report is for, besides what it says of itself");
}

} // namespace microslip::app
