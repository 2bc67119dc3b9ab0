#pragma once

#include <cstdint>
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

/// In words; empty for `none`.
constexpr std::string_view to_string(Unsolved reason) {
  switch (reason) {
  case Unsolved::none:
    return "";
  case Unsolved::out_of_range:
    return "the state is out of range";
  case Unsolved::apart:
    return "wheel and rail do not touch";
  case Unsolved::no_height:
    return "no height bears the vertical force: friction on the flange pulls the wheel down, or the bodies would "
           "overlap "
           "by more than 1/1000 of the radius";
  case Unsolved::force_jumps:
    return "the vertical force jumps over the one given at this height";
  case Unsolved::too_many_patches:
    return "wheel and rail touch in more than 128 patches";
  case Unsolved::pressures:
    return "the pressures have not converged: see the residual";
  case Unsolved::tractions:
    return "the tangential problem of a patch has not converged: see its status";
  case Unsolved::beyond_elements:
    return "the contact reaches beyond the elements of its patch";
  case Unsolved::residual:
    return "not converged: see the residual";
  case Unsolved::numbers:
    return "a number beyond all bounds: the contact would be larger than the bodies";
  case Unsolved::derivatives:
    return "derivatives beyond all bounds: the wheel hardly moves";
  case Unsolved::implausible:
    return "solved, but it cannot be meant: see the warnings";
  case Unsolved::no_balance:
    return "no height, roll and rolling speed give the load and the torque";
  case Unsolved::off_its_rail:
    return "a wheel is not above its rail";
  }
  return "";
}

} // namespace microslip
