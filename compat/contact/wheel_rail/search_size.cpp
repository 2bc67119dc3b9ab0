#include "compat/contact/wheel_rail/search_size.hpp"

#include "compat/contact/units.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/words.hpp"
#include "microslip/error.hpp"

namespace microslip::contact_program {

void require_few_points(double on_line, const PatchRules& sizes) {
  if (on_line <= SearchThresholds::most_on_line) return;
  throw Error("DS = " + short_number(sizes.ds / mm) + " mm: the contact is searched at " + short_number(on_line) +
              " points across the rail, must be at most " + short_number(SearchThresholds::most_on_line));
}

void require_few_points(double along, double across, const PatchRules& sizes, double radius) {
  if (along * across <= SearchThresholds::most_on_grid) return;
  throw Error("DX = " + short_number(sizes.dx / mm) + ", DS = " + short_number(sizes.ds / mm) +
              ", NOMRADW = " + short_number(radius / mm) + " mm: the contact is searched by brute force at " +
              short_number(along) + " x " + short_number(across) + " points, must be at most " +
              short_number(SearchThresholds::most_on_grid));
}

void require_rows(double rows, double widest, const PatchRules& sizes) {
  constexpr int least = SearchThresholds::least_rows;
  if (rows >= least) return;
  throw Error("DS = " + short_number(sizes.ds / mm) + " mm: the contact is searched by brute force at " +
              short_number(rows) + " rows across the rail, must be at least " + short_number(least) +
              ": DS must be at most " + short_number(widest / (least - 1) / mm) + " mm");
}

} // namespace microslip::contact_program
