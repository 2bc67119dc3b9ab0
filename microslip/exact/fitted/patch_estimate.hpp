#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/exact/fitted/nested_rolling.hpp"

#include <optional>

namespace microslip {

/// Solves a fitted contact of any shape that rolls along +x by FASTSIM (GridFastsim): with the blended flexibilities
/// of the ellipse that has the contact's area and its ratio of length to width, and spin about the centre of the load.
/// `contact` must outlive it. Cost O(elements); for prescribed forces [N], which `input` has, of some solutions.
RollingEstimate estimate_by_fastsim(const CombinedMaterial& material, const FittedContact& contact, double capacity,
                                    const SecondOrderInput& input);

} // namespace microslip
