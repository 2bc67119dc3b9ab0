#include "microslip/contact/force_response.hpp"

#include "microslip/error.hpp"

namespace microslip {
namespace {

/// Changes the signs of Mz and of spin, and those of a force and the creepage of its direction.
ForceResponse with_signs(ForceResponse response, int direction) {
  for (const int changed : {direction, 2}) {
    for (std::complex<double>& value : response.by_creepage[changed]) value = -value;
    for (auto& row : response.by_creepage) row[changed] = -row[changed];
    response.by_load[changed] = -response.by_load[changed];
    response.by_roughness[changed] = -response.by_roughness[changed];
    response.work_by_creepage[changed] = -response.work_by_creepage[changed];
  }
  return response;
}

} // namespace

ForceResponse mirrored_along(ForceResponse response) {
  return with_signs(response, 0);
}

ForceResponse mirrored_across(ForceResponse response) {
  return with_signs(response, 1);
}

void require_wavenumbers(std::span<const double> wavenumbers) {
  constexpr double largest = 1e9; // [1/m]
  for (const double wavenumber : wavenumbers) require_between("wavenumber", wavenumber, "1/m", 0, largest);
}

} // namespace microslip
