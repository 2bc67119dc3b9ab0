#include "microslip/contact/conclude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_finite(const ContactForces& f) {
  return std::isfinite(f.fx) && std::isfinite(f.fy) && std::isfinite(f.mz) && std::isfinite(f.adhesion_area) &&
         std::isfinite(f.slip_area);
}

} // namespace

void conclude(ContactForces& result) noexcept {
  if (result.status == Status::invalid_input || !is_finite(result))
    result = {nan, nan, nan, nan, nan, Status::invalid_input};
}

void conclude(ContactDerivatives& result) noexcept {
  double* const first = &result.jacobian[0][0];
  if (!std::all_of(first, first + 12, [](double d) { return std::isfinite(d); }))
    result.forces.status = Status::invalid_input;
  conclude(result.forces);
  if (result.forces.status == Status::invalid_input) std::fill_n(first, 12, nan);
}

} // namespace microslip
