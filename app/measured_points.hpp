#pragma once

#include "campaign/sweep_points.hpp"
#include "io/case_file.hpp"
#include "io/json.hpp"
#include "io/result_writer.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace microslip::app {

/// What to do where measured points are given for a wheel on a rail: `--points is for` this.
inline constexpr const char* instead_of_wheel =
    "cases of two bodies: in a wheel on a rail the creepage differs from patch to patch. Give such a case the radii, "
    "or "
    "an [ellipse] of a patch's area, and its load; or take `sweep --points` over wheel.pitch_velocity or wheel.yaw";

/// Distance of computed from measured coefficients, of all points of curves.
struct Deviations {
  std::size_t points = 0;
  double rms = 0, bias = 0; ///< [-]
};
Deviations deviations_of(const std::vector<campaign::ComparedCurve>& curves);

/// Writes measured points with the coefficients computed at them as points/creepage, points/coefficient, points/fitted,
/// points/rolling_speed, points/normal_force, points/run, and the names of the runs.
void write_points(io::ResultWriter& file, const io::MeasuredCurves& curves, const std::vector<double>& computed);

/// A case beside the measured points of a CSV: a curve for each run, speed and load.
std::vector<campaign::ComparedCurve> compare_with_points(const io::RollingCase& input,
                                                         const std::filesystem::path& points);
/// The curves of a result of a case of two bodies, or of a sweep, that have points of a CSV. Throws Error for others.
std::vector<campaign::ComparedCurve> compare_result(const std::string& result, const std::filesystem::path& points);
/// Those of several results; names begin with the results' titles, or where these are the same with their files.
std::vector<campaign::ComparedCurve> compare_results(const std::vector<std::string>& results,
                                                     const std::filesystem::path& points);

/// Writes measured_points.h5 with curves and their points to a folder; returns its path.
std::filesystem::path write_comparison(const std::vector<campaign::ComparedCurve>& curves, io::Provenance of,
                                       const std::filesystem::path& folder);

/// `points`, `rms` and `bias` as members of a JSON object.
io::Json comparison_document(const Deviations& deviations);
/// `72 measured points: rms 0.01234, bias -0.00123`.
std::string comparison_text(const Deviations& deviations);
/// The same of curves: a list of objects with a `name`, and a line each.
io::Json comparison_document(const std::vector<campaign::ComparedCurve>& curves);
std::string comparison_text(const std::vector<campaign::ComparedCurve>& curves);

} // namespace microslip::app
