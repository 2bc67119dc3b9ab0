#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/interface_layer.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// How fast the coefficient of friction follows a change of the slip velocity s: d mu/dt = -max(s, s0)/d (mu -
/// mu_law(s)) (Vollebregt & Schuttelaars 2012). Without it the law holds at once.
struct FrictionMemory {
  double distance = 0; ///< d [m], >= 0; 0: no memory
  double slowest = 0;  ///< s0 [m/s], >= 0

  friend bool operator==(const FrictionMemory&, const FrictionMemory&) = default;
};

/// Where the slip velocity begins when the friction depends on it. With friction that falls there may be several
/// solutions; which one is found depends on this.
enum class SlipStart {
  below, ///< zero: friction is static everywhere
  above, ///< rolling speed: friction is that of full sliding
  given, ///< that of the step before
};

/// Friction that depends on the temperature, which depends on friction: in steady rolling.
struct FrictionHeating {
  std::vector<TemperatureEffect> effects; ///< of each row of the grid; one: the same for all
  ThermalBodies bodies;
  double rolling_speed = 0; ///< [m/s]
};

/// The coefficients of friction of the elements for the slip that they have, and what the slip does to a layer between
/// the bodies.
class SlipFriction {
public:
  /// How a particle's time passes from one element to the next, or from one step to the next.
  struct Passage {
    double time = 0;         ///< of a step, or from element to element in steady rolling [s]
    bool along_rows = false; ///< steady: what was before is what the element before has
    bool from_high_x = true; ///< where rows begin
    /// Else: coefficients and plastic deformation [m] before; empty: static, none.
    std::vector<double> before = {}, deformation_before = {};
  };

  /// `laws` has one law, or one for each row; `heating` needs a passage along rows. Throws Error for numbers out of
  /// range, and where heat could take a coefficient out of [0, FrictionLaw::largest_coefficient].
  SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
               const InterfaceLayer& layer, Passage passage, std::optional<FrictionHeating> heating = {});

  /// Whether friction depends neither on the slip nor on the temperature.
  bool is_constant() const;
  /// With the slip velocity s [m/s] of the elements: mu = theta mu' + (1 - theta) mu_law(s), theta = d/(d + t max(s,
  /// s0)), where mu' is the coefficient before, static for particles that come from outside. With heating mu_law has
  /// the temperature's effect on top, where the temperature is that of friction with these very coefficients, slip
  /// velocities and pressures [Pa]; found element by element from the leading edge on. Cost then O(mx^2 my).
  std::vector<double> coefficients(std::span<const double> slip_velocity, std::span<const double> pressure = {}) const;
  /// Plastic deformation [m] after slip with this velocity where the layer yields: all of it there, and nothing
  /// elsewhere.
  std::vector<double> plastic_deformation(std::span<const double> slip_velocity, std::span<const char> yields) const;
  /// Coefficients limited by the layer's yield stress after a deformation, and where it yields.
  void limit(std::span<double> friction, std::span<const double> pressure, std::span<const double> deformation,
             std::span<char> yields) const;
  /// At rest and cold.
  std::vector<double> static_coefficients() const;

private:
  template <class At> void for_particles(At at) const;
  const FrictionLaw& law(int row) const { return laws_.size() == 1 ? laws_[0] : laws_[static_cast<std::size_t>(row)]; }
  const TemperatureEffect& effect(int row) const {
    return heating_->effects.size() == 1 ? heating_->effects[0] : heating_->effects[static_cast<std::size_t>(row)];
  }

  ElementGrid grid_;
  std::vector<FrictionLaw> laws_;
  FrictionMemory memory_;
  InterfaceLayer layer_;
  Passage passage_;
  std::optional<FrictionHeating> heating_;
};

} // namespace microslip
