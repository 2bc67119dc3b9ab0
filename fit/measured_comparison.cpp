#include "fit/measured_comparison.hpp"

#include "fit/curve_evaluator.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace microslip::fit {

MeasuredComparison compare_with_measured(const io::RollingCase& input, io::MeasuredCurves curves) {
  MeasuredComparison found{.curves = std::move(curves), .coefficients = {}};
  const std::size_t count = found.curves.points.size();
  found.coefficients.resize(count);
  CreepCurveSolver solver(found.curves, input.method.theory == Theory::exact, std::numeric_limits<int>::max());
  if (!solver.solve(input, found.coefficients)) throw Error("the case is not solved at the measured creepages");
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double deviation = found.coefficients[i] - found.curves.points[i].coefficient;
    sum += deviation, squares += deviation * deviation;
  }
  found.bias = sum / static_cast<double>(count);
  found.rms = std::sqrt(squares / static_cast<double>(count));
  return found;
}

} // namespace microslip::fit
