#pragma once

#include "fit/curve_fit.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::fit {

/// Further points that would make a parameter better known.
struct FurtherMeasurement {
  std::size_t parameter = 0; ///< index among those of the fit
  std::size_t points = 0;    ///< how many, evenly over the logarithm of the creepage
  double least_creepage = 0, largest_creepage = 0;
  double speed = 0; ///< [m/s]
  double width = 1; ///< of the parameter's interval with these points, over that without them
};

/// Points that would narrow down a parameter the most, with the parameters `counted` free, by their indices, those too
/// that are held because the data do not identify them: a fifth of the number of points more, at least 10, below the
/// smallest creepage (to a tenth of it), beyond the largest (to twice that), or over the same creepages at half or
/// twice the speed. By the derivatives and the present scatter. None if no interval would be at most 0.7 of what it is.
std::optional<FurtherMeasurement> further_measurement(const CurveFitter& fitter, const CurveFit& fit,
                                                      const std::vector<std::size_t>& counted,
                                                      const io::MeasuredCurves& curves, int elements);

/// Creepage at which two fits differ most.
struct LargestDifference {
  double creepage = 0, first = 0, second = 0;
};
/// Between a tenth of the smallest and twice the largest creepage of the first run, at its conditions.
LargestDifference largest_difference(const CurveFit& first, const CurveFit& second, const io::MeasuredCurves& curves,
                                     int elements);

} // namespace microslip::fit
