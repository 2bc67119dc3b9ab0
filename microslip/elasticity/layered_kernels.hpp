#pragma once

#include "microslip/elasticity/layered_spectrum.hpp"
#include "microslip/elasticity/spectrum_table.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>

namespace microslip {

/// Displacements of a layered body's surface at a distance r from a unit force, less those of the half-space of its
/// surface's material [m/N]: u_n from a normal force; u_x = sum + difference cos 2 theta from one along x, u_y =
/// difference sin 2 theta; u_x = coupling cos theta from a normal one, where (x, y) = r (cos theta, sin theta).
struct PointKernel {
  double normal, sum, difference, coupling;
};

/// Point kernels of the parts of a LayeredSpectrum: normal = integral of rest_nn J0(k r) over k/(2 pi), sum of (rest_ll
/// + rest_tt)/2 J0, difference of -(rest_ll - rest_tt)/2 J2, coupling of -rest_ln J1. They are smooth on the scale of
/// the surface layer's thickness h and kept as polynomials of asinh(r/h), relative errors some 1e-10 of the
/// half-space's displacement at the distance hypot(h, r).
class LayeredKernels {
public:
  /// Kernels of a spectrum whose surface layer has the thickness h [m], for no distances yet.
  LayeredKernels(LayeredSpectrum spectrum, double thickness);
  /// For distances up to `reach` [m].
  LayeredKernels(LayeredSpectrum spectrum, double thickness, double reach);

  /// Finds them for distances up to `reach` [m]; what was found before stays as it is.
  void extend(double reach);

  /// Retardation times [s] of the parts 1, 2 ...; part 0 is instantaneous.
  std::span<const double> times() const { return spectrum_.times(); }
  std::size_t parts() const { return spectrum_.parts(); }
  /// h [m], the scale on which kernels vary at r = 0; elsewhere it is hypot(h, r).
  double thickness() const { return thickness_; }
  void evaluate(double r, std::span<PointKernel> parts) const;

private:
  LayeredSpectrum spectrum_;
  double thickness_;
  SpectrumTable table_;
  PanelPolynomials of_distance_;
};

} // namespace microslip
