#pragma once

#include "io/profile_file.hpp"
#include "microslip/rolling/method.hpp"

#include <span>
#include <string_view>

namespace microslip::io {

/// The words by which files and the command line name options, e.g. "fastsim_half_step" or "parabolic". There are
/// words for Theory, TractionBound, FlexibilityModel, CreepageTable, Precision, RollingDirection,
/// ContactMotion, Discretisation, ElementShape, Coupling, SlipStart, ProfileRole, ProfileFormat, LateralSense,
/// VerticalSense, PatchShape, TrackSide and RollRule.
template <class Option> std::span<const std::string_view> option_words();
template <class Option> std::string_view to_word(Option option);

/// The option that a word names. Error for any other word: `FIELD = "WORD": must be A, B or C; did you mean B?`.
template <class Option> Option from_word(std::string_view field, std::string_view word);

/// Error as above unless `word` is one of `words`.
void require_word(std::string_view field, std::string_view word, std::span<const std::string_view> words);

} // namespace microslip::io
