#pragma once

#include "spatial_slopes.hpp"
#include "track.hpp"

#include <microslip/railway/wheel_rail.hpp>

#include <array>
#include <memory>
#include <vector>

/// The forces of rails on wheelsets: all of a vehicle, since they are solved side by side.
///
/// Of each wheel, the frame of its rail moves along with it (TrackLine::rail). Position, angles and velocities of the
/// wheelset relative to that frame are a microslip::WheelState, with the rail in its nominal position; force and moment
/// of its solution, the latter moved to the wheelset's centre, act on the body. A frame that follows the rail leaves no
/// velocities of irregularities: a rail that bends to the left moves nothing to the left.
///
/// It never throws in a state that it cannot solve: forces are the best that were found, none if they are no numbers,
/// and the statuses are counted.
class WheelRailForces : public SimTK::Force::Custom::Implementation, public SlopedForce {
public:
  struct Options {
    microslip::WheelRailMethod method = {};
    int threads = 1; ///< that share the wheels
    /// Factor alpha of normal damping [s/m]: F_n (1 + 3/2 alpha v) for a speed of approach v, never below 0 (Hunt &
    /// Crossley 1975); it damps the bounce of a wheelset on its contacts. Friction stays that of F_n.
    double normal_damping = 0;
    bool differences = false; ///< derivatives by differences of forces instead of the library's
  };
  /// What was done so far.
  struct Counts {
    long wheels = 0;                ///< solved, those of differences too
    long differentiated = 0;        ///< with derivatives by the library
    std::array<long, 7> statuses{}; ///< of wheels, by microslip::Status
    long patch_changes = 0;         ///< wheels that touched in another number of patches than the time before
    double seconds = 0;             ///< processor time that all of it took, on all threads
    /// Statuses that are neither ok nor no_contact.
    long doubtful() const;
  };
  /// A wheel after the last solve.
  struct Wheel {
    microslip::WheelRail law;
    TrackFrame rail; ///< that it is on
    microslip::WheelState<double> state;
    microslip::WheelRailSolution found;
    microslip::WheelRailDerivatives slopes;
    SimTK::SpatialVec force; ///< moment about the wheelset's centre and force, in the ground's axes
    std::size_t patches = 0;
  };
  struct Wheelset {
    SimTK::MobilizedBodyIndex body;
    double distance; ///< along the track [m]
    Wheel left, right;
  };

  /// Of wheelsets whose bodies have their origin in the middle of the axle and y along it to the left. `bodies` of a
  /// left wheel are those of the right one too.
  WheelRailForces(const SimTK::SimbodyMatterSubsystem& matter, const microslip::WheelRailBodies& bodies,
                  std::shared_ptr<const TrackLine> track, const Options& options);
  void add(SimTK::MobilizedBodyIndex body, double distance);

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override;
  double calcPotentialEnergy(const SimTK::State&) const override { return 0; }
  void add_slopes(const SimTK::State& state, SpatialSlopes& slopes) const override;

  const std::vector<Wheelset>& wheelsets() const { return wheelsets_; }
  const Counts& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }
  void set_threads(int threads) { options_.threads = threads; }
  void set_differences(bool differences) { options_.differences = differences; }
  double nominal_radius() const { return bodies_.wheelset.nominal_radius; }
  /// The height of a wheelset's centre above its nominal radius where its wheels bear this load each [m].
  double height_under(double vertical_force) const;

private:
  struct Slopes {
    SimTK::Mat66 by_position, by_velocity;
  };
  void locate(Wheel& wheel, bool left, const Wheelset& wheelset, const SimTK::Transform& pose,
              const SimTK::SpatialVec& velocity) const;
  void to_body(Wheel& wheel, bool left) const;
  void add_damping(Wheel& wheel, const microslip::Vec3<double>& centre, microslip::Vec3<double>& force,
                   microslip::Vec3<double>& moment) const;
  void find_place(const SimTK::State& state, Wheelset& wheelset) const;
  template <class Work> void of_all_wheels(const Work& work) const;
  void count(const Wheel& wheel) const;
  Slopes library_slopes(const Wheel& wheel, bool left) const;
  void add_differences(const SimTK::State& state, Wheelset& wheelset, SpatialSlopes& slopes) const;

  const SimTK::SimbodyMatterSubsystem& matter_;
  microslip::WheelRailBodies bodies_;
  std::shared_ptr<const TrackLine> track_;
  Options options_;
  double half_base_; ///< from the wheelset's centre to a wheel's [m]
  // Solvers start from their last state, and results are kept: Simbody calls forces by const functions.
  mutable std::vector<Wheelset> wheelsets_;
  mutable Counts counts_;
};
