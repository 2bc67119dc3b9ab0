#include "microslip/exact/halfspace/element_response.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

namespace microslip {

InfluenceTable::InfluenceTable(int mx, int my, double dx, double dy, Kind kind)
    : mx_(require_count("mx", mx, 1, most_cells)), my_(require_count("my", my, 1, most_cells)),
      first_(kind.symmetric ? 0 : 1 - mx), dx_(dx), dy_(dy), strips_(kind.strips), shape_(kind.shape),
      values_(static_cast<std::size_t>(mx - first_) * (2 * static_cast<std::size_t>(my) - 1)) {
  require_positive("dx", dx, "m");
  require_positive("dy", dy, "m");
}

FullInfluence InfluenceTable::find(int i, int j) const {
  if (std::abs(i) >= mx_ || std::abs(j) >= my_) return {};
  if (i >= first_) return values_[index(i, j)];
  FullInfluence a = values_[index(-i, j)];
  a.xy = -a.xy, a.xz = -a.xz, a.yx = -a.yx, a.zx = -a.zx;
  return a;
}

namespace {

void check(const RowInclination& inclination, const ElementGrid& grid) {
  if (inclination.is_flat()) return;
  if (grid.line) throw Error("inclination: not of a line contact");
  if (inclination.angle.size() != static_cast<std::size_t>(grid.my))
    throw Error("inclination: must have an angle for each of the " + std::to_string(grid.my) + " rows");
  for (const double angle : inclination.angle) require_finite("inclination", angle, "rad");
  const double share = inclination.traction_share;
  if (!(share >= 0 && share <= 1)) throw Error("traction_share", share, "-", "in [0, 1]");
  if (inclination.plane_along_x && share != 1) throw Error("traction_share", share, "-", "1 with plane_along_x");
}

} // namespace

void check(const ElementResponse& response, const ElementGrid& grid) {
  constexpr double rounding = 1e-8; // [m]: files have few digits
  if (response.table) {
    const auto check_size = [&](const char* name, double size, double of_grid) {
      if (!(std::abs(size - of_grid) <= rounding))
        throw Error(std::string(name) + " of the influence coefficients", size, "m",
                    "that of the grid's elements, " + std::to_string(of_grid * 1e3) + " mm");
    };
    check_size("dx", response.table->dx(), grid.dx);
    check_size("dy", response.table->dy(), grid.dy);
    if (response.table->is_of_strips() && !grid.line)
      throw Error("influence coefficients of strips: need a line contact");
    if (grid.line && !response.table->is_of_strips()) throw Error("influence coefficients: need no line contact");
    if (grid.shape != response.table->shape())
      throw Error(std::string("influence coefficients: are of ") +
                  (grid.shape == ElementShape::constant ? "bilinear" : "constant") + " elements, the grid's are not");
  }
  check(response.inclination, grid);
  if (response.table && !response.inclination.is_flat())
    throw Error("inclination: not with a table of influence coefficients");
  const auto& [count, patch_of_row, factors] = response.patches;
  if (require_count("patches", count, 1, most_cells) == 1) return;
  if (patch_of_row.size() != static_cast<std::size_t>(grid.my))
    throw Error("patch_of_row: must have a patch for each of the " + std::to_string(grid.my) + " rows");
  for (const int patch : patch_of_row) require_count("patch_of_row", patch, 0, count - 1);
  if (factors.size() != static_cast<std::size_t>(count) * static_cast<std::size_t>(count))
    throw Error("factors: must have one for each pair of patches");
  for (const double factor : factors) require_finite("factors", factor, "-");
}

} // namespace microslip
