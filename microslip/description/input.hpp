#pragma once

#include "microslip/description/words.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::description {

/// Range of an input's numbers.
struct Bounds {
  enum class Kind {
    finite,   ///< any finite number
    positive, ///< finite and > 0
    between,  ///< in [low, high]
    radius,   ///< of curvature: not 0; infinite for a flat body
    modulus   ///< > 0; infinite for a rigid body
  };
  Kind kind = Kind::finite;
  double low = 0, high = 0; ///< of `between`

  /// Throws Error with field, value, unit and range for a number that is out of bounds.
  void require(std::string_view field, double value, std::string_view unit) const;
  /// Text of the range: "in [0, 10]", "positive"; empty for any finite number.
  std::string text() const;
  /// The least and the largest number between which all lie that are allowed; infinite where there is none.
  double least() const;
  double largest() const;
};
inline constexpr Bounds any_number{};
inline constexpr Bounds positive{Bounds::Kind::positive};
inline constexpr Bounds radius{Bounds::Kind::radius};
inline constexpr Bounds modulus{Bounds::Kind::modulus};
constexpr Bounds between(double low, double high) {
  return {Bounds::Kind::between, low, high};
}

/// Kind of the value under a key.
enum class InputKind {
  number,
  numbers, ///< a list of at least one
  whole,   ///< a whole number
  wholes,  ///< two of them, or one for both
  text,
  word, ///< one of a few
  texts ///< a list of them
};

/// Words of another key of the section with which alone a key goes.
struct Condition {
  std::string_view key = ""; ///< "law"; empty: the key always goes
  std::span<const Word> words = {};
};

/// A key of case files or of files of sweeps, or an option of a command: all interfaces take unit, bounds, default and
/// text from here. A new one is a line of the tables in rolling_inputs.cpp, wheel_inputs.cpp and so on.
struct Input {
  std::string_view section =
      "";                    ///< "load"; `body` is that of body1 and body2, `profile` of all sections with a profile
  std::string_view key = ""; ///< "normal_force"
  InputKind kind = InputKind::number;
  std::string_view unit = ""; ///< SI, "-" without one; empty where it is no number
  Bounds bounds = {};
  std::optional<double> missing = {};           ///< what it is where it is left out
  std::string_view missing_word = "";           ///< the same of a word
  std::span<const double> missing_numbers = {}; ///< the same of a list of numbers
  Condition only = {};
  bool is_needed = false;   ///< a case without it is refused; of alternatives one is needed
  bool is_in_list = false;  ///< its section is a list, [[body1.layers]]; paths have its place in it, from 1 on
  bool is_state = false;    ///< of a wheel's state or load, which a sweep may vary
  bool may_be_list = false; ///< a list of numbers may stand for the number
  std::span<const std::string_view> words = {};
  std::string_view text = ""; ///< what it is, with the sign's meaning
};

/// An input under one of the names that its section has in files.
struct NamedInput {
  std::string path; ///< "body1.rolling_radius"; "body1.layers.1.thickness" is that of the first in a list
  const Input* input;
  std::string range; ///< what it may be, in words: "in [0, 10]", "forward or backward"; empty for all of its kind
};

/// The inputs of a kind of case, in the order in which they are shown.
class InputTable {
public:
  /// `shared` are names of sections of files and the section of the table whose keys they have beside their own ones.
  struct Shared {
    std::string_view in_files, in_table;
  };
  InputTable(std::vector<Input> inputs, std::vector<Shared> shared);
  InputTable(InputTable&&) = default;

  std::span<const Input> inputs() const { return inputs_; }
  /// Each under all of its names.
  std::span<const NamedInput> named() const { return named_; }
  /// The keys of a section of a file, "" for those of the file itself.
  std::vector<std::string_view> keys(std::string_view section) const;
  /// The names that a section of the table has in files.
  std::vector<std::string_view> names(std::string_view section) const;
  /// The input of a key in a section of a file, "body1.layers.2" if it is one in a list; none if there is no such key.
  const Input* find(std::string_view section, std::string_view key) const;

private:
  bool has(const Input& input, std::string_view section) const;

  std::vector<Input> inputs_;
  std::vector<Shared> shared_;
  std::vector<NamedInput> named_;
};

/// Inputs of two bodies in rolling contact; of a wheel on a rail, and of a wheelset, which has more.
const InputTable& rolling_inputs();
const InputTable& wheel_inputs();
const InputTable& wheelset_inputs();

/// Inputs of a file of `microslip sweep`: what varies in its cases is a key of these.
const InputTable& sweep_inputs();
/// The options of `microslip conicity` for track, wheelset and motions, and of `microslip table make`.
const InputTable& conicity_inputs();
const InputTable& creep_table_inputs();

/// Inputs of one of input_kinds.
const InputTable& inputs_of(std::string_view kind);

} // namespace microslip::description
