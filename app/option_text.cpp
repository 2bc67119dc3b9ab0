#include "app/option_text.hpp"

#include <CLI/CLI.hpp>

namespace microslip::app {
namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

std::string value_name(const CLI::Option& option) {
  const auto type = option.get_type_name();
  return type.empty() ? option.get_name(true) : type;
}

std::string description(const CLI::Option& option) {
  auto text = option.get_description();
  if (!option.get_default_str().empty()) text += "; default: " + option.get_default_str();
  if (option.get_required() && !option.get_positional()) text += "; required";
  return text;
}

class HelpFormatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_positional() || !takes_value(*option) ? "" : " " + value_name(*option);
  }

  std::string make_option_desc(const CLI::Option* option) const override { return description(*option); }
};

OptionText option_text(const CLI::Option& option) {
  OptionText text;
  for (const auto& name : option.get_snames()) text.dashed_names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) text.dashed_names.push_back("--" + name);
  text.name = option.get_name(true);
  if (takes_value(option)) text.value_name = value_name(option);
  text.description = description(option);
  text.is_required = option.get_required();
  text.is_repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll && text.takes_value() &&
                       option.get_expected_max() == 1;
  text.fewest_values = option.get_items_expected_min();
  text.most_values = option.get_expected_max();
  return text;
}

} // namespace

std::string OptionText::usage() const {
  const auto values = name + (most_values > 1 ? "..." : "");
  return is_required ? values : "[" + values + "]";
}

CommandText command_text(const CLI::App& command) {
  CommandText text = {.name = command.get_name(),
                      .description = command.get_description(),
                      .footer = command.get_footer(),
                      .options = {},
                      .arguments = {},
                      .commands = {}};
  for (const auto* option : command.get_options())
    (option->nonpositional() ? text.options : text.arguments).push_back(option_text(*option));
  for (const auto* one : command.get_subcommands([](const CLI::App*) { return true; }))
    text.commands.push_back(command_text(*one));
  return text;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

} // namespace microslip::app
