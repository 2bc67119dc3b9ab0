#pragma once

#include "simbody.hpp"

/// Derivatives of the forces on bodies by their positions and velocities. Bodies are those of the matter subsystem
/// without the ground; each has six rows and columns: moment and force about its origin, small rotation and
/// displacement or angular velocity and velocity of its origin, all in the ground's axes.
struct SpatialSlopes {
  SimTK::Matrix by_position, by_velocity;

  explicit SpatialSlopes(int bodies) : by_position(6 * bodies, 6 * bodies), by_velocity(6 * bodies, 6 * bodies) {
    clear();
  }
  void clear() { by_position = 0, by_velocity = 0; }
  static int first(SimTK::MobilizedBodyIndex body) { return 6 * (int(body) - 1); }
};

/// A force that knows its derivatives.
class SlopedForce {
public:
  virtual ~SlopedForce() = default;
  /// Adds them in a state that is realized to velocities. What is small beside the stiffness of a contact may be left
  /// out: Newton's method takes them, no result depends on them.
  virtual void add_slopes(const SimTK::State& state, SpatialSlopes& slopes) const = 0;
};
