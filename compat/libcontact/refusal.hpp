#pragma once

#include <stdexcept>
#include <string>

namespace microslip::libcontact {

/// A call that is refused: the code it returns, and why, for the log.
struct Refusal : std::runtime_error {
  Refusal(int why, const std::string& text) : std::runtime_error(text), code(why) {}
  int code;
};

} // namespace microslip::libcontact
