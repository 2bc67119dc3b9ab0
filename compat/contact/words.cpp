#include "compat/contact/words.hpp"

#include "io/nearest_word.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>

namespace microslip::contact_program {
namespace {

constexpr std::size_t longest_line = 4096;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '=' || c == '\r' || c == '\f';
}

/// The word with an exponent that C++ knows; nothing if it is no number.
std::optional<std::string> with_plain_exponent(std::string_view word) {
  std::string number;
  std::size_t i = 0;
  const auto sign = [&] {
    if (i < word.size() && (word[i] == '+' || word[i] == '-')) {
      if (word[i] == '-') number += '-';
      ++i;
    }
  };
  const auto digits = [&] {
    const std::size_t begin = i;
    while (i < word.size() && is_digit(word[i])) number += word[i++];
    return i - begin;
  };
  sign();
  std::size_t count = digits();
  if (i < word.size() && word[i] == '.') {
    number += word[i++];
    count += digits();
  }
  if (count == 0) return {};
  if (i == word.size()) return number;
  const bool has_letter = std::string_view("eEdDqQ").find(word[i]) != std::string_view::npos;
  if (!has_letter && word[i] != '+' && word[i] != '-') return {};
  if (has_letter) ++i;
  number += 'e';
  sign();
  if (digits() == 0 || i != word.size()) return {};
  return number;
}

std::optional<double> to_real(std::string_view word) {
  const auto number = with_plain_exponent(word);
  if (!number) return {};
  double value = 0;
  const auto [end, error] = std::from_chars(number->data(), number->data() + number->size(), value);
  if (error == std::errc::result_out_of_range) {
    // Too small to be told from zero, or too large for a number.
    const auto exponent = number->find('e');
    return exponent != std::string::npos && (*number)[exponent + 1] == '-' ? std::optional(0.0) : std::nullopt;
  }
  return value;
}

std::optional<int> to_integer(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return value;
}

} // namespace

std::string short_number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

Words::Words(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

bool Words::read_line() {
  words_.clear();
  next_ = 0;
  std::string text;
  char c = 0;
  bool any = false;
  while (stream_.get(c)) {
    any = true;
    if (c == '\n') break;
    text += c;
    if (text.size() > longest_line) {
      ++line_;
      fail("the line is longer than " + std::to_string(longest_line) + " characters; is this a text file?");
    }
  }
  if (!any) return false;
  ++line_;
  split(text);
  return true;
}

void Words::split(const std::string& text) {
  for (std::size_t i = 0; i < text.size() && text[i] != '%';) {
    if (is_separator(text[i])) {
      ++i;
    } else if (text[i] == '\'') {
      const std::size_t end = std::min(text.find('\'', i + 1), text.size());
      words_.push_back({text.substr(i + 1, end - i - 1), true});
      i = end + 1;
    } else {
      const std::size_t begin = i;
      while (i < text.size() && !is_separator(text[i]) && text[i] != '%') ++i;
      words_.push_back({text.substr(begin, i - begin), false});
    }
  }
}

bool Words::fill() {
  while (!has_more())
    if (!read_line()) return false;
  return true;
}

bool Words::at_end() {
  return !fill();
}

std::size_t Words::line() {
  fill();
  return line_;
}

const Words::Word& Words::next(std::string_view field) {
  if (!fill()) fail("the file ends where " + std::string(field) + " is wanted");
  return words_[next_++];
}

int Words::integer(std::string_view field, int low, int high) {
  const Word& word = next(field);
  const auto value = word.quoted ? std::nullopt : to_integer(word.text);
  if (!value) fail(std::string(field) + " = " + io::printable(word.text) + ": must be a whole number");
  if (*value < low || *value > high)
    fail(field, *value, "must be in " + std::to_string(low) + " to " + std::to_string(high));
  return *value;
}

double Words::real(std::string_view field, double unit) {
  const Word& word = next(field);
  const auto value = word.quoted ? std::nullopt : to_real(word.text);
  if (!value) fail(std::string(field) + " = " + io::printable(word.text) + ": must be a number");
  return *value * unit;
}

double Words::positive(std::string_view field, double unit) {
  const double value = real(field);
  if (!(value > 0)) fail(field, value, "must be > 0");
  return value * unit;
}

double Words::not_negative(std::string_view field) {
  const double value = real(field);
  if (!(value >= 0)) fail(field, value, "must not be negative");
  return value;
}

double Words::between(std::string_view field, double low, double high, double unit) {
  const double value = real(field);
  if (!(value >= low && value <= high))
    fail(field, value, "must be in [" + short_number(low) + ", " + short_number(high) + "]");
  return value * unit;
}

double Words::angle(std::string_view field) {
  const Word& word = next(field);
  std::string_view text = word.text;
  double unit = 1;
  if (text.ends_with('d')) unit = std::numbers::pi / 180;
  if (text.ends_with('d') || text.ends_with('r')) text.remove_suffix(1);
  const auto value = word.quoted ? std::nullopt : to_real(text);
  if (!value)
    fail(std::string(field) + " = " + io::printable(word.text) + ": must be an angle, in degrees with a d behind");
  return *value * unit;
}

std::string Words::text(std::string_view field) {
  const Word& word = next(field);
  if (!word.quoted) fail(std::string(field) + " = " + io::printable(word.text) + ": must be a text in single quotes");
  return word.text;
}

void Words::skip_lines(int count) {
  for (int k = 0; k < count; ++k)
    if (!read_line()) fail("the file ends where a line of text is wanted");
  words_.clear();
}

std::vector<double> Words::reals(std::string_view field, std::size_t count, double unit) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(real(std::string(field) + "(" + std::to_string(k + 1) + ")", unit));
  end_record();
  return values;
}

std::vector<int> Words::control(std::string_view field, std::size_t most) {
  const Word& word = next(field);
  const bool is_number = !word.quoted && std::all_of(word.text.begin(), word.text.end(), is_digit);
  if (!is_number || word.text.size() > 9)
    fail(std::string(field) + " = " + io::printable(word.text) + ": must be a control integer of up to " +
         std::to_string(most) + " digits");
  std::vector<int> digits(most, 0);
  std::size_t position = most;
  for (auto digit = word.text.rbegin(); digit != word.text.rend(); ++digit) {
    if (position == 0 && *digit != '0')
      fail(std::string(field) + " = " + word.text + ": must have " + std::to_string(most) + " digits at most");
    if (position > 0) digits[--position] = *digit - '0';
  }
  return digits;
}

double Words::optional_real(std::string_view field, double fallback, double unit) {
  if (!has_more() || words_[next_].quoted || !with_plain_exponent(words_[next_].text)) {
    end_record();
    return fallback;
  }
  return real(field, unit);
}

int Words::optional_integer(std::string_view field, int fallback, int low, int high) {
  if (!has_more() || words_[next_].quoted || !to_integer(words_[next_].text)) {
    end_record();
    return fallback;
  }
  return integer(field, low, high);
}

void Words::end_record() {
  next_ = words_.size();
}

void Words::fail(const std::string& message) const {
  throw Error(name_ + ":" + std::to_string(line_) + ": " + message);
}

void Words::fail(std::string_view field, double value, const std::string& must) const {
  fail(std::string(field) + " = " + short_number(value) + ": " + must);
}

} // namespace microslip::contact_program
