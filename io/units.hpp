#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Numbers in one unit as such in another. Only one of the two is not 1, so that decimal numbers of a prefix, 1435 mm,
/// are the nearest numbers of the unit without it.
struct UnitScale {
  double times = 1, over = 1;
  double operator()(double value) const { return value * times / over; }
};

// Numbers with a unit as files have them, "80 kN" or "0.4 1/m", by the grammar of UDUNITS: blanks, dots, `*` and `/`
// between units, exponents as m2, m^2 or m-1, prefixes from n to G. The units are listed in docs/quick-start.md.

/// Converts `text` to `unit`: 80e3 for "80 kN" in "N". A temperature in "deg C" may be given in K or degF, a difference
/// in "K" in nothing else; spin and curvature in "1/m" as an angle by a length, too. Error for text without a number or
/// without a unit, an unknown unit, and one of another kind: `FIELD = "80 mm" [N]: must be in N, kN, MN, kgf or lbf,
/// e.g. "80 kN"`. Cost: about a microsecond.
double number_in_unit(std::string_view field, std::string_view text, std::string_view unit);
/// Scale from a unit to another without an offset. Error as above.
UnitScale scale_to_unit(std::string_view field, std::string_view from, std::string_view unit);

/// A unit that messages offer for numbers of a kind, and what makes numbers in it those in SI.
struct OfferedUnit {
  std::string_view name;
  UnitScale to_si;
};
/// Units offered for numbers in `unit`, an SI unit; none with another zero.
std::vector<OfferedUnit> offered_units(std::string_view unit);

} // namespace microslip::io
