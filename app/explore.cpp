#include "app/commands.hpp"

#include "app/child_process.hpp"
#include "io/case_file.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/profile_file.hpp"
#include "io/profile_formats.hpp"
#include "io/program_files.hpp"
#include "io/toml_section.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/error.hpp"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ExploreArguments {
  std::vector<fs::path> files;
  fs::path page;
  bool no_browser = false;
};

/// The profiles that a case names, by the names that it gives them.
io::Json profiles_of(const std::string& text, const fs::path& file) {
  const toml::table table = io::parse_toml(text, file.string());
  io::Json files = io::Json::object();
  for (const std::string_view section : io::profile_sections)
    if (const auto name = table[section]["profile"].value<std::string>();
        name && !io::names_standard(io::profile_path(file.parent_path(), *name)))
      files[*name] = io::read_profile_text(file.parent_path() / *name);
  return files;
}

/// A case with its profiles; Error where the reader refuses it.
io::Json start_of_case(const fs::path& file) {
  const std::string text = io::read_case_text(file), name = file.string();
  if (io::is_wheelset_case(text, name))
    throw Error(name + ": the explorer has one wheel on its rail: wheel.side = \"left\" or \"right\"");
  if (!io::is_wheel_rail_case(text, name)) {
    (void)io::parse_case(text, name);
    return {{"case", text}};
  }
  (void)io::parse_wheel_rail_case(text, name);
  return {{"case", text}, {"files", profiles_of(text, file)}};
}

/// A case, or profiles.
io::Json start_of(const std::vector<fs::path>& files) {
  if (files.size() == 1 && files[0].extension() == ".toml") return start_of_case(files[0]);
  io::Json profiles = io::Json::object();
  for (const fs::path& file : files) {
    (void)io::read_profile(file);
    profiles[file.filename().string()] = io::read_profile_text(file);
  }
  return {{"files", profiles}};
}

/// Address by RFC 8089: file:///home/me/a.html, file:///C:/a.html.
std::string file_address(const fs::path& file) {
  const std::u8string path = fs::absolute(file).generic_u8string();
  std::string address = path.starts_with(u8'/') ? "file://" : "file:///";
  for (const char8_t letter : path) {
    const bool is_plain =
        std::isalnum(letter) || std::string_view("/-._~:").find(static_cast<char>(letter)) != std::string_view::npos;
    address += is_plain ? std::string(1, static_cast<char>(letter)) : fmt::format("%{:02X}", unsigned(letter));
  }
  return address;
}

/// A page that leads to the explorer's with what it starts with in the link, which is too long for a command line.
std::string leading_page(const std::string& page, const io::Json& start) {
  std::string json = io::Json(io::json_text(start)).dump(); // as a text of JavaScript, which ends no script element
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return fmt::format("<!doctype html><meta charset=\"utf-8\"><title>microslip explorer</title><script>\n"
                     "const bytes = new TextEncoder().encode({});\n"
                     "let text = \"\";\n"
                     "for (const byte of bytes) text += String.fromCharCode(byte);\n"
                     "location.replace({} + \"#case.\" + btoa(text));\n</script>\n",
                     json, io::Json(page).dump());
}

void explore(const ExploreArguments& arguments) {
  const fs::path page = io::explorer_page();
  if (!fs::exists(page)) throw Error(page.string() + ": the explorer's page is not there; tools/explorer builds it");
  std::string address = file_address(page);
  if (!arguments.files.empty()) {
    io::OutputFile file(arguments.page);
    const io::Json start = start_of(arguments.files);
    file.write(leading_page(address, start));
    file.commit();
    address = file_address(arguments.page);
  }
  fmt::print("{}\n", address);
  if (arguments.no_browser) return;
  if (!open_in_browser(address))
    fmt::print(stderr, "microslip: no browser could be started: open the address above in one\n");
}

constexpr const char* footer = R"(The page computes by itself, without a server or a network.

Example:
  microslip explore examples/wheel_on_rail.toml)";

} // namespace

void add_explore_command(Command& program) {
  Command command = program.add_subcommand(
      "explore", "Open the explorer, a page to see and feel rolling contact, in a browser", footer);
  ExploreArguments& arguments = command.arguments(explore);
  arguments.page = "explorer.html";
  const CommandOption file = command.add_option(
      "FILE", arguments.files, "a case file (.toml), or profiles of a wheel and a rail, to start with");
  command
      .add_option("-o,--output PAGE.html", arguments.page,
                  "page that leads to the explorer with FILE, to keep or to send")
      .needs(file)
      .capture_default_str();
  command.add_flag("--no-browser", arguments.no_browser, "print the address only");
}

} // namespace microslip::app
