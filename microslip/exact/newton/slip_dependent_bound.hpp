#pragma once

#include <memory>
#include <span>

namespace microslip {

/// A traction bound q that depends on the slip, instead of g in (E15). An element with |z| = |p - rho s| adheres if
/// |z| does not exceed its bound at rest. Else its traction is q(l) and its slip the l > 0 with q(l) + rho l = |z|,
/// (B8). What particles bring along from element to element, such as plastic deformation, counts as well: a bound may
/// depend on |z| of the elements that its particles come through before. Fields have all elements of a grid.
class SlipDependentBound {
public:
  virtual ~SlipDependentBound() = default;

  /// The largest q of any slip: the residual counts in its norm, and where it is zero an element carries nothing.
  virtual void largest(std::span<const double> pressure, std::span<double> bound) const = 0;
  /// Least rho with one slip for each |z|, where the bound falls with the slip [Pa].
  virtual double least_rho(std::span<const double> pressure) const = 0;
  /// q for |z|, in adhesion that at rest.
  virtual void project(std::span<const double> size, std::span<const double> pressure, double rho,
                       std::span<double> bound) const = 0;
  /// The same, and its derivative z|, 1 in|with respect to the element's |z|, 1 in |z|, 1 in adhesion, where it is that
  /// of the traction's size. `carry` then is the rest of the derivative.
  virtual void linearise(std::span<const double> size, std::span<const double> pressure, double rho,
                         std::span<double> bound, std::span<double> own) = 0;
  /// Change of the bound with the pressure and with the state of entering particles, where there is slip. No pressure
  /// changes if `pressure_change` is empty. Returns false, and leaves bound_change as it was, if nothing does.
  virtual bool carry(std::span<const double> size_change, std::span<const double> pressure_change,
                     std::span<double> bound_change) const = 0;

  /// The same law on elements twice as long and wide, whose particles take `longer` times as long for a step; nothing
  /// where a solution need not be the only one, so that one there may be another.
  virtual std::unique_ptr<SlipDependentBound> on_coarser(double longer) const = 0;

protected:
  SlipDependentBound() = default;
  SlipDependentBound(const SlipDependentBound&) = default;
  SlipDependentBound(SlipDependentBound&&) = default;
  SlipDependentBound& operator=(const SlipDependentBound&) = default;
  SlipDependentBound& operator=(SlipDependentBound&&) = default;
};

} // namespace microslip
