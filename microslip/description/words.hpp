#pragma once

#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/railway/wheelset_contact.hpp"
#include "microslip/rolling/method.hpp"

#include <array>
#include <string_view>

namespace microslip::description {

using Word = std::string_view;

/// The words by which all interfaces name an option's values, in the order of its enumerators.
template <class Option> inline constexpr std::array<Word, 0> words{};
template <>
inline constexpr auto words<Theory> =
    std::array<Word, 6>{"fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"};
template <> inline constexpr auto words<TractionBound> = std::array<Word, 2>{"parabolic", "elliptic"};
template <> inline constexpr auto words<FlexibilityModel> = std::array<Word, 3>{"three", "one", "blended"};
template <> inline constexpr auto words<CreepageTable> = std::array<Word, 2>{"kalker", "computed"};
template <> inline constexpr auto words<Precision> = std::array<Word, 2>{"double", "single"};
template <> inline constexpr auto words<RollingDirection> = std::array<Word, 2>{"forward", "backward"};
template <> inline constexpr auto words<Discretisation> = std::array<Word, 2>{"second_order", "classical"};
template <> inline constexpr auto words<ElementShape> = std::array<Word, 2>{"constant", "bilinear"};
template <> inline constexpr auto words<Coupling> = std::array<Word, 2>{"newton", "alternating"};
template <> inline constexpr auto words<SlipStart> = std::array<Word, 2>{"below", "above"};
template <> inline constexpr auto words<ContactMotion> = std::array<Word, 3>{"shift", "transient", "steady"};
template <> inline constexpr auto words<ProfileRole> = std::array<Word, 2>{"rail", "wheel"};
template <> inline constexpr auto words<WheelRailLevel> = std::array<Word, 3>{"fastsim2", "exact", "table"};
template <> inline constexpr auto words<PatchShape> = std::array<Word, 3>{"flat", "curved", "conformal"};
template <> inline constexpr auto words<TrackSide> = std::array<Word, 2>{"left", "right"};
template <> inline constexpr auto words<RollRule> = std::array<Word, 2>{"equilibrium", "none"};

/// Those of profile files and of friction laws in case files.
inline constexpr std::array<Word, 3> profile_formats{"simpack", "miniprof", "columns"};
inline constexpr std::array<Word, 2> lateral_senses{"field", "gauge"};
inline constexpr std::array<Word, 2> vertical_senses{"up", "down"};

} // namespace microslip::description
