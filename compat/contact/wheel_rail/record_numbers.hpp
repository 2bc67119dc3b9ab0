#pragma once

#include "compat/contact/wheel_rail/records.hpp"

namespace microslip::contact_program {

enum class Given { number, angle };
enum class Mirrored { even, odd };

/// A number of a record: CONTACT's name, how files give it, and whether it changes its sign in a mirror whose plane is
/// the track's centre.
template <class Record> struct RecordNumber {
  const char* name;
  double Record::*member;
  Given given;
  Mirrored mirrored;
};

// In the order of the files.

inline constexpr RecordNumber<RailPosition> rail_position_numbers[] = {
    {"DYRAIL", &RailPosition::dy, Given::number, Mirrored::odd},
    {"DZRAIL", &RailPosition::dz, Given::number, Mirrored::even},
    {"DROLLR", &RailPosition::roll, Given::angle, Mirrored::odd},
    {"VYRAIL", &RailPosition::vy, Given::number, Mirrored::odd},
    {"VZRAIL", &RailPosition::vz, Given::number, Mirrored::even},
    {"VROLLR", &RailPosition::vroll, Given::angle, Mirrored::odd},
};

/// Without DYSTEP0, a length.
inline constexpr RecordNumber<RailSupport> rail_support_numbers[] = {
    {"KYRAIL", &RailSupport::ky, Given::number, Mirrored::even},
    {"FYRAIL", &RailSupport::fy, Given::number, Mirrored::odd},
    {"KZRAIL", &RailSupport::kz, Given::number, Mirrored::even},
    {"FZRAIL", &RailSupport::fz, Given::number, Mirrored::even},
};

/// Without the third one, Z_WS or FZ.
inline constexpr RecordNumber<WheelsetPosition> wheelset_position_numbers[] = {
    {"S_WS", &WheelsetPosition::s, Given::number, Mirrored::even},
    {"Y_WS", &WheelsetPosition::y, Given::number, Mirrored::odd},
    {"ROLL_WS", &WheelsetPosition::roll, Given::angle, Mirrored::odd},
    {"YAW_WS", &WheelsetPosition::yaw, Given::angle, Mirrored::odd},
    {"PITCH_WS", &WheelsetPosition::pitch, Given::angle, Mirrored::even},
};

/// Without the first one, VS_WS or a roller's RPITCH, and the last one, VPITCH_WS or a force or moment.
inline constexpr RecordNumber<WheelsetVelocity> wheelset_velocity_numbers[] = {
    {"VY_WS", &WheelsetVelocity::vy, Given::number, Mirrored::odd},
    {"VZ_WS", &WheelsetVelocity::vz, Given::number, Mirrored::even},
    {"VROLL_WS", &WheelsetVelocity::vroll, Given::angle, Mirrored::odd},
    {"VYAW_WS", &WheelsetVelocity::vyaw, Given::angle, Mirrored::odd},
};

/// Two records of six.
inline constexpr RecordNumber<WheelDeflection> wheel_deflection_numbers[] = {
    {"DXWHL", &WheelDeflection::dx, Given::number, Mirrored::even},
    {"DYWHL", &WheelDeflection::dy, Given::number, Mirrored::odd},
    {"DZWHL", &WheelDeflection::dz, Given::number, Mirrored::even},
    {"DROLLW", &WheelDeflection::droll, Given::angle, Mirrored::odd},
    {"DYAWW", &WheelDeflection::dyaw, Given::angle, Mirrored::odd},
    {"DPITCHW", &WheelDeflection::dpitch, Given::angle, Mirrored::even},
    {"VXWHL", &WheelDeflection::vx, Given::number, Mirrored::even},
    {"VYWHL", &WheelDeflection::vy, Given::number, Mirrored::odd},
    {"VZWHL", &WheelDeflection::vz, Given::number, Mirrored::even},
    {"VROLLW", &WheelDeflection::vroll, Given::angle, Mirrored::odd},
    {"VYAWW", &WheelDeflection::vyaw, Given::angle, Mirrored::odd},
    {"VPITCHW", &WheelDeflection::vpitch, Given::angle, Mirrored::even},
};

} // namespace microslip::contact_program
