#pragma once

#include "microslip/railway/rows/equivalent_contact.hpp"
#include "microslip/railway/wheel_rail.hpp"

namespace microslip {

/// A theory for wheels: all that tells it from the others once rows carry the wheel's load. A new one is a row
/// of the table in wheel_theories.cpp with its word; creep forces of rows are those of RowContact.
struct WheelTheory {
  Theory theory;
  const char* name;
  /// Each patch is solved by elements, its derivatives are differences of whole solves. The others have the forces and
  /// derivatives of their rows.
  bool by_elements;
  double least_tolerance; ///< of the vertical force, relative: less counts as this
  /// Throws Error for what a method of this theory cannot be, or lacks.
  void (*require)(const WheelRailMethod& method);
  /// Turns a solution by rows into one of this theory. Throws Stopped where `progress` says so.
  void (*solve)(EquivalentContact& contact, const WheelState<double>& state, const WheelRailMethod& method,
                std::optional<double> vertical_force, WheelRailSolution& out, const Progress& progress);
};

/// Throws Error for a theory that wheels do not have.
const WheelTheory& theory_of(const WheelRailMethod& method);

} // namespace microslip
