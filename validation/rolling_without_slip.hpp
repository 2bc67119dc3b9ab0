#pragma once

namespace microslip::validation {

/// Creepage coefficients as in CreepageCoefficients, with C32 by itself: it equals -C23, which shows how exact both
/// are.
struct LinearCoefficients {
  double c11, c22, c23, c32, c33;
};

/// The linear theory of rolling (Kalker 1967) on the half-space: bodies that roll over an elliptic contact, semi-axes a
/// (rolling direction) and b, without slip, so that w = du/dx everywhere and tractions vanish at the leading edge.
///
/// On the unit disk the tractions are p_j = P_j(x, y)/sqrt(1 - x^2 - y^2) with polynomials of a degree. Along the lines
/// x cos w + y sin w = s they have integrals g_j(w, s) = sum_n P_n(s) g_jn(w), with Legendre's P_n and Fourier series
/// g_jn of the harmonics -n, 2 - n, ..., n; the displacements are u_i = (a b/(pi G)) times the integral of k_ij(w)
/// g_j(w, x cos w + y sin w) over w from 0 to pi. So every degree n is a separate small system. What is free is a
/// function of y in each u_i; it makes P_j = g_j(w, 1)/pi vanish along the leading edge, in the sense of least squares.
///
/// Ratios from 0.01 to 100, nu from 0 to 0.5. Cost: degree^4. Digits at degree 32: 6 for a/b from 0.5 to 2, 4 at 0.05
/// and 20.
LinearCoefficients rolling_without_slip(double a_over_b, double poisson_ratio, int degree);

} // namespace microslip::validation
