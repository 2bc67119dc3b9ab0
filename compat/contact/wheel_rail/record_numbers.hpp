#pragma once

#include "compat/contact/wheel_rail/records.hpp"

#include <cstddef>

namespace microslip::contact_program {

namespace units {
inline constexpr Unit plain = 0, angle = {0, true}, length = 1, per_length = -1;
}
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
    {"DYRAIL", &RailPosition::dy, units::length, Mirrored::odd},
    {"DZRAIL", &RailPosition::dz, units::length, Mirrored::even},
    {"DROLLR", &RailPosition::roll, units::angle, Mirrored::odd},
    {"VYRAIL", &RailPosition::vy, units::length, Mirrored::odd},
    {"VZRAIL", &RailPosition::vz, units::length, Mirrored::even},
    {"VROLLR", &RailPosition::vroll, units::angle, Mirrored::odd},
};

/// Without DYSTEP0, a length.
inline constexpr RecordNumber<RailSupport> rail_support_numbers[] = {
    {"KYRAIL", &RailSupport::ky, units::per_length, Mirrored::even},
    {"FYRAIL", &RailSupport::fy, units::plain, Mirrored::odd},
    {"KZRAIL", &RailSupport::kz, units::per_length, Mirrored::even},
    {"FZRAIL", &RailSupport::fz, units::plain, Mirrored::even},
};

/// Without the third one, Z_WS or FZ.
inline constexpr std::size_t before_vertical = 2;
inline constexpr RecordNumber<WheelsetPosition> wheelset_position_numbers[] = {
    {"S_WS", &WheelsetPosition::s, units::length, Mirrored::even},
    {"Y_WS", &WheelsetPosition::y, units::length, Mirrored::odd},
    {"ROLL_WS", &WheelsetPosition::roll, units::angle, Mirrored::odd},
    {"YAW_WS", &WheelsetPosition::yaw, units::angle, Mirrored::odd},
    {"PITCH_WS", &WheelsetPosition::pitch, units::angle, Mirrored::even},
};

/// Without the first one, VS_WS or a roller's RPITCH, and the last one, VPITCH_WS or a force or moment.
inline constexpr RecordNumber<WheelsetVelocity> wheelset_velocity_numbers[] = {
    {"VY_WS", &WheelsetVelocity::vy, units::length, Mirrored::odd},
    {"VZ_WS", &WheelsetVelocity::vz, units::length, Mirrored::even},
    {"VROLL_WS", &WheelsetVelocity::vroll, units::angle, Mirrored::odd},
    {"VYAW_WS", &WheelsetVelocity::vyaw, units::angle, Mirrored::odd},
};

/// Two records of six.
inline constexpr RecordNumber<WheelDeflection> wheel_deflection_numbers[] = {
    {"DXWHL", &WheelDeflection::dx, units::length, Mirrored::even},
    {"DYWHL", &WheelDeflection::dy, units::length, Mirrored::odd},
    {"DZWHL", &WheelDeflection::dz, units::length, Mirrored::even},
    {"DROLLW", &WheelDeflection::droll, units::angle, Mirrored::odd},
    {"DYAWW", &WheelDeflection::dyaw, units::angle, Mirrored::odd},
    {"DPITCHW", &WheelDeflection::dpitch, units::angle, Mirrored::even},
    {"VXWHL", &WheelDeflection::vx, units::length, Mirrored::even},
    {"VYWHL", &WheelDeflection::vy, units::length, Mirrored::odd},
    {"VZWHL", &WheelDeflection::vz, units::length, Mirrored::even},
    {"VROLLW", &WheelDeflection::vroll, units::angle, Mirrored::odd},
    {"VYAWW", &WheelDeflection::vyaw, units::angle, Mirrored::odd},
    {"VPITCHW", &WheelDeflection::vpitch, units::angle, Mirrored::even},
};

} // namespace microslip::contact_program
