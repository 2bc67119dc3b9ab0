#include "app/completion.hpp"

#include "app/init.hpp"
#include "app/option_text.hpp"
#include "io/option_words.hpp"
#include "validation/study.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

using Words = std::vector<std::string>;

/// What may stand for a value.
struct Candidates {
  enum class Kind { none, words, files, folders } kind = Kind::none;
  Words words = {};
  std::string ending = {}; ///< of the files
};

Words study_names() {
  Words names;
  for (const auto& study : validation::studies()) names.emplace_back(study.name);
  return names;
}

Candidates candidates(const CLI::Option& option) {
  const auto value = value_name(option);
  if (value == "EXAMPLE") {
    const auto names = example_names();
    return {.kind = Candidates::Kind::words, .words = Words(names.begin(), names.end())};
  }
  if (value == "STUDY") return {.kind = Candidates::Kind::words, .words = study_names()};
  if (value == "FOLDER") return {.kind = Candidates::Kind::folders};
  if (value.find('|') != std::string::npos)
    return {.kind = Candidates::Kind::words, .words = CLI::detail::split(value, '|')};
  const auto dot = value.find('.');
  if (dot != std::string::npos) return {.kind = Candidates::Kind::files, .ending = value.substr(dot + 1)};
  return {};
}

Words names_of(const std::vector<const CLI::Option*>& options) {
  Words names;
  for (const auto* option : options)
    for (const auto& name : dashed_names(*option)) names.push_back(name);
  return names;
}

Words names_of(const std::vector<const CLI::App*>& commands) {
  Words names;
  for (const auto* command : commands) names.push_back(command->get_name());
  return names;
}

// bash

constexpr auto bash_begin = R"(# Completion of microslip in bash, made by `microslip completion bash`.
_microslip_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word")
}
_microslip_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -X "!*.$1" -- "$word"; compgen -d -- "$word")
}
_microslip_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
_microslip() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= i
  # bash takes --option=value as three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} != -* ]]; then
      command=${COMP_WORDS[i]}
      break
    fi
  done
  COMPREPLY=()
  case "$command $before" in
)";

constexpr auto bash_end = R"(      esac ;;
  esac
}
complete -F _microslip microslip
)";

std::string in_bash(const Candidates& candidates) {
  switch (candidates.kind) {
  case Candidates::Kind::words:
    return fmt::format("_microslip_words '{}'", fmt::join(candidates.words, " "));
  case Candidates::Kind::files:
    return "_microslip_files " + candidates.ending;
  case Candidates::Kind::folders:
    return "_microslip_folders";
  default:
    return ":";
  }
}

std::string bash_values(const CLI::App& command) {
  std::string script;
  for (const auto* option : named_options(command)) {
    if (!takes_value(*option)) continue;
    Words patterns;
    for (const auto& name : dashed_names(*option)) patterns.push_back("'" + command.get_name() + " " + name + "'");
    script += fmt::format("    {}) {} ;;\n", fmt::join(patterns, " | "), in_bash(candidates(*option)));
  }
  return script;
}

std::string bash_words(const CLI::App& command) {
  auto script = fmt::format("        '{} '-*) _microslip_words '{}' ;;\n", command.get_name(),
                            fmt::join(names_of(named_options(command)), " "));
  for (const auto* argument : positional_arguments(command))
    script += fmt::format("        '{} '*) {} ;;\n", command.get_name(), in_bash(candidates(*argument)));
  return script;
}

std::string bash_script(const CLI::App& program) {
  std::string script = bash_begin;
  for (const auto* command : commands(program)) script += bash_values(*command);
  script += "    *)\n      case \"$command $word\" in\n";
  for (const auto* command : commands(program)) script += bash_words(*command);
  script += fmt::format("        ' '-*) _microslip_words '{}' ;;\n", fmt::join(names_of(named_options(program)), " "));
  script += fmt::format("        ' '*) _microslip_words '{}' ;;\n", fmt::join(names_of(commands(program)), " "));
  return script + bash_end;
}

// zsh

constexpr auto zsh_begin = R"(#compdef microslip
# Completion of microslip in zsh, made by `microslip completion zsh`.
_microslip() {
  local curcontext=$curcontext state line
  typeset -A opt_args
)";

constexpr auto zsh_end = R"(  esac
}
if [[ $funcstack[1] == _microslip ]]; then
  _microslip "$@"
else
  compdef _microslip microslip
fi
)";

std::string zsh_quoted(const std::string& text) {
  return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'";
}

/// Escapes the characters that _arguments and _describe interpret.
std::string zsh_text(std::string text) {
  for (const auto* mark : {"\\", "[", "]", ":"})
    text = CLI::detail::find_and_replace(text, mark, "\\" + std::string(mark));
  return text;
}

std::string in_zsh(const Candidates& candidates) {
  switch (candidates.kind) {
  case Candidates::Kind::words:
    return fmt::format("({})", fmt::join(candidates.words, " "));
  case Candidates::Kind::files:
    return "_files -g \"*." + candidates.ending + "\"";
  case Candidates::Kind::folders:
    return "_files -/";
  default:
    return " ";
  }
}

/// `--name[what]:VALUE:candidates` for each of its names; one excludes the others unless it may be given again.
std::string zsh_option(const CLI::Option& option) {
  const bool again = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll && takes_value(option) &&
                     option.get_expected_max() == 1;
  const auto names = dashed_names(option);
  std::string script;
  for (const auto& name : names) {
    auto text = again ? "*" : fmt::format("({})", fmt::join(names, " "));
    text += name;
    if (takes_value(option)) text += name.starts_with("--") ? "=" : "+";
    text.append("[").append(zsh_text(description(option))).append("]");
    for (int i = 0; takes_value(option) && i < option.get_items_expected_min(); ++i)
      text += ":" + zsh_text(value_name(option)) + ":" + in_zsh(candidates(option));
    script += " \\\n        " + zsh_quoted(text);
  }
  return script;
}

std::string zsh_argument(const CLI::Option& argument) {
  const auto place = argument.get_expected_max() > 1 ? "*" : "1";
  return " \\\n        " +
         zsh_quoted(place + (":" + zsh_text(argument.get_name(true)) + ":") + in_zsh(candidates(argument)));
}

std::string zsh_script(const CLI::App& program) {
  std::string script = zsh_begin;
  script += "  local -a commands=(\n";
  for (const auto* command : commands(program))
    script += "    " + zsh_quoted(command->get_name() + ":" + zsh_text(command->get_description())) + "\n";
  script += "  )\n  _arguments -C";
  for (const auto* option : named_options(program)) script += zsh_option(*option);
  script += " \\\n        '1: :->command' '*:: :->arguments' && return\n";
  script += "  if [[ $state == command ]]; then\n    _describe -t commands command commands\n    return\n  fi\n";
  script += "  curcontext=${curcontext%:*:*}:microslip-$words[1]:\n  case $words[1] in\n";
  for (const auto* command : commands(program)) {
    script += "    " + command->get_name() + ")\n      _arguments";
    for (const auto* option : named_options(*command)) script += zsh_option(*option);
    for (const auto* argument : positional_arguments(*command)) script += zsh_argument(*argument);
    script += " ;;\n";
  }
  return script + zsh_end;
}

// fish

std::string fish_quoted(const std::string& text) {
  return "'" + CLI::detail::find_and_replace(CLI::detail::find_and_replace(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string in_fish(const Candidates& candidates) {
  switch (candidates.kind) {
  case Candidates::Kind::words:
    return fmt::format(" -a '{}'", fmt::join(candidates.words, " "));
  case Candidates::Kind::files:
    return " -k -a '(__fish_complete_suffix ." + candidates.ending + ")'";
  case Candidates::Kind::folders:
    return " -a '(__fish_complete_directories)'";
  default:
    return "";
  }
}

std::string fish_option(const CLI::Option& option) {
  std::string script;
  for (const auto& name : option.get_snames()) script += " -s " + name;
  for (const auto& name : option.get_lnames()) script += " -l " + name;
  if (takes_value(option)) script += " -x" + in_fish(candidates(option));
  return script + " -d " + fish_quoted(description(option)) + "\n";
}

std::string fish_script(const CLI::App& program) {
  std::string script =
      "# Completion of microslip in fish, made by `microslip completion fish`.\ncomplete -c microslip -f\n";
  const std::string first = "complete -c microslip -n __fish_use_subcommand";
  for (const auto* option : named_options(program)) script += first + fish_option(*option);
  for (const auto* command : commands(program))
    script += first + " -a " + command->get_name() + " -d " + fish_quoted(command->get_description()) + "\n";
  for (const auto* command : commands(program)) {
    const auto after = "complete -c microslip -n '__fish_seen_subcommand_from " + command->get_name() + "'";
    for (const auto* option : named_options(*command)) script += after + fish_option(*option);
    for (const auto* argument : positional_arguments(*command)) script += after + in_fish(candidates(*argument)) + "\n";
  }
  return script;
}

struct Shell {
  std::string_view name;
  std::string (*script)(const CLI::App& program);
};

constexpr std::array<Shell, 3> shells = {{{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}}};

void print_completion(const CLI::App& program, const std::string& word) {
  std::vector<std::string_view> names;
  names.reserve(shells.size());
  for (const auto& shell : shells) names.push_back(shell.name);
  io::require_word("SHELL", word, names);
  const auto shell = std::find_if(shells.begin(), shells.end(), [&](const Shell& s) { return s.name == word; });
  fmt::print("{}", shell->script(program));
}

} // namespace

void add_completion_command(CLI::App& program) {
  auto* command = program.add_subcommand("completion", "Print a script that completes commands and options in a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->type_name("bash|zsh|fish");
  command->footer(
      "cmake --install puts the scripts where the shells look for them; without it, load one where the shell starts:\n"
      "~/.bashrc, ~/.zshrc or ~/.config/fish/config.fish.\n\n"
      "Example:\n  source <(microslip completion bash)\n  microslip completion fish | source");
  command->callback([&program, shell] { print_completion(program, *shell); });
}

} // namespace microslip::app
