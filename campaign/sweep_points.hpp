#pragma once

#include "io/measured_curve.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::campaign {

/// A computed creep curve, and measured points beside it.
struct ComparedCurve {
  std::string name = {};                ///< "solution.theory = exact, motion.spin = 0.3"; empty if nothing else varies
  double speed = 0, normal_force = 0;   ///< rolling speed [m/s] and load [N] where the creepage is least
  std::vector<double> creepage = {};    ///< magnitudes [-], ascending
  std::vector<double> coefficient = {}; ///< [-], positive where the force resists the slip
  io::MeasuredCurves measured = {};     ///< the points at this speed and load, both to 5 %
  std::vector<double> computed = {};    ///< coefficients at the points
  double rms = 0;                       ///< of the computed less the measured coefficients [-]
  double bias = 0;                      ///< their mean [-]

  /// Finds rms and bias.
  void find_deviations();
};

/// The curves of a sweep's result file over the creepage, for each combination of what else varies, that have measured
/// points, of a CSV as read_measured_curves: points and curves of a longitudinal or a lateral creepage. Of two bodies
/// that creepage must vary; of a wheel on a rail the key that makes it, such as wheel.pitch_velocity or wheel.yaw:
/// creepage and coefficient are then those of the patches, the creepages' mean weighted with the loads, and the sum of
/// forces over that of loads. Of creepages of both signs those that more cases have count. Throws Error for other
/// sweeps, for quantities that the file has not, and for points at other speeds or loads, or at creepages beyond the
/// cases. Cost: some 10 us for each case.
std::vector<ComparedCurve> compare_sweep(const std::filesystem::path& result_file, const std::filesystem::path& points);

} // namespace microslip::campaign
