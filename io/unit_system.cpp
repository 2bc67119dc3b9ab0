#include "io/unit_system.hpp"

#include "io/text_line.hpp"
#include "microslip/decimal.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <map>
#include <string_view>

namespace microslip::io {
namespace {

constexpr std::size_t base_units = 6; ///< as many as the table has
constexpr std::string_view digits = "0123456789";

/// A number x in this unit is factor 10^decade (x + origin) in base units. Powers of prefixes are exact.
struct Unit {
  std::array<int, base_units> powers{};
  double factor = 1, origin = 0;
  int decade = 0;
};

/// A product has no origin.
Unit product(const Unit& a, const Unit& b, int power) {
  Unit out{.powers = a.powers, .factor = a.factor, .decade = a.decade + power * b.decade};
  for (std::size_t k = 0; k < base_units; ++k) out.powers[k] += power * b.powers[k];
  for (int k = 0; k < std::abs(power); ++k) power > 0 ? out.factor *= b.factor : out.factor /= b.factor;
  return out;
}

double times_power_of_ten(double value, int exponent) {
  double power = 1;
  for (int k = 0; k < std::abs(exponent); ++k) power *= 10;
  return exponent < 0 ? value / power : value * power;
}

} // namespace

struct UnitSystem::Kept {
  Kept() {
    std::size_t base = 0;
    for (const auto& [symbol, value] : unit_definitions()) {
      Unit unit;
      if (value == nullptr)
        unit.powers.at(base++) = 1;
      else
        unit = parse(value).value_or(unit);
      units.emplace(symbol, unit);
    }
  }

  std::optional<Unit> find(std::string_view symbol) const {
    const auto found = units.find(symbol);
    if (found != units.end()) return found->second;
    for (const auto& [prefix, decade] : unit_prefixes()) {
      if (!symbol.starts_with(prefix)) continue;
      const auto unit = units.find(symbol.substr(std::string_view(prefix).size()));
      if (unit != units.end() && unit->first != "%") return product({.decade = decade}, unit->second, 1);
    }
    return {};
  }

  std::optional<Unit> parse(std::string_view text) const;

  std::map<std::string, Unit, std::less<>> units;
};

namespace {

/// Products and quotients from left to right, of numbers and of units with powers; `UNIT @ NUMBER` moves its zero.
template <class Find> class UnitParser {
public:
  UnitParser(std::string_view text, const Find& find) : rest_(trimmed(text)), find_(find) {}

  std::optional<Unit> unit() {
    auto found = products();
    if (found && take('@')) {
      const auto origin = number();
      if (!origin) return {};
      found->origin = *origin;
    }
    return rest_.empty() ? found : std::nullopt;
  }

private:
  bool take(char c) {
    const bool is_next = rest_.starts_with(c);
    if (is_next) rest_ = trimmed(rest_.substr(1));
    return is_next;
  }

  std::optional<double> number() {
    double value = 0;
    const auto [stop, error] = read_number(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) return {};
    rest_ = trimmed(rest_.substr(static_cast<std::size_t>(stop - rest_.data())));
    return value;
  }

  std::optional<Unit> products() {
    auto all = factor();
    while (all && !rest_.empty() && rest_.front() != ')' && rest_.front() != '@') {
      const int power = take('/') ? -1 : 1;
      if (power > 0 && !take('*')) take('.');
      const auto next = factor();
      if (!next) return {};
      all = product(*all, *next, power);
    }
    return all;
  }

  std::optional<Unit> factor() {
    if (take('(')) {
      const auto inner = products();
      return take(')') ? inner : std::nullopt;
    }
    if (!rest_.empty() && digits.find(rest_.front()) != std::string_view::npos) {
      const auto value = number();
      return value ? std::optional(Unit{.factor = *value}) : std::nullopt;
    }
    const auto unit = find_(rest_.substr(0, symbol_length()));
    rest_.remove_prefix(symbol_length());
    const int exponent = power();
    rest_ = trimmed(rest_);
    if (!unit || exponent == 1) return unit;
    return product({}, *unit, exponent);
  }

  std::size_t symbol_length() const {
    std::size_t length = 0;
    while (length < rest_.size() &&
           (std::isalpha(static_cast<unsigned char>(rest_[length])) != 0 || rest_[length] == '%'))
      ++length;
    return length;
  }

  /// Power of one digit, with a sign and a circumflex before it; 1 if there is none.
  int power() {
    if (rest_.starts_with('^')) rest_.remove_prefix(1);
    const int sign = rest_.starts_with('-') ? -1 : 1;
    if (sign < 0) rest_.remove_prefix(1);
    if (rest_.empty() || digits.find(rest_.front()) == std::string_view::npos) return 1;
    const int value = rest_.front() - '0';
    rest_.remove_prefix(1);
    return sign * value;
  }

  std::string_view rest_;
  const Find& find_;
};

} // namespace

std::optional<Unit> UnitSystem::Kept::parse(std::string_view text) const {
  const auto find_symbol = [&](std::string_view symbol) { return find(symbol); };
  return UnitParser(text, find_symbol).unit();
}

UnitSystem::UnitSystem() : kept_(std::make_unique<Kept>()) {}
UnitSystem::~UnitSystem() = default;

bool UnitSystem::knows(const std::string& symbol) const {
  return kept_->find(symbol).has_value();
}

std::optional<UnitSystem::Conversion> UnitSystem::conversion(const std::string& from, const std::string& to) const {
  const auto given = kept_->parse(from), wanted = kept_->parse(to);
  if (!given || !wanted || given->powers != wanted->powers) return {};
  const double factor = times_power_of_ten(given->factor / wanted->factor, given->decade - wanted->decade);
  return [factor, before = given->origin, after = wanted->origin](double value) {
    return factor * (value + before) - after;
  };
}

} // namespace microslip::io
