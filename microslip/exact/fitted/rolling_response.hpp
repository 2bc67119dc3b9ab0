#pragma once

#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/fitted/fitted_operator.hpp"
#include "microslip/exact/newton/friction_newton.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace microslip {

using ComplexField = std::vector<std::complex<double>>;

/// Means over the path of an element's slip, from its point x_I to the end ahead, of what oscillates as e^{i omega t}
/// while a particle runs through it: of f(x) e^{-i k (x - x_I)} with k = omega/V [1/m], by Gauss's rule of three
/// points.
template <class Function>
std::complex<double> mean_over_path(const FittedElement& e, double wavenumber, const Function& f) {
  constexpr double node = 0.7745966692414834; // sqrt(3/5)
  const double half = (e.end - e.point) / 2;
  const auto at = [&](double t) { return f(e.point + (1 + t) * half) * std::polar(1.0, -wavenumber * (1 + t) * half); };
  return (5.0 * at(-node) + 8.0 * at(0) + 5.0 * at(node)) / 18.0;
}

/// Small oscillations e^{i omega t} about steady rolling along +x, with adhesion, slip and its direction those of the
/// steady state: the complex linear equations that RollingDerivative has for omega = 0. A particle at x_I was at
/// x_{I+1} the time d/V before, so the displacement there has the factor e^{-i k d}, k = omega/V:
///
/// s_I = w_I + (u(x_I) - e^{-i k d} u(x_{I+1}))/d
///
/// and slip is moved to the elements' centres (CentredSlip) along the particles' paths in time. Second order in the
/// elements' length where k d is small against 1.
class RollingResponse {
public:
  RollingResponse(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans);
  RollingResponse(RollingResponse&&) noexcept;
  RollingResponse& operator=(RollingResponse&&) noexcept;
  ~RollingResponse();

  /// The steady solution of a problem with these traction bounds, whose slip at these elements is that at their
  /// centres. Holds where no element is just between adhesion and slip.
  void linearise(std::span<const double> bound, const FrictionSolution& solution, std::span<const char> centred);

  /// Complex amplitudes of what makes the tractions oscillate.
  struct Cause {
    ComplexField cx, cy; ///< of the slip without tractions, means over the elements' paths [-]
    ComplexField bound;  ///< of g [Pa]; empty: none

    explicit Cause(std::size_t elements) : cx(elements), cy(elements) {}
  };
  /// Complex amplitudes.
  struct Change {
    ComplexField px, py; ///< of the tractions [Pa]
    ComplexField sx, sy; ///< of the slip, as the solution has it [-]
    long products = 0;   ///< with the operator, two for each complex one
  };

  /// To a relative residual of `tolerance`. Cost: some tens of complex products. Throws Stopped.
  Change solve(double wavenumber, const Cause& cause, double tolerance, const Progress& progress = {});

private:
  class Equations;
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

} // namespace microslip
