#pragma once

#include "microslip/error.hpp"

#include <string>
#include <string_view>

namespace microslip {

/// Style in which an interface writes keys, and a word or number that they need.
enum class KeyStyle {
  case_file, ///< solution.theory = "exact"
  option,    ///< --theory exact
  keyword    ///< theory="exact"
};

/// Something in a problem that its method, or another part of the problem, does not allow.
struct Incompatibility {
  std::string_view field; ///< where it is given, as in case files: "motion.kind"
  /// Text of the fault and its remedy, keys in braces: "needs {solution.theory=exact}".
  std::string_view text;

  /// "motion.kind: must be steady with viscoelastic bodies", with keys as an interface writes them.
  std::string message(KeyStyle style = KeyStyle::case_file) const;
  /// The text alone.
  std::string reason(KeyStyle style = KeyStyle::case_file) const;
};

/// An Error that one is, for interfaces that write keys in their own style.
class Incompatible : public Error {
public:
  explicit Incompatible(const Incompatibility& of) : Error(of.message()), of_(of) {}
  const Incompatibility& of() const { return of_; }

private:
  Incompatibility of_; ///< of texts that last
};

/// A creep-force table for another theory than that of tables.
inline constexpr Incompatibility table_without_theory{"solution.table", "needs {solution.theory=table}"};

} // namespace microslip
