#include "microslip/railway/profile/profile_surface.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/cubic_roots.hpp"
#include "microslip/numerics/not_a_knot_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace microslip {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double ProfilePoint::*coordinates[] = {&ProfilePoint::y, &ProfilePoint::z};

/// Factors of the values at both ends of a piece, and of the second derivatives there.
struct CubicBasis {
  std::array<double, 4> value, first, second;

  CubicBasis(double h, double b) {
    const double a = 1 - b;
    value = {a, b, h * h / 6 * (a * a * a - a), h * h / 6 * (b * b * b - b)};
    first = {-1 / h, 1 / h, -h / 6 * (3 * a * a - 1), h / 6 * (3 * b * b - 1)};
    second = {0, 0, a, b};
  }
};

ProfilePoint combined(const std::array<double, 4>& factor, const ProfilePoint& a, const ProfilePoint& b,
                      const ProfilePoint& c, const ProfilePoint& d) {
  return {factor[0] * a.y + factor[1] * b.y + factor[2] * c.y + factor[3] * d.y,
          factor[0] * a.z + factor[1] * b.z + factor[2] * c.z + factor[3] * d.z};
}

/// y over one interval of v, as a cubic from its ends' values and second derivatives.
struct CubicOfV {
  double start, end, first_slope, last_slope, first_bend, last_bend;

  explicit CubicOfV(const std::array<ProfilePoint, 4>& c)
      : start(c[0].y), end(c[1].y), first_slope(end - start - (2 * c[2].y + c[3].y) / 6),
        last_slope(end - start + (c[2].y + 2 * c[3].y) / 6), first_bend(c[2].y), last_bend(c[3].y) {}

  /// It lies between the least and the greatest of its coefficients in Bernstein's basis.
  bool may_reach(double y) const {
    const auto [least, greatest] = std::minmax({start, start + first_slope / 3, end - last_slope / 3, end});
    return least <= y && y <= greatest;
  }
  CubicRoots roots(double y) const {
    return cubic_roots({start - y, first_slope, first_bend / 2, (last_bend - first_bend) / 6}, 0, 1);
  }
};

/// A cubic B-spline with knots at u, and control points there: its values and second derivatives at the knots. Beyond
/// the ends knots and control points go on along straight lines.
void approximate(std::span<const double> u, std::span<double> values, std::span<double> second) {
  const std::size_t n = values.size();
  std::fill(second.begin(), second.end(), 0);
  if (n < 3) return;
  const std::vector<double> control(values.begin(), values.end());
  const auto last = static_cast<std::ptrdiff_t>(n) - 1;
  const auto beyond = [last](const auto& of, std::ptrdiff_t k) {
    const auto at = [&of](std::ptrdiff_t i) { return of[static_cast<std::size_t>(i)]; };
    if (k < 0) return at(0) + double(-k) * (at(0) - at(1));
    if (k > last) return at(last) + double(k - last) * (at(last) - at(last - 1));
    return at(k);
  };
  for (std::ptrdiff_t k = 0; k <= last; ++k) {
    const auto t = [&](std::ptrdiff_t i) { return beyond(u, k + i); };
    const auto c = [&](std::ptrdiff_t i) { return beyond(control, k + i); };
    const double before = t(0) - t(-1), behind = t(1) - t(0), both = before + behind;
    const double left = behind * behind / (both * (t(1) - t(-2))), right = before * before / (both * (t(2) - t(-1)));
    values[static_cast<std::size_t>(k)] = left * c(-1) + (1 - left - right) * c(0) + right * c(1);
    const double slope_before = 3 * (c(0) - c(-1)) / (t(1) - t(-2)), slope_behind = 3 * (c(1) - c(0)) / (t(2) - t(-1));
    second[static_cast<std::size_t>(k)] = 2 * (slope_behind - slope_before) / both;
  }
}

void check(const std::vector<SurfaceSlice>& slices) {
  if (slices.empty()) throw Error("profile surface: no slices");
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const std::string name = "profile surface: slice " + std::to_string(k + 1);
    require_finite(name + ": u", slices[k].u, "m or rad");
    if (k > 0 && !(slices[k].u > slices[k - 1].u)) throw Error(name + ": u must be above that of the slice before");
    if (slices[k].points.size() < 2) throw Error(name + ": fewer than two points");
    for (const ProfilePoint& p : slices[k].points) {
      require_finite(name + ": y", p.y, "m");
      require_finite(name + ": z", p.z, "m");
    }
  }
}

} // namespace

ProfileSurface::ProfileSurface(std::vector<SurfaceSlice> slices, SurfaceOptions options)
    : slices_(std::move(slices)), options_(std::move(options)) {
  check(slices_);
  last_given_ = slices_.size() - 1;
  least_y_ = greatest_y_ = slices_.front().points.front().y;
  for (const SurfaceSlice& slice : slices_) {
    width_ = std::max(width_, slice.last() + 1);
    for (std::size_t j = 0; j < slice.points.size(); ++j) {
      least_y_ = std::min(least_y_, slice.points[j].y);
      greatest_y_ = std::max(greatest_y_, slice.points[j].y);
    }
  }
  constexpr std::size_t most_points = 4'000'000;
  if (slices_.size() > most_points / width_)
    throw Error("profile surface: " + std::to_string(slices_.size()) + " slices of " + std::to_string(width_) +
                " points: must be at most 4000000 in all");
  if (options_.is_wheel) close_wheel();
  number_nodes();
  make_splines_across();
  make_splines_along();
  find_where_y_ascends();
}

/// Repeats the first and the last slices beyond one turn, so that the splines pass over its end.
void ProfileSurface::close_wheel() {
  constexpr std::size_t repeated = 8; // the influence of a value decays by 0.27 from knot to knot
  constexpr double rounding = 1e-4;
  const std::size_t n = slices_.size();
  if (n < 3 || last_u() - first_u() > turn + rounding) return;
  double widest = 0;
  for (std::size_t k = 1; k < n; ++k) widest = std::max(widest, slices_[k].u - slices_[k - 1].u);
  const double gap = turn - (last_u() - first_u());
  if (gap > 2 * widest) return;
  const std::size_t doubled = gap < rounding ? 1 : 0; // the same slice at both ends
  const std::size_t count = std::min(repeated, n - 1 - doubled);
  std::vector<SurfaceSlice> before, behind;
  for (std::size_t k = 0; k < count; ++k) {
    before.push_back(slices_[n - count - doubled + k]);
    before.back().u -= turn;
    behind.push_back(slices_[k + doubled]);
    behind.back().u += turn;
  }
  slices_.insert(slices_.begin(), before.begin(), before.end());
  slices_.insert(slices_.end(), behind.begin(), behind.end());
  first_given_ += count, last_given_ += count;
}

ProfileSurface ProfileSurface::in_units(double of_u, double of_y, double of_z) const {
  ProfileSurface out = *this;
  const auto scale = [=](ProfilePoint& p, double factor) { p.y *= factor * of_y, p.z *= factor * of_z; };
  for (SurfaceSlice& slice : out.slices_) {
    slice.u *= of_u;
    for (ProfilePoint& p : slice.points) scale(p, 1);
  }
  for (Node& node : out.nodes_) {
    scale(node.value, 1), scale(node.vv, 1);
    scale(node.uu, 1 / (of_u * of_u)), scale(node.uuvv, 1 / (of_u * of_u));
  }
  for (ProfileWave& wave : out.options_.waves) wave.amplitude *= of_z, wave.wavenumber /= of_u;
  out.least_y_ *= of_y, out.greatest_y_ *= of_y;
  return out;
}

void ProfileSurface::number_nodes() {
  std::vector<bool> cut(width_);
  for (const std::size_t kink : options_.kinks)
    if (kink > 0 && kink + 1 < width_) cut[kink] = true;
  std::size_t number = 0;
  for (std::size_t v = 0; v < width_; ++v, ++number) {
    if (cut[v]) ++number;
    numbers_.push_back(number);
  }
  nodes_.resize(slices_.size() * number);
}

void ProfileSurface::make_splines_across() {
  for (std::size_t k = 0; k < slices_.size(); ++k) {
    const SurfaceSlice& slice = slices_[k];
    for (std::size_t v = slice.first; v <= slice.last(); ++v)
      node(k, ending(v)).value = node(k, beginning(v)).value = slice.points[v - slice.first];
    std::size_t begin = slice.first;
    for (std::size_t v = begin + 1; v <= slice.last(); ++v)
      if (v == slice.last() || is_kink(v)) {
        make_spline_across(k, begin, v);
        begin = v;
      }
  }
}

/// Over the points of a section.
void ProfileSurface::make_spline_across(std::size_t slice, std::size_t first_v, std::size_t last_v) {
  const std::size_t n = last_v - first_v + 1, first = beginning(first_v);
  std::vector<double> steps(n - 1, 1), values(n), second(n);
  for (double ProfilePoint::*c : coordinates) {
    for (std::size_t j = 0; j < n; ++j) values[j] = node(slice, first + j).value.*c;
    not_a_knot_spline(steps, values, second);
    for (std::size_t j = 0; j < n; ++j) node(slice, first + j).vv.*c = second[j];
  }
}

/// The derivatives on one side of a kink are there where slices have the section on that side.
void ProfileSurface::make_splines_along() {
  for (std::size_t v = 0; v < width_; ++v)
    for (std::size_t number = ending(v); number <= beginning(v); ++number) {
      const std::size_t low = number < beginning(v) ? v - 1 : v, high = number > ending(v) ? v + 1 : v;
      make_splines_along(number, v, v, &Node::value, &Node::uu);
      make_splines_along(number, low, high, &Node::vv, &Node::uuvv);
    }
}

/// Over each row of slices that have points from `low` to `high` without interruption.
void ProfileSurface::make_splines_along(std::size_t number, std::size_t low, std::size_t high,
                                        ProfilePoint Node::*value, ProfilePoint Node::*derivative) {
  const auto holds = [&](std::size_t k) { return slices_[k].holds(low) && slices_[k].holds(high); };
  std::vector<double> u, steps, values, second;
  for (std::size_t first = 0; first < slices_.size(); ++first) {
    if (!holds(first)) continue;
    std::size_t last = first;
    while (last + 1 < slices_.size() && holds(last + 1)) ++last;
    const std::size_t n = last - first + 1;
    u.clear(), steps.clear(), values.resize(n), second.resize(n);
    for (std::size_t k = first; k <= last; ++k) u.push_back(slices_[k].u);
    for (std::size_t k = 1; k < n; ++k) steps.push_back(u[k] - u[k - 1]);
    for (double ProfilePoint::*c : coordinates) {
      for (std::size_t k = 0; k < n; ++k) values[k] = node(first + k, number).*value.*c;
      if (options_.method == SliceMethod::approximating)
        approximate(u, values, second);
      else
        not_a_knot_spline(steps, values, second);
      for (std::size_t k = 0; k < n; ++k) {
        node(first + k, number).*value.*c = values[k];
        node(first + k, number).*derivative.*c = second[k];
      }
    }
    first = last;
  }
}

void ProfileSurface::find_where_y_ascends() {
  y_ascends_.assign(slices_.size(), true);
  for (std::size_t k = 0; k < slices_.size(); ++k)
    for (std::size_t v = 0; v + 1 < width_ && y_ascends_[k]; ++v) y_ascends_[k] = y_ascends_in(k, v);
}

/// Whether a slice has points at v and v + 1.
bool ProfileSurface::has_patch(std::size_t slice, std::size_t v) const {
  return slice < slices_.size() && slices_[slice].holds(v) && slices_[slice].holds(v + 1);
}

/// Of two slices at least one of which has it: where the surface begins or ends at a slice there is nothing on its
/// other side.
ProfileSurface::Patch ProfileSurface::patch(std::size_t slice, std::size_t v) const {
  const std::size_t before = has_patch(slice, v) ? slice : slice + 1,
                    behind = has_patch(slice + 1, v) ? slice + 1 : slice;
  return {&node(before, beginning(v)), &node(behind, beginning(v))};
}

/// y and z at v and v + 1, then their second derivatives along v there.
std::array<ProfilePoint, 4> ProfileSurface::Patch::over_u(const std::array<double, 4>& f) const {
  const Node &a0 = before[0], &a1 = before[1], &b0 = behind[0], &b1 = behind[1];
  return {combined(f, a0.value, b0.value, a0.uu, b0.uu), combined(f, a1.value, b1.value, a1.uu, b1.uu),
          combined(f, a0.vv, b0.vv, a0.uuvv, b0.uuvv), combined(f, a1.vv, b1.vv, a1.uuvv, b1.uuvv)};
}

/// Whether dy/dv is positive all over a patch, as it is if its coefficients in Bernstein's basis are: y may fold
/// between slices on which it ascends.
bool ProfileSurface::y_ascends_in(std::size_t slice, std::size_t v) const {
  if (!has_patch(slice, v) && !has_patch(slice + 1, v)) return true;
  const Patch p = patch(slice, v);
  const double h = p.is_between() ? slices_[slice + 1].u - slices_[slice].u : 0, bend = h * h / 18;
  const std::array<double, 4> along[] = {
      {1, 0, 0, 0}, {2.0 / 3, 1.0 / 3, -2 * bend, -bend}, {1.0 / 3, 2.0 / 3, -bend, -2 * bend}, {0, 1, 0, 0}};
  return std::all_of(std::begin(along), std::end(along), [&](const std::array<double, 4>& factor) {
    const CubicOfV c(p.over_u(factor));
    return c.first_slope > 0 && c.first_slope + c.first_bend / 2 > 0 && c.last_slope > 0;
  });
}

double ProfileSurface::in_turn_of_slices(double angle) const {
  return angle - turn * std::rint((angle - (first_u() + last_u()) / 2) / turn);
}

ProfileSurface::Interval ProfileSurface::interval_at(double u) const {
  Interval p;
  p.u = u;
  if (options_.is_wheel) u = in_turn_of_slices(u);
  const double clamped = std::clamp(u, slices_.front().u, slices_.back().u);
  p.is_beyond = clamped != u;
  if (slices_.size() == 1) return p;
  const auto above = std::upper_bound(slices_.begin(), slices_.end(), clamped,
                                      [](double value, const SurfaceSlice& slice) { return value < slice.u; });
  p.k = std::clamp<std::size_t>(static_cast<std::size_t>(above - slices_.begin()), 1, slices_.size() - 1) - 1;
  p.step = slices_[p.k + 1].u - slices_[p.k].u;
  p.share = (clamped - slices_[p.k].u) / p.step;
  return p;
}

bool ProfileSurface::holds(const Interval& p, std::size_t v) const {
  const bool first = p.share<1, second = p.share> 0 && slices_.size() > 1;
  return (!first || slices_[p.k].holds(v)) && (!second || slices_[p.k + 1].holds(v));
}

ProfilePoint ProfileSurface::point(const Interval& p, std::size_t v) const {
  const std::size_t number = beginning(v);
  if (p.share == 0) return node(p.k, number).value;
  if (p.share == 1) return node(p.k + 1, number).value;
  const Node &a = node(p.k, number), &b = node(p.k + 1, number);
  return combined(CubicBasis(p.step, p.share).value, a.value, b.value, a.uu, b.uu);
}

std::optional<SurfacePoint> ProfileSurface::at(double u, double v) const {
  const Interval p = interval_at(u);
  if (!(v >= 0 && v <= double(width_ - 1))) return {};
  std::size_t j = std::min(static_cast<std::size_t>(v), width_ - 2);
  if (v == double(j) && j > 0 && !holds(p, j + 1)) --j; // the last point of a surface that ends there
  if (!holds(p, j) || !holds(p, j + 1)) return {};
  const CubicBasis along(p.step, p.share), across(1, v - double(j));
  const Patch part = patch(p.k, j);
  const auto over_v = [](const std::array<double, 4>& f, const std::array<ProfilePoint, 4>& c) {
    return combined(f, c[0], c[1], c[2], c[3]);
  };
  const auto values = part.over_u(along.value);
  SurfacePoint s;
  s.value = over_v(across.value, values);
  s.dv = over_v(across.first, values);
  s.dvv = over_v(across.second, values);
  if (!p.is_beyond && part.is_between()) {
    const auto rates = part.over_u(along.first);
    s.du = over_v(across.value, rates);
    s.duv = over_v(across.first, rates);
    s.duu = over_v(across.value, part.over_u(along.second));
  }
  for (const ProfileWave& wave : options_.waves) {
    const double angle = wave.wavenumber * u + wave.phase, rate = wave.amplitude * wave.wavenumber;
    s.value.z += wave.amplitude * std::sin(angle);
    s.du.z += rate * std::cos(angle);
    s.duu.z -= rate * wave.wavenumber * std::sin(angle);
  }
  return s;
}

SurfaceSlice ProfileSurface::section(double u) const {
  const Interval p = interval_at(u);
  double raised = 0;
  for (const ProfileWave& wave : options_.waves) raised += wave.amplitude * std::sin(wave.wavenumber * u + wave.phase);
  SurfaceSlice section;
  section.u = u;
  for (std::size_t v = 0; v < width_; ++v) {
    if (!holds(p, v)) continue;
    if (section.points.empty()) section.first = v;
    section.points.push_back(point(p, v));
    section.points.back().z += raised;
  }
  return section;
}

std::vector<double> ProfileSurface::v_at_y(double u, double y) const {
  const Interval p = interval_at(u);
  std::size_t first = std::max(slices_[p.k].first, p.share > 0 ? slices_[p.k + 1].first : 0);
  std::size_t last = slices_[p.k].last();
  if (p.share > 0) last = std::min(last, slices_[p.k + 1].last());
  if (p.share == 1) first = slices_[p.k + 1].first, last = slices_[p.k + 1].last();
  std::vector<double> found;
  if (first >= last) return found;
  if (y_ascends_[p.k]) {
    if (y < point(p, first).y || y > point(p, last).y) return found;
    while (last - first > 1) {
      const std::size_t middle = (first + last) / 2;
      (point(p, middle).y <= y ? first : last) = middle;
    }
  }
  for (std::size_t v = first; v < last; ++v) add_v_at_y(p, v, y, found);
  return found;
}

/// Adds those from v to v + 1.
void ProfileSurface::add_v_at_y(const Interval& p, std::size_t v, double y, std::vector<double>& found) const {
  constexpr double least_distance = 1e-9;
  const CubicOfV cubic(patch(p.k, v).over_u(CubicBasis(p.step, p.share).value));
  if (!cubic.may_reach(y)) return;
  const auto add = [&, low = static_cast<double>(v)](double t) {
    if (found.empty() || low + t > found.back() + least_distance) found.push_back(low + t);
  };
  const double start = cubic.start - y, end = cubic.end - y;
  if (start == 0) add(0);
  const CubicRoots roots = cubic.roots(y);
  for (const double t : roots) add(t);
  if (roots.count == 0 && start * end < 0) add(std::abs(start) < std::abs(end) ? 0 : 1); // one that rounding lost
  if (end == 0) add(1);
}

} // namespace microslip
