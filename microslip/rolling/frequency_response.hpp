#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <complex>
#include <vector>

namespace microslip {

/// Small oscillations e^{i omega t} of the forces about steady rolling, k = omega/V [1/m]: complex amplitudes of fx, fy
/// [N], mz [Nm] in rows, as ExactDerivatives has them for k = 0. An imaginary part of the other sign than the real one
/// is a lag.
struct ForceResponse {
  double wavenumber = 0;                       ///< k [1/m]: the wavelength along the track is 2 pi/k
  std::complex<double> by_creepage[3][3] = {}; ///< per unit of xi, eta [-], phi [1/m]
  std::complex<double> by_load[3] = {};        ///< per newton of the normal force
};

/// The responses of a contact over the wavenumber, about its steady solution.
struct FrequencyResponse {
  ContactSolution solution;
  std::vector<ForceResponse> at; ///< in the order of the wavenumbers; none where the solution is not converged
  long products = 0;             ///< that the responses took
};

/// Contact filter: the normal force that a wave of roughness, amplitude r, makes in Hertz's contact at a given
/// approach, over r dFn/d(delta). By reciprocity it is the mean of the wave weighted by the pressure of a flat punch on
/// the ellipse, and so sin(q)/q with q^2 = (k_x a)^2 + (k_y b)^2: for waves along x and y with the wavenumbers k_x, k_y
/// [1/m].
double contact_filter(double a, double b, double wavenumber_x, double wavenumber_y = 0);

} // namespace microslip
