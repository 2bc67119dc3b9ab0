#pragma once

#include "io/toml_section.hpp"
#include "microslip/description/input.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace microslip::io {

/// Inputs of a case by their paths, "load.normal_force" or "body2.layers.1.thickness", in SI units: what a program
/// gives instead of a file. The table of inputs tells at once whether a path is there and what it may be; incompatible
/// values the readers of cases refuse, as they do in a file. A call that throws changes nothing.
class CaseInputs {
public:
  /// A number, a text or a word, a list of numbers; a number may be a text with its unit, "80 kN".
  using Value = ReadInput::Value;

  /// None yet, of a kind of case, one of description::case_kinds; `name` as below.
  explicit CaseInputs(std::string_view kind, std::string name = "problem");
  /// Inputs of a case file's text; `name` is its name for messages, and files of profiles start at its folder. Throws
  /// Error for text that is no TOML.
  static CaseInputs read(std::string_view text, const std::string& name);

  std::string_view kind() const { return kind_; }

  /// Throws Error with path, value, unit and range, and with the nearest path for one that there is not.
  void set(std::string_view path, const Value& value);
  /// Goes back to the default. Throws Error for an unknown path.
  void unset(std::string_view path);
  /// Value as it was set, numbers in SI units, or the default; none without either. Throws Error for an unknown path,
  /// and for what a text has under this path that it may not have.
  std::optional<Value> get(std::string_view path) const;

  /// All of it for the readers of cases; it must not outlive this.
  TomlSection root() const { return {given_, name_}; }
  /// The case file that has these inputs.
  std::string text() const;
  /// Inputs without the states of wheels and their sweeps.
  CaseInputs without_states() const;

  friend bool operator==(const CaseInputs&, const CaseInputs&) = default;

private:
  const description::Input& input(std::string_view path) const;
  /// Table of a path's section, made where it is missing.
  toml::table& table_of(std::string_view path);

  std::string_view kind_;
  std::string name_;
  toml::table given_;
};

} // namespace microslip::io
