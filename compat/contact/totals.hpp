#pragma once

#include "compat/contact/input.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"

#include <optional>
#include <string>

namespace microslip::contact_program {

/// The quantities that CONTACT prints for a case, with its names, signs and units (mm, N).
struct PrintedTotals {
  double fn = 0, fx = 0, fy = 0;        ///< [N], on body 1
  double mz = 0;                        ///< [N mm]
  double elastic_energy = 0;            ///< ELAST.EN. [J]
  double friction = 0;                  ///< FRIC.POWER [W], for shifts FRIC.WORK [J]; negative where energy is lost
  double fn_over_g = 0;                 ///< FN/G [mm2]
  std::string x_name = {}, y_name = {}; ///< FX/FSTAT/FN, or CREEP X, SHIFT X [mm] where the force is given
  double x = 0, y = 0;
  double approach = 0;                                    ///< [mm]
  double peak_pressure = 0;                               ///< PMAX [N/mm2]
  std::optional<double> integral_fn = {};                 ///< TILDE_FN: of the pressure over a curved patch [N]
  std::optional<double> temperature = {};                 ///< MAX(T1,T2) [deg C] in contact, if asked for
  int potential = 0, contact = 0, adhesion = 0, slip = 0; ///< NPOT, NCON, NADH, NSLIP: numbers of elements
  std::optional<int> plastic = {};                        ///< NPLAST, where a layer between the bodies can yield
};

PrintedTotals printed_totals(const Case& c, const ContactStep& step, const ContactStepSolution& solution);

} // namespace microslip::contact_program
