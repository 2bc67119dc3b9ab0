#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Thermal data of a body.
struct ThermalBody {
  double bulk_temperature = 0; ///< where it enters the contact [deg C]
  double conductivity = 0;     ///< lambda [W/(m K)], > 0
  double density = 0;          ///< rho [kg/m^3], > 0
  double heat_capacity = 0;    ///< c [J/(kg K)], > 0

  /// beta = sqrt(lambda rho c) [W s^(1/2)/(m^2 K)].
  double effusivity() const;

  friend bool operator==(const ThermalBody&, const ThermalBody&) = default;
};

/// Both bodies of a contact.
struct ThermalBodies {
  ThermalBody body1, body2;

  friend bool operator==(const ThermalBodies&, const ThermalBodies&) = default;
};

/// Throws Error for numbers out of range.
void check(const ThermalBodies& bodies);

/// The temperature of a row of elements in contact, (T2): a mean of the bulk temperatures, and what the heat of the
/// elements ahead adds. Elements count along the particles' path from the leading edge of the grid on.
class FlashTemperature {
public:
  /// Elements of the length dx [m]. No check of the numbers.
  FlashTemperature(int elements, double dx, double rolling_speed, const ThermalBodies& bodies);

  /// Temperature without heat [deg C]: bodies that conduct better count more.
  double mean() const { return mean_; }
  /// Rise of temperature by heat of 1 W/m^2 in an element, at the one `later` elements behind it [K m^2/W].
  double rise(int later) const { return rise_[static_cast<std::size_t>(later)]; }
  /// Rise of temperature in element i by the heat [W/m^2] of elements 0 to i - 1, and of element i if it is there [K].
  double rise(std::span<const double> heat, int i) const;

private:
  double mean_;
  std::vector<double> rise_;
};

/// Temperatures of the surfaces at the centres of a grid's elements [deg C]: the same in contact.
struct SurfaceTemperature {
  std::vector<double> body1, body2;
  double highest = 0; ///< in contact; minus infinity without contact
};

/// Surface temperatures in steady rolling (Ertz & Knothe 2002): heat flows into the depth only, both bodies pass at the
/// rolling speed, they are in perfect thermal contact where they touch and insulated elsewhere. In contact
/// T = (beta1 T1 + beta2 T2)/(beta1 + beta2) + 1/((beta1 + beta2) sqrt(pi V)) integral of q(x')/sqrt(x' - x) dx' over
/// what lies ahead in the row (T2). Accurate to first order in dx where q varies, for a Peclet
/// number V a rho c/lambda well above 10.
///
/// `pressure` tells the elements in contact (> 0), `heat` is the frictional heat of both bodies -V p.s [W/m^2], all of
/// the grid, x fastest. Throws Error for numbers out of range. Cost O(mx^2 my).
SurfaceTemperature surface_temperature(const ElementGrid& grid, RollingDirection direction, double rolling_speed,
                                       const ThermalBodies& bodies, std::span<const double> pressure,
                                       std::span<const double> heat);

} // namespace microslip
