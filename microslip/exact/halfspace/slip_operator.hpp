#pragma once

#include <cstddef>
#include <span>

namespace microslip {

/// From so many unknowns on linear systems have products and preconditioners in single precision. By trial: with 13,000
/// elements that saves a tenth of a solve, with 50,000 a quarter; with fewer the product in double for the slip of each
/// Newton step takes what they save.
inline constexpr std::size_t rough_unknowns = std::size_t(1) << 14;

/// A linear map D from tractions to slip on the elements of a contact, with a preconditioner: all that a
/// friction problem needs to know of bodies, elements and motion.
class SlipOperator {
public:
  virtual ~SlipOperator() = default;

  /// s = D p.
  virtual void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) = 0;

  /// s = D p in single precision, where there is that: for the products of linear systems that are solved to a few
  /// digits. A displacement has errors of some 1e-7 of the largest one; a difference of them over an element has what
  /// that is over it.
  virtual void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                             std::span<double> sy) {
    apply(px, py, sx, sy);
  }
  virtual bool has_rough_product() const { return false; }

  /// q = M^-1 p, where M is near D over its scale: a right preconditioner for linear systems with D. Counts for
  /// elements in contact; p is zero elsewhere. Returns false, with q as it was, if there is none.
  virtual bool precondition(std::span<const double> /*px*/, std::span<const double> /*py*/, std::span<double> /*qx*/,
                            std::span<double> /*qy*/) {
    return false;
  }

  /// Diagonal entry of an interior element, the mean of D_xx and D_yy.
  virtual double diagonal() const = 0;

  /// Response of D to tractions that vary over medium distances: where to tell adhesion from slip, z = p - s/scale,
  /// predicts best. Where all tractions have slip of about the same size, the diagonal.
  virtual double scale() const { return diagonal(); }

  /// Number of products with D so far.
  virtual long products() const = 0;

protected:
  SlipOperator() = default;
  SlipOperator(const SlipOperator&) = default;
  SlipOperator(SlipOperator&&) = default;
  SlipOperator& operator=(const SlipOperator&) = default;
  SlipOperator& operator=(SlipOperator&&) = default;
};

} // namespace microslip
