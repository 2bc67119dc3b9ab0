#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/fitted/fitted_operator.hpp"
#include "microslip/exact/fitted/rolling_derivative.hpp"
#include "microslip/exact/fitted/rolling_response.hpp"
#include "microslip/exact/fitted/row_variation.hpp"
#include "microslip/exact/newton/friction_newton.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

struct SecondOrderInput {
  Creepage creepage;
  RowVariation variation = {};
  std::optional<double> force_x, force_y; ///< [N], on body 1; the creepage in that direction is an unknown then
  FrictionStart start;                    ///< for each element; the constants are the creepages where a force is given
  std::span<const char> centred = {};     ///< of a solution near the start (SecondOrderSolution); empty: to be found
  Progress progress = {};  ///< called after each Newton step; false ends the iteration, with status not_converged
  double tolerance = 1e-6; ///< of the residual, as in FrictionSolution
};

struct SecondOrderSolution {
  FrictionSolution friction; ///< tractions, slip and state of each element
  std::vector<char> centred; ///< 1: the element's slip is that at its centre, as CentredSlip has it
  VectorField displacement;  ///< difference [m]
  Creepage creepage;
  double frictional_work = 0; ///< per metre rolled [N]

  /// Solution to be found: creepages as given, 0 where a force is.
  SecondOrderSolution(const SecondOrderInput& input, std::size_t elements);
  SecondOrderSolution() = default;
  /// Adds the creepages that were found for the given forces.
  void add_found_creepages();
};

/// Steady rolling along +x with forces of second order in the elements' size. Three measures make it so: leading
/// elements fitted to the edge (FittedContact), the traction bound averaged over each element's area, and slip taken
/// where the traction is. Slip is computed over the path between the centres of two elements and belongs to its middle;
/// at the centre of a sliding element it is interpolated (CentredSlip). Which elements slide is found roughly with the
/// slip as it is; then the problem is solved with the slip of those at their centres. If this set were updated during
/// the iteration, Newton's method would occasionally stall.
class SecondOrderRolling {
public:
  /// Throws Stopped if `progress` returns false.
  SecondOrderRolling(const CombinedMaterial& material, FittedContact contact, const Progress& progress = {},
                     const TransformPlans& plans = {});

  /// Makes the problem anew in its memory. Unusable if stopped.
  void renew(const CombinedMaterial& material, FittedContact contact, const Progress& progress = {});

  /// Sets the contact stretched evenly, and bodies with another shear modulus. Costs next to nothing.
  void rescale(FittedContact contact, double shear_modulus);

  const FittedContact& contact() const { return contact_; }

  /// `bound` is g [Pa] of each element. Not converging and a force beyond friction are statuses.
  SecondOrderSolution solve(std::span<const double> bound, const SecondOrderInput& input);

  /// Derivatives of the tractions with respect to xi, eta (per 1) and phi (per 1/m), for a solution with creepages
  /// given; the linear systems are solved to `tolerance`. Holds where no element is just between adhesion and slip.
  /// Cost: three linear solves. Throws Stopped if `progress` returns false.
  struct Derivatives {
    std::array<RollingDerivative::Change, 3> by; ///< xi, eta, phi
    long products = 0;
  };
  Derivatives differentiate(std::span<const double> bound, const SecondOrderSolution& solution, double tolerance,
                            const Progress& progress = {});

  /// Complex amplitudes of the tractions for small oscillations e^{i omega t} of xi, eta (per 1), phi (per 1/m), and of
  /// the contact's size, k = omega/V [1/m]; of a solution with the conditions of `differentiate`, which is k = 0.
  struct Responses {
    std::array<RollingResponse::Change, 3> by; ///< xi, eta, phi
    /// All lengths and traction bounds times 1 + l, as by Hertz's contacts under 1 + 3 l times the load, per l. In
    /// coordinates that grow with the contact: forces are 2 l, moments 3 l times the steady ones more.
    RollingResponse::Change by_size;
  };
  /// Cost: four complex linear solves. Throws Stopped if `progress` returns false.
  Responses respond(std::span<const double> bound, const SecondOrderSolution& solution, double wavenumber,
                    double tolerance, const Progress& progress = {});
  /// The first three of these alone.
  std::array<RollingResponse::Change, 3> respond_to_creepages(std::span<const double> bound,
                                                              const SecondOrderSolution& solution, double wavenumber,
                                                              double tolerance, const Progress& progress = {});
  /// The same of anything else.
  RollingResponse::Change respond_to(const RollingResponse::Cause& cause, std::span<const double> bound,
                                     const SecondOrderSolution& solution, double wavenumber, double tolerance,
                                     const Progress& progress = {});
  /// D p, the contribution of tractions to the slip.
  VectorField slip_by(const VectorField& traction);

private:
  RollingResponse& linearised_response(std::span<const double> bound, const SecondOrderSolution& solution);
  void solve_twice(std::span<const double> bound, const SecondOrderInput& input, SecondOrderSolution& out);

  TransformPlans plans_;
  FittedContact contact_;
  FittedOperator operator_;
  FrictionNewton newton_;
  std::vector<double> area_share_;
  std::optional<RollingDerivative> derivative_; ///< made when it is first needed
  std::optional<RollingResponse> response_;     ///< the same
};

} // namespace microslip
