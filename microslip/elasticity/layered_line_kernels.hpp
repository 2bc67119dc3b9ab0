#pragma once

#include "microslip/elasticity/layered_spectrum.hpp"
#include "microslip/elasticity/spectrum_table.hpp"
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
  /// For a surface layer of the thickness h [m], for no distances yet.
  LayeredLineKernels(LayeredSpectrum spectrum, double thickness);

  /// Finds them for distances up to `reach` [m]; what was found before stays as it is.
  void extend(double reach);

  std::size_t parts() const { return spectrum_.parts(); }
  /// h [m], the scale on which kernels vary at x = 0.
  double thickness() const { return thickness_; }
  /// Sets the kernels at x >= 0, with displacements that approach 0 at the distance `far` [m].
  void evaluate(double x, double far, std::span<LineKernel> parts) const;

private:
  LayeredSpectrum spectrum_;
  double thickness_;
  SpectrumTable table_;
  std::vector<SurfaceResponse<double>> limit_; ///< b of each part
  PanelPolynomials of_distance_;               ///< with h for `far`
};

} // namespace microslip
