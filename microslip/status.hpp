#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace microslip {

/// Outcome of a calculation. It is part of every result; anything but `ok` comes with a reason a user can act on.
enum class Status {
  ok,            ///< the result satisfies the equations to the tolerance it states
  invalid_input, ///< an input is not a number or outside its range; the result's numbers are NaN
  not_converged, ///< the result is the best one found; its residual is stated and larger than the tolerance
  no_contact,    ///< the bodies do not touch; all tractions are zero
  no_solution,   ///< the prescribed force exceeds what friction can carry; the result slides fully in its direction
  out_of_range,  ///< beyond the range of a creep-force table; the forces are those of limits
  implausible,   ///< solved, but it cannot be meant, as its warnings say: pressures beyond elasticity, a mistaken file
};

/// Its name; empty for what is no status.
constexpr std::string_view to_string(Status status) {
  constexpr std::string_view names[] = {"ok",          "invalid_input", "not_converged", "no_contact",
                                        "no_solution", "out_of_range",  "implausible"};
  static_assert(std::size(names) == static_cast<std::size_t>(Status::implausible) + 1);
  const auto k = static_cast<std::size_t>(status);
  return k < std::size(names) ? names[k] : "";
}

/// Codes and names, as files of results state them.
constexpr const char* status_codes =
    "0 ok, 1 invalid_input, 2 not_converged, 3 no_contact, 4 no_solution, 5 out_of_range, 6 implausible";

/// Returns whether the equations are satisfied, whatever warnings the result has.
constexpr bool is_solved(Status status) {
  return status == Status::ok || status == Status::implausible;
}

} // namespace microslip
