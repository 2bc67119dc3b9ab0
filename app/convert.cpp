#include "app/convert.hpp"

#include "app/interrupt.hpp"
#include "io/contact_toml.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

struct ConvertArguments {
  fs::path input, folder = "results";
};

/// Letters that need no care in a TOML string.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) result += c >= ' ' && c != '"' && c != '\\' && c != '\x7f' ? c : '_';
  return result;
}

void save(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

int convert(const ConvertArguments& arguments) {
  const InterruptGuard guard;
  std::error_code ignored;
  if (fs::is_directory(arguments.input, ignored))
    throw Error(arguments.input.string() + ": cannot be read: it is a folder");
  std::ifstream input(arguments.input, std::ios::binary);
  if (!input) throw Error(arguments.input.string() + ": cannot be read: " + std::generic_category().message(errno));
  ContactInputReader reader(input, arguments.input.string());
  create_folder(arguments.folder);
  const std::string name = arguments.input.stem().string();
  int refused = 0;
  while (const ContactCase* c = reader.next()) {
    InterruptGuard::throw_if_interrupted();
    try {
      const auto path = arguments.folder / fmt::format("{}.{:04}.toml", name, c->number);
      save(path, to_toml(*c, fmt::format("{}, case {}", plain(name), c->number)));
      fmt::print("{}\n", path.string());
    } catch (const Error& error) {
      ++refused;
      fmt::print(stderr, "microslip: warning: {}:{}: case {} is not written: {}\n", arguments.input.string(), c->line,
                 c->number, error.what());
    }
  }
  return refused == 0 ? 0 : 1;
}

} // namespace

void add_convert_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("convert", "Write the cases of an input file of the program CONTACT as TOML");
  const auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("FILE.inp", arguments->input, "input file, module 3")->required();
  command->add_option("-o,--output", arguments->folder, "folder for FILE.0001.toml, ...")->capture_default_str();
  command->footer(
      "Writes a case file for microslip solve for each case that is a contact of its own with an elliptic area. Cases\n"
      "that go on from others, and other areas, are named; microslip run runs them. Exit code 1: some are not "
      "written.\n\n"
      "Example:\n  microslip convert examples/sphere_on_plane.inp -o results");
  command->callback([arguments, &exit_code] { exit_code = convert(*arguments); });
}

} // namespace microslip
