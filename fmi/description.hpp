#pragma once

#include "fmi/model.hpp"

#include <string>

namespace microslip::fmi {

/// modelDescription.xml (FMI 2.0, section 2.2) of a unit for co-simulation. Throws Error for a unit of measurement that
/// is no product of powers of those known.
std::string model_description(const ModelInfo& info);

/// documentation/index.html of a unit: what it computes, and its variables with units, starts and ranges.
std::string documentation(const ModelInfo& info);

/// What ties description and binary together: it changes when the description does.
std::string guid(const ModelInfo& info);

} // namespace microslip::fmi
