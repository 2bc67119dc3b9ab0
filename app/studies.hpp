#pragma once

#include "app/validate.hpp"

namespace microslip::app {

/// Runs the studies that are asked for and prints their figures; returns the exit code.
int run_studies(const ValidateArguments& arguments);

/// Runs vehicles and prints how fast they are; returns the exit code.
int bench_vehicle(bool json);

} // namespace microslip::app
