#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <vector>

namespace microslip {

/// T-gamma of a contact, |Fx xi| + |Fy eta| [N, or J per metre rolled]: what wear indices of wheels and rails are
/// functions of (McEwen & Harvey 1985). With the spin |Mz phi| is added. The exact work is the frictional power over V.
double t_gamma(double fx, double fy, const Creepage& creepage);
double t_gamma_with_spin(double fx, double fy, double mz, const Creepage& creepage);
/// T-gamma of a solution.
double t_gamma(const ContactSolution& solution);
double t_gamma_with_spin(const ContactSolution& solution);

/// T-gamma of each element per area, -p s [N/m^2, or J/m^2 per metre rolled], s the relative slip. Its integral is the
/// frictional power over V.
std::vector<double> friction_work(const ContactSolution& solution);

/// Wear coefficients k [-] of Archard's law over sliding speed and pressure, a constant in each of four regions: the
/// map that KTH measured for dry wheel and rail steels (Jendel 2002). It gives ranges, 1 to 10e-4 below 0.2 m/s and
/// above 0.7 m/s, 30 to 40e-4 between, 300 to 400e-4 beyond 0.8 of the hardness; the defaults are their middles. On
/// lubricated surfaces k is several times less.
struct WearMap {
  double slow = 5.5e-4;       ///< mild
  double medium = 35e-4;      ///< severe
  double fast = 5.5e-4;       ///< mild again: oxides
  double seizure = 350e-4;    ///< at high pressure, at any speed
  double medium_from = 0.2;   ///< sliding speed [m/s]
  double medium_to = 0.7;     ///< [m/s]
  double seizure_above = 0.8; ///< pressure over hardness [-]

  double coefficient(double sliding_speed, double pressure, double hardness) const;
};

/// Data of a surface for Archard's law.
struct ArchardWear {
  double hardness = 0; ///< H [Pa] of the surface that wears, > 0, as a pressure: Vickers' or Brinell's
  WearMap map = {};
};

/// The depth [m] that each element of a contact wears off the surface that runs through it once, k p_n |s| dx/H
/// (Archard 1953): the sum over a row is the depth that a passage leaves there. A rail wears by that with every wheel,
/// a wheel with every turn. `rolling_speed` is V [m/s]. Throws Error for a solution without pressures and for H or V
/// out of range.
std::vector<double> wear_depth(const ContactSolution& solution, const ArchardWear& wear, double rolling_speed);

/// The sum over each row [m]: depth at the rows' y after a passage.
std::vector<double> row_sums(const Elements& elements, const std::vector<double>& field);

/// Rate at which wheel steel R8T wears on rail steel UIC60 900A, dry, with T-gamma over the contact's area [N/m^2]:
/// mass [kg] per metre rolled and square metre of contact, linear in three pieces: 5.3 T/A (mild), 55 (severe) and 55
/// + 61.9 (T/A - 77.2) (catastrophic) in ug/(m mm^2) with T/A in N/mm^2 (Braghin, Lewis, Dwyer-Joyce & Bruni 2006).
double wear_rate_r8t(double t_gamma_per_area);

/// Cross-section [m^2] that a wheel of the diameter [m] loses per metre rolled, by British Rail's wear index:
/// in mm^2/km, with T-gamma in N and D in mm, T/(4 D) below 100 N, 25/D up to 200 N, (1.19 T - 154)/D beyond, where it
/// jumps (Pearce & Sherratt 1991).
double worn_area_british_rail(double t_gamma, double diameter);

} // namespace microslip
