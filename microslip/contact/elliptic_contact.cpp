#include "microslip/contact/elliptic_contact.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <cmath>

namespace microslip {
namespace {

/// The ranges of all numbers, told to `range`, which has a function for each kind of range.
template <class Range> void check_ranges(const EllipticContact& c, Range&& range) {
  range.positive("a", c.a, "m");
  range.positive("b", c.b, "m");
  range.positive("shear_modulus", c.shear_modulus, "Pa");
  range.between("poisson_ratio", c.poisson_ratio, "-", 0, 0.5);
  range.positive("normal_force", c.normal_force, "N");
  range.positive("rolling_speed", c.rolling_speed, "m/s");
  range.finite("creepage.longitudinal", c.creepage.longitudinal, "-");
  range.finite("creepage.lateral", c.creepage.lateral, "-");
  range.finite("creepage.spin", c.creepage.spin, "1/m");
  range.between("dissimilarity", c.dissimilarity, "-", -largest_dissimilarity, largest_dissimilarity);
}

/// Checks the sizes in addition, to which the simplified theory is limited.
template <class Range> void check_sizes(const EllipticContact& c, Range&& range) {
  range.between("a", c.a, "m", smallest_size, largest_size);
  range.between("b", c.b, "m", smallest_size, largest_size);
  range.between("shear_modulus", c.shear_modulus, "Pa", smallest_size, largest_size);
  range.between("normal_force", c.normal_force, "N", smallest_size, largest_size);
  range.between("rolling_speed", c.rolling_speed, "m/s", smallest_size, largest_size);
  range.between("creepage.longitudinal", c.creepage.longitudinal, "-", -largest_size, largest_size);
  range.between("creepage.lateral", c.creepage.lateral, "-", -largest_size, largest_size);
  range.between("creepage.spin", c.creepage.spin, "1/m", -largest_size, largest_size);
}

/// Throws at the first number out of range.
struct Refusal {
  void finite(const char* field, double value, const char* unit) { require_finite(field, value, unit); }
  void positive(const char* field, double value, const char* unit) { require_positive(field, value, unit); }
  void between(const char* field, double value, const char* unit, double low, double high) {
    require_between(field, value, unit, low, high);
  }
};

bool depends_on_more(const FrictionLaw& law) {
  return law.depends_on_pressure() || law.depends_on_temperature();
}

/// Only tells whether all are in range, at the cost of the comparisons: for calls that must not throw.
struct Verdict {
  bool valid = true;

  void finite(const char*, double value, const char*) { valid &= std::isfinite(value); }
  void positive(const char*, double value, const char*) { valid &= value > 0 && std::isfinite(value); }
  void between(const char*, double value, const char*, double low, double high) {
    valid &= value >= low && value <= high;
  }
};

} // namespace

bool is_valid(const EllipticContact& contact) noexcept {
  Verdict verdict;
  check_ranges(contact, verdict);
  return verdict.valid;
}

void check(const EllipticContact& contact) {
  check_ranges(contact, Refusal());
}

bool is_valid_simplified(const EllipticContact& c) noexcept {
  Verdict verdict;
  check_ranges(c, verdict);
  check_sizes(c, verdict);
  return verdict.valid && c.dissimilarity == 0 && !depends_on_more(c.friction);
}

void check_simplified(const EllipticContact& c) {
  check(c);
  check_sizes(c, Refusal());
  if (c.dissimilarity != 0) throw Error("dissimilarity", c.dissimilarity, "-", "0 in the simplified theory");
  if (depends_on_more(c.friction))
    throw Error("friction: must depend on the slip velocity alone in the simplified theory");
}

} // namespace microslip
