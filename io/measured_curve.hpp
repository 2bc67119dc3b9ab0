#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Measured point of a creep curve, in SI units. The signs are left out, since longitudinal and lateral curves are odd.
struct MeasuredPoint {
  double creepage = 0;     ///< magnitude [-], > 0
  double coefficient = 0;  ///< adhesion coefficient, force over normal force [-], positive where it resists the slip
  double speed = 0;        ///< rolling speed [m/s], > 0
  double normal_force = 0; ///< [N], > 0
  double sigma = 1;        ///< standard deviation of the coefficient [-]; 1 where the table has none
  std::size_t run = 0;     ///< index of its run
};

/// Measured creep curves of one table.
struct MeasuredCurves {
  std::vector<MeasuredPoint> points = {};
  std::vector<std::string> runs =
      {};                  ///< names of the runs, in the order of the table; one without a name if it has none
  bool is_lateral = false; ///< whether the creepage is lateral, else longitudinal
  bool has_sigma = false;
};

/// What holds for points of a table that has no column of it.
struct MeasuringConditions {
  double speed = 0;        ///< [m/s]
  double normal_force = 0; ///< [N]
};

/// Reads measured creep curves from CSV. The first line that does not begin with # names the columns, in any order:
/// creepage_longitudinal or creepage_lateral [-], adhesion_coefficient [-] or force [N], and if wanted rolling_speed
/// [m/s], normal_force [N], run (a text) and sigma (in the unit of the force or [-]), the standard deviation of what is
/// measured. Behind a name there may be another unit, `creepage_longitudinal [%]`. Other columns are left out.
/// Separators, decimal commas, blanks and byte-order marks are those of tables of contacts. The forces resist the slip
/// or drive it, by the sign that most of them have. Throws Error with file, line, column and range.
MeasuredCurves read_measured_curves(std::string_view text, const std::string& name,
                                    const MeasuringConditions& conditions);

} // namespace microslip::io
