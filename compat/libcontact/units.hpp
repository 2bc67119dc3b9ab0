#pragma once

#include "compat/contact/units.hpp"
#include "compat/libcontact/include/contact_addon.h"

#include <span>
#include <vector>

namespace microslip::libcontact {

/// The units that a contact problem's numbers are exchanged in: CONTACT's, or metres instead of millimetres. Forces are
/// in N, angles in rad always.
struct Units {
  bool in_metres = false;
  double body = 1; ///< 1: forces and slip are those of body 1, -1: of body 2

  /// A unit in SI.
  constexpr double of(contact_program::Unit unit) const { return in_metres ? 1 : unit.value(); }
  constexpr double length() const { return of(1); }
  constexpr double per_length() const { return of(-1); }
  constexpr double pressure() const { return of(-2); }
  constexpr double per_pressure() const { return of(2); }
  /// Numbers of such units in SI.
  std::vector<double> in_si(std::span<const double> values, const contact_program::UnitList& units) const {
    std::vector<double> found(values.begin(), values.end());
    for (std::size_t k = 0; k < found.size(); ++k) found[k] *= of(units[k]);
    return found;
  }
};

/// Those of one of CNTC_un_...; imperial units are those of CONTACT.
inline Units units_of(int code) {
  if (code == CNTC_un_spck) return {true, -1};
  return {code == CNTC_un_si, 1};
}

} // namespace microslip::libcontact
