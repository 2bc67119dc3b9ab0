#pragma once

#include "campaign/sweep_points.hpp"
#include "fit/measured_comparison.hpp"
#include "io/json.hpp"
#include "io/result_writer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::app {

/// What to do where measured points are given for a wheel on a rail: `--points is for` this.
inline constexpr const char* instead_of_wheel =
    "cases of two bodies: in a wheel on a rail the creepage differs from patch to patch. Give such a case the radii, "
    "or "
    "an [ellipse] of a patch's area, and its load; or take `sweep --points` over wheel.pitch_velocity or wheel.yaw";

/// Writes measured points with the coefficients computed at them as points/creepage, points/coefficient, points/fitted,
/// points/rolling_speed, points/normal_force, points/run, and the names of the runs.
void write_points(io::ResultWriter& file, const io::MeasuredCurves& curves, const std::vector<double>& computed);

/// Compares a case with the measured points of a CSV.
fit::MeasuredComparison compare_with_points(const io::RollingCase& input, const std::filesystem::path& points);

/// Writes the comparison to measured_points.h5 in a folder and draws it; returns the names of the files.
std::vector<std::string> write_comparison(const fit::MeasuredComparison& comparison, const io::Provenance& of,
                                          const std::filesystem::path& folder, bool with_picture);

/// The same of the curves of a sweep.
std::vector<std::string> write_comparison(const std::vector<campaign::SweepCurve>& curves, const io::Provenance& of,
                                          const std::filesystem::path& folder);

/// `points`, `rms` and `bias` as members of a JSON object.
io::Json comparison_document(const fit::MeasuredComparison& comparison);
/// `72 measured points: rms 0.01234, bias -0.00123`.
std::string comparison_text(const fit::MeasuredComparison& comparison);
/// The same of the curves of a sweep: a list of objects with a `name`, and a line each.
io::Json comparison_document(const std::vector<campaign::SweepCurve>& curves);
std::string comparison_text(const std::vector<campaign::SweepCurve>& curves);

} // namespace microslip::app
