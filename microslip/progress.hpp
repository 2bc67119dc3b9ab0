#pragma once

#include <functional>

namespace microslip {

/// Called now and then by long work with the fraction done, 0 to 1. Returning false asks the work to stop.
using Progress = std::function<bool(double fraction)>;

} // namespace microslip
