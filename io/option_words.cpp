#include "io/option_words.hpp"

#include "io/nearest_word.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

#include <algorithm>
#include <string>

namespace microslip::io {
namespace {

template <class Option> constexpr std::array<std::string_view, 0> words_of{};
template <> constexpr auto words_of<Theory> = description::theories;
template <> constexpr auto words_of<TractionBound> = description::traction_bounds;
template <> constexpr auto words_of<FlexibilityModel> = description::flexibility_models;
template <> constexpr auto words_of<CreepageTable> = description::creepage_tables;
template <> constexpr auto words_of<Precision> = description::precisions;
template <> constexpr auto words_of<RollingDirection> = description::rolling_directions;
template <> constexpr auto words_of<Discretisation> = description::discretisations;
template <> constexpr auto words_of<ElementShape> = description::element_shapes;
template <> constexpr auto words_of<Coupling> = description::couplings;
template <> constexpr auto words_of<SlipStart> = description::slip_starts;
template <> constexpr auto words_of<ContactMotion> = description::contact_motions;
template <> constexpr auto words_of<ProfileRole> = description::profile_roles;
template <> constexpr auto words_of<ProfileFormat> = description::profile_formats;
template <> constexpr auto words_of<LateralSense> = description::lateral_senses;
template <> constexpr auto words_of<VerticalSense> = description::vertical_senses;
template <> constexpr auto words_of<PatchShape> = description::patch_shapes;
template <> constexpr auto words_of<TrackSide> = description::track_sides;
template <> constexpr auto words_of<RollRule> = description::roll_rules;

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
template PatchShape from_word(std::string_view, std::string_view);
template TrackSide from_word(std::string_view, std::string_view);
template RollRule from_word(std::string_view, std::string_view);

void require_word(std::string_view field, std::string_view word, std::span<const std::string_view> words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return;
  throw Error(std::string(field) + " = " + printable(word) + ": must be " + listed(words) + suggestion(word, words));
}

} // namespace microslip::io
