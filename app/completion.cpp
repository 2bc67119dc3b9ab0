#include "app/commands.hpp"

#include "app/init.hpp"
#include "app/option_text.hpp"
#include "io/option_words.hpp"
#include "io/text_line.hpp"
#include "validation/study_texts.hpp"

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

/// Candidates for a value.
struct Candidates {
  enum class Kind { none, words, files, folders } kind = Kind::none;
  Words words = {};
  std::string ending = {}; ///< of the files
};

std::string replaced(const std::string& text, std::string_view what, std::string_view by) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_here = text.compare(at, what.size(), what) == 0;
    result += is_here ? by : std::string_view(text).substr(at, 1);
    at += is_here ? what.size() : 1;
  }
  return result;
}

Words study_names() {
  Words names;
  for (const auto& study : validation::study_texts) names.emplace_back(study.name);
  return names;
}

Candidates candidates(const OptionText& option) {
  const std::string& value = option.value_name;
  if (value == "EXAMPLE") {
    const auto names = example_names();
    return {.kind = Candidates::Kind::words, .words = Words(names.begin(), names.end())};
  }
  if (value == "STUDY") return {.kind = Candidates::Kind::words, .words = study_names()};
  if (value == "FOLDER") return {.kind = Candidates::Kind::folders};
  if (value.find('|') != std::string::npos) {
    const auto words = io::parts_of(value, '|');
    return {.kind = Candidates::Kind::words, .words = Words(words.begin(), words.end())};
  }
  const auto dot = value.find('.');
  if (dot != std::string::npos) return {.kind = Candidates::Kind::files, .ending = value.substr(dot + 1)};
  return {};
}

/// Text that lists them for a shell: `words` and `files` have braces for these words and this ending.
std::string said(const Candidates& candidates, const char* words, const char* files, const char* folders,
                 const char* none) {
  switch (candidates.kind) {
  case Candidates::Kind::words:
    return fmt::format(fmt::runtime(words), fmt::join(candidates.words, " "));
  case Candidates::Kind::files:
    return fmt::format(fmt::runtime(files), candidates.ending);
  case Candidates::Kind::folders:
    return folders;
  default:
    return none;
  }
}

Words names_of(const std::vector<OptionText>& options) {
  Words names;
  for (const OptionText& option : options)
    names.insert(names.end(), option.dashed_names.begin(), option.dashed_names.end());
  return names;
}

Words names_of(const std::vector<CommandText>& commands) {
  Words names;
  for (const CommandText& command : commands) names.push_back(command.name);
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
  return said(candidates, "_microslip_words '{}'", "_microslip_files {}", "_microslip_folders", ":");
}

std::string bash_values(const CommandText& command) {
  std::string script;
  for (const OptionText& option : command.options) {
    if (!option.takes_value()) continue;
    Words patterns;
    for (const auto& name : option.dashed_names) patterns.push_back("'" + command.name + " " + name + "'");
    script += fmt::format("    {}) {} ;;\n", fmt::join(patterns, " | "), in_bash(candidates(option)));
  }
  return script;
}

std::string bash_words(const CommandText& command) {
  auto script = fmt::format("        '{} '-*) _microslip_words '{}' ;;\n", command.name,
                            fmt::join(names_of(command.options), " "));
  for (const OptionText& argument : command.arguments)
    script += fmt::format("        '{} '*) {} ;;\n", command.name, in_bash(candidates(argument)));
  return script;
}

std::string bash_script(const CommandText& program) {
  std::string script = bash_begin;
  for (const CommandText& command : program.commands) script += bash_values(command);
  script += "    *)\n      case \"$command $word\" in\n";
  for (const CommandText& command : program.commands) script += bash_words(command);
  script += fmt::format("        ' '-*) _microslip_words '{}' ;;\n", fmt::join(names_of(program.options), " "));
  script += fmt::format("        ' '*) _microslip_words '{}' ;;\n", fmt::join(names_of(program.commands), " "));
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
  return "'" + replaced(text, "'", "'\\''") + "'";
}

/// Escapes the characters that _arguments and _describe interpret.
std::string zsh_text(std::string text) {
  for (const auto* mark : {"\\", "[", "]", ":"}) text = replaced(text, mark, "\\" + std::string(mark));
  return text;
}

std::string in_zsh(const Candidates& candidates) {
  return said(candidates, "({})", "_files -g \"*.{}\"", "_files -/", " ");
}

/// `--name[what]:VALUE:candidates` for each of its names; one excludes the others unless it may be given again.
std::string zsh_option(const OptionText& option) {
  const Words& names = option.dashed_names;
  std::string script;
  for (const auto& name : names) {
    auto text = option.is_repeatable ? "*" : fmt::format("({})", fmt::join(names, " "));
    text += name;
    if (option.takes_value()) text += name.starts_with("--") ? "=" : "+";
    text.append("[").append(zsh_text(option.description)).append("]");
    for (int i = 0; option.takes_value() && i < option.fewest_values; ++i)
      text += ":" + zsh_text(option.value_name) + ":" + in_zsh(candidates(option));
    script += " \\\n        " + zsh_quoted(text);
  }
  return script;
}

std::string zsh_argument(const OptionText& argument) {
  const auto place = argument.most_values > 1 ? "*" : "1";
  return " \\\n        " + zsh_quoted(place + (":" + zsh_text(argument.name) + ":") + in_zsh(candidates(argument)));
}

std::string zsh_script(const CommandText& program) {
  std::string script = zsh_begin;
  script += "  local -a commands=(\n";
  for (const CommandText& command : program.commands)
    script += "    " + zsh_quoted(command.name + ":" + zsh_text(command.description)) + "\n";
  script += "  )\n  _arguments -C";
  for (const OptionText& option : program.options) script += zsh_option(option);
  script += " \\\n        '1: :->command' '*:: :->arguments' && return\n";
  script += "  if [[ $state == command ]]; then\n    _describe -t commands command commands\n    return\n  fi\n";
  script += "  curcontext=${curcontext%:*:*}:microslip-$words[1]:\n  case $words[1] in\n";
  for (const CommandText& command : program.commands) {
    script += "    " + command.name + ")\n      _arguments";
    for (const OptionText& option : command.options) script += zsh_option(option);
    for (const OptionText& argument : command.arguments) script += zsh_argument(argument);
    script += " ;;\n";
  }
  return script + zsh_end;
}

// fish

std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string in_fish(const Candidates& candidates) {
  return said(candidates, " -a '{}'", " -k -a '(__fish_complete_suffix .{})'", " -a '(__fish_complete_directories)'",
              "");
}

std::string fish_option(const OptionText& option) {
  std::string script;
  for (const auto& name : option.dashed_names)
    script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_value()) script += " -x" + in_fish(candidates(option));
  return script + " -d " + fish_quoted(option.description) + "\n";
}

std::string fish_script(const CommandText& program) {
  std::string script =
      "# Completion of microslip in fish, made by `microslip completion fish`.\ncomplete -c microslip -f\n";
  const std::string first = "complete -c microslip -n __fish_use_subcommand";
  for (const OptionText& option : program.options) script += first + fish_option(option);
  for (const CommandText& command : program.commands)
    script += first + " -a " + command.name + " -d " + fish_quoted(command.description) + "\n";
  for (const CommandText& command : program.commands) {
    const auto after = "complete -c microslip -n '__fish_seen_subcommand_from " + command.name + "'";
    for (const OptionText& option : command.options) script += after + fish_option(option);
    for (const OptionText& argument : command.arguments) script += after + in_fish(candidates(argument)) + "\n";
  }
  return script;
}

struct Shell {
  std::string_view name;
  std::string (*script)(const CommandText& program);
};

constexpr std::array<Shell, 3> shells = {{{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}}};

void print_completion(const CommandText& program, const std::string& word) {
  std::vector<std::string_view> names;
  names.reserve(shells.size());
  for (const auto& shell : shells) names.push_back(shell.name);
  io::require_word("SHELL", word, names);
  const auto shell = std::find_if(shells.begin(), shells.end(), [&](const Shell& s) { return s.name == word; });
  fmt::print("{}", shell->script(program));
}

constexpr const char* footer =
    R"(cmake --install puts the scripts where the shells look for them; without it, load one where the shell starts:
~/.bashrc, ~/.zshrc or ~/.config/fish/config.fish.

Example:
  source <(microslip completion bash)
  microslip completion fish | source)";

} // namespace

void add_completion_command(Command& program) {
  Command command =
      program.add_subcommand("completion", "Print a script that completes commands and options in a shell", footer);
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL bash|zsh|fish", *shell, "bash, zsh or fish").required();
  command.callback([&program, shell] { print_completion(command_text(program.parser()), *shell); });
}

} // namespace microslip::app
