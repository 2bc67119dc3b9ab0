#pragma once

#include "microslip/contact/force_response.hpp"

namespace microslip {

/// Contact filter: the normal force that a wave of roughness, amplitude r, makes in Hertz's contact at a given
/// approach, over r dFn/d(delta). By reciprocity it is the mean of the wave weighted by the pressure of a flat punch on
/// the ellipse, and so sin(q)/q with q^2 = (k_x a)^2 + (k_y b)^2: for waves along x and y with the wavenumbers k_x, k_y
/// [1/m].
double contact_filter(double a, double b, double wavenumber_x, double wavenumber_y = 0);

} // namespace microslip
