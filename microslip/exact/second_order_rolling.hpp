#pragma once

#include "microslip/exact/fitted_response.hpp"
#include "microslip/exact/friction_newton.hpp"
#include "microslip/simplified/contact.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

struct SecondOrderInput {
  Creepage creepage;
  std::optional<double> force_x, force_y; ///< [N], on body 1; the creepage in that direction is an unknown then
  FrictionNewton::Start start;            ///< for each element; the constants are the creepages where a force is given
  double tolerance = 1e-6;                ///< of the residual, as in FrictionSolution
};

struct SecondOrderSolution {
  FrictionSolution friction;  ///< tractions, slip and state of each element
  std::vector<double> ux, uy; ///< displacement difference [m]
  Creepage creepage;
};

/// Steady rolling along +x with forces of second order in the elements' size. Three measures make it so: leading
/// elements fitted to the edge (FittedContact), the traction bound averaged over each element's area, and the direction
/// of sliding taken where the traction is. Slip is computed over the way between the centres of two elements and
/// belongs to its middle; at an element's centre it is the mean of the two ways that meet there. In the conditions of
/// friction this would be no variational inequality any more, and Newton's method would stall now and then. So the
/// problem is solved with the slip as it is, then the difference of that solution is added to the slip of the sliding
/// elements as a constant, and the problem is solved once more: the method of deferred correction.
class SecondOrderRolling {
public:
  SecondOrderRolling(const CombinedMaterial& material, FittedContact contact);

  const FittedContact& contact() const { return contact_; }

  /// `bound` is g [Pa] of each element. Not converging and a force beyond friction are statuses.
  SecondOrderSolution solve(std::span<const double> bound, const SecondOrderInput& input);

private:
  SecondOrderSolution full_sliding(std::span<const double> bound, const SecondOrderInput& input, double excess) const;
  std::vector<double> slip_at_centre(const std::vector<double>& slip) const;

  FittedContact contact_;
  FittedResponse response_;
  FrictionNewton newton_;
  std::vector<double> area_share_;
};

} // namespace microslip
