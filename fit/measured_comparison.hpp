#pragma once

#include "io/case_file.hpp"
#include "io/measured_curve.hpp"

#include <vector>

namespace microslip::fit {

/// Measured creep curves beside those of a case.
struct MeasuredComparison {
  io::MeasuredCurves curves;
  std::vector<double> coefficients; ///< of the case at the points
  double rms = 0;                   ///< of the coefficients less the measured ones [-]
  double bias = 0;                  ///< their mean [-]
};

/// Solves the case at the measured creepages, speeds and loads. Throws Error for a case without creep curves or one
/// that is not solved there.
MeasuredComparison compare_with_measured(const io::RollingCase& input, io::MeasuredCurves curves);

} // namespace microslip::fit
