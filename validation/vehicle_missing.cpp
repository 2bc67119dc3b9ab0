// In place of vehicle.cpp and vehicle_speeds.cpp where Simbody is not there.

#include "microslip/error.hpp"
#include "validation/report.hpp"
#include "validation/studies.hpp"
#include "validation/vehicle_speeds.hpp"

namespace microslip::validation {

bool run_vehicle(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      "  not run: microslip was built without Simbody; with the package libsimbody-dev the build has the vehicle");
  return report.all_as_stated();
}

std::vector<VehicleSpeed> vehicle_speeds() {
  throw Error("bench vehicle: microslip was built without Simbody; with the package libsimbody-dev the build has it");
}

} // namespace microslip::validation
