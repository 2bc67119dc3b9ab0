#include "io/length_unit.hpp"

#include "io/option_words.hpp"

#include <array>

namespace microslip::io {

double length_of_unit(std::string_view field, std::string_view word) {
  constexpr auto words = std::to_array<std::string_view>({"mm", "m", "in"});
  require_word(field, word, words);
  return word == "mm" ? 1e-3 : word == "m" ? 1 : 0.0254;
}

} // namespace microslip::io
