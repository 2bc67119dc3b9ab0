#pragma once

#include "spatial_slopes.hpp"

#include <vector>

/// Springs and dampers between two bodies, at a point of the left side and at its mirror image. Linear along the axes
/// of the first body, massless, unloaded but for `preload` while the points coincide. They keep the sums of forces and
/// moments, and follow the second body's point only: a point on a wheelset's axle does not turn with it.
struct SpringPair {
  SimTK::MobilizedBodyIndex first, second;
  SimTK::Vec3 on_first, on_second; ///< the left point in the bodies' axes [m]
  SimTK::Vec3 stiffness{0, 0, 0};  ///< of one side, along x, y, z of the first body [N/m]
  SimTK::Vec3 damping{0, 0, 0};    ///< [N s/m]
  double preload = 0;              ///< that presses the bodies apart along z, on one side [N]
};

/// Several of them.
class Suspension : public SimTK::Force::Custom::Implementation, public SlopedForce {
public:
  explicit Suspension(const SimTK::SimbodyMatterSubsystem& matter) : matter_(matter) {}
  void add(const SpringPair& pair) { pairs_.push_back(pair); }

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override;
  double calcPotentialEnergy(const SimTK::State& state) const override;
  void add_slopes(const SimTK::State& state, SpatialSlopes& slopes) const override;
  /// What the dampers take [W].
  double power(const SimTK::State& state) const;

private:
  const SimTK::SimbodyMatterSubsystem& matter_;
  std::vector<SpringPair> pairs_;
};
