#pragma once

#include "compat/contact/wheel_rail/records.hpp"

#include <cstddef>

namespace microslip::contact_program {

/// The unit of an angle, which files may give in degrees.
inline constexpr double angle = 0;
enum class Mirrored { even, odd };

/// A number of a record: CONTACT's name, its unit in files, and whether it changes its sign in a mirror whose plane is
/// the track's centre.
template <class Record> struct RecordNumber {
  const char* name;
  double Record::*member;
  double unit;
  Mirrored mirrored;
};

// In the order of the files.

inline constexpr RecordNumber<RailPosition> rail_position_numbers[] = {
    {"DYRAIL", &RailPosition::dy, mm, Mirrored::odd},      {"DZRAIL", &RailPosition::dz, mm, Mirrored::even},
    {"DROLLR", &RailPosition::roll, angle, Mirrored::odd}, {"VYRAIL", &RailPosition::vy, mm, Mirrored::odd},
    {"VZRAIL", &RailPosition::vz, mm, Mirrored::even},     {"VROLLR", &RailPosition::vroll, angle, Mirrored::odd},
};

/// Without DYSTEP0, a length.
inline constexpr RecordNumber<RailSupport> rail_support_numbers[] = {
    {"KYRAIL", &RailSupport::ky, per_mm, Mirrored::even},
    {"FYRAIL", &RailSupport::fy, 1, Mirrored::odd},
    {"KZRAIL", &RailSupport::kz, per_mm, Mirrored::even},
    {"FZRAIL", &RailSupport::fz, 1, Mirrored::even},
};

/// Without the third one, Z_WS or FZ.
inline constexpr std::size_t before_vertical = 2;
inline constexpr RecordNumber<WheelsetPosition> wheelset_position_numbers[] = {
    {"S_WS", &WheelsetPosition::s, mm, Mirrored::even},
    {"Y_WS", &WheelsetPosition::y, mm, Mirrored::odd},
    {"ROLL_WS", &WheelsetPosition::roll, angle, Mirrored::odd},
    {"YAW_WS", &WheelsetPosition::yaw, angle, Mirrored::odd},
    {"PITCH_WS", &WheelsetPosition::pitch, angle, Mirrored::even},
};

/// Without the first one, VS_WS or a roller's RPITCH, and the last one, VPITCH_WS or a force or moment.
inline constexpr RecordNumber<WheelsetVelocity> wheelset_velocity_numbers[] = {
    {"VY_WS", &WheelsetVelocity::vy, mm, Mirrored::odd},
    {"VZ_WS", &WheelsetVelocity::vz, mm, Mirrored::even},
    {"VROLL_WS", &WheelsetVelocity::vroll, angle, Mirrored::odd},
    {"VYAW_WS", &WheelsetVelocity::vyaw, angle, Mirrored::odd},
};

/// Two records of six.
inline constexpr RecordNumber<WheelDeflection> wheel_deflection_numbers[] = {
    {"DXWHL", &WheelDeflection::dx, mm, Mirrored::even},
    {"DYWHL", &WheelDeflection::dy, mm, Mirrored::odd},
    {"DZWHL", &WheelDeflection::dz, mm, Mirrored::even},
    {"DROLLW", &WheelDeflection::droll, angle, Mirrored::odd},
    {"DYAWW", &WheelDeflection::dyaw, angle, Mirrored::odd},
    {"DPITCHW", &WheelDeflection::dpitch, angle, Mirrored::even},
    {"VXWHL", &WheelDeflection::vx, mm, Mirrored::even},
    {"VYWHL", &WheelDeflection::vy, mm, Mirrored::odd},
    {"VZWHL", &WheelDeflection::vz, mm, Mirrored::even},
    {"VROLLW", &WheelDeflection::vroll, angle, Mirrored::odd},
    {"VYAWW", &WheelDeflection::vyaw, angle, Mirrored::odd},
    {"VPITCHW", &WheelDeflection::vpitch, angle, Mirrored::even},
};

} // namespace microslip::contact_program
