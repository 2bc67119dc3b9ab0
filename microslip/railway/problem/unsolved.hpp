#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace microslip {

/// Why the status of a wheel's or a wheelset's solution is not ok.
enum class Unsolved : std::uint8_t {
  none,
  out_of_range,
  apart,
  no_height,
  force_jumps,
  too_many_patches,
  pressures,
  tractions,
  beyond_elements,
  residual,
  numbers,
  derivatives,
  implausible,
  no_balance,
  off_its_rail,
};

/// Text of the reason; empty for `none`.
constexpr std::string_view to_string(Unsolved reason) {
  constexpr std::string_view texts[] = {
      "",
      "the state is out of range",
      "wheel and rail do not touch",
      ("no height bears the vertical force: friction on the flange pulls the wheel down, or the bodies would overlap "
       "by more than 1/1000 of the radius"),
      "the vertical force jumps over the one given at this height",
      "wheel and rail touch in more than 128 patches",
      "the pressures have not converged: see the residual",
      "the tangential problem of a patch has not converged: see its status",
      "the contact reaches beyond the elements of its patch",
      "not converged: see the residual",
      "a number beyond all bounds: the contact would be larger than the bodies",
      "derivatives beyond all bounds: the wheel hardly moves",
      "solved, but it cannot be meant: see the warnings",
      "no height, roll and rolling speed give the load and the torque",
      "a wheel is not above its rail",
  };
  static_assert(std::size(texts) == static_cast<std::size_t>(Unsolved::off_its_rail) + 1);
  const auto k = static_cast<std::size_t>(reason);
  return k < std::size(texts) ? texts[k] : "";
}

} // namespace microslip
