#pragma once

namespace microslip {

/// Remington's contact filter |H| of roughness at a wavenumber k [1/m] along the track (Remington 1976): the root of
///
///     |H|^2 = 4/alpha 1/(k r)^2 times the integral of J_1(k r sec x)^2 from 0 to arctan(alpha),
///
/// of a circular contact of the radius r [m], over which the roughness is averaged evenly. alpha >= 0 tells how soon
/// roughness changes across the track: at 0, the limit 2 J_1(k r)/(k r), waves have straight crests; the larger, the
/// less neighbouring lines of it have in common.
double remington_filter(double radius, double alpha, double wavenumber);

} // namespace microslip
