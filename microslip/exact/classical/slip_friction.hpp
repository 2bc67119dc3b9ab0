#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/interface_layer.hpp"
#include "microslip/exact/newton/slip_dependent_bound.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Rate at which the coefficient of friction follows a change of the slip velocity s: d mu/dt = -max(s, s0)/d (mu -
/// mu_law(s)) (Vollebregt & Schuttelaars 2012; (B6)). Without it friction follows the slip without delay.
struct FrictionMemory {
  double distance = 0; ///< d [m], >= 0; 0: no memory
  double slowest = 0;  ///< s0 [m/s], >= 0

  friend bool operator==(const FrictionMemory&, const FrictionMemory&) = default;
};

/// Initial slip velocity of the iteration when the friction depends on it. With friction that falls there may be
/// several solutions; which one is found depends on this.
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

/// Friction and a layer's yield stress for the slip that the elements have: the traction bound
/// q = min(mu(s) p_n, tau_c(u_pl)), (B7), as particles come through the elements one after the other. The friction is
/// mu = theta mu' + (1 - theta) mu_law(s), theta = d/(d + t max(s, s0)), where mu' is the coefficient before, static
/// for particles that come from outside; a table's mu_law may depend on p_n. With heating it has the temperature's
/// effect on top, or is a table's that depends on the temperature, where the temperature is that of friction with these
/// very coefficients, slip velocities and pressures. Where the layer's yield stress tau_c = tau_c0 + k u_pl is the
/// smaller one the slip is plastic deformation, until friction is reached. Cost O(N), with heating O(mx^2 my).
class SlipFriction : public SlipDependentBound {
public:
  /// Time of a particle from one element to the next, or from one step to the next.
  struct Passage {
    double time = 0;         ///< of a step, or from element to element in steady rolling [s]
    double speed = 1;        ///< V [m/s], by which a slip is a velocity; 1 in a shift
    bool along_rows = false; ///< steady: what was before is what the element before has
    bool from_high_x = true; ///< where rows begin
    /// Else: coefficients and plastic deformation [m] before; empty: static, none.
    std::vector<double> before = {}, deformation_before = {};
  };

  /// State of friction and layer of the elements after their slip.
  struct State {
    std::vector<double> friction;    ///< mu [-], as memory carries it on
    std::vector<double> bound;       ///< q [Pa]
    std::vector<double> deformation; ///< u_pl [m]
    std::vector<char> yields;        ///< whether the slip is plastic deformation only
  };

  /// `laws` has one law, or one for each row; `heating` needs a passage along rows. Throws Error for numbers out of
  /// range, and where heat could take a coefficient out of [0, FrictionLaw::largest_coefficient].
  SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
               const InterfaceLayer& layer, Passage passage, std::optional<FrictionHeating> heating = {});

  /// Returns whether the bound depends neither on the slip nor on the temperature.
  bool is_constant() const;
  /// Returns whether friction changes with the slip or the temperature, so that there may be several solutions.
  bool falls() const;
  /// Coefficients at rest and cold.
  std::vector<double> static_coefficients() const;
  /// State at the slip velocity s [m/s] and pressure [Pa] of the elements.
  State state(std::span<const double> slip_velocity, std::span<const double> pressure) const;

  void largest(std::span<const double> pressure, std::span<double> bound) const override;
  double least_rho(std::span<const double> pressure) const override;
  void project(std::span<const double> size, std::span<const double> pressure, double rho,
               std::span<double> bound) const override;
  void linearise(std::span<const double> size, std::span<const double> pressure, double rho, std::span<double> bound,
                 std::span<double> own) override;
  bool carry(std::span<const double> size_change, std::span<const double> pressure_change,
             std::span<double> bound_change) const override;
  std::unique_ptr<SlipDependentBound> on_coarser(double longer) const override;

private:
  /// State of a particle as it enters an element.
  struct Particle {
    double friction = 0;    ///< mu [-]
    double deformation = 0; ///< u_pl [m]
    double temperature = 0; ///< by the heat of the elements ahead [deg C]; 0 without heating
  };
  /// State in the element. Without slip the bound is the largest traction that it can carry.
  struct Element {
    double slip = 0, friction = 0, bound = 0, deformation = 0;
    bool yields = false;
  };
  /// Derivatives of what an element has.
  struct Slope {
    double slip_by_size = 0; ///< 0 in adhesion
    double bound_by_deformation = 0;
    double friction_by_slip = 0, friction_by_before = 0, friction_by_temperature = 0, friction_by_pressure = 0;
    double slip = 0, friction = 0, pressure = 0;
    enum class Regime { adhesion, friction, friction_after_yielding, yielding } regime = Regime::adhesion;
  };

  /// Under which friction falls with the slip.
  struct Condition {
    double pressure, temperature; ///< [Pa], [deg C]
  };

  const FrictionLaw& law(int row) const { return laws_.size() == 1 ? laws_[0] : laws_[static_cast<std::size_t>(row)]; }
  const TemperatureEffect& effect(int row) const {
    return heating_->effects.size() == 1 ? heating_->effects[0] : heating_->effects[static_cast<std::size_t>(row)];
  }
  template <class At> void for_particles(At at) const;
  template <class Find> void pass(std::span<const double> pressure, Find find) const;
  template <class Real>
  Real coefficient(int row, const Real& slip, const Real& before, const Real& temperature, const Real& pressure) const;
  std::vector<Condition> conditions(int row, double peak) const;
  double slip_by_friction(int row, double size, double rho, const Particle& before, double pressure) const;
  double slip_by_yielding(double size, double rho, const Particle& before) const;
  Element with_slip(int row, double slip, const Particle& before, double pressure) const;
  Element with_size(int row, double size, double rho, const Particle& before, double pressure) const;
  Slope slope_at(int row, const Element& at, double rho, const Particle& before, double pressure) const;

  ElementGrid grid_;
  std::vector<FrictionLaw> laws_;
  FrictionMemory memory_;
  InterfaceLayer layer_;
  Passage passage_;
  std::optional<FrictionHeating> heating_;
  std::optional<FlashTemperature> flash_;
  double hardening_;          ///< of the yield stress with the slip [Pa]
  double rho_ = 0;            ///< of the linearisation
  std::vector<Slope> slopes_; ///< of the elements
};

} // namespace microslip
