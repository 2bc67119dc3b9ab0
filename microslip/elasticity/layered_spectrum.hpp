#pragma once

#include "microslip/elasticity/creep_basis.hpp"
#include "microslip/elasticity/layered_response.hpp"

#include <span>

namespace microslip {

/// The rest of a layered body's response, as an instantaneous part and parts retarded by the times T_m of its creep
/// basis: rest(k, omega) = rest_0(k) + sum of rest_m(k)/(1 + i omega T_m). A stack of viscoelastic layers so is a sum
/// of elastic ones with memory, whatever the speed at which it is rolled over.
class LayeredSpectrum {
public:
  /// Throws Error for values of `body` out of range.
  explicit LayeredSpectrum(const LayeredBody& body);

  std::span<const double> times() const { return basis_.times(); }
  std::size_t parts() const { return 1 + times().size(); }
  /// Sets rest_0, rest_1 ... at the wavenumber k > 0, times k.
  void find(double k, std::span<SurfaceResponse<double>> rest) const;
  /// Sets those of endlessly long waves: the substrate's half-space, or 0 of a rigid core, less the surface's.
  void find_long(std::span<SurfaceResponse<double>> rest) const;

private:
  template <class Response> void find_parts(const Response& of, std::span<SurfaceResponse<double>> rest) const;

  CreepBasis basis_;
  LayerStack<double> instantaneous_;
  std::vector<LayerStack<std::complex<double>>> stacks_; ///< at the basis' frequencies
};

} // namespace microslip
