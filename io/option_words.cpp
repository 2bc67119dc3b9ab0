#include "io/option_words.hpp"

#include "io/nearest_word.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheelset_contact.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace microslip::io {
namespace {

using Word = std::string_view;

// Each list is in the order of its enumerators.
template <class Option> constexpr std::array<Word, 0> words_of{};
template <>
constexpr auto words_of<Theory> =
    std::array<Word, 6>{"fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"};
template <> constexpr auto words_of<TractionBound> = std::array<Word, 2>{"parabolic", "elliptic"};
template <> constexpr auto words_of<FlexibilityModel> = std::array<Word, 3>{"three", "one", "blended"};
template <> constexpr auto words_of<CreepageTable> = std::array<Word, 2>{"kalker", "computed"};
template <> constexpr auto words_of<Precision> = std::array<Word, 2>{"double", "single"};
template <> constexpr auto words_of<RollingDirection> = std::array<Word, 2>{"forward", "backward"};
template <> constexpr auto words_of<Discretisation> = std::array<Word, 2>{"second_order", "classical"};
template <> constexpr auto words_of<ElementShape> = std::array<Word, 2>{"constant", "bilinear"};
template <> constexpr auto words_of<Coupling> = std::array<Word, 2>{"newton", "alternating"};
template <> constexpr auto words_of<SlipStart> = std::array<Word, 2>{"below", "above"};
template <> constexpr auto words_of<ContactMotion> = std::array<Word, 3>{"shift", "transient", "steady"};
template <> constexpr auto words_of<ProfileRole> = std::array<Word, 2>{"rail", "wheel"};
template <> constexpr auto words_of<ProfileFormat> = std::array<Word, 3>{"simpack", "miniprof", "columns"};
template <> constexpr auto words_of<LateralSense> = std::array<Word, 2>{"field", "gauge"};
template <> constexpr auto words_of<VerticalSense> = std::array<Word, 2>{"up", "down"};
template <> constexpr auto words_of<WheelRailLevel> = std::array<Word, 3>{"fastsim2", "exact", "table"};
template <> constexpr auto words_of<PatchShape> = std::array<Word, 3>{"flat", "curved", "conformal"};
template <> constexpr auto words_of<TrackSide> = std::array<Word, 2>{"left", "right"};
template <> constexpr auto words_of<RollRule> = std::array<Word, 2>{"equilibrium", "none"};

} // namespace

template <class Option> std::span<const std::string_view> option_words() {
  return words_of<Option>;
}

template <class Option> std::string_view to_word(Option option) {
  return words_of<Option>[static_cast<std::size_t>(option)];
}

template <class Option> Option from_word(std::string_view field, std::string_view word) {
  constexpr auto& words = words_of<Option>;
  require_word(field, word, words);
  return static_cast<Option>(std::find(words.begin(), words.end(), word) - words.begin());
}

template std::span<const std::string_view> option_words<Theory>();
template std::span<const std::string_view> option_words<TractionBound>();
template std::span<const std::string_view> option_words<FlexibilityModel>();
template std::span<const std::string_view> option_words<CreepageTable>();
template std::span<const std::string_view> option_words<Precision>();
template std::span<const std::string_view> option_words<RollingDirection>();
template std::span<const std::string_view> option_words<ContactMotion>();
template std::span<const std::string_view> option_words<Discretisation>();
template std::span<const std::string_view> option_words<ElementShape>();
template std::span<const std::string_view> option_words<Coupling>();
template std::span<const std::string_view> option_words<SlipStart>();
template std::span<const std::string_view> option_words<ProfileRole>();
template std::span<const std::string_view> option_words<ProfileFormat>();
template std::span<const std::string_view> option_words<LateralSense>();
template std::span<const std::string_view> option_words<VerticalSense>();
template std::span<const std::string_view> option_words<WheelRailLevel>();
template std::span<const std::string_view> option_words<PatchShape>();
template std::span<const std::string_view> option_words<TrackSide>();
template std::span<const std::string_view> option_words<RollRule>();
template std::string_view to_word(Theory);
template std::string_view to_word(TractionBound);
template std::string_view to_word(FlexibilityModel);
template std::string_view to_word(CreepageTable);
template std::string_view to_word(Precision);
template std::string_view to_word(RollingDirection);
template std::string_view to_word(ContactMotion);
template std::string_view to_word(Discretisation);
template std::string_view to_word(ElementShape);
template std::string_view to_word(Coupling);
template std::string_view to_word(SlipStart);
template std::string_view to_word(ProfileRole);
template std::string_view to_word(ProfileFormat);
template std::string_view to_word(LateralSense);
template std::string_view to_word(VerticalSense);
template std::string_view to_word(WheelRailLevel);
template std::string_view to_word(PatchShape);
template std::string_view to_word(TrackSide);
template std::string_view to_word(RollRule);
template Theory from_word(std::string_view, std::string_view);
template TractionBound from_word(std::string_view, std::string_view);
template FlexibilityModel from_word(std::string_view, std::string_view);
template CreepageTable from_word(std::string_view, std::string_view);
template Precision from_word(std::string_view, std::string_view);
template RollingDirection from_word(std::string_view, std::string_view);
template ContactMotion from_word(std::string_view, std::string_view);
template Discretisation from_word(std::string_view, std::string_view);
template ElementShape from_word(std::string_view, std::string_view);
template Coupling from_word(std::string_view, std::string_view);
template SlipStart from_word(std::string_view, std::string_view);
template ProfileRole from_word(std::string_view, std::string_view);
template ProfileFormat from_word(std::string_view, std::string_view);
template LateralSense from_word(std::string_view, std::string_view);
template VerticalSense from_word(std::string_view, std::string_view);
template WheelRailLevel from_word(std::string_view, std::string_view);
template PatchShape from_word(std::string_view, std::string_view);
template TrackSide from_word(std::string_view, std::string_view);
template RollRule from_word(std::string_view, std::string_view);

void require_word(std::string_view field, std::string_view word, std::span<const std::string_view> words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return;
  throw Error(std::string(field) + " = " + printable(word) + ": must be " + listed(words) + suggestion(word, words));
}

} // namespace microslip::io
