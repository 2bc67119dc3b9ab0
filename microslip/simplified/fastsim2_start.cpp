#include "microslip/simplified/fastsim2_start.hpp"

#include "microslip/simplified/fastsim2.hpp"
#include "microslip/vec2.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// Traction over bound at cell k of the simplified theory's fields.
Vec2 direction_at(const ContactFields& f, std::size_t k) {
  return f.bound[k] > 0 ? Vec2{f.px[k] / f.bound[k], f.py[k] / f.bound[k]} : Vec2{};
}

/// Between the two cells of row j next to x; towards the edges that of the outermost cell.
Vec2 interpolate(const ContactFields& f, int j, double x) {
  const std::size_t first = static_cast<std::size_t>(j) * f.mx;
  if (f.mx == 1) return direction_at(f, first);
  const double place = (x - f.x[first]) / (f.x[first + 1] - f.x[first]);
  const double inside = std::clamp(place, 0.0, double(f.mx - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(inside), static_cast<std::size_t>(f.mx - 2));
  const double t = inside - double(i);
  const Vec2 a = direction_at(f, first + i), b = direction_at(f, first + i + 1);
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

} // namespace

VectorField start_from_fastsim2(const EllipticContact& contact, const ElementGrid& grid, std::span<const double> bound,
                                RollingDirection direction) {
  SimplifiedOptions options;
  options.mx = std::clamp(static_cast<int>(std::lround(2 * contact.a / grid.dx)), 1, 10000);
  options.my = std::clamp(static_cast<int>(std::lround(2 * contact.b / grid.dy)), 1, 10000);
  options.bound = TractionBound::elliptic;
  options.flexibility = FlexibilityModel::blended;
  options.direction = direction;
  const ContactFields f = Fastsim2(options).fields(contact);

  VectorField start(grid.count());
  if (f.mx == 0) return start;
  for (int j = 0; j < grid.my; ++j) {
    const double row = (grid.y(j) / contact.b + 1) / 2 * f.my - 0.5; // rows are cut as the elements are
    const int nearest = std::clamp(static_cast<int>(std::lround(row)), 0, f.my - 1);
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      const Vec2 p = interpolate(f, nearest, grid.x(i));
      start.x[k] = bound[k] * p.x;
      start.y[k] = bound[k] * p.y;
    }
  }
  return start;
}

} // namespace microslip
