#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace microslip::io {

/// A unit by what stands before it in the table; base units have no value.
struct UnitDefinition {
  const char *symbol, *value;
};
struct UnitPrefix {
  const char* symbol;
  int decade; ///< of its power of ten
};

/// The units of case files, and the prefixes that they may have.
std::span<const UnitDefinition> unit_definitions();
std::span<const UnitPrefix> unit_prefixes();

/// Units with the algebra of products, quotients and whole powers.
class UnitSystem {
public:
  UnitSystem();
  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  /// Returns whether it is a unit's symbol, with prefixes or without.
  bool knows(const std::string& symbol) const;

  /// A number in one unit as such in another, whose symbols are known. Empty for units of different dimensions.
  using Conversion = std::function<double(double)>;
  std::optional<Conversion> conversion(const std::string& from, const std::string& to) const;

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

} // namespace microslip::io
