#include "microslip/contact/elliptic_contact.hpp"

#include "microslip/error.hpp"

#include <cmath>

namespace microslip {
namespace {

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}

} // namespace

bool is_valid(const EllipticContact& c) noexcept {
  return is_positive(c.a) && is_positive(c.b) && is_positive(c.shear_modulus) && is_positive(c.normal_force) &&
         is_positive(c.rolling_speed) && c.poisson_ratio >= 0 && c.poisson_ratio <= 0.5 &&
         std::isfinite(c.creepage.longitudinal) && std::isfinite(c.creepage.lateral) &&
         std::isfinite(c.creepage.spin) && std::abs(c.dissimilarity) <= largest_dissimilarity;
}

void check(const EllipticContact& c) {
  require_positive("a", c.a, "m");
  require_positive("b", c.b, "m");
  require_positive("shear_modulus", c.shear_modulus, "Pa");
  require_between("poisson_ratio", c.poisson_ratio, "-", 0, 0.5);
  require_positive("normal_force", c.normal_force, "N");
  require_positive("rolling_speed", c.rolling_speed, "m/s");
  require_finite("creepage.longitudinal", c.creepage.longitudinal, "-");
  require_finite("creepage.lateral", c.creepage.lateral, "-");
  require_finite("creepage.spin", c.creepage.spin, "1/m");
  require_between("dissimilarity", c.dissimilarity, "-", -largest_dissimilarity, largest_dissimilarity);
}

bool is_valid_simplified(const EllipticContact& c) noexcept {
  return is_valid(c) && c.dissimilarity == 0;
}

void check_simplified(const EllipticContact& c) {
  check(c);
  if (c.dissimilarity != 0) throw Error("dissimilarity", c.dissimilarity, "-", "0 in the simplified theory");
}

} // namespace microslip
