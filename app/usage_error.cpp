#include "app/usage_error.hpp"

#include "io/nearest_word.hpp"

#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace microslip::app {
namespace {

std::vector<std::string_view> views(const std::vector<std::string>& words) {
  return {words.begin(), words.end()};
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const auto* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// CLI11's words, except for a value that its option does not take: all but texts are numbers.
std::string described(const CLI::ParseError& error) {
  constexpr std::string_view not_converted = "Could not convert: ";
  const std::string text = error.what();
  if (!text.starts_with(not_converted)) return text;
  return text.substr(not_converted.size()) + ": must be a number";
}

} // namespace

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  const auto& command = chosen.empty() ? program : *chosen.front();
  const auto help = "; see microslip " + (chosen.empty() ? "" : command.get_name() + " ") + "--help";
  const auto unexpected = program.remaining(true);
  if (unexpected.empty()) return described(error) + help;
  const auto& word = unexpected.front();
  const bool is_option = word.starts_with("-");
  if (!is_option && !chosen.empty()) return "unexpected argument " + io::printable(word) + help;
  const auto known = is_option ? option_names(command) : command_names(program);
  const auto near = io::suggestion(word, views(known));
  return (is_option ? "unknown option " : "unknown command ") + io::printable(word) + (near.empty() ? help : near);
}

} // namespace microslip::app
