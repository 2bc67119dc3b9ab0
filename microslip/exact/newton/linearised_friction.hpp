#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// The derivative of friction's equations F(p) = p - P_g(z), z = p - rho s (friction_newton.hpp), at a point, element
/// by element, (E17) to (E19): with n = z/|z|, t orthogonal to n and alpha = g/|z| it is rho ds in adhesion, |z| <= g,
/// and n.dp along n, (1 - alpha) t.dp + alpha rho t.ds along t in slip. Where the bound q changes with |z|, as that of
/// a SlipDependentBound, the part along n is between both: (1 - beta) n.dp + beta rho n.ds, beta = dq/d|z|, alpha =
/// q/|z|. Vectors have the x components of all elements, then the y components. In double or in single precision.
template <class Real> class LinearisedFriction {
public:
  explicit LinearisedFriction(std::size_t elements);

  /// Sets element k. Without a traction bound it slides, and its traction is fixed.
  void set(std::size_t k, double zx, double zy, double g);
  /// Sets element k whose traction has the size q <= |z| with the derivative `beta` with respect to |z|.
  void set(std::size_t k, double zx, double zy, double q, double beta);

  /// beta of element k.
  double beta(std::size_t k) const { return beta_[k]; }
  /// The mean of alpha, 1 in adhesion.
  double mean_alpha() const;

  /// The derivative times v, whose slip is `slip`.
  void derivative(std::span<const Real> v, std::span<const Real> slip, Real rho, std::span<Real> out) const;

  /// The part of a change of the tractions that slip can bring about: all of it in adhesion, a share of what is across
  /// the traction in slip. Taken before and after a preconditioner's map the share alpha comes out: where D is s, with
  /// |s| = 1, and the map 1/s, (1 - alpha + alpha s)(1 - alpha + alpha/s) is real and positive. `out` may be `v`.
  void free_part(std::span<const Real> v, std::span<Real> out) const;

  /// The change n.dz of |z| for a change v of the tractions, whose slip is `slip`.
  void change_of_size(std::span<const Real> v, std::span<const Real> slip, Real rho, std::span<Real> out) const;
  /// Takes n times a change of the tractions' size off `v`.
  void subtract_along(std::span<const Real> size_change, std::span<Real> v) const;

private:
  std::size_t n_;
  std::vector<Real> nx_, ny_;                ///< n
  std::vector<Real> alpha_, beta_;           ///< beta is 1 in adhesion and 0 in slip with a fixed bound
  std::vector<Real> root_alpha_, root_beta_; ///< which preconditioners need often
};

} // namespace microslip
