#pragma once

#include "compat/contact/units.hpp"
#include "compat/libcontact/include/contact_addon.h"

#include <span>
#include <vector>

namespace microslip::libcontact {

/// The units that a contact problem's numbers are exchanged in, in SI: of lengths and of velocities, of pressures, and
/// what numbers in SI are multiplied by. Forces are in N, angles in rad always.
struct Units {
  double length = contact_program::mm, per_length = contact_program::per_m;
  double pressure = contact_program::newton_per_mm2, per_pressure = contact_program::mega;
  /// That of a number which files have in this unit.
  double of(double in_file) const {
    using namespace contact_program;
    if (in_file == mm) return length;
    if (in_file == per_mm) return 1 / length;
    if (in_file == newton_per_mm2) return pressure;
    if (in_file == newton_per_mm2 / mm) return pressure / length;
    return in_file == mm3_per_newton ? length / pressure : 1;
  }
  /// Numbers in SI that files have in these units.
  std::vector<double> in_si(std::span<const double> values, const contact_program::Scales& in_file) const {
    std::vector<double> found(values.begin(), values.end());
    for (std::size_t k = 0; k < found.size(); ++k) found[k] *= of(in_file[k]);
    return found;
  }
  double body = 1; ///< 1: forces and slip are those of body 1, -1: of body 2
};

/// Those of one of CNTC_un_...; imperial units are those of CONTACT.
inline Units units_of(int code) {
  if (code == CNTC_un_spck) return {1, 1, 1, 1, -1};
  if (code == CNTC_un_si) return {1, 1, 1, 1, 1};
  return {};
}

} // namespace microslip::libcontact
