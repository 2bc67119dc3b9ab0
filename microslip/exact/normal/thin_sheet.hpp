#pragma once

#include "microslip/exact/normal/normal_problem.hpp"

#include <span>

namespace microslip {

/// Normal contact of a thin compressible sheet on rigid bodies, an elastic (Winkler) foundation: u_n = L p_n, so that
/// p_n = (delta - h)/L where that is positive (Johnson 1985, section 4.3). For a sheet of thickness t that is bonded to
/// its base L = t (1 + nu)(1 - 2 nu)/((1 - nu) E).
///
/// `flexibility` is L [m/Pa], `gap` the undeformed distance h of the elements [m]; `excluded` is 1 for elements that
/// cannot come into contact, empty: none. Direct: residual 0, no iterations. A given force is met to rounding. No
/// element in contact is Status::no_contact. Throws Error for input out of range. Cost O(N log N) with a force, O(N)
/// with an approach.
NormalSolution solve_thin_sheet(double flexibility, const ElementGrid& grid, std::span<const double> gap,
                                const NormalLoad& load, std::span<const char> excluded = {});

} // namespace microslip
