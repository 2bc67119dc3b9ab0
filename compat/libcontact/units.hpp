#pragma once

#include "compat/libcontact/include/contact_addon.h"

namespace microslip::libcontact {

/// From SI, in which the library computes, to CONTACT's units.
inline constexpr double mm_per_m = 1e3, newton_per_mm2 = 1e-6;

/// The units that a contact problem's numbers are exchanged in, over CONTACT's mm, N and s; angles are in rad always.
struct Units {
  double length = 1; ///< [mm]
  double speed = 1;  ///< [mm/s]
  double body = 1;   ///< 1: forces and slip are those of body 1, -1: of body 2

  double area() const { return length * length; }
  /// Unit of a pressure or a modulus of elasticity [N/mm2].
  double pressure() const { return 1 / area(); }
};

/// Those of one of CNTC_un_...; imperial units are those of CONTACT.
inline Units units_of(int code) {
  if (code == CNTC_un_spck) return {1e3, 1e3, -1};
  if (code == CNTC_un_si) return {1e3, 1e3, 1};
  return {};
}

} // namespace microslip::libcontact
