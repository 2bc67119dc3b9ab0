#include "validation/measurements_fits.hpp"
#include "validation/measurements_sampling.hpp"
#include "validation/measurements_smoothing.hpp"
#include "validation/report.hpp"
#include "validation/studies.hpp"

namespace microslip::validation {

bool run_measurements(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  return report_creep_curve_fits(report, options) && report_sampling(report, options) &&
         report_measured_profiles(report, options) && report.all_as_stated();
}

} // namespace microslip::validation
