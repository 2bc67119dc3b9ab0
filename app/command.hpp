#pragma once

#include <functional>
#include <memory>
#include <string>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
class Option;
} // namespace CLI

namespace microslip::app {

/// An option or an argument of a command while it is declared. Like Command it hides the parser's templates, which take
/// seconds to compile wherever they are seen.
class CommandOption {
public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  CommandOption& required();
  /// Sets the number of values that follow it.
  CommandOption& expected(int count);
  CommandOption& expected(int fewest, int most);
  /// All values count where it is given again.
  CommandOption& take_all();
  /// The default as texts say it; that of the variable as it is now.
  CommandOption& default_str(const std::string& text);
  CommandOption& capture_default_str();
  CommandOption& needs(const CommandOption& other);
  CommandOption& excludes(const std::string& name);

private:
  CLI::Option* option_;
};

/// The program or one of its commands while it is declared. What it refers to must outlive the parsing.
class Command {
public:
  explicit Command(CLI::App& command) : command_(&command) {}

  /// `footer`: what help and man page say at the end, with an example.
  Command add_subcommand(const std::string& name, const std::string& what, const std::string& footer = "");
  /// `names`: "-o,--output FOLDER", with what stands instead of its value in texts, see OptionText; or the name of an
  /// argument, "FILE". For texts, paths and numbers, several of them, and some that need not be there: the list is in
  /// command.cpp.
  template <class Value> CommandOption add_option(const std::string& names, Value& value, const std::string& what);
  CommandOption add_flag(const std::string& name, bool& value, const std::string& what);
  void footer(const std::string& text);
  void callback(std::function<void()> run);
  /// Arguments for `run`, which live as long as the command.
  template <class Arguments> Arguments& arguments(void (*run)(const Arguments& arguments)) {
    const auto kept = std::make_shared<Arguments>();
    callback([kept, run] { run(*kept); });
    return *kept;
  }
  /// Adds arguments of a command whose `run` returns the exit code.
  template <class Arguments> Arguments& arguments(int& exit_code, int (*run)(const Arguments& arguments)) {
    const auto kept = std::make_shared<Arguments>();
    callback([kept, run, &exit_code] { exit_code = run(*kept); });
    return *kept;
  }
  void require_subcommand(int count);

  const CLI::App& parser() const { return *command_; }

private:
  CLI::App* command_;
};

} // namespace microslip::app
