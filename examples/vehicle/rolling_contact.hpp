#pragma once

#include "simbody.hpp"

#include <microslip/elasticity/material.hpp>
#include <microslip/simplified/fastsim2.hpp>

#include <memory>

/// Rolling contact with friction in place of Simbody's Hertzian contact with Coulomb's friction, between any two curved
/// bodies whose contact is a point: `subsystem.adoptForceGenerator(new RollingContact<...>(...))`.
///
/// The normal force is Hertz's at the depth, with damping as Hunt & Crossley 1975: F_n (1 + 3/2 alpha v). Creepages are
/// the relative velocity and spin of the surfaces over the rolling speed, at which the contact moves over them: for
/// relative curvatures k_x, k_y and a relative angular velocity w it is (w_y/k_x, -w_x/k_y), by which contact points of
/// bodies that roll move. FASTSIM2 gives forces and the moment about the normal. Below `slowest` the speed is taken as
/// that, so that creepages stay finite: what sticks at rest creeps.
///
/// An ellipse that does not roll along an axis is replaced by one that does, of the same area and as long along the
/// rolling direction.
template <class PointContact> class RollingContact : public SimTK::ContactForceGenerator {
public:
  struct Surfaces {
    microslip::CombinedMaterial material;
    double friction = 0.3;
    double normal_damping = 0; ///< alpha [s/m]
    double slowest = 0.01;     ///< [m/s]
  };

  explicit RollingContact(const Surfaces& surfaces)
      : ContactForceGenerator(PointContact::classTypeId()), surfaces_(surfaces) {}

  void calcContactForce(const SimTK::State& state, const SimTK::Contact& overlapping, const SimTK::SpatialVec& velocity,
                        SimTK::ContactForce& force) const override;
  /// Gives none: only Simbody's own generators may set a patch.
  void calcContactPatch(const SimTK::State&, const SimTK::Contact&, const SimTK::SpatialVec&,
                        SimTK::ContactPatch& patch) const override {
    patch.clear();
  }

private:
  Surfaces surfaces_;
  mutable microslip::Fastsim2 law_; // Simbody calls it by const functions, from one thread
};

using RollingBall = RollingContact<SimTK::CircularPointContact>;
using RollingEllipse = RollingContact<SimTK::EllipticalPointContact>;
