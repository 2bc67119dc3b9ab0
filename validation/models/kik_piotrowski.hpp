#pragma once

#include "validation/models/normal_patch.hpp"
#include "validation/models/patch_gap.hpp"

namespace microslip::validation {

/// Kik & Piotrowski 1996 (Piotrowski & Kik 2008, (7) to (13)): contact is where the undeformed bodies overlap when they
/// come as near as 0.55 of the approach, l(y)^2 = (0.55 approach - h(y))/A; the pressure is that of
/// pressed_at_point().
NormalPatch kik_piotrowski(const PatchGap& gap, const CombinedMaterial& material, double approach);

/// The same with its shape corrected as Piotrowski & Kik 2008 describe it in words: the region's length times c, its
/// width over c, such that L/W becomes Hertz's ratio of axes for the curvatures A/B = (W/L)^2, the area kept.
NormalPatch kik_piotrowski_corrected(const PatchGap& gap, const CombinedMaterial& material, double approach);

/// The same with a share eps(y) instead of 0.55, as the program CONTACT corrects it (KPEC, (H14)): with
/// B = approach/(2 b'^2) of the region below half of the approach, b' half its width and y' its middle, and Hertz's
/// ellipse for A, B and the approach, eps approach = A a^2 - (A a^2 - B b^2) (y - y')^2/b^2, within 0 and the approach.
NormalPatch kik_piotrowski_contact(const PatchGap& gap, const CombinedMaterial& material, double approach);

} // namespace microslip::validation
