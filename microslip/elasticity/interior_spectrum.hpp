#pragma once

#include "microslip/elasticity/creep_basis.hpp"
#include "microslip/elasticity/interior_response.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Responses at a depth of a layered body, as LayeredSpectrum has them of its surface: an instantaneous part and parts
/// retarded by the times T_m of its creep basis. In the surface's layer they are less the half-space's of its material
/// as it is at once.
class InteriorSpectrum {
public:
  /// Throws Error for values of `body` out of range, and for a depth in a rigid core.
  InteriorSpectrum(const LayeredBody& body, double depth);

  std::span<const double> times() const { return basis_.times(); }
  std::size_t parts() const { return 1 + times().size(); }
  /// The distance s [m] with which the instantaneous part decays as exp(-k s), and all do: 2 h - z in an elastic
  /// surface layer of the thickness h, else the depth z.
  double decay_distance() const { return decay_distance_; }
  /// Sets the parts' responses at the wavenumber k > 0.
  void find(double k, std::span<InteriorResponse<double>> parts) const;

private:
  CreepBasis basis_;
  LayerDepth at_;
  LayerStack<double> instantaneous_;
  std::vector<LayerStack<std::complex<double>>> stacks_; ///< at the basis' frequencies
  double decay_distance_;
};

/// These as polynomials of ln k: from waves so long that they are constant to those of which nothing is left, k s = 40.
class InteriorSpectrumTable {
public:
  /// For distances up to `reach` [m].
  InteriorSpectrumTable(const InteriorSpectrum& spectrum, double reach);

  double k_max() const { return k_max_; } ///< [rad/m]
  void find(double k, std::span<InteriorResponse<double>> parts) const;
  /// Sets those of endlessly long waves.
  void find_long(std::span<InteriorResponse<double>> parts) const { find(0, parts); }

private:
  double k_max_;
  PanelPolynomials of_logarithm_;
};

} // namespace microslip
