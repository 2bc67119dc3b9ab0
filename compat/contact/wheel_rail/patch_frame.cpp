#include "compat/contact/wheel_rail/patch_frame.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/words.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace microslip::contact_program {
namespace {

/// An angle that is not within a thousandth of a right one, where planes across the track would have no width.
double off_vertical(double angle) {
  constexpr double right = std::numbers::pi / 2, least = SearchThresholds::off_vertical;
  const double off = std::abs(angle) - right;
  if (std::abs(off) >= least) return angle;
  return std::copysign(right + std::copysign(least, off), angle);
}

/// Height of a roller's surface at x, given that at x = 0; the axle's where it does not reach as far.
double height_at(double z, double x, const Placement& p) {
  if (!p.on_roller()) return z;
  const double axle = p.rail.origin.z + p.roller_radius, radius = axle - z;
  return axle - std::copysign(std::sqrt(std::max(radius * radius - x * x, 0.0)), radius);
}

/// Elements along an axis that cover [low, high] with one more on either side, multiples of the size.
struct Range {
  int first = 0, count = 0;

  Range(double low, double high, double size) {
    constexpr double farthest = 1e8; // elements from the origin
    const auto element = [&](double steps) { return static_cast<int>(std::clamp(steps, -farthest, farthest)); };
    first = element(std::floor(low / size)) - 1;
    count = element(std::ceil(high / size)) + 1 - first + 1;
  }
};

/// s along the rail; of slices, others of which may reach farther than this one, goes on in a plane at this angle.
/// Beyond the end of a rail that does not vary there is nothing: s ends, as in CONTACT.
double s_across(const ProfileCurve& rail, double y, const Placement& p, double angle) {
  const double s = rail.nearest_s_at_y(y);
  return p.rail_profile.varies() ? s + (y - rail.at(s).value.y) / std::cos(angle) : s;
}

/// Whether elements are enlarged until there are less than NPOT_MAX, `most`.
bool is_limited(GridOrigin origin, int most) {
  return origin == GridOrigin::reference && most >= SearchThresholds::least_limit;
}

/// Elements along an axis; their number may be greater than any that is allowed.
struct Row {
  double start = 0, count = 0;
};

/// Elements of a size from `start` on, `count` of them, and as many more as reach from `low` to `high` as well.
Row reaching(double low, double high, double size, double start, int count) {
  const double before = std::max(0.0, std::round((start - low) / size));
  const double behind = std::max(0.0, std::round((high - start) / size) - count);
  return {start - before * size, count + before + behind};
}

} // namespace

double most_elements(GridOrigin origin, int most) {
  return is_limited(origin, most) ? SearchThresholds::most_asked_for : SearchThresholds::most_elements;
}

bool cover(PatchFrame& frame, const PatchBox& box, double most) {
  const Row x = reaching(box.x0, box.x1, frame.dx, frame.x0, frame.mx);
  const Row s = reaching(box.s0, box.s1, frame.ds, frame.s0, frame.my);
  const double elements = x.count * s.count;
  if (!(elements <= most)) {
    if (box.x1 < frame.x0 || box.x0 > frame.x1()) return false;
    throw Error("the patch and the last case's contact, from which it goes on, cover " + short_number(elements) +
                " elements with DX = " + short_number(frame.dx / mm) + ", DS = " + short_number(frame.ds / mm) +
                " mm: must be at most " + short_number(most) + "; larger elements are fewer");
  }
  frame.x0 = x.start;
  frame.mx = static_cast<int>(x.count);
  frame.s0 = s.start;
  frame.my = static_cast<int>(s.count);
  return true;
}

PatchFrame lay_out_patch(const PatchRegion& patch, const Placement& placement, const ProfileCurve& rail,
                         const PatchRules& sizes, GridOrigin origin, double place, int most) {
  const GapRegion& whole = patch.whole;
  PatchFrame f;
  f.s_rail = rail.nearest_s_at_y(whole.y);
  const ProfilePoint at = rail.at(f.s_rail).value;
  f.angle = off_vertical(whole.angle);
  f.reference = {{whole.x, at.y, height_at(at.z + patch.below_section, whole.x, placement)}, rotation_about_x(f.angle)};
  f.grid = f.reference;
  double s_grid = f.s_rail;
  if (origin != GridOrigin::reference) {
    const double along = origin == GridOrigin::fixed ? place + whole.x : whole.x;
    f.grid.origin = f.reference.outer({-along, -f.s_rail, 0});
    s_grid = 0;
  }
  const double s_low = s_across(rail, whole.y0, placement, f.angle) - s_grid;
  const double s_high = s_across(rail, whole.y1, placement, f.angle) - s_grid;
  const double x_low = whole.x0 - f.grid.origin.x, x_high = whole.x1 - f.grid.origin.x;
  if (!std::isfinite(x_low + x_high + s_low + s_high))
    throw Error("the extent of the overlap of wheel and rail is no number");
  f.dx = sizes.dx;
  f.ds = sizes.ds;
  Range x(x_low, x_high, f.dx), s(std::min(s_low, s_high), std::max(s_low, s_high), f.ds);
  constexpr int few = SearchThresholds::few_elements;
  while (is_limited(origin, most) && double(x.count) * s.count >= most && (x.count > few || s.count > few)) {
    if (x.count > few) x = Range(x_low, x_high, f.dx *= 2);
    if (s.count > few) s = Range(std::min(s_low, s_high), std::max(s_low, s_high), f.ds *= 2);
  }
  const double elements = double(x.count) * s.count;
  const double allowed = most_elements(origin, most);
  if (!(elements <= allowed))
    throw Error("wheel and rail overlap over " + short_number((x_high - x_low) / mm) + " x " +
                short_number((s_high - s_low) / mm) + " mm, " + short_number(elements) +
                " elements with DX = " + short_number(f.dx / mm) + ", DS = " + short_number(f.ds / mm) +
                " mm: must be at most " + short_number(allowed) + "; is the wheel's height right?");
  f.mx = x.count;
  f.my = s.count;
  f.x0 = (x.first - 0.5) * f.dx;
  f.s0 = (s.first - 0.5) * f.ds;
  f.y0 = whole.y0;
  f.y1 = whole.y1;
  const std::size_t n = patch.parts.size();
  for (std::size_t k = n; k-- > 1;) {
    const double y = (patch.parts[k].y1 + patch.parts[k - 1].y0) / 2;
    f.separators.push_back((y - f.grid.origin.y) / std::cos(f.angle));
  }
  f.factors = patch.factors;
  std::reverse(f.factors.begin(), f.factors.end()); // both indices count from the other side
  return f;
}

} // namespace microslip::contact_program
