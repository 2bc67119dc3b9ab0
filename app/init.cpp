#include "app/init.hpp"

#include "app/commands.hpp"
#include "app/input_list.hpp"
#include "examples.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view case_ending = ".toml";

struct InitArguments {
  fs::path file = "case.toml";
  std::string example = "hertzian_contact";
  std::string keys = {}; ///< of which kind of inputs they are printed
  bool force = false;
};

void print_keys(const std::string& kind) {
  io::require_word("--keys", kind, description::input_kinds);
  fmt::print("{}", input_list(description::inputs_of(kind)));
}

std::string_view text_of(std::string_view name) {
  const auto found = std::find_if(examples.begin(), examples.end(), [&](const auto& one) { return one.name == name; });
  return found->text;
}

void write(const fs::path& path, std::string_view text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
  fmt::print("{}\n", path.string());
}

void require_free(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored)))
    throw Error(file.string() + ": is there already; --force replaces it");
}

/// Returns whether an example's text has a key with the other's name as its value.
bool is_named(std::string_view text, const ExampleFile& other) {
  const auto found = text.find("= \"" + std::string(other.name) + '"');
  return found != std::string_view::npos && text[text.rfind('\n', found) + 1] != '#'; // comments name some, too
}

/// The examples that an example needs beside it, with what these need in their turn.
void add_needed(std::string_view text, std::vector<std::string_view>& names) {
  for (const ExampleFile& other : examples) {
    if (!is_named(text, other) || std::find(names.begin(), names.end(), other.name) != names.end()) continue;
    names.push_back(other.name);
    add_needed(other.text, names);
  }
}

bool has_text(const fs::path& path, std::string_view text) {
  std::ifstream file(path, std::ios::binary);
  return file && std::string((std::istreambuf_iterator<char>(file)), {}) == text;
}

void init(const InitArguments& arguments) {
  if (!arguments.keys.empty()) return print_keys(arguments.keys);
  const auto known = example_names();
  if (std::find(known.begin(), known.end(), arguments.example) == known.end())
    throw Error("--example = \"" + arguments.example + "\": must be " + io::listed(known, "or") +
                io::suggestion(arguments.example, known));
  const std::string_view text = text_of(arguments.example + std::string(case_ending));
  std::vector<std::string_view> needed;
  add_needed(text, needed);
  const fs::path folder = arguments.file.parent_path();
  if (!arguments.force) require_free(arguments.file);
  // One that is there as it is written here stays.
  std::erase_if(needed, [&](std::string_view name) { return has_text(folder / name, text_of(name)); });
  if (!arguments.force)
    for (const auto name : needed) require_free(folder / name);
  for (const auto name : needed) {
    if (const fs::path path = folder / name; path.has_parent_path()) io::create_folder(path.parent_path());
    write(folder / name, text_of(name));
  }
  write(arguments.file, text);
}

} // namespace

std::vector<std::string_view> example_names() {
  std::vector<std::string_view> names;
  for (const ExampleFile& example : examples)
    if (example.name.ends_with(case_ending))
      names.push_back(example.name.substr(0, example.name.size() - case_ending.size()));
  return names;
}

constexpr const char* footer =
    R"(There are hertzian_contact, a case of two bodies by their radii, and wheel_on_rail, of a wheel on a rail by
their profiles, both with every key, its unit, range and default in a comment; further two_rollers,
rubber_roller, coated_roller, twin_disc, starting_to_roll, friction_of_ones_own, lateral_sweep, wheelset_in_curve; and
creep_sweep and wheel_rail_sample for `microslip sweep`.
Profiles, tables and case files that an example names are written beside it.

Example:
  microslip init wheel.toml && microslip solve wheel.toml
  microslip init --example wheel_on_rail rail.toml && microslip solve rail.toml)";

void add_init_command(Command& program) {
  Command command = program.add_subcommand("init", "Write an annotated case file to start from", footer);
  InitArguments& arguments = command.arguments(init);
  command.add_option("CASE.toml", arguments.file, "name of the case file").capture_default_str();
  command.add_option("--example EXAMPLE", arguments.example, "which example it is").capture_default_str();
  command.add_option(fmt::format("--keys {}", fmt::join(description::input_kinds, "|")), arguments.keys,
                     "print the keys of case files, of files of sweeps, or the options of conicity and table make, in "
                     "place of writing a case: unit, default, range and meaning of each");
  command.add_flag("--force", arguments.force, "replace files of these names");
}

} // namespace microslip::app
