#pragma once

#include "app/validate.hpp"

namespace microslip::app {

/// Runs the studies that are asked for and prints their figures; returns the exit code.
int run_studies(const ValidateArguments& arguments);

} // namespace microslip::app
