#include "microslip/simplified/fastsim2_start.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "microslip/vec2.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// Traction over bound at cell k of the simplified theory's fields.
Vec2 direction_at(const SurfaceFields& f, std::size_t k) {
  return f.bound[k] > 0 ? Vec2{f.traction.x[k] / f.bound[k], f.traction.y[k] / f.bound[k]} : Vec2{};
}

/// Between the two cells of row j next to x; towards the edges that of the outermost cell.
Vec2 interpolate(const ContactSolution& simplified, int j, double x) {
  const Elements& e = simplified.elements;
  const SurfaceFields& f = simplified.fields;
  const std::size_t first = e.index(0, j);
  const int mx = e.mx();
  if (mx == 1) return direction_at(f, first);
  const double position = (x - e.x[first]) / (e.x[first + 1] - e.x[first]);
  const double inside = std::clamp(position, 0.0, double(mx - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(inside), static_cast<std::size_t>(mx - 2));
  const double t = inside - double(i);
  const Vec2 a = direction_at(f, first + i), b = direction_at(f, first + i + 1);
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

} // namespace

VectorField start_from_fastsim2(const EllipticContact& contact, const ElementGrid& grid, std::span<const double> bound,
                                RollingDirection direction) {
  SimplifiedOptions options;
  options.mx = std::clamp(static_cast<int>(std::lround(2 * contact.a / grid.dx)), 1, most_cells);
  options.my = std::clamp(static_cast<int>(std::lround(2 * contact.b / grid.dy)), 1, most_cells);
  options.bound = TractionBound::elliptic;
  options.flexibility = FlexibilityModel::blended;
  options.direction = direction;
  EllipticContact similar = contact;
  similar.dissimilarity = 0;
  const ContactSolution simplified = Fastsim2(options).fields(similar);
  const int rows = simplified.elements.my();

  VectorField start(grid.count());
  if (rows == 0) return start;
  for (int j = 0; j < grid.my; ++j) {
    const double row = (grid.y(j) / contact.b + 1) / 2 * rows - 0.5; // rows are cut as the elements are
    const int nearest = std::clamp(static_cast<int>(std::lround(row)), 0, rows - 1);
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      const Vec2 p = interpolate(simplified, nearest, grid.x(i));
      start.x[k] = bound[k] * p.x;
      start.y[k] = bound[k] * p.y;
    }
  }
  return start;
}

} // namespace microslip
