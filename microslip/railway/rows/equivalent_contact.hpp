#pragma once

#include "microslip/railway/geometry/equivalent_rail.hpp"
#include "microslip/railway/rows/row_contact.hpp"

#include <memory>

namespace microslip {

/// A left wheel on its rail as a round wheel on a prismatic rail: those that are given or, where surfaces vary and on
/// rollers, the equivalent ones of each state.
class EquivalentContact {
public:
  /// The bodies must outlive it.
  EquivalentContact(const WheelRailBodies& bodies, const WheelRailMethod& method, const NominalPlacement& nominal);
  ~EquivalentContact();

  /// Returns true if each state has its own equivalent rail.
  bool varies() const { return varies_; }
  /// Finds the equivalent rail of a state, in its height or in that where the wheel first touches, if surfaces vary:
  /// some 10 ms, allocates. False where there is no rail.
  bool move_to(const WheelState<double>& state, bool where_it_touches);

  RowContact& rows();                    ///< of the state moved to
  const WheelRailBodies& bodies() const; ///< with the profiles of these rows

private:
  struct Round;

  std::optional<EquivalentRail> equivalent_rail(const WheelState<double>& state, bool where_it_touches) const;

  const WheelRailBodies& given_;
  const WheelRailMethod& method_;
  const NominalPlacement& nominal_;
  bool varies_;
  std::unique_ptr<Round> round_;
};

} // namespace microslip
