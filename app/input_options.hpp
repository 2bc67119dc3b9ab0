#pragma once

#include "app/command.hpp"
#include "microslip/description/input.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::app {

/// Options of a command that are lines of a section of a table of inputs, which has their texts, units, bounds and
/// defaults: --gauge-height of gauge_height. Values must stay where they are until they are checked.
class InputOptions {
public:
  /// `prefix` makes --wheel-unit of unit, `of` says in texts what it concerns.
  explicit InputOptions(const description::InputTable& table, std::string_view section = "", std::string prefix = "",
                        const std::string& of = "");

  /// The option's name with its dashes.
  std::string name(std::string_view key) const;
  /// Add an option. Its value becomes the default, if there is one.
  CommandOption add(Command& command, std::string_view key, double& value);
  CommandOption add(Command& command, std::string_view key, std::optional<double>& value);
  CommandOption add(Command& command, std::string_view key, int& value);
  /// `type` stands in place of the values in texts, "FROM TO STEP".
  CommandOption add(Command& command, std::string_view key, std::vector<double>& values, const std::string& type);
  /// A word; empty where the option is left out, if it has no default or `has_default` is false.
  CommandOption add(Command& command, std::string_view key, std::string& word, bool has_default = true);
  CommandOption add_text(Command& command, std::string_view key, std::string& text, const std::string& type);

  /// Throws Error with option, value, unit and range for a number out of bounds or an unknown word.
  void require() const;

private:
  const description::Input& input(std::string_view key) const;
  template <class Value>
  CommandOption add_option(Command& command, std::string_view key, Value& value, const std::string& type);

  const description::InputTable* table_;
  std::string_view section_;
  std::string prefix_, of_;
  std::vector<std::function<void()>> checks_;
};

} // namespace microslip::app
