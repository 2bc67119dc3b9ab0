#pragma once

#include "io/json.hpp"

namespace microslip::explorer {

/// What the tables of inputs and of quantities say: `inputs` by the kinds of cases and the names of keys in files,
/// `outputs` of two bodies, their fields, a wheel and a patch by their names, and of the units of inputs those in which
/// numbers may be given, each with the two numbers by which one is multiplied and divided.
io::Json description();

} // namespace microslip::explorer
