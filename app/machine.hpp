#pragma once

#include <string>

namespace microslip::app {

/// The processor's name and the number of its threads, and the system, for what is measured or filed.
std::string machine();

} // namespace microslip::app
