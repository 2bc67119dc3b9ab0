#pragma once

#include "binding/fields.hpp"
#include "microslip/railway/wheel_rail.hpp"

namespace microslip::python {

template <>
inline constexpr auto fields<Track> =
    members<&Track::gauge, &Track::gauge_height, &Track::rail_origin, &Track::cant, &Track::roller_radius>;
template <>
inline constexpr auto fields<Wheelset> = members<&Wheelset::flange_back_distance, &Wheelset::flange_back_position,
                                                 &Wheelset::nominal_radius, &Wheelset::tape_circle>;
template <> inline constexpr auto fields<Vec3<double>> = members<&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z>;
template <>
inline constexpr auto fields<PatchDamage> = members<&PatchDamage::worn_area, &PatchDamage::wear_depth,
                                                    &PatchDamage::fatigue_index, &PatchDamage::shakedown_load>;
template <>
inline constexpr auto fields<WheelRailPatch> =
    members<&WheelRailPatch::place, &WheelRailPatch::angle, &WheelRailPatch::rail_y, &WheelRailPatch::wheel_y,
            &WheelRailPatch::rolling_radius, &WheelRailPatch::turn, &WheelRailPatch::conformity,
            &WheelRailPatch::approach, &WheelRailPatch::rolling_speed, &WheelRailPatch::creepage,
            &WheelRailPatch::normal_force, &WheelRailPatch::fx, &WheelRailPatch::fs, &WheelRailPatch::moment,
            &WheelRailPatch::contact_area, &WheelRailPatch::slip_area, &WheelRailPatch::peak_pressure,
            &WheelRailPatch::frictional_power, &WheelRailPatch::friction, &WheelRailPatch::damage,
            &WheelRailPatch::status>;
template <>
inline constexpr auto fields<WheelRailSolution> =
    members<&WheelRailSolution::force, &WheelRailSolution::moment, &WheelRailSolution::vertical,
            &WheelRailSolution::patches, &WheelRailSolution::fields, &WheelRailSolution::residual,
            &WheelRailSolution::iterations, &WheelRailSolution::warnings, &WheelRailSolution::y_over_q,
            &WheelRailSolution::nadal_limit, &WheelRailSolution::status, &WheelRailSolution::reason>;

} // namespace microslip::python
