#pragma once

#include <span>
#include <string>
#include <string_view>

namespace microslip::io {

/// The known word that differs least from a misspelt one, counting letters inserted, left out, replaced or swapped
/// with their neighbour; letters of either case count as equal. Empty if more than a third of the letters differ. Cost:
/// the product of the lengths for every known word; words of more than 64 letters resemble nothing.
std::string nearest_word(std::string_view word, std::span<const std::string_view> known);

/// `; did you mean WORD?` with the nearest word, or nothing: the end of a message about an unknown word.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

/// Words in a sentence: `a, b or c`, or with "and" as the conjunction.
std::string listed(std::span<const std::string_view> words, std::string_view conjunction = "or");

/// Text from a file as a message can show it: in double quotes, bytes that do not print as \xNN, shortened if long.
std::string printable(std::string_view text);

} // namespace microslip::io
