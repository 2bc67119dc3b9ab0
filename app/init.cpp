#include "app/init.hpp"

#include "example_case.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace microslip {
namespace {

struct InitArguments {
  std::filesystem::path file = "case.toml";
  bool force = false;
};

void init(const InitArguments& arguments) {
  std::error_code ignored;
  if (!arguments.force && std::filesystem::exists(std::filesystem::symlink_status(arguments.file, ignored)))
    throw Error(arguments.file.string() + ": is there already; --force replaces it");
  OutputFile file(arguments.file);
  file.write(example_case);
  file.commit();
  fmt::print("{}\n", arguments.file.string());
}

} // namespace

void add_init_command(CLI::App& program) {
  auto* command = program.add_subcommand("init", "Write an annotated case file to start from");
  const auto arguments = std::make_shared<InitArguments>();
  command->add_option("CASE.toml", arguments->file, "name of the case file")->type_name("")->capture_default_str();
  command->add_flag("--force", arguments->force, "replace a file of that name");
  command->footer(
      "The case file is one of two bodies by their radii, with every key, its unit, range and default in a comment;\n"
      "examples/wheel_on_rail.toml is such a file of a wheel on a rail by their profiles.\n\n"
      "Example:\n  microslip init wheel.toml && microslip solve wheel.toml");
  command->callback([arguments] { init(*arguments); });
}

} // namespace microslip
