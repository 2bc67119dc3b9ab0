#pragma once

#include "binding/fields.hpp"
#include "cases/nip_result.hpp"
#include "microslip/interior/layered_interior.hpp"

namespace microslip::python {

template <>
inline constexpr auto fields<ContactWarnings> =
    members<&ContactWarnings::all, &ContactWarnings::texts, &ContactWarnings::kinds>;
template <>
inline constexpr auto fields<RollerState> =
    members<&RollerState::pressure_power, &RollerState::drive, &RollerState::indentation, &RollerState::cover,
            &RollerState::strain>;
template <>
inline constexpr auto fields<Nip> =
    members<&Nip::width, &Nip::peak_pressure, &Nip::indentation, &Nip::traction, &Nip::traction_capacity,
            &Nip::utilisation, &Nip::hysteresis_power, &Nip::slip_power, &Nip::rolling_resistance, &Nip::body1,
            &Nip::body2, &Nip::warnings>;
template <>
inline constexpr auto fields<FreeRoller> =
    members<&FreeRoller::speed_ratio, &FreeRoller::creepage, &FreeRoller::fx, &FreeRoller::solution>;
template <>
inline constexpr auto fields<cases::NipResult> =
    members<&cases::NipResult::nip, &cases::NipResult::free1, &cases::NipResult::free2>;

template <>
inline constexpr auto fields<LayerPeak> =
    members<&LayerPeak::body, &LayerPeak::layer, &LayerPeak::von_mises, &LayerPeak::place>;
template <>
inline constexpr auto fields<InterfacePeak> =
    members<&InterfacePeak::body, &InterfacePeak::layer, &InterfacePeak::shear, &InterfacePeak::shear_place,
            &InterfacePeak::tension, &InterfacePeak::tension_place>;
template <> inline constexpr auto fields<LayeredPeaks> = members<&LayeredPeaks::layers, &LayeredPeaks::interfaces>;

} // namespace microslip::python
