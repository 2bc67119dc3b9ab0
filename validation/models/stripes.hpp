#pragma once

#include "validation/models/normal_patch.hpp"
#include "validation/models/patch_gap.hpp"

namespace microslip::validation {

/// STRIPES (Ayasse & Chollet 2005; Quost, Sebes, Eddhahak, Ayasse, Chollet, Gautier & Thouverez 2006), with corrected
/// longitudinal curvatures. With n = b and m = a of Hertz's ellipses of a unit size, r their approach, and lambda = A/B
/// where the bodies touch, the bodies overlap over h0 = eps approach, eps = n^2/(r (1 + lambda)), which is B b^2. A
/// strip with the curvature B has A_c = B (n/m)^2 instead of A, the half-length sqrt((h0 - h)/A_c), and the load
/// E (1 + lambda)/(2 (1 - nu^2) n^3) (h0 - h) dy. So an ellipse is Hertz's; curvatures as PatchGap::across.
NormalPatch stripes(const PatchGap& gap, const CombinedMaterial& material, double approach);

} // namespace microslip::validation
