#pragma once

#include "compat/contact/units.hpp"
#include "compat/contact/wheel_rail/digits.hpp"
#include "compat/contact/wheel_rail/profile_thresholds.hpp"

#include <memory>
#include <string>
#include <variant>

namespace microslip::contact_program {

// The records of module 1, in SI units and CONTACT's axes: the track's x forward, y to the right, z down.

/// The grid of elements, and the rules by which patches are joined: DX DS DQREL A_SEP D_SEP D_COMB D_TURN G_MISS.
struct PatchRules {
  double dx = 0, ds = 0; ///< sides of the elements along the track and along the rail's profile
  double dqrel = 1;      ///< step of rolling over DX
  double a_sep = 0;      ///< patches whose angles differ by more are not joined
  double d_sep = 0;      ///< nor are those further apart;
  double d_comb = 0;     ///< up to this distance they are one region,
  double d_turn = 0;     ///< and up to this one their frames are turned towards each other
  double g_miss = -mm;   ///< gaps below it count as near misses; < 0: none
};

class ProfileCurve;

/// A profile's file and what is to be done with its points, which are in mm then.
struct ProfileRecord {
  std::string file;                               ///< with its path
  std::shared_ptr<const ProfileCurve> curve = {}; ///< what has been made of it already; empty: the file is to be read
  std::string name = {};                          ///< as the input file has it
  int mirror_y = 0;
  double scale = 1;
  double smooth = 0;                         ///< SMOOTH: lambda with ISMOOTH = 0, else a wavelength
  int mirror_z = 0;                          ///< -1 no, 0 by the shape, 1 yes
  int smoothing = 0;                         ///< ISMOOTH: 0 without weights, 1 with, 2 with by the third derivative
  double zigzag = ProfileThresholds::zigzag; ///< ZIGTHRS
  double kink_high = ProfileThresholds::kink_high;                                ///< KINKHIGH
  double kink_low = ProfileThresholds::kink_high / ProfileThresholds::kink_ratio; ///< KINKLOW
  double kink_width = ProfileThresholds::kink_width;                              ///< KINKWID
  int error_handling = 0;                                                         ///< ERRHND
  double most_omitted = ProfileThresholds::most_omitted;                          ///< MAXOMIT

  friend bool operator==(const ProfileRecord&, const ProfileRecord&) = default;
};

/// Position of the rails, or of the roller: GAUGHT > 0 by the gauge, else by RAILY0 and RAILZ0.
struct TrackDimensions {
  double gauge_height = 0;         ///< GAUGHT
  double gauge_width = 0;          ///< GAUGWD
  double rail_y0 = 0, rail_z0 = 0; ///< RAILY0, RAILZ0
  double cant = 0, curvature = 0;  ///< CANT, CURV; not of rollers
  double roller_radius = 0;        ///< NOMRADR, < 0 for a raceway; of rollers

  bool by_gauge() const { return gauge_height > 0; }
};

/// The current rail off its position: DYRAIL DZRAIL DROLLR VYRAIL VZRAIL VROLLR.
struct RailPosition {
  double dy = 0, dz = 0, roll = 0, vy = 0, vz = 0, vroll = 0;
};

/// A rail without mass: KYRAIL FYRAIL KZRAIL FZRAIL DYSTEP0.
struct RailSupport {
  double ky = 0, fy = 0, kz = 0, fz = 0, first_step = mm;
};

/// FBDIST FBPOS NOMRADW YTAPE.
struct WheelsetDimensions {
  /// Range of NOMRADW [m]. Ours: with more the wheel is a plane along the track, and overlaps are as long as the grid.
  static constexpr double least_radius = 1e-6, greatest_radius = 1e3;
  double flange_back_distance = 0, flange_back_position = 0, nominal_radius = 0;
  double tape_circle = 0.999; ///< y of the wheel's profile where the radius is the nominal one; from 0.999 on: z = 0
};

/// N = 0: Z_WS, > 0 below the nominal position.
struct VerticalPosition {
  double z = 0;
};
/// N = 1: FZ on the rail.
struct VerticalForce {
  double fz = 0;
};
using Vertical = std::variant<VerticalPosition, VerticalForce>;

/// S Y Z ROLL YAW PITCH.
struct WheelsetPosition {
  double s = 0; ///< along the track, for rollers the roller's X
  double y = 0;
  Vertical vertical = {};
  double roll = 0, yaw = 0, pitch = 0;

  bool by_force() const { return std::holds_alternative<VerticalForce>(vertical); }
};

/// F = 0 and 3: VPITCH_WS.
struct PitchVelocity {
  double rate = 0;
};
/// F = 1: FX_WS on the rail.
struct LongitudinalForce {
  double fx = 0;
};
/// F = 2: MY_WS.
struct PitchMoment {
  double my = 0;
};
using PitchDrive = std::variant<PitchVelocity, LongitudinalForce, PitchMoment>;

/// VS VY VZ VROLL VYAW, and what drives the wheelset about its axle; in a shift the increments.
struct WheelsetVelocity {
  double vs = 0; ///< of the wheelset, for rollers the roller's rate of rotation
  double vy = 0, vz = 0, vroll = 0, vyaw = 0;
  PitchDrive pitch = {};

  /// VPITCH_WS where it is given, else 0.
  double pitch_rate() const {
    const auto* given = std::get_if<PitchVelocity>(&pitch);
    return given ? given->rate : 0;
  }
};

/// The wheel off its position in the wheelset, and its velocities.
struct WheelDeflection {
  double dx = 0, dy = 0, dz = 0, droll = 0, dyaw = 0, dpitch = 0;
  double vx = 0, vy = 0, vz = 0, vroll = 0, vyaw = 0, vpitch = 0;
};

/// Data of a case of module 1 in addition to those of both modules.
struct WheelRailData {
  WheelRailDigits digits;
  ContactSearch search = ContactSearch::keep; ///< D, of this case or before; never keep or form in a case to be run
  PatchRules grid;
  TrackDimensions track;
  ProfileRecord rail, wheel;
  RailPosition rail_position;
  RailSupport support;
  WheelsetDimensions wheelset;
  WheelsetPosition position;
  WheelsetVelocity velocity;
  WheelDeflection deflection;
};

/// Each reads the record at which `words` stands. Errors as those of Words.
PatchRules read_patch_rules(Words& words);
ProfileRecord read_profile_record(Words& words, const std::string& folder);
TrackDimensions read_track(Words& words, bool roller);
RailPosition read_rail_position(Words& words);
RailSupport read_rail_support(Words& words);
WheelsetDimensions read_wheelset(Words& words);
WheelsetPosition read_position(Words& words, Normal norm);
WheelsetVelocity read_velocity(Words& words, const WheelRailDigits& digits);
WheelDeflection read_deflection(Words& words);

} // namespace microslip::contact_program
