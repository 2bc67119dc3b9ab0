#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/theory.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/damage/surface_strength.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/railway/geometry/patch_surface.hpp"
#include "microslip/railway/geometry/track.hpp"
#include "microslip/railway/geometry/wheelset.hpp"
#include "microslip/railway/problem/unsolved.hpp"
#include "microslip/railway/profile/profile.hpp"
#include "microslip/railway/profile/profile_surface.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace microslip {

class CreepForceTable;

/// Friction that depends on the inclination of the rail's surface against the track plane.
struct InclinedFriction {
  double angle = 0;       ///< [rad], ascending; > 0 where the surface rises to the field side
  double coefficient = 0; ///< mu there, linear in between, constant beyond the first and the last angle
};

/// Side of the track.
enum class TrackSide { left, right };

/// A wheel on a rail: all that stays the same while it runs.
struct WheelRailBodies {
  Profile rail, wheel;
  Track track;
  Wheelset wheelset;
  TrackSide side = TrackSide::left;
  CombinedMaterial material{};
  std::vector<InclinedFriction> friction; ///< at least one
  SurfaceStrength strength = {};          ///< for wear and fatigue only
  /// Surfaces of a rail that varies along the track, u in m, and of a wheel out of round, u in rad; `rail` and `wheel`
  /// are then the profiles by which they are placed.
  std::shared_ptr<const ProfileSurface> rail_surface = {}, wheel_surface = {};
  /// Elastic layers on the wheel, body 1, and on the rail, body 2: with the theory exact, on patches whose shape is
  /// given as flat or curved. `material` is that of the half-spaces below: the fast theory begins with it, and patches
  /// lift each other by it. Heights are those of pressures without tractions.
  std::optional<LayeredBodies> layered = {};
};

/// Method of solution.
struct WheelRailMethod {
  Theory theory = Theory::fastsim2; ///< or exact or table; the others are for one patch alone
  /// exact: unless given curved, and conformal where the rail's surface turns (conformity()); the rows of fastsim2 and
  /// table always follow the surface.
  std::optional<PatchShape> shape = {};
  int elements = 24;       ///< exact: across each contact
  double tolerance = 1e-6; ///< of the vertical force, relative; less than 1e-6 counts as that with the theory exact
  bool fields = false;     ///< fastsim2: the fields of each patch, too, for which it allocates; exact always has them
  std::shared_ptr<const CreepForceTable> table = {}; ///< table: rolling forward; one for nu alone is the smallest

  /// Surface of gaps and creepages: that of the shape that is given, or the true one.
  PatchShape surface() const { return shape.value_or(PatchShape::curved); }
  /// The largest residual of a solution: the tolerance that counts.
  double solved_tolerance() const;
  /// Weight of the change of displacements by the angles of a patch's rows: 0 of a curved patch, 1 of a
  /// conformal one. Unless the shape is given it rises smoothly, 1/2 where the rail's surface turns by 14 degrees
  /// [rad] across the patch, where a cosine differs by 3 %.
  double conformity(double turn) const;
};

/// Damage of a patch to the surfaces; empty where a number of their strength is not given.
struct PatchDamage {
  std::optional<double> worn_area;      ///< cross-section that a passage wears off [m^2], or volume per metre [m^3/m]
  std::optional<double> wear_depth;     ///< the largest depth of it [m]
  std::optional<double> fatigue_index;  ///< surface fatigue index [-]
  std::optional<double> shakedown_load; ///< p0/k, ordinate of the shakedown map [-]
};

/// A patch in contact, in track axes; forces on the wheel.
struct WheelRailPatch {
  Vec3<double> place;                      ///< origin of its frame, on the rail [m]
  double angle = 0;                        ///< [rad] of the contact plane against the track plane
  double rail_y = 0, wheel_y = 0;          ///< of both profiles there, in the profiles' axes [m]
  double rolling_radius = 0;               ///< of the wheel there [m]
  double turn = 0;                         ///< by how much the rail's surface turns across the patch [rad]
  double conformity = 0;                   ///< exact: 0 solved as curved (or flat), 1 as conformal [-]
  double approach = 0;                     ///< greatest overlap [m]
  double rolling_speed = 0;                ///< V [m/s]
  Creepage creepage;                       ///< at the frame's origin
  double normal_force = 0, fx = 0, fs = 0; ///< along the frame's axes [N]
  double moment = 0;                       ///< about the frame's normal through its origin [N m]
  double contact_area = 0, slip_area = 0;  ///< [m^2]
  double peak_pressure = 0;                ///< [Pa]
  double frictional_power = 0;             ///< [W]
  double friction = 0;                     ///< mu at its inclination [-]
  PatchDamage damage;
  Status status = Status::ok;
};

struct WheelRailSolution {
  Vec3<double> force;  ///< on the wheel, in track axes [N]
  Vec3<double> moment; ///< about the wheel's centre, on the axle at y = 0 of the profile, in track axes [N m]
  double vertical = 0; ///< of the wheelset's centre: as given, or that of the vertical force [m]
  std::vector<WheelRailPatch> patches; ///< from the gauge side to the field side of the left wheel
  std::vector<ContactSolution> fields; ///< of each patch, in its frame, where the method has them
  double residual = 0;                 ///< of the vertical force, relative
  int iterations = 0;                  ///< over the wheel's height
  std::optional<double> y_over_q;      ///< Y/Q [-]: force towards the track's centre over the vertical one
  std::optional<double> nadal_limit;   ///< of it, where the flange is steepest [-]; empty without a flange
  Warnings warnings;                   ///< why it is doubtful
  Status status = Status::ok;
  Unsolved reason = Unsolved::none; ///< why the status is not ok
};

} // namespace microslip
