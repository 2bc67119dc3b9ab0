#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/vec2.hpp"
#include "validation/models/normal_patch.hpp"

#include <optional>

namespace microslip::validation {

/// Tangential force on body 1 [N] of a model's patch and pressure by the exact theory of rolling, at second order, with
/// `elements` across and along; creepages are those at the origin. Nothing where it does not converge.
std::optional<Vec2> exactly_rolled(const NormalPatch& patch, const CombinedMaterial& material, const Creepage& creepage,
                                   double friction, int elements);

} // namespace microslip::validation
