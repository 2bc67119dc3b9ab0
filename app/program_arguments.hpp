#pragma once

#include <string>
#include <vector>

namespace microslip::app {

/// The arguments of `main` without the program itself, as UTF-8, which the console then takes and shows where it must
/// be told to.
std::vector<std::string> program_arguments(int count, char** arguments);

} // namespace microslip::app
