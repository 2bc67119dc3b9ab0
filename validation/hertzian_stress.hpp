#pragma once

#include "microslip/elasticity/stress.hpp"

namespace microslip::validation {

/// Stresses below p0 sqrt(1 - r^2/a^2) on a circle of radius a, at (x, 0, z), z > 0 (Huber 1904; Fischer-Cripps 2007,
/// section 5.3). The rings' direction is y. In units of p0, with a = 1.
Stress stress_below_sphere(double poisson_ratio, double x, double z);

/// Stresses below p0 sqrt(1 - x^2/a^2) on a strip of half-width a, plane strain (McEwen 1949; Johnson 1985, (4.49)). In
/// units of p0, with a = 1.
Stress stress_below_cylinder(double poisson_ratio, double x, double z);

/// The same for the tangential traction px = p0 sqrt(1 - x^2/a^2) (Johnson 1985, section 7.1).
Stress stress_below_pulled_cylinder(double poisson_ratio, double x, double z);

} // namespace microslip::validation
