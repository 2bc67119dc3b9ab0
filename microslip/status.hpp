#pragma once

#include <string_view>

namespace microslip {

/// How a calculation ended. It is part of every result; anything but `ok` comes with a reason a user can act on.
enum class Status {
  ok,            ///< the result satisfies the equations to the tolerance it states
  invalid_input, ///< an input is not a number or outside its range; the result's numbers are NaN
};

constexpr std::string_view to_string(Status status) {
  return status == Status::ok ? "ok" : "invalid_input";
}

} // namespace microslip
