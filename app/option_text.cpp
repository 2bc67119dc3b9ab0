#include "app/option_text.hpp"

namespace microslip::app {

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

std::vector<std::string> dashed_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const auto& name : option.get_snames()) names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<const CLI::Option*> named_options(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<const CLI::Option*> positional_arguments(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::string usage(const CLI::Option& argument) {
  const auto name = argument.get_name(true) + (argument.get_expected_max() > 1 ? "..." : "");
  return argument.get_required() ? name : "[" + name + "]";
}

std::vector<const CLI::App*> commands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_positional() || !takes_value(*option) ? "" : " " + value_name(*option);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return description(*option);
}

} // namespace microslip::app
