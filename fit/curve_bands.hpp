#pragma once

#include "fit/curve_fit.hpp"

#include <string>
#include <vector>

namespace microslip::fit {

/// A number that follows from the fit, with its 95 % interval.
struct DerivedQuantity {
  double value = 0, lower = 0, upper = 0;
};

/// A fitted curve of one run, speed and load, with its bands, at creepages evenly over their logarithm.
struct CurveBand {
  io::MeasuredPoint conditions;
  std::vector<double> creepage = {}, coefficient = {};
  std::vector<double> half_width = {}; ///< of the 95 % band of the curve at each creepage by itself
  std::vector<double> scatter = {};    ///< local standard deviation of the points
  std::vector<double> least_point = {}, largest_point = {}; ///< 95 % band of further points
  double simultaneous = 0; ///< half widths of the band that holds the whole curve, over `half_width`
  DerivedQuantity peak = {}, creepage_at_peak = {}, last = {}; ///< last: at the largest creepage
  DerivedQuantity slope = {};                                  ///< at the least creepage
};

/// The bands of a solved fit. The curve's is its derivatives with the sandwich covariance, that of the whole curve and
/// of derived quantities from 1000 wild resamples: deviations over 1 - leverage with signs at random, by the
/// derivatives. That of further points adds the local scatter, a kernel of 0.3 in the logarithm of the creepage, times
/// the factor that holds 95 % of the points themselves.
std::vector<CurveBand> curve_bands(const CurveFit& fit, const io::MeasuredCurves& curves, int elements);

} // namespace microslip::fit
