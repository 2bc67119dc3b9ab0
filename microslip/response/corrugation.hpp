#pragma once

#include "microslip/contact/force_response.hpp"

#include <complex>
#include <span>
#include <vector>

namespace microslip {

/// Receptance of wheel and rail at their contact over the frequency: by how far they part for each newton of the normal
/// force, the sum of both bodies' displacements along the forces on them; amplitudes of e^{i omega t}.
class Receptance {
public:
  /// Throws Error unless frequencies [Hz] ascend from 0 on and there is a finite receptance [m/N] for each.
  Receptance(std::vector<double> frequencies, std::vector<std::complex<double>> values);

  /// Linear between the frequencies. Throws Error beyond them.
  std::complex<double> at(double frequency) const;
  double least_frequency() const { return frequencies_.front(); }
  double largest_frequency() const { return frequencies_.back(); }

private:
  std::vector<double> frequencies_;
  std::vector<std::complex<double>> values_;
};

/// Wear that is proportional to the frictional work on the surface.
struct WorkWear {
  double coefficient = 0; ///< volume worn off per frictional work [m^3/J]
  double width = 0;       ///< of the running band that the work is spread over [m]
};

/// A wave of the surface's height r e^{i k x} under a passage; per metre of r.
struct CorrugationGrowth {
  std::complex<double> normal_force; ///< its oscillation [N/m]
  std::complex<double> work;         ///< amplitude of the frictional work per metre of the surface [N/m]
  /// Growth of the wave's amplitude by a passage, over itself [-]: the real part > 0 makes it higher, and one of -1
  /// wears it off; the imaginary part moves it, by that many radians of the wave along -x.
  std::complex<double> rate;
};

/// The growth in one passage, at constant creepages. Roughness r and the bodies' approach a make the normal force
///
///     F = F_r r + k_H a,   a = -G F,   so   F = F_r r/(1 + k_H G)
///
/// with G the receptance at the frequency `speed` k/(2 pi), k_H the normal stiffness; and the frictional work
/// W = W_r r + W_F k_H a. Worn off is c W/B, with the wear coefficient c and the band's width B, so the rate is
/// -(c/B) W/r. This is the feedback of Hempelmann & Knothe 1996 with the responses of the contact in place of their
/// linear creep coefficients. Throws Error for frequencies beyond the receptance's, and for responses without
/// roughness.
std::vector<CorrugationGrowth> corrugation_growth(const FrequencyResponse& response, double speed,
                                                  const Receptance& receptance, const WorkWear& wear);

} // namespace microslip
