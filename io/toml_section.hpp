#pragma once

#include "io/option_words.hpp"
#include "io/read_inputs.hpp"
#include "io/toml.hpp"
#include "microslip/description/input.hpp"

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::io {

/// Parses TOML; `file` is its name for messages. Error with file and line if it is malformed.
toml::table parse_toml(std::string_view text, const std::string& file);

/// A table of a TOML file whose values are read and checked key by key. What is wrong throws an Error with file, line,
/// key, value and range. Where a number in a unit is wanted a text with a unit may stand, "80 kN". An optional table
/// that is missing reads as an empty one. A value for `missing` makes a key optional. Keeps references to the parsed
/// file and its name.
class TomlSection {
public:
  using Words = std::vector<std::string_view>;
  using ReadKeys = ReadInputs;
  /// Units in which numbers of the file are read, by the full names of keys.
  using KeyUnits = std::map<std::string, std::string, std::less<>>;
  static KeyUnits units_of(const ReadKeys& keys);

  /// The whole file, or a table in it with its name for messages. All that is read goes to `keys`, of what is refused
  /// the unit alone.
  TomlSection(const toml::table& table, const std::string& file, std::string name = {}, ReadKeys* keys = nullptr)
      : table_(&table), name_(std::move(name)), section_(name_), file_(file), keys_(keys) {}
  /// The file's name for messages.
  const std::string& file() const { return file_; }
  TomlSection required_section(std::string_view name) const;
  TomlSection optional_section(std::string_view name) const;
  /// The tables of a list, [[name]], with the names name.1, name.2 ... for messages; none if it is missing.
  std::vector<TomlSection> sections(std::string_view name) const;
  /// A section by its path from here, "solution.slope_reduction" or "body1.layers.2"; an empty one if it is missing.
  TomlSection at_path(std::string_view path) const;

  /// Section with a table of its inputs, from which the functions below that are given a key alone take unit,
  /// bounds and default. All that is read goes to `read` as well, if given. Both must outlive it.
  TomlSection described_by(const description::InputTable& inputs, ReadInputs* read = nullptr) const;

  /// A table somewhere below this one, with its name for messages and the section of the table of inputs whose keys it
  /// has.
  TomlSection inside(const toml::table& table, std::string name, std::string_view section) const;

  /// Error for any key but these; of several wrong ones, the first in the file is named.
  void allow(const Words& keys) const;
  /// Refuses any key except those that the table has for this section, and `more`, such as sections within it, and keys
  /// whose condition (Input::only) does not hold; the first of them in the table is named.
  void allow_described(const Words& more = {}) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }
  bool is_described(std::string_view key) const { return inputs_->find(section_, key) != nullptr; }
  /// Returns which of several keys is there; Error if it is none or more than one.
  std::string_view one_of(std::initializer_list<std::string_view> keys) const;
  std::string_view one_of(std::string_view first, std::string_view second) const { return one_of({first, second}); }

  double number(std::string_view key) const;
  /// None if the key is missing.
  std::optional<double> optional_number(std::string_view key) const;
  int whole(std::string_view key) const;
  /// Two whole numbers, or one for both.
  std::pair<int, int> wholes(std::string_view key) const;
  std::vector<double> numbers(std::string_view key) const;
  std::string word(std::string_view key) const;
  template <class Option> Option option(std::string_view key) const { return from_word<Option>(key, word(key)); }
  /// The table's line of a key.
  const description::Input& input(std::string_view key) const;

  double finite(std::string_view key, std::string_view unit, std::optional<double> missing = {}) const;
  double between(std::string_view key, std::string_view unit, double low, double high,
                 std::optional<double> missing = {}) const;
  /// A list of finite numbers, at least one.
  std::vector<double> numbers(std::string_view key, std::string_view unit) const;
  bool is_list(std::string_view key) const;
  bool is_text(std::string_view key) const;
  std::string text(std::string_view key, std::string_view missing) const;
  /// A list of texts, empty if the key is missing.
  std::vector<std::string> texts(std::string_view key) const;
  /// Text that must be there and not empty.
  std::string required_text(std::string_view key) const;
  std::string word(std::string_view key, std::string_view missing, std::span<const std::string_view> words) const;
  template <class Option> Option option(std::string_view key, Option missing) const {
    return from_word<Option>(key, word(key, to_word(missing), option_words<Option>()));
  }
  /// A whole number, which keeps its value if the key is missing.
  void count(std::string_view key, int low, int high, int& value) const;
  /// A list of two whole numbers, or one for both, which keep their values if the key is missing.
  void counts(std::string_view key, int low, int high, int& first, int& second) const;

  /// Runs a check and puts file and line before its message: those of the key, if it is there, or of the table.
  void at(std::string_view key, const std::function<void()>& check) const;

  /// Full name of a key, for messages: "load.normal_force".
  std::string full(std::string_view key) const;

  /// Prefix of a message about a key: file and line, of the key, if it is there, or of the table.
  std::string line_of(std::string_view key) const;

private:
  /// Refuses a key that is here without the word with which it goes.
  void require_condition(const description::Input& input) const;
  using Check = std::function<double(std::string_view field, double value)>;

  TomlSection(const toml::table* table, std::string name, const TomlSection& parent)
      : table_(table), name_(std::move(name)), section_(name_), file_(parent.file_), keys_(parent.keys_),
        inputs_(parent.inputs_), read_(parent.read_) {}
  const toml::node* find(std::string_view key) const { return table_ == nullptr ? nullptr : table_->get(key); }
  /// "[load]" and what comes then; nothing in a table without a name.
  std::string in_section(const char* after) const;
  [[noreturn]] void refuse_missing(std::string_view key) const;
  [[noreturn]] void wrong_type(std::string_view key, const toml::node& node, const std::string& wanted) const;
  double number(std::string_view key, std::string_view unit, std::optional<double> missing, const Check& check) const;
  double value_of(std::string_view key, const toml::node& node, std::string_view unit, const std::string& wanted) const;
  int whole(std::string_view key, const toml::node& node, int low, int high) const;
  void record(std::string_view key, ReadInput::Value value, std::string_view unit) const;

  const toml::table* table_ = nullptr;
  std::string name_, section_; ///< for messages; in the table of inputs
  const std::string& file_;
  ReadKeys* keys_ = nullptr;
  const description::InputTable* inputs_ = nullptr;
  ReadInputs* read_ = nullptr;
};

} // namespace microslip::io
