#pragma once

#include "validation/models/normal_patch.hpp"
#include "validation/models/patch_gap.hpp"

#include <string>
#include <vector>

namespace microslip::validation {

/// A model of the normal problem: the contact at a point, from the gap and the approach [m] > 0.
struct NormalModel {
  std::string name, source;
  NormalPatch (*press)(const PatchGap& gap, const CombinedMaterial& material, double approach);
};

/// Hertz, the equivalent ellipse, Kik & Piotrowski, STRIPES, ANALYN.
const std::vector<NormalModel>& normal_models();

} // namespace microslip::validation
