#pragma once

#include "microslip/exact/fitted/fitted_contact.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Moves the slip of sliding elements to their centres, where their tractions are. Slip is a mean over the path from an
/// element's centre to the next one ahead. Where two paths meet, the parabola with the means s_{I-1}, s_I, s_{I+1} over
/// its path and its neighbours has the value (2 s_{I-1} + 5 s_I - s_{I+1})/6 if they are equally long, (E26): of
/// third order, and unlike formulas that are symmetric about the centre it leaves nothing out, not even slip that
/// changes its sign from path to path. The trailing element's slip is extrapolated, (3 s_I - s_{I+1})/2; the leading
/// one keeps that of its path. Linear; in double or in single precision.
template <class Real> class CentredSlip {
public:
  /// `centred`: 1 for each element whose slip is to be moved.
  CentredSlip(const FittedContact& contact, std::span<const char> centred);

  /// Moves one component of all elements' slip from their paths to the centres. Cost O(N).
  void move(std::span<Real> slip);
  /// Approximate inverse, 2 - T for the map T of `move`: for preconditioners. Cost O(N).
  void nearly_undo(std::span<Real> slip);

private:
  std::vector<Real> behind_, own_, ahead_; ///< weights of three paths, for each element
  std::vector<Real> ways_;                 ///< slip, with one more at either end
};

} // namespace microslip
