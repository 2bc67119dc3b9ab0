#pragma once

#include "microslip/elasticity/layered_spectrum.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>
#include <vector>

namespace microslip {

/// The rest of a layered body's response, of all parts, as polynomials of ln k: from the shortest waves, of which
/// nothing is left, to ones as long as needed.
class SpectrumTable {
public:
  /// For a surface layer of the thickness h [m].
  SpectrumTable(const LayeredSpectrum& spectrum, double thickness);

  /// Adds longer waves, those that a distance `reach` [m] needs: until k times the response is constant.
  void extend(const LayeredSpectrum& spectrum, double reach);

  /// Wavenumber from which on the rest is below rounding, k h = 20 [rad/m].
  double k_max() const { return k_max_; }
  /// Sets the parts' responses at k > 0, times k.
  void find(double k, std::span<SurfaceResponse<double>> rest) const;

private:
  double k_max_;
  PanelPolynomials of_length_; ///< of -ln k
};

} // namespace microslip
