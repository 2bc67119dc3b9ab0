#pragma once

#include "io/option_words.hpp"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {

/// The words of an option as its type name shows them, e.g. "parabolic|elliptic".
template <class Option> std::string choices() {
  return fmt::format("{}", fmt::join(io::option_words<Option>(), "|"));
}

/// Text of an option in help, man page and shell completion. The type name of an option, or the name of an argument
/// without one, tells what stands there: choices as above, FOLDER, STUDY (a study of `validate`), a file with its
/// ending such as CASE.toml, or anything else.
bool takes_value(const CLI::Option& option);
std::string value_name(const CLI::Option& option);
/// Description, and its default or that it is required.
std::string description(const CLI::Option& option);
/// Its names with their dashes, short ones first; empty for an argument without.
std::vector<std::string> dashed_names(const CLI::Option& option);
std::vector<const CLI::Option*> named_options(const CLI::App& command);
std::vector<const CLI::Option*> positional_arguments(const CLI::App& command);
/// Form of an argument in a usage line, e.g. "CASE.toml" or "[STUDY...]".
std::string usage(const CLI::Option& argument);
std::vector<const CLI::App*> commands(const CLI::App& program);

/// Help with these texts.
class HelpFormatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

} // namespace microslip::app
