#pragma once

#include "compat/contact/wheel_rail/records.hpp"

#include <cstddef>

namespace microslip::contact_program {

enum class Mirrored { even, odd };

/// A number of a record: CONTACT's name, its unit in files, and whether it changes its sign in a mirror whose plane is
/// the track's centre.
template <class Record> struct RecordNumber {
  const char* name;
  double Record::*member;
  Unit unit;
  Mirrored mirrored;
};

// In the order of the files.

inline constexpr RecordNumber<RailPosition> rail_position_numbers[] = {
    {"DYRAIL", &RailPosition::dy, Unit::length, Mirrored::odd},
    {"DZRAIL", &RailPosition::dz, Unit::length, Mirrored::even},
    {"DROLLR", &RailPosition::roll, Unit::angle, Mirrored::odd},
    {"VYRAIL", &RailPosition::vy, Unit::length, Mirrored::odd},
    {"VZRAIL", &RailPosition::vz, Unit::length, Mirrored::even},
    {"VROLLR", &RailPosition::vroll, Unit::angle, Mirrored::odd},
};

/// Without DYSTEP0, a length.
inline constexpr RecordNumber<RailSupport> rail_support_numbers[] = {
    {"KYRAIL", &RailSupport::ky, Unit::per_length, Mirrored::even},
    {"FYRAIL", &RailSupport::fy, Unit::plain, Mirrored::odd},
    {"KZRAIL", &RailSupport::kz, Unit::per_length, Mirrored::even},
    {"FZRAIL", &RailSupport::fz, Unit::plain, Mirrored::even},
};

/// Without the third one, Z_WS or FZ.
inline constexpr std::size_t before_vertical = 2;
inline constexpr RecordNumber<WheelsetPosition> wheelset_position_numbers[] = {
    {"S_WS", &WheelsetPosition::s, Unit::length, Mirrored::even},
    {"Y_WS", &WheelsetPosition::y, Unit::length, Mirrored::odd},
    {"ROLL_WS", &WheelsetPosition::roll, Unit::angle, Mirrored::odd},
    {"YAW_WS", &WheelsetPosition::yaw, Unit::angle, Mirrored::odd},
    {"PITCH_WS", &WheelsetPosition::pitch, Unit::angle, Mirrored::even},
};

/// Without the first one, VS_WS or a roller's RPITCH, and the last one, VPITCH_WS or a force or moment.
inline constexpr RecordNumber<WheelsetVelocity> wheelset_velocity_numbers[] = {
    {"VY_WS", &WheelsetVelocity::vy, Unit::length, Mirrored::odd},
    {"VZ_WS", &WheelsetVelocity::vz, Unit::length, Mirrored::even},
    {"VROLL_WS", &WheelsetVelocity::vroll, Unit::angle, Mirrored::odd},
    {"VYAW_WS", &WheelsetVelocity::vyaw, Unit::angle, Mirrored::odd},
};

/// Two records of six.
inline constexpr RecordNumber<WheelDeflection> wheel_deflection_numbers[] = {
    {"DXWHL", &WheelDeflection::dx, Unit::length, Mirrored::even},
    {"DYWHL", &WheelDeflection::dy, Unit::length, Mirrored::odd},
    {"DZWHL", &WheelDeflection::dz, Unit::length, Mirrored::even},
    {"DROLLW", &WheelDeflection::droll, Unit::angle, Mirrored::odd},
    {"DYAWW", &WheelDeflection::dyaw, Unit::angle, Mirrored::odd},
    {"DPITCHW", &WheelDeflection::dpitch, Unit::angle, Mirrored::even},
    {"VXWHL", &WheelDeflection::vx, Unit::length, Mirrored::even},
    {"VYWHL", &WheelDeflection::vy, Unit::length, Mirrored::odd},
    {"VZWHL", &WheelDeflection::vz, Unit::length, Mirrored::even},
    {"VROLLW", &WheelDeflection::vroll, Unit::angle, Mirrored::odd},
    {"VYAWW", &WheelDeflection::vyaw, Unit::angle, Mirrored::odd},
    {"VPITCHW", &WheelDeflection::vpitch, Unit::angle, Mirrored::even},
};

} // namespace microslip::contact_program
