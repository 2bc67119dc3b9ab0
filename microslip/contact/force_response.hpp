#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <complex>
#include <span>
#include <vector>

namespace microslip {

/// Small oscillations e^{i omega t} about steady rolling, k = omega/V [1/m]: complex amplitudes of fx, fy [N], mz [Nm]
/// in rows, as ExactDerivatives has them for k = 0. An imaginary part of the other sign than the real one is a lag.
///
/// Roughness is a wave of the surfaces' height r e^{i k x} that comes towards the contact with omega = k V, r > 0 where
/// they are nearer to each other; the bodies keep their distance. Work is the frictional work on the surface per metre
/// of it [J/m]: a place X of the surface that was at the contact's origin at t = X/V has the amplitude's e^{i k X}.
///
/// Those by roughness are zero unless they were asked for, and work by the load may be, too.
struct ForceResponse {
  double wavenumber = 0;                         ///< k [1/m]: the wavelength along the track is 2 pi/k
  std::complex<double> by_creepage[3][3] = {};   ///< per unit of xi, eta [-], phi [1/m]
  std::complex<double> by_load[3] = {};          ///< per newton of the normal force
  std::complex<double> by_roughness[3] = {};     ///< per metre of roughness
  std::complex<double> load_by_roughness = 0;    ///< the normal force per metre of roughness [N/m]
  std::complex<double> work_by_creepage[3] = {}; ///< [N], of spin [N m]
  std::complex<double> work_by_load = 0;         ///< per newton of the normal force [-]
  std::complex<double> work_by_roughness = 0;    ///< per metre of roughness [N/m]
};

/// What responses are asked for: to creepages and the load, to roughness too, or to all but creepages.
enum class ResponseTo { motion_and_load, roughness_too, load_and_roughness };

/// The response of the mirror image along x or across, as rolling along -x, or right wheels, have it.
ForceResponse mirrored_along(ForceResponse response);
ForceResponse mirrored_across(ForceResponse response);

/// Throws Error for wavenumbers out of range [1/m].
void require_wavenumbers(std::span<const double> wavenumbers);

/// The responses of a contact over the wavenumber, about its steady solution.
struct FrequencyResponse {
  ContactSolution solution = {};
  std::vector<ForceResponse> at = {}; ///< in the order of the wavenumbers; none where the solution is not converged
  double normal_stiffness = 0;        ///< dFn/d(delta) [N/m]
  long products = 0;                  ///< that the responses took
};

} // namespace microslip
