#pragma once

#include "fmi/model.hpp"

#include <string>

namespace microslip::fmi {

/// Version of the Functional Mock-up Interface.
enum class Version { fmi2, fmi3 };

/// modelDescription.xml (FMI 2.0, section 2.2; FMI 3.0, section 2.4) of a unit for model
/// exchange and co-simulation. With FMI 3.0 the
/// independent variable `time` follows those of the table. Throws Error for a unit of measurement that is no product of
/// powers of those known.
std::string model_description(const ModelInfo& info, Version version);

/// documentation/index.html of a unit: what it computes, and its variables with units, starts and ranges.
std::string documentation(const ModelInfo& info);

/// Key of description and binary, the guid or instantiation token: it changes when the description does.
std::string guid(const ModelInfo& info, Version version);

} // namespace microslip::fmi
