#pragma once

#include "compat/contact/wheel_rail/records.hpp"

namespace microslip::contact_program {

/// Throws Error for a gap with more points than a search for contact may have, over the locus or, `on_grid`, along and
/// across the track, on which a wheel of this radius [m] is searched by brute force.
void require_few_points(double on_line, const PatchRules& sizes);
void require_few_points(double along, double across, const PatchRules& sizes, double radius);
/// Throws Error for a search by brute force with fewer rows across the rail than the least gap and the curvature there
/// are found from; `widest` is the DS that would give one step [m].
void require_rows(double rows, double widest, const PatchRules& sizes);

} // namespace microslip::contact_program
