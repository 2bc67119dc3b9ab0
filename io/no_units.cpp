#include "io/nearest_word.hpp"
#include "io/units.hpp"
#include "microslip/error.hpp"

namespace microslip {

class Units::System {};

Units::Units() = default;
Units::~Units() = default;

double Units::number(std::string_view field, std::string_view text, std::string_view unit) {
  throw Error(std::string(field) + " = " + printable(text) + " [" + std::string(unit) +
              "]: must be a number; this program was built without UDUNITS, which reads units");
}

UnitScale Units::scale(std::string_view field, std::string_view from, std::string_view unit) {
  if (from == unit) return {};
  throw Error(std::string(field) + " [" + std::string(from) + "]: must be in " + std::string(unit) +
              "; this program was built without UDUNITS, which reads units");
}

} // namespace microslip
