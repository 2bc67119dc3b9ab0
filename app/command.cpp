#include "app/command.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace microslip::app {

CommandOption& CommandOption::required() {
  option_->required();
  return *this;
}

CommandOption& CommandOption::expected(int count) {
  option_->expected(count);
  return *this;
}

CommandOption& CommandOption::expected(int fewest, int most) {
  option_->expected(fewest, most);
  return *this;
}

CommandOption& CommandOption::take_all() {
  option_->take_all();
  return *this;
}

CommandOption& CommandOption::default_str(const std::string& text) {
  option_->default_str(text);
  return *this;
}

CommandOption& CommandOption::capture_default_str() {
  option_->capture_default_str();
  return *this;
}

CommandOption& CommandOption::needs(const CommandOption& other) {
  option_->needs(other.option_);
  return *this;
}

CommandOption& CommandOption::excludes(const std::string& name) {
  option_->excludes(name);
  return *this;
}

Command Command::add_subcommand(const std::string& name, const std::string& what, const std::string& footer) {
  CLI::App* command = command_->add_subcommand(name, what);
  command->footer(footer); // else it would be that of the program
  return Command(*command);
}

template <class Value>
CommandOption Command::add_option(const std::string& names, Value& value, const std::string& what) {
  const std::size_t end = std::min(names.find(' '), names.size());
  CLI::Option* option = command_->add_option(names.substr(0, end), value, what);
  option->type_name(end < names.size() ? names.substr(end + 1) : "");
  return CommandOption(*option);
}

template CommandOption Command::add_option(const std::string&, std::string&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::filesystem::path&, const std::string&);
template CommandOption Command::add_option(const std::string&, int&, const std::string&);
template CommandOption Command::add_option(const std::string&, double&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::optional<int>&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::optional<double>&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::optional<std::filesystem::path>&,
                                           const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<double>&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<std::filesystem::path>&, const std::string&);

CommandOption Command::add_flag(const std::string& name, bool& value, const std::string& what) {
  return CommandOption(*command_->add_flag(name, value, what));
}

void Command::footer(const std::string& text) {
  command_->footer(text);
}

void Command::callback(std::function<void()> run) {
  command_->callback(std::move(run));
}

void Command::require_subcommand(int count) {
  command_->require_subcommand(count);
}

} // namespace microslip::app
