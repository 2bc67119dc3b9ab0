#pragma once

#include "microslip/elasticity/layered_spectrum.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>
#include <vector>

namespace microslip {

/// The rest of a layered body's response, of all parts, as polynomials of ln k: from waves so long that k times the
/// response is constant to those of which nothing is left.
class SpectrumTable {
public:
  /// For a surface layer of the thickness h [m] and distances up to `reach` [m].
  SpectrumTable(const LayeredSpectrum& spectrum, double thickness, double reach);

  /// Wavenumber from which on the rest is below rounding, k h = 20 [rad/m].
  double k_max() const { return k_max_; }
  /// Sets the parts' responses at k > 0, times k.
  void find(double k, std::span<SurfaceResponse<double>> rest) const;
  /// Sets those of endlessly long waves, times k.
  void find_long(std::span<SurfaceResponse<double>> rest) const { find(0, rest); }

private:
  double k_max_;
  PanelPolynomials of_logarithm_;
};

} // namespace microslip
