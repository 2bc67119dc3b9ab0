#pragma once

#include "microslip/elasticity/layered_spectrum.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Displacements of a layered body's surface at the distance x from a line force of unit size per length, less those of
/// the half-space of its surface's material [1/Pa]: u_n from a normal force, u_x from one along x, u_y from one along
/// the line; u_x = coupling for x > 0 from a normal one, which is odd in x.
struct LineKernel {
  double normal, along, across, coupling;
};

/// Line kernels of the parts of a LayeredSpectrum. With b the long waves' limit of k times the response's rest X,
/// normal = (integral of (X_nn - b exp(-k h)) cos(k x)/k - b ln(hypot(h, x)/far))/pi, along and across likewise, and
/// coupling =
/// -(integral of X_ln sin(k x)/k)/pi. So the displacement of a half-space below layers approaches 0 at the distance
/// `far`, where that of line_influence is 0, and that of layers on a rigid core decays.
class LayeredLineKernels {
public:
  /// For a surface layer of the thickness h [m] and distances up to `reach` [m].
  LayeredLineKernels(const LayeredSpectrum& spectrum, double thickness, double reach, double far);

  std::size_t parts() const { return parts_; }
  /// h [m], the scale on which kernels vary at x = 0.
  double thickness() const { return thickness_; }
  /// Sets the kernels at x >= 0.
  void evaluate(double x, std::span<LineKernel> parts) const;

private:
  double thickness_;
  std::size_t parts_;
  PanelPolynomials of_distance_;
};

} // namespace microslip
