#pragma once

#include <array>
#include <vector>

namespace microslip::validation {

/// The half-line x < 0 in full adhesion with a leading element ahead of it, by Wiener-Hopf factorisation.
///
/// Regular elements n = 0, 1, ... of width 1 have the centres -(n + 1/2) and constant tractions p_n; the leading
/// element covers 0 < x < omega. The displacement, for the kernel -ln|x|/pi, is the same at all centres and at omega +
/// 1/2. Far away p ~ (d - x)^(1/2) (1 + 0/x + ...): d is the position of the edge, and beta = d - omega.
///
/// The displacements of regular elements at their centres have the symbol K = M/(2 |sin(theta/2)|), K(z) = K+(z)
/// K+(1/z). With G = (1 - z)^(-1/2)/K+ the sequences p_n with generating functions G (1 - z)^(-1/2) and G (1 -
/// z)^(-3/2) are the homogeneous solutions that grow like n^(-1/2) and n^(1/2); kappa = -G'(1)/G(1) sets their far
/// fields. Displacements ahead of the half-line are integrals over s > 0 of generating functions at z = exp(-s).
///
/// All integrals are taken by the trapezoidal rule in the logarithm of their variable, whose error falls like
/// exp(-pi^2/spacing). Construction costs O(1/spacing^2), so does each distance.
class HalfLine {
public:
  explicit HalfLine(double spacing);

  /// beta(1) = 1/4 + kappa.
  double full_width_inset() const { return 0.25 + kappa_; }
  /// d(omega) = omega + beta(omega), omega > 0.
  double distance(double omega) const;
  /// The same where the displacement is that of the centres at these two points instead of omega/2 and omega + 1/2.
  double distance(double omega, const std::array<double, 2>& points) const;

private:
  double growing(double y) const;
  double decaying(double y) const;
  std::vector<double> induced(double omega) const;
  double leading(double y, double omega, const std::vector<double>& source) const;

  double kappa_ = 0, first_ = 0;
  std::vector<double> s_, weight_; ///< nodes, and weights with the factor 1/pi
  std::vector<double> log_c_;      ///< ln c, c = 1 - exp(-s)
  std::vector<double> log_g_;      ///< ln(G(exp(-s))/G(0))
  std::vector<double> chain_;      ///< sum over n >= 1 of exp(-n (s + t)) for all pairs of nodes
};

} // namespace microslip::validation
