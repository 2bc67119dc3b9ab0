#pragma once

#include "validation/models/normal_patch.hpp"
#include "validation/models/patch_gap.hpp"

namespace microslip::validation {

/// ANALYN (Sichani, Enblom & Berg 2014) in the form of the program CONTACT, (H15): a strip of the curvature B, with
/// Hertz's ellipse for A, B and the approach, has the local depth d = approach (1 - h/(B b^2)), the half-length
/// a sqrt(d/approach), and a pressure whose peak is Hertz's for A, B and d. Curvatures as PatchGap::across.
NormalPatch analyn(const PatchGap& gap, const CombinedMaterial& material, double approach);

} // namespace microslip::validation
