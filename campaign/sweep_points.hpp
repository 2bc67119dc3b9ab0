#pragma once

#include "io/measured_curve.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::campaign {

/// The adhesion coefficient of a sweep over the creepage, for one combination of what else varies, and measured points
/// beside it.
struct SweepCurve {
  std::string name = {};                ///< "solution.theory = exact, motion.spin = 0.3"; empty if nothing else varies
  double speed = 0, normal_force = 0;   ///< rolling speed [m/s] and load [N] of the case of least creepage
  std::vector<double> creepage = {};    ///< magnitudes [-] of the cases, ascending
  std::vector<double> coefficient = {}; ///< [-], positive where the force resists the slip
  std::vector<io::MeasuredPoint> points = {}; ///< measured at this speed and load, both to 5 %
  std::vector<double> computed = {};          ///< coefficients at the points, linear between the cases
  double rms = 0;                             ///< of the computed less the measured coefficients [-]
  double bias = 0;                            ///< their mean [-]
};

/// The curves of a sweep's result file that have measured points, of a CSV as read_measured_curves: points and curves
/// of a longitudinal or a lateral creepage. Of two bodies that creepage must vary; of a wheel on a rail the key that
/// makes it, such as wheel.pitch_velocity or wheel.yaw: creepage and coefficient are then those of the patches, the
/// creepages' mean weighted with the loads, and the sum of forces over that of loads. Of creepages of both signs those
/// that more cases have count. Throws Error for other sweeps, for quantities that the file has not, and for points at
/// other speeds or loads, or at creepages beyond the cases. Cost: some 10 us for each case.
std::vector<SweepCurve> compare_sweep(const std::filesystem::path& result_file, const std::filesystem::path& points);

} // namespace microslip::campaign
