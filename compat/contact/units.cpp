#include "compat/contact/units.hpp"

#include <cmath>
#include <limits>

namespace microslip::contact_program {

double in_file(double value, double unit) {
  const double near = value / unit, infinity = std::numeric_limits<double>::infinity();
  for (const double one : {near, std::nextafter(near, -infinity), std::nextafter(near, infinity)})
    if (one * unit == value) return one;
  return near;
}

std::vector<double> in_file(std::vector<double> values, const UnitList& units) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = in_file(values[k], units[k].value());
  return values;
}

} // namespace microslip::contact_program
