#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::contact_program {

/// As messages have it: six significant digits at most.
std::string short_number(double value);

/// Values of an input file of the program CONTACT, one after the other. Words are separated by blanks, tabs, commas and
/// equals signs, `%` begins a comment, empty lines count for nothing. A record is a row of values that must be there,
/// on one line or several; after them the same line may hold optional ones, and the rest of it is a remark.
///
/// All readers throw Error with file, line, field, value and allowed range: `a.inp:12: FSTAT = -0.3: must be in [0,
/// 10]`. Lines have 4096 characters at most.
class Words {
public:
  /// `stream` must outlive the words; `name` is the file's name for messages.
  Words(std::istream& stream, std::string name);

  /// Returns whether there is no further value.
  bool at_end();
  /// The line of the next value, from 1.
  std::size_t line();

  int integer(std::string_view field, int low, int high);
  /// A real number as Fortran reads it: `1`, `1.`, `0.5`, `1d-3`, and `0.1-07` without a letter for the exponent.
  /// This and the others are numbers of a unit; messages and ranges have the file's.
  double real(std::string_view field, double unit = 1);
  double positive(std::string_view field, double unit = 1);
  double not_negative(std::string_view field);
  double between(std::string_view field, double low, double high, double unit = 1);
  /// [rad]; degrees if it ends in d: `90d`, `180.d`. `90d0` is 90 rad.
  double angle(std::string_view field);
  /// A text between single quotes.
  std::string text(std::string_view field);
  /// `count` real numbers.
  std::vector<double> reals(std::string_view field, std::size_t count, double unit = 1);
  /// The digits of a control integer from the left, `most` of them; missing ones are leading zeros.
  std::vector<int> control(std::string_view field, std::size_t most);

  /// An optional value: the next word of the line if it is a number, else `fallback`.
  double optional_real(std::string_view field, double fallback, double unit = 1);
  int optional_integer(std::string_view field, int fallback, int low, int high);

  /// What is left of the line is a remark.
  void end_record();
  /// Drops so many lines after the last value's, whatever they are. Throws Error at the end of the file.
  void skip_lines(int count);
  /// Throws Error with file and the line of the last value.
  [[noreturn]] void fail(const std::string& message) const;
  /// The same for a field and its value.
  [[noreturn]] void fail(std::string_view field, double value, const std::string& must) const;

private:
  struct Word {
    std::string text;
    bool quoted = false;
  };

  bool read_line();
  bool fill();
  void split(const std::string& text);
  const Word& next(std::string_view field);
  bool has_more() const { return next_ < words_.size(); }

  std::istream& stream_;
  std::string name_;
  std::vector<Word> words_; ///< of the line
  std::size_t next_ = 0, line_ = 0;
};

} // namespace microslip::contact_program
