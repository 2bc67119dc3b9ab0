#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/creepage.hpp"
#include "microslip/contact/elements.hpp"
#include "microslip/contact/surface_fields.hpp"
#include "microslip/vec2.hpp"

namespace microslip {

/// Integrals and extremes of a contact's fields. Forces and moments act on body 1.
struct Totals {
  double fx = 0; ///< integral of px [N]
  double fy = 0; ///< integral of py [N]
  double mz = 0; ///< moment about z, integral of x py - y px [N m]
  /// Moment about y of the pressure, -(integral of x p_n) [N m]: rolling resistance. Pressure of viscoelastic bodies
  /// leads: rolling along +x, where a wheel turns positively about y, it is negative, along -x positive, and over the
  /// wheel's radius it is the force that keeps the wheel rolling. Zero to rounding for similar elastic bodies.
  double my = 0;
  double adhesion_area = 0; ///< [m^2]
  double slip_area = 0;     ///< [m^2]
  /// -V integral of p.s [W], for a shift the work, without V [J]. In steady rolling the best that the discretisation
  /// has for it, (E23a), (S22): of elastic bodies of one material that by creepages. Else the sum over the elements.
  double frictional_power = 0;
  double power_by_creepage = 0; ///< -V (xi fx + eta fy + phi mz) (E22) [W]; for a shift the work, without V [J]
  double elastic_energy = 0;    ///< of the tangential tractions, half the integral of p.u [J]
  double peak_pressure = 0;     ///< largest pressure of an element [Pa]
  double peak_traction = 0;     ///< largest |p| of an element [Pa]
};

bool is_finite(const Totals& totals);

/// Fields of an element in adhesion or slip.
struct LoadedElement {
  double x = 0, y = 0, area = 0; ///< [m], [m], [m^2]
  bool slides = false;
  Vec2 traction = {}, slip = {}, displacement = {};
};

/// Adds what an element contributes to forces, areas, energy and, for V = 1, frictional power. Every sum over a contact
/// goes through here.
void add(Totals& totals, const LoadedElement& element);

/// Adds the moment and the peak of the pressures of all elements.
void add(Totals& totals, const Elements& elements, const std::vector<double>& pressure);

/// The power by the creepages, which follows from the forces. `speed` as for find_totals.
double power_by_creepage(const Totals& totals, const Creepage& creepage, double speed);

/// The totals of fields. Elements in adhesion or slip count, in the order of their indices; fields
/// that are empty count as zero. `speed` is V [m/s], 1 for a shift.
Totals find_totals(const Elements& elements, const SurfaceFields& fields, const Creepage& creepage, double speed);

} // namespace microslip
