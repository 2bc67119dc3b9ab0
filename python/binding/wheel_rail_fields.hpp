#pragma once

#include "binding/fields.hpp"
#include "microslip/railway/wheel_rail.hpp"

namespace microslip::python {

template <>
inline constexpr auto fields<Track> =
    std::tuple{Field{"gauge", &Track::gauge}, Field{"gauge_height", &Track::gauge_height},
               Field{"rail_origin", &Track::rail_origin}, Field{"cant", &Track::cant},
               Field{"roller_radius", &Track::roller_radius}};
template <>
inline constexpr auto fields<Wheelset> =
    std::tuple{Field{"flange_back_distance", &Wheelset::flange_back_distance},
               Field{"flange_back_position", &Wheelset::flange_back_position},
               Field{"nominal_radius", &Wheelset::nominal_radius}, Field{"tape_circle", &Wheelset::tape_circle}};
template <>
inline constexpr auto fields<Vec3<double>> =
    std::tuple{Field{"x", &Vec3<double>::x}, Field{"y", &Vec3<double>::y}, Field{"z", &Vec3<double>::z}};
template <>
inline constexpr auto fields<PatchDamage> =
    std::tuple{Field{"worn_area", &PatchDamage::worn_area}, Field{"wear_depth", &PatchDamage::wear_depth},
               Field{"fatigue_index", &PatchDamage::fatigue_index},
               Field{"shakedown_load", &PatchDamage::shakedown_load}};
template <> inline constexpr auto fields<Warnings> = std::tuple{Field{"code", &Warnings::code}};
template <>
inline constexpr auto fields<WheelRailPatch> = std::tuple{Field{"place", &WheelRailPatch::place},
                                                          Field{"angle", &WheelRailPatch::angle},
                                                          Field{"rail_y", &WheelRailPatch::rail_y},
                                                          Field{"wheel_y", &WheelRailPatch::wheel_y},
                                                          Field{"rolling_radius", &WheelRailPatch::rolling_radius},
                                                          Field{"turn", &WheelRailPatch::turn},
                                                          Field{"conformity", &WheelRailPatch::conformity},
                                                          Field{"approach", &WheelRailPatch::approach},
                                                          Field{"rolling_speed", &WheelRailPatch::rolling_speed},
                                                          Field{"creepage", &WheelRailPatch::creepage},
                                                          Field{"normal_force", &WheelRailPatch::normal_force},
                                                          Field{"fx", &WheelRailPatch::fx},
                                                          Field{"fs", &WheelRailPatch::fs},
                                                          Field{"moment", &WheelRailPatch::moment},
                                                          Field{"contact_area", &WheelRailPatch::contact_area},
                                                          Field{"slip_area", &WheelRailPatch::slip_area},
                                                          Field{"peak_pressure", &WheelRailPatch::peak_pressure},
                                                          Field{"frictional_power", &WheelRailPatch::frictional_power},
                                                          Field{"friction", &WheelRailPatch::friction},
                                                          Field{"damage", &WheelRailPatch::damage},
                                                          Field{"status", &WheelRailPatch::status}};
template <>
inline constexpr auto fields<WheelRailSolution> = std::tuple{
    Field{"force", &WheelRailSolution::force},           Field{"moment", &WheelRailSolution::moment},
    Field{"vertical", &WheelRailSolution::vertical},     Field{"patches", &WheelRailSolution::patches},
    Field{"fields", &WheelRailSolution::fields},         Field{"residual", &WheelRailSolution::residual},
    Field{"iterations", &WheelRailSolution::iterations}, Field{"warnings", &WheelRailSolution::warnings},
    Field{"y_over_q", &WheelRailSolution::y_over_q},     Field{"nadal_limit", &WheelRailSolution::nadal_limit},
    Field{"status", &WheelRailSolution::status},         Field{"reason", &WheelRailSolution::reason}};

} // namespace microslip::python
