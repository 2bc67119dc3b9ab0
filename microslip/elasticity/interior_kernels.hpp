#pragma once

#include "microslip/elasticity/interior_influence.hpp"
#include "microslip/elasticity/interior_spectrum.hpp"
#include "microslip/numerics/panel_polynomials.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Kernels of a point force at a distance, before their angles.
struct InteriorPointState {
  struct {
    double un, ur, nn, rn, mean, difference;
  } normal;
  struct {
    double u_mean, u_difference, un, nn, shear_mean, shear_difference, m, e, f;
  } along;

  /// Influence on body 1 of point forces at a point [1/N, and 1/m2].
  InteriorInfluence at(double x, double y) const;
};

/// Kernels of a line of forces at a distance x >= 0.
struct InteriorLineState {
  struct {
    double un, ux, nn, xn, xx, yy;
  } normal;
  struct {
    double ux, un, xn, nn, xx, yy;
  } along;
  double uy, yn, xy; ///< of forces along the line

  /// Influence on body 1 of forces per length; what is odd changes its sign for x < 0.
  InteriorInfluence at(double x) const;
};

/// States at a depth of the parts of an InteriorSpectrum, at the distance r from unit forces on the surface: integrals
/// over k/(2 pi) of responses times J0 to J3(k r). They are smooth on the scale of s, the distance with which the
/// spectrum decays, and kept as polynomials of asinh(r/s), relative errors some 1e-10 of the half-space's state at the
/// distance hypot(s, r). With (x, y) = r (cos theta, sin theta), of a normal force:
///   u_n, sigma_nn J0; u_r, sigma_rn -J1; sigma_xx, yy = mean J0 +- d cos 2 theta, sigma_xy = d sin 2 theta, d -J2;
/// of one along x: u_x, sigma_xn as the mean J0 and d cos 2 theta, u_y, sigma_yn d sin 2 theta; u_n, sigma_nn J1
/// cos theta; sigma_xx, yy = (m +- e) cos theta +- f cos 3 theta, sigma_xy = e sin theta + f sin 3 theta with
/// m = (sigma_ll + sigma_tt)/2 J1, e = ((sigma_ll - sigma_tt)/4 - sigma_lt/2) J1, f = -((sigma_ll - sigma_tt)/4 +
/// sigma_lt/2) J3. One along y is that turned.
class InteriorPointKernels {
public:
  /// For distances up to `reach` [m].
  InteriorPointKernels(const InteriorSpectrum& spectrum, double reach);

  /// s [m], the scale on which kernels vary at r = 0.
  double smooth_distance() const { return scale_; }
  std::size_t parts() const { return parts_; }
  void evaluate(double r, std::span<InteriorPointState> parts) const;

  static constexpr std::size_t kinds = 15;

private:
  double scale_;
  std::size_t parts_;
  PanelPolynomials of_distance_;
};

/// States at the distance x from lines of unit forces per length, of endless strips: integrals over k/pi of responses
/// times cos(k x) or sin(k x). Displacements along forces have the long waves' limit b taken out as b exp(-k s), of
/// which the integral is -b ln(hypot(s, x)/far), as LayeredLineKernels.
class InteriorLineKernels {
public:
  InteriorLineKernels(const InteriorSpectrum& spectrum, double reach, double far);

  double smooth_distance() const { return scale_; }
  std::size_t parts() const { return parts_; }
  void evaluate(double x, std::span<InteriorLineState> parts) const;

  static constexpr std::size_t kinds = 15;

private:
  double scale_;
  std::size_t parts_;
  PanelPolynomials of_distance_;
};

} // namespace microslip
