#pragma once

#include "app/command.hpp"
#include "microslip/description/input.hpp"

#include <functional>
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
                        const std::string& of = "")
      : table_(&table), section_(section), prefix_(std::move(prefix)), of_(of.empty() ? "" : of + ": ") {}

  /// The option's name with its dashes.
  std::string name(std::string_view key) const;
  /// Text of the input, for an option whose value has another form.
  std::string text(std::string_view key) const { return of_ + std::string(table_->find(section_, key)->text); }
  /// Adds an option. A number, a list of numbers or a word becomes the default, if there is one; an optional number,
  /// and a word with `is_given_only`, stay empty where the option is left out. `type` stands instead of the value in
  /// texts, "FROM TO STEP"; of words these.
  template <class Value>
  CommandOption add(Command& command, std::string_view key, Value& value, std::string type = "VALUE",
                    bool is_given_only = false);

  /// Throws Error with option, value, unit and range for a number out of bounds or an unknown word.
  void require() const;

private:
  const description::InputTable* table_;
  std::string_view section_;
  std::string prefix_, of_;
  std::vector<std::function<void()>> checks_;
};

} // namespace microslip::app
