#include "microslip/simplified/kernel/patch_march.hpp"

#include "microslip/contact/conclude.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/kernel/field_recorder.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace microslip::detail {
namespace {

std::string indexed(const char* name, std::size_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

void check(const PatchRows& patch, const PatchMotion& motion, double travel) {
  require_count("mx", patch.mx, 1, most_cells);
  require_positive("row_width", patch.row_width, "m");
  const std::size_t rows = patch.y.size();
  if (patch.leading.size() != rows || patch.trailing.size() != rows)
    throw Error("leading, trailing: must have as many rows as y, " + std::to_string(rows));
  if (patch.pressure.size() != rows * static_cast<std::size_t>(patch.mx))
    throw Error("pressure: must have mx times rows = " + std::to_string(rows * patch.mx) + " values");
  for (std::size_t j = 0; j < rows; ++j) {
    require_finite(indexed("y", j), patch.y[j], "m");
    require_finite(indexed("leading", j), patch.leading[j], "m");
    require_finite(indexed("trailing", j), patch.trailing[j], "m");
    if (!((patch.trailing[j] - patch.leading[j]) * travel > 0))
      throw Error(indexed("leading", j), patch.leading[j], "m", "ahead of trailing in the rolling direction");
  }
  for (std::size_t k = 0; k < patch.pressure.size(); ++k)
    if (!(patch.pressure[k] >= 0) || !std::isfinite(patch.pressure[k]))
      throw Error(indexed("pressure", k), patch.pressure[k], "Pa", "finite and not negative");
  require_positive("flexibilities.longitudinal", motion.flexibilities.longitudinal, "m/Pa");
  require_positive("flexibilities.lateral", motion.flexibilities.lateral, "m/Pa");
  require_positive("flexibilities.spin", motion.flexibilities.spin, "m/Pa");
  require_finite("creepage.longitudinal", motion.creepage.longitudinal, "-");
  require_finite("creepage.lateral", motion.creepage.lateral, "-");
  require_finite("creepage.spin", motion.creepage.spin, "1/m");
  require_positive("rolling_speed", motion.rolling_speed, "m/s");
}

/// Pressure along a row between the cell centres, where only theirs is known: parabolas, with zero pressure at both
/// edges. All of it is exact for a parabolic pressure.
class RowPressure {
public:
  /// p_n at the centres, from the leading edge on.
  explicit RowPressure(std::vector<double> centres) : p_(std::move(centres)), n_(static_cast<int>(p_.size())) {}

  /// Position of the edge, i = 0, and of the centre of cell i.
  double centre(int i) const { return i == 0 ? 0 : p_[i - 1]; }
  /// Position half-way between the points i and i + 1.
  double middle(int i) const {
    if (n_ == 1) return 0.75 * p_[0];
    double value = 0;
    if (i == 0)
      value = 0.625 * p_[0] - p_[1] / 24;
    else if (i == 1)
      value = p_[0] + p_[1] / 3;
    else if (i == n_ - 1)
      value = p_[n_ - 1] + p_[n_ - 2] / 3;
    else
      value = (9 * (p_[i - 1] + p_[i]) - p_[i - 2] - p_[i + 1]) / 16;
    return std::max(value, 0.0);
  }
  /// Per cell at the leading edge.
  double slope() const { return n_ == 1 ? 4 * p_[0] : std::max(3 * p_[0] - p_[1] / 3, 0.0); }

private:
  std::vector<double> p_;
  int n_;
};

std::vector<double> from_leading_edge(const PatchRows& patch, int j, double travel) {
  const auto row = patch.pressure.subspan(static_cast<std::size_t>(j) * patch.mx, patch.mx);
  std::vector<double> centres(row.begin(), row.end());
  if (direction_of(travel) == RollingDirection::forward) std::reverse(centres.begin(), centres.end());
  return centres;
}

/// The regular grid over all rows, as if they were evenly spaced.
ElementGrid covering_grid(const PatchRows& patch) {
  if (patch.y.empty()) return {.mx = patch.mx};
  const auto [low, high] = std::minmax_element(patch.trailing.begin(), patch.trailing.end());
  const auto [other_low, other_high] = std::minmax_element(patch.leading.begin(), patch.leading.end());
  const double left = std::min(*low, *other_low), right = std::max(*high, *other_high), dx = (right - left) / patch.mx;
  return {patch.mx, static_cast<int>(patch.y.size()), left + dx / 2, patch.y[0], dx, patch.row_width};
}

} // namespace

ContactSolution march_patch(const MarchingKernels& kernels, double travel, const PatchRows& patch,
                            const PatchMotion& motion) {
  check(patch, motion, travel);
  const int mx = patch.mx, my = static_cast<int>(patch.y.size()), width = kernels.width;
  const Drive<double> drive = {motion.creepage.longitudinal, motion.creepage.lateral, motion.creepage.spin, 0};
  const EffectiveSlip w = {drive.xi / motion.flexibilities.longitudinal, drive.eta / motion.flexibilities.lateral,
                           drive.phi / motion.flexibilities.spin};
  const auto row = [&](int j) {
    return RowGeometry{patch.y[j], patch.leading[j], std::abs(patch.leading[j] - patch.trailing[j]) / mx};
  };

  ContactSolution out;
  out.elements = Elements(covering_grid(patch));
  out.fields = SurfaceFields(out.elements.size());
  out.creepage = motion.creepage;
  RowArrays rows(my, mx);
  FieldRecorder recorder(mx, width);
  RowSums totals;
  double area = 0, slip_area = 0;
  for (int first = 0; first < my; first += width) {
    for (int lane = 0; lane < width; ++lane) {
      const int j = std::min(first + lane, my - 1); // lanes beyond the last row repeat it
      const RowGeometry at = row(j);
      put_row(rows, first + lane, 0, w, at, travel);
      const RowPressure pressure(from_leading_edge(patch, j, travel));
      const auto friction = [&](double position) {
        const double x = at.leading + travel * position * at.cell;
        return friction_coefficient(motion.friction, drive, motion.rolling_speed, x, at.y);
      };
      rows.table_slope[lane] = friction(0) * pressure.slope();
      for (int i = 0; i <= mx; ++i)
        rows.table_centre[i * width + lane] = friction(i == 0 ? 0 : i - 0.5) * pressure.centre(i);
      for (int i = 0; i < mx; ++i)
        rows.table_middle[i * width + lane] = friction(i == 0 ? 0.25 : i) * pressure.middle(i);
    }
    MarchingRows view = rows.view(first, width, mx);
    recorder.attach(view);
    kernels.fields_with_table(view);
    for (int j = first; j < std::min(first + width, my); ++j) {
      const RowGeometry at = row(j);
      recorder.copy_row(out, j, j - first, at, travel, motion.flexibilities);
      recorder.copy_bound(out, j, j - first, travel, rows.table_centre);
      std::fill_n(&out.elements.area[out.elements.index(0, j)], mx, at.cell * patch.row_width);
      totals.add_row(rows, j, 0, at, travel);
      area += mx * at.cell * patch.row_width;
      slip_area += rows.slip_cells[j] * at.cell * patch.row_width;
    }
  }
  const double dy = patch.row_width;
  set_totals(out, forces_of({totals.fx * dy, totals.fy * dy, totals.mz * dy}, slip_area, area), motion.rolling_speed);
  out.totals.frictional_power = motion.rolling_speed * work_on_rigid_slip(out, motion.flexibilities);
  conclude(out, 0); // nothing is iterated
  return out;
}

} // namespace microslip::detail
