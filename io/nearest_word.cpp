#include "io/nearest_word.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace microslip::io {
namespace {

constexpr std::size_t longest_word = 64;

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// Edit distance with swaps of neighbours ("optimal string alignment"). Keeps three rows of the table.
std::size_t distance(std::string_view from, std::string_view to) {
  std::array<std::array<std::size_t, longest_word + 1>, 3> rows{};
  auto *before = &rows[0], *previous = &rows[1], *current = &rows[2];
  for (std::size_t j = 0; j <= to.size(); ++j) (*previous)[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    (*current)[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const bool same = lower(from[i - 1]) == lower(to[j - 1]);
      auto cost = std::min({(*previous)[j] + 1, (*current)[j - 1] + 1, (*previous)[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && lower(from[i - 1]) == lower(to[j - 2]) && lower(from[i - 2]) == lower(to[j - 1]))
        cost = std::min(cost, (*before)[j - 2] + 1);
      (*current)[j] = cost;
    }
    auto* const oldest = before;
    before = previous;
    previous = current;
    current = oldest;
  }
  return (*previous)[to.size()];
}

} // namespace

std::string nearest_word(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  auto least = longest_word;
  for (const auto candidate : known) {
    const auto longer = std::max(word.size(), candidate.size());
    if (longer > longest_word) continue;
    const auto found = distance(word, candidate);
    if (3 * found <= longer && found < least) {
      least = found;
      best = candidate;
    }
  }
  return std::string(best);
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const auto nearest = nearest_word(word, known);
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

std::string listed(std::span<const std::string_view> words, std::string_view conjunction) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && i + 1 == words.size())
      text.append(" ").append(conjunction).append(" ");
    else if (i > 0)
      text += ", ";
    text += words[i];
  }
  return text;
}

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 40;
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char byte : text.substr(0, longest)) {
    const auto code = static_cast<unsigned char>(byte);
    if (code >= 0x20 && code < 0x7f) {
      result += byte;
    } else {
      result += "\\x";
      result += digits[code / 16];
      result += digits[code % 16];
    }
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

} // namespace microslip::io
