#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "validation/models/pressed_wheel.hpp"
#include "validation/models/tangential_models.hpp"

#include <cmath>

namespace microslip::validation {

/// Numbers of a wheel that is pressed on its rail; NaN where they are not known.
struct PressedNumbers {
  double area = NAN;     ///< of all patches [m^2]
  double peak = NAN;     ///< the highest pressure [Pa]
  double width = NAN;    ///< of all rows that bear loads [m]
  double length = NAN;   ///< of the longest row [m]
  double lowering = NAN; ///< of the wheel below its first touch [m]
};

/// Numbers of a wheel that rolls; NaN where they are not known.
struct RollingNumbers {
  double fx = NAN, fy = NAN; ///< horizontal force on the wheel, in track axes [N]
  double power = NAN;        ///< T-gamma of all patches [N]
};

/// Of the library's solution; without fields it has no width nor length. `touching` is the height of the wheelset's
/// centre at its first touch [m].
PressedNumbers pressed_numbers(const WheelRailSolution& solution, double touching);
PressedNumbers pressed_numbers(const PressedWheel& wheel);

RollingNumbers rolling_numbers(const WheelRailSolution& solution);
RollingNumbers rolling_numbers(const PressedWheel& wheel);
/// With the tangential forces of the exact theory on the model's patches, pressures and creepages, at the height that
/// there is; without T-gamma.
RollingNumbers rolling_exactly(PressedWheel wheel, const CombinedMaterial& material, double friction);
/// With the tangential forces of a law of ellipses on the patches of a solution with fields: each with its load and the
/// creepages of its frame, and the ellipse of its area whose axes are as its length to its width.
RollingNumbers rolling_by_law(const WheelRailSolution& solution, const CombinedMaterial& material,
                              const TangentialModel& law);

/// What T-gamma is measured by: the sum over patches of mu Fn (|xi| + |eta| + c |phi|), c the root of area/pi [N].
double creepage_power(const WheelRailSolution& solution);

} // namespace microslip::validation
