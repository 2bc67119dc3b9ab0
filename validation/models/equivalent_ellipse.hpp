#pragma once

#include "validation/models/normal_patch.hpp"
#include "validation/models/patch_gap.hpp"

namespace microslip::validation {

/// Hertz 1882 with the curvatures of the surfaces where they touch.
NormalPatch hertz_at_point(const PatchGap& gap, const CombinedMaterial& material, double approach);

/// Hertz's ellipse of the virtual penetration (Piotrowski & Chollet 2005). The region in which
/// A x^2 + h(y) is below 0.55 of the approach has the area S, the length L and the width W; the ellipse with this area
/// and this ratio of axes, a = sqrt(S L/(pi W)), b = sqrt(S W/(pi L)), is where bodies with the curvatures
/// 0.55 approach/a^2 and 0.55 approach/b^2 overlap likewise: the contact is Hertz's of these curvatures and the
/// approach, in the middle of the region.
NormalPatch equivalent_ellipse(const PatchGap& gap, const CombinedMaterial& material, double approach);

} // namespace microslip::validation
