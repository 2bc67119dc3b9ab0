#include "io/units.hpp"

#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "io/unit_system.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

constexpr UnitDefinition definitions[] = {
    {"m", nullptr},
    {"kg", nullptr},
    {"s", nullptr},
    {"K", nullptr},
    {"rad", nullptr}, // with a separate dimension, so that 10 Hz are not 10 rad/s
    {"ShoreA", nullptr},
    {"g", "0.001 kg"},
    {"t", "1000 kg"},
    {"lb", "0.45359237 kg"},
    {"in", "0.0254 m"},
    {"ft", "0.3048 m"},
    {"mi", "1609.344 m"},
    {"min", "60 s"},
    {"h", "3600 s"},
    {"mph", "mi/h"},
    {"deg", "0.017453292519943295 rad"},
    {"rpm", "6.283185307179586 rad/min"},
    {"N", "kg m s-2"},
    {"kgf", "9.80665 N"},
    {"kp", "kgf"},
    {"lbf", "4.4482216152605 N"},
    {"kip", "1000 lbf"},
    {"Pa", "N m-2"},
    {"bar", "100000 Pa"},
    {"psi", "lbf in-2"},
    {"ksi", "1000 psi"},
    {"J", "N m"},
    {"W", "J/s"},
    {"degC", "K @ 273.15"},
    {"degF", "0.5555555555555556 K @ 459.67"},
    {"%", "0.01"},
};

constexpr UnitPrefix prefixes[] = {{"n", -9}, {"u", -6}, {"m", -3}, {"c", -2}, {"d", -1},
                                   {"da", 1}, {"k", 3},  {"M", 6},  {"G", 9}};

/// Text of messages on the unit of a value: those to choose from, and an example.
struct Choice {
  std::string_view unit, example;
  std::array<std::string_view, 7> units;

  std::vector<std::string_view> known() const {
    return {units.begin(), std::find(units.begin(), units.end(), std::string_view())};
  }
  std::string sentence() const {
    return "must be in " + listed(known()) + ", e.g. \"" + std::string(example) +
           (unit == "-" ? "\", or a number" : "\"");
  }
};

constexpr Choice choices[] = {
    {"m", "460 mm", {"m", "mm", "um", "cm", "km", "in", "ft"}},
    {"N", "80 kN", {"N", "kN", "MN", "kgf", "lbf", "kip"}},
    {"Pa", "210 GPa", {"Pa", "kPa", "MPa", "GPa", "N/mm^2", "psi", "ksi"}},
    {"1/m", "0.4 1/m", {"1/m", "1/mm", "1/km", "rad/m", "mrad/m", "deg/m"}},
    {"rad", "3 deg", {"rad", "mrad", "deg"}},
    {"m/s", "100 km/h", {"m/s", "mm/s", "km/h", "mph", "ft/s"}},
    {"rad/s", "400 rpm", {"rad/s", "mrad/s", "deg/s", "rpm"}},
    {"N m", "2 kN m", {"N m", "kN m", "N mm", "lbf ft"}},
    {"s", "10 ms", {"s", "ms", "us", "min", "h"}},
    {"s/m", "0.6 s/m", {"s/m", "s/mm", "h/km"}},
    {"deg C", "20 degC", {"degC", "K", "degF"}},
    {"K", "400 K", {"K"}},
    {"kg/m^3", "7.85 g/cm^3", {"kg/m^3", "g/cm^3", "t/m^3"}},
    {"W/(m K)", "50 W/(m K)", {"W/(m K)", "kW/(m K)"}},
    {"J/(kg K)", "0.45 kJ/(kg K)", {"J/(kg K)", "kJ/(kg K)"}},
    {"Pa/m", "400 MPa/mm", {"Pa/m", "MPa/m", "MPa/mm", "GPa/mm"}},
    {"ShoreA", "60 ShoreA", {"ShoreA"}},
    {"-", "30 %", {"%"}},
};

const Choice& choice_of(std::string_view unit) {
  const auto* const found =
      std::find_if(std::begin(choices), std::end(choices), [&](const auto& choice) { return choice.unit == unit; });
  if (found == std::end(choices)) throw Error("no text with a unit is known for [" + std::string(unit) + "]");
  return *found;
}

/// Unit in ASCII, without blanks around signs.
std::string in_ascii(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> others[] = {
      {"\u00b5", "u"}, {"\u03bc", "u"}, {"\u00b0", "deg"}, {"\u00b2", "2"},
      {"\u00b3", "3"}, {"\u00b7", "*"}, {"\u22c5", "*"}};
  std::string text(unit.starts_with('/') ? "1" : "");
  text += unit;
  for (const auto& [other, letters] : others)
    for (auto at = text.find(other); at != std::string::npos; at = text.find(other))
      text.replace(at, other.size(), letters);
  for (const std::string_view sign : {" *", "* ", " /", "/ "})
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign)) text.erase(at + sign.find(' '), 1);
  return text;
}

/// Products and quotients of units with exponents, in parentheses where it matters. Not a number before them, as in
/// "1 435 mm", and no other origin: what only the table of units may have.
class PlainUnit {
public:
  explicit PlainUnit(std::string_view text) : rest_(text) {
    if (rest_.starts_with("1/") || rest_.starts_with("1 ")) rest_.remove_prefix(1), wants_operand_ = false;
    bool is_good = text.size() <= longest;
    while (is_good && !(rest_ = trimmed(rest_)).empty()) is_good = wants_operand_ ? take_operand() : take_operator();
    is_plain_ = is_good && !wants_operand_ && depth_ == 0;
  }

  bool is_plain() const { return is_plain_; }
  const std::vector<std::string>& symbols() const { return symbols_; }

private:
  static constexpr std::size_t longest = 40;

  bool take_operand() {
    if (rest_.front() == '(') {
      rest_.remove_prefix(1);
      return ++depth_ <= 5;
    }
    const auto end = std::min(rest_.size(), rest_.find_first_not_of(letters));
    if (end == 0) return false;
    symbols_.emplace_back(rest_.substr(0, end));
    rest_.remove_prefix(end);
    wants_operand_ = false;
    return take_exponent();
  }

  /// None, or one digit, with a sign and a circumflex before it.
  bool take_exponent() {
    const bool is_marked = rest_.starts_with('^');
    if (is_marked) rest_.remove_prefix(1);
    const bool is_negative = rest_.starts_with('-');
    if (is_negative) rest_.remove_prefix(1);
    const bool has_digit = !rest_.empty() && digits.find(rest_.front()) != std::string_view::npos;
    if (has_digit) rest_.remove_prefix(1);
    const bool has_more = !rest_.empty() && digits.find(rest_.front()) != std::string_view::npos;
    return !has_more && (has_digit || (!is_marked && !is_negative));
  }

  /// Between units a blank is enough.
  bool take_operator() {
    wants_operand_ = rest_.front() != ')';
    if (!wants_operand_) --depth_;
    if (std::string_view(")*/.").find(rest_.front()) != std::string_view::npos) rest_.remove_prefix(1);
    return depth_ >= 0;
  }

  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ%",
                                    digits = "0123456789";

  std::string_view rest_;
  std::vector<std::string> symbols_;
  int depth_ = 0;
  bool wants_operand_ = true, is_plain_ = false;
};

UnitScale scale_of(double factor) {
  const double inverse = std::round(1 / factor);
  return std::abs(inverse * factor - 1) < 1e-15 ? UnitScale{.over = inverse} : UnitScale{.times = factor};
}

/// A number and what follows it.
std::pair<double, std::string_view> split(std::string_view text, const Choice& choice) {
  auto rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = read_number(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc())
    throw Error("must be a number, or one with its unit such as \"" + std::string(choice.example) + "\"");
  rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()));
  if (rest.starts_with(',')) throw Error("must have a decimal point");
  return {value, trimmed(rest)};
}

/// The angle [rad] of a slope, of which a text has what follows the first number: ":40" of "1:40".
std::optional<double> angle_of_slope(double rise, std::string_view rest) {
  if (!rest.starts_with(':')) return {};
  const auto run = parse_number(trimmed(rest.substr(1)));
  if (!run || !(*run > 0)) throw Error("must be a slope such as \"1:40\"");
  return std::atan(rise / *run);
}

/// Only temperatures may differ by their zero.
UnitSystem::Conversion conversion(std::string_view name, const Choice& choice) {
  static const UnitSystem system; // of constants
  const std::string given = in_ascii(name);
  const PlainUnit plain(given);
  const auto& symbols = plain.symbols();
  const auto is_known = [&](const std::string& symbol) { return system.knows(symbol); };
  if (!plain.is_plain() || !std::all_of(symbols.begin(), symbols.end(), is_known)) {
    const auto near = suggestion(given, choice.known());
    throw Error("unknown unit " + printable(name) + (near.empty() ? "; " + choice.sentence() : near));
  }
  const bool is_temperature = choice.unit == "deg C";
  const auto to = [&](const std::string& unit) {
    auto found = system.conversion(given, unit);
    if (found && !is_temperature && (*found)(0) != 0) found.reset();
    return found;
  };
  auto found = to(is_temperature ? "degC" : choice.unit == "-" ? "1" : std::string(choice.unit));
  if (!found && choice.unit == "1/m") found = to("rad/m");
  if (!found) throw Error(choice.sentence());
  return *found;
}

} // namespace

std::span<const UnitDefinition> unit_definitions() {
  return definitions;
}
std::span<const UnitPrefix> unit_prefixes() {
  return prefixes;
}

double number_in_unit(std::string_view field, std::string_view text, std::string_view unit) {
  try {
    const Choice& choice = choice_of(unit);
    const auto [value, name] = split(text, choice);
    if (name.empty() && unit == "-") throw Error("must be a number without quotes");
    if (name.empty() && !std::isfinite(value)) return value; // in any unit, where a field takes it
    if (unit == "rad")
      if (const auto angle = angle_of_slope(value, name)) return *angle;
    if (name.empty()) throw Error("has no unit; " + choice.sentence());
    if (name == unit) return value;
    const auto converted = conversion(name, choice);
    return converted(0) != 0 ? converted(value) : scale_of(converted(1))(value);
  } catch (const Error& error) {
    throw Error(std::string(field) + " = " + printable(text) + " [" + std::string(unit) + "]: " + error.what());
  }
}

UnitScale scale_to_unit(std::string_view field, std::string_view from, std::string_view unit) {
  if (from == unit) return {};
  try {
    const Choice& choice = choice_of(unit);
    const auto converted = conversion(from, choice);
    if (converted(0) != 0) throw Error("differs by its zero, too");
    return scale_of(converted(1));
  } catch (const Error& error) {
    throw Error(std::string(field) + " [" + std::string(from) + "]: " + error.what());
  }
}

std::vector<OfferedUnit> offered_units(std::string_view unit) {
  const Choice& choice = choice_of(unit);
  std::vector<OfferedUnit> offered;
  for (const std::string_view name : choice.known())
    if (const auto converted = conversion(name, choice); converted(0) == 0)
      offered.push_back({name, scale_of(converted(1))});
  return offered;
}

} // namespace microslip::io
