#pragma once

#include <string_view>
#include <vector>

namespace microslip::app {

/// Names of the case files that `microslip init` writes, first that by default.
std::vector<std::string_view> example_names();

} // namespace microslip::app
