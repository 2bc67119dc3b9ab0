#pragma once

#include "io/option_words.hpp"

#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace CLI {
class App;
class FormatterBase;
} // namespace CLI

namespace microslip::app {

/// The words of an option as its type name shows them, e.g. "parabolic|elliptic".
template <class Option> std::string choices() {
  return fmt::format("{}", fmt::join(io::option_words<Option>(), "|"));
}

/// Text of an option or an argument in help, man page and shell completion.
struct OptionText {
  std::vector<std::string> dashed_names; ///< with their dashes, short ones first; none of an argument
  std::string name;                      ///< of an argument
  /// Value, its type name or its own name: choices as above, FOLDER, STUDY (a study of `validate`), a file
  /// with its ending such as CASE.toml, or anything else. Empty: it takes no value.
  std::string value_name;
  std::string description; ///< what it is, and its default or that it is required
  bool is_required = false;
  bool is_repeatable = false;             ///< may be given again, with one value each time
  int fewest_values = 0, most_values = 0; ///< that follow it

  bool takes_value() const { return !value_name.empty(); }
  /// Argument in a usage line, e.g. "CASE.toml" or "[STUDY...]".
  std::string usage() const;
};

/// A command, or the program with its commands.
struct CommandText {
  std::string name, description, footer;
  std::vector<OptionText> options, arguments;
  std::vector<CommandText> commands;
};

CommandText command_text(const CLI::App& command);

/// Formatter of help with these texts.
std::shared_ptr<CLI::FormatterBase> help_formatter();

} // namespace microslip::app
