#include "microslip/railway/geometry/contact_search.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace microslip {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
/// [rad], inclinations that differ by less everywhere on two arcs count as equal.
constexpr double parallel = 1e-9;
/// [rad], [m], rounding of inclinations and positions.
constexpr double rounding = 1e-13;
/// Surfaces whose inclination is within this of the view's direction [rad] are not seen.
constexpr double grazing = 1e-6;
/// cos^2 chi, about cos^2 tau: points of the wheel further than 60 degrees from its lowest line are left out. There the
/// locus of a steep flank under yaw climbs to the axle, where no rail is.
constexpr double highest_place = 0.25;
/// States that count as near: components of axes [-] and the lateral position [m] change by less.
constexpr double near_axes = 1e-4, near_lateral = 3e-4;
/// By how much more the gap of pairs of arcs that are kept for them may be [m].
constexpr double near_reach = 1e-4;
/// Halvings of an arc after which the sign of a derivative need not be proven any more.
constexpr int finest = 40;

/// The rail's curve in the axes of the search.
class RailCurve {
public:
  struct Point {
    double y = 0, z = 0, cosine = 1, sine = 0, speed = 0, turn = 0;
  };

  RailCurve(const ProfileArcs& arcs, const Frame<double>& rail)
      : arcs_(arcs), y_(rail.origin.y), z_(rail.origin.z), cosine_(rail.axes.ey.y), sine_(rail.axes.ey.z),
        angle_(std::atan2(sine_, cosine_)) {}

  Point at(const ProfileArc& arc, double u) const {
    return turned(u == 0 ? arc.ends[0] : u == 1 ? arc.ends[1] : arcs_.at(arc, u));
  }

  Range y(const ArcNode& node) const { return cosine_ * node.y + (-sine_) * node.z + y_; }
  Range z(const ArcNode& node) const { return sine_ * node.y + cosine_ * node.z + z_; }
  Range inclination(const ArcNode& node) const { return node.alpha + angle_; }

private:
  Point turned(const ArcPoint& p) const {
    return {y_ + cosine_ * p.place.y - sine_ * p.place.z,
            z_ + sine_ * p.place.y + cosine_ * p.place.z,
            cosine_ * p.cosine - sine_ * p.sine,
            sine_ * p.cosine + cosine_ * p.sine,
            p.speed,
            p.turn};
  }

  const ProfileArcs& arcs_;
  double y_, z_, cosine_, sine_, angle_;
};

/// Range of cosines of angles between two that differ by less than a straight angle.
Range between_angles(double c0, double s0, double c1, double s1) {
  Range range = Range::between(c0, c1);
  if (s0 * s1 < 0 && c0 + c1 > 0) range.high = 1;
  if (s0 * s1 < 0 && c0 + c1 < 0) range.low = -1;
  return range;
}

/// sin(b - a) of two directions.
template <class A, class B> double sine_between(const A& a, const B& b) {
  return a.cosine * b.sine - a.sine * b.cosine;
}

/// Bounds of delta - delta0 at the angle alpha of the profile, where sin(delta - delta0) = sin(alpha)/c. For small
/// changes e = delta - delta0 - alpha from sin e = sin(alpha) (cos(alpha) - cos(delta - delta0) c)/c.
Range inclination_at(double alpha, double sine, double cosine, double across) {
  if (across == 1) return {alpha, alpha};
  const double rest = across * across - sine * sine;
  if (rest > 0) {
    const double change = sine * (cosine - std::copysign(std::sqrt(rest), cosine)) / across;
    if (std::abs(change) < 0.1) {
      const double cubic = 0.2 * std::abs(change) * change * change;
      return {alpha + change - cubic, alpha + change + cubic};
    }
  }
  const double branch = std::round(alpha / std::numbers::pi);
  const double angle = std::asin(std::clamp(sine / across, -1.0, 1.0));
  const double all = branch * std::numbers::pi + (std::fmod(branch, 2) == 0 ? angle : -angle);
  return {all, all};
}

Range inclination_at(double alpha, double sine, double cosine, const Range& across) {
  Range all = inclination_at(alpha, sine, cosine, across.low); // a monotone function of c
  all.include(inclination_at(alpha, sine, cosine, across.high));
  return all;
}

/// What bounds of the wheel's locus depend on, in one placement, or with T = Range in all that are near it.
template <class T> struct WheelPose {
  Vec3<T> ex, ey, ez;
  T y{}, z{};            ///< of the origin [m]
  T across{};            ///< c
  T level{};             ///< delta0 [rad]
  T in_wheel{};          ///< length of the track's x axis across the axle
  bool is_level = false; ///< the axle is across the track
};

WheelPose<double> pose_of(const WheelLocus<double>& locus) {
  const auto& [origin, axes] = locus.wheel();
  return {.ex = axes.ex,
          .ey = axes.ey,
          .ez = axes.ez,
          .y = origin.y,
          .z = origin.z,
          .across = locus.across(),
          .level = std::atan2(locus.level_sine(), locus.level_cosine()),
          .in_wheel = std::hypot(axes.ex.x, axes.ez.x),
          .is_level = axes.ey.x == 0};
}

/// The poses whose axes and lateral position are near, at the same height.
WheelPose<Range> poses_near(const WheelPose<double>& p) {
  constexpr double more = 1 + 1e-6; // for rounding
  const auto around = [](double value, double change) { return Range{value - more * change, value + more * change}; };
  const auto axis = [&](const Vec3<double>& e) {
    return Vec3<Range>{around(e.x, near_axes), around(e.y, near_axes), around(e.z, near_axes)};
  };
  const Range lean = axis(p.ey).x;
  const double most = std::max(-lean.low, lean.high);
  return {.ex = axis(p.ex),
          .ey = axis(p.ey),
          .ez = axis(p.ez),
          .y = around(p.y, near_lateral),
          .z = {p.z, p.z},
          .across = {std::sqrt(std::max(1 - most * most, 1e-12)), 1},
          .level = around(p.level, 2 * near_axes / p.across), // the arc of a chord of at most sqrt(2) of it
          .in_wheel = around(p.in_wheel, std::numbers::sqrt2 * near_axes),
          .is_level = false};
}

bool is_near(const Vec3<double>& a, const Vec3<double>& b) {
  return std::abs(a.x - b.x) <= near_axes && std::abs(a.y - b.y) <= near_axes && std::abs(a.z - b.z) <= near_axes;
}

/// The wheel's origin from the rail's.
Vec3<double> offset(const WheelPlacement<double>& p) {
  return p.wheel.frame.origin - p.rail.frame.origin;
}

/// Whether poses_near() of the one placement has the other, but for its height.
bool is_near(const WheelPlacement<double>& a, const WheelPlacement<double>& b) {
  const auto &rail_a = a.rail.frame.axes.ey, &rail_b = b.rail.frame.axes.ey;
  const auto &wheel_a = a.wheel.frame.axes, &wheel_b = b.wheel.frame.axes;
  return a.radius == b.radius && rail_a.y == rail_b.y && rail_a.z == rail_b.z &&
         std::abs(offset(a).y - offset(b).y) <= near_lateral && is_near(wheel_a.ex, wheel_b.ex) &&
         is_near(wheel_a.ey, wheel_b.ey) && is_near(wheel_a.ez, wheel_b.ez);
}

/// The zero of a monotone function between a and b, where it has opposite signs or is zero, from a first guess:
/// Newton's method within a bracket. `function` returns value and derivative.
template <class Function> double monotone_root(double a, double b, bool rising, double guess, Function function) {
  double u = std::clamp(guess, a, b);
  for (int k = 0; k < 80; ++k) {
    const auto [value, slope] = function(u);
    if (value == 0) return u;
    ((value > 0) == rising ? b : a) = u;
    double next = u - value / slope;
    // after a step as small as this Newton's method has the zero to rounding
    if (std::abs(next - u) <= 1e-10 && next >= a && next <= b) return next;
    if (!(next >= a && next <= b) || k % 8 == 7) next = (a + b) / 2;
    if (std::abs(next - u) <= 4e-16 * (1 + std::abs(u))) return next;
    u = next;
  }
  return u;
}

/// Zero of the straight line through (a, f(a)) and (b, f(b)).
double secant(double a, double fa, double b, double fb) {
  return fa == fb ? (a + b) / 2 : a - fa * (b - a) / (fb - fa);
}

struct ValueAndSlope {
  double value, slope;
};

Frame<double> seen_from(const Frame<double>& frame, double view) {
  return view == 0 ? frame : Frame<double>{{}, rotation_about_x(-view)} * frame;
}

} // namespace

/// One search: pairs of arcs that may hold a point of equal inclination.
struct ArcPairSearch {
  ContactSearch& search;
  double approach;
  const ProfileArcs &rail_arcs = search.rail_, &wheel_arcs = search.wheel_;
  RailCurve rail{rail_arcs, search.turned_.rail.frame};
  WheelLocus<double> locus{search.turned_.wheel.frame, search.turned_.radius};
  WheelPose<double> pose = pose_of(locus);
  double lowest = std::numeric_limits<double>::infinity();

  struct WheelPart {
    const ProfileArc& arc;
    double u0, u1;
    LocusPoint<double> p0, p1;
  };
  struct RailPart {
    const ProfileArc& arc;
    double v0, v1;
    RailCurve::Point p0, p1;
  };

  template <class T> ContactSearch::LocusBounds bounds_of(const ArcNode& node, const WheelPose<T>& at) const {
    ContactSearch::LocusBounds bounds;
    const auto end = [&](std::size_t k, double alpha) {
      return inclination_at(alpha, node.sine[k], node.cosine[k], at.across);
    };
    bounds.inclination = Range{end(0, node.alpha.low).low, end(1, node.alpha.high).high} + at.level;
    // tau = beta + sigma with sin sigma = -e_x tan(alpha)/hypot(a1, a3), where a1, a3 are the components of the track's
    // x axis across the axle
    Range sine{0, 0}, cosine{1, 1};
    if (!at.is_level) {
      sine = {-1, 1};
      if (node.one_branch) {
        const Range all = (-1.0 * at.ey.x / at.in_wheel) * Range{node.tangent[0], node.tangent[1]};
        sine = {std::clamp(all.low, -1.0, 1.0), std::clamp(all.high, -1.0, 1.0)};
      }
      cosine = Range::between(std::sqrt(1 - sine.low * sine.low), std::sqrt(1 - sine.high * sine.high));
      if (sine.holds(0)) cosine.high = 1;
    }
    const T a1 = at.ex.x / at.in_wheel, a3 = at.ez.x / at.in_wheel;
    const Range tau_sine = a1 * sine + a3 * cosine;
    const Range tau_cosine = a1 * cosine + -1.0 * a3 * sine;
    const Range rho{locus.radius() - node.z.high, locus.radius() - node.z.low};
    const Range ahead = rho * tau_sine, below = rho * tau_cosine;
    bounds.y = at.ex.y * ahead + at.ey.y * node.y + -1.0 * at.ez.y * below + at.y;
    bounds.z = at.ex.z * ahead + at.ey.z * node.y + -1.0 * at.ez.z * below + at.z;
    return bounds;
  }

  LocusPoint<double> wheel_at(const ProfileArc& arc, double u) const {
    if (u == 0 || u == 1) return ends(arc)[u == 0 ? 0 : 1];
    return locus.at(wheel_arcs.at(arc, u));
  }

  const std::array<LocusPoint<double>, 2>& ends(const ProfileArc& arc) const {
    const auto k = static_cast<std::size_t>(&arc - wheel_arcs.arcs().data());
    if (search.ends_of_[k] != search.search_) {
      search.ends_of_[k] = search.search_;
      search.ends_[k] = {locus.at(arc.ends[0]), locus.at(arc.ends[1])};
    }
    return search.ends_[k];
  }

  const ContactSearch::LocusBounds& bounds(std::size_t node) const {
    if (search.bounds_of_[node] != search.search_) {
      search.bounds_of_[node] = search.search_;
      search.bounds_[node] = bounds_of(wheel_arcs.nodes()[node], pose);
    }
    return search.bounds_[node];
  }

  /// Whether parts of the profiles may have a point of equal inclination with a gap of at most `reach`.
  bool may_touch(const ContactSearch::LocusBounds& wheel, const ArcNode& rail_node, double reach) const {
    Range inclination = rail.inclination(rail_node);
    inclination = {std::max(inclination.low, -right_angle), std::min(inclination.high, right_angle)};
    return inclination.meets(wheel.inclination) && rail.y(rail_node).meets(wheel.y) &&
           !(wheel.z.low - rail.z(rail_node).high > reach);
  }

  /// Calls f(node, node) for the pairs of arcs below two nodes for which may(node, node) holds down to them.
  template <class May, class Function>
  void for_each_pair(std::size_t w, std::size_t r, const May& may, const Function& f) {
    if (!may(w, r)) return;
    const ArcNode &wheel_node = wheel_arcs.nodes()[w], &rail_node = rail_arcs.nodes()[r];
    if (wheel_node.count == 1 && rail_node.count == 1) {
      f(w, r);
    } else if (rail_node.count == 1 || (wheel_node.count > 1 && wheel_node.count >= rail_node.count)) {
      for (const std::size_t half : {w + 1, wheel_node.second}) for_each_pair(half, r, may, f);
    } else {
      for (const std::size_t half : {r + 1, rail_node.second}) for_each_pair(w, half, may, f);
    }
  }

  bool may_touch_here(std::size_t w, std::size_t r) const {
    return may_touch(bounds(w), rail_arcs.nodes()[r], lowest + approach);
  }

  void look_at(std::size_t w, std::size_t r) {
    const ProfileArc &wheel_arc = wheel_arcs.arcs()[wheel_arcs.nodes()[w].first],
                     &rail_arc = rail_arcs.arcs()[rail_arcs.nodes()[r].first];
    pair({wheel_arc, 0, 1, wheel_at(wheel_arc, 0), wheel_at(wheel_arc, 1)},
         {rail_arc, 0, 1, rail.at(rail_arc, 0), rail.at(rail_arc, 1)}, 0);
  }

  /// All pairs of arcs by the trees.
  void visit_all() {
    for_each_pair(
        0, 0, [&](auto w, auto r) { return may_touch_here(w, r); }, [&](auto w, auto r) { look_at(w, r); });
  }

  /// Those of the pairs that are kept.
  void visit_kept() {
    for (const auto& [w, r] : search.kept_)
      if (may_touch_here(w, r)) look_at(w, r);
  }

  /// Keeps all pairs that near placements may need, whose gap is at most `reach` higher or lower than here. False if
  /// there are too many.
  bool keep(double reach) {
    const WheelPose<Range> poses = poses_near(pose);
    std::size_t node = wheel_arcs.nodes().size();
    ContactSearch::LocusBounds wheel;
    search.kept_.clear();
    bool all = true;
    for_each_pair(
        0, 0,
        [&](std::size_t w, std::size_t r) {
          if (w != node) wheel = bounds_of(wheel_arcs.nodes()[node = w], poses);
          return all && may_touch(wheel, rail_arcs.nodes()[r], reach);
        },
        [&](std::size_t w, std::size_t r) {
          all = search.kept_.size() < search.kept_.capacity();
          if (all) search.kept_.push_back({w, r});
        });
    return all;
  }

  void pair(const WheelPart& w, const RailPart& r, int depth) {
    if (!w.p0.exists && !w.p1.exists) return;
    const bool wheel_rises = sine_between(w.p0, w.p1) >= 0, rail_rises = sine_between(r.p0, r.p1) >= 0;
    const auto &wheel_low = wheel_rises ? w.p0 : w.p1, &wheel_high = wheel_rises ? w.p1 : w.p0;
    const auto &rail_low = rail_rises ? r.p0 : r.p1, &rail_high = rail_rises ? r.p1 : r.p0;
    if (sine_between(wheel_high, rail_low) > rounding || sine_between(rail_high, wheel_low) > rounding) return;

    Range speed = w.arc.speed, turn = w.arc.turn, rail_speed = r.arc.speed, rail_turn = r.arc.turn;
    if (depth > 0) {
      wheel_arcs.bound_derivatives(w.arc, w.u0, w.u1, speed, turn);
      rail_arcs.bound_derivatives(r.arc, r.v0, r.v1, rail_speed, rail_turn);
    }
    const Range cosine = between_angles(w.p0.cosine, w.p0.sine, w.p1.cosine, w.p1.sine);
    const Range rail_cosine = between_angles(r.p0.cosine, r.p0.sine, r.p1.cosine, r.p1.sine);
    if (cosine.high < grazing || rail_cosine.high < grazing) return;
    bool known = true;
    if (locus.lean() > 0) {
      const Range square = square_of_chi(w);
      if (square.high < highest_place) return;
      known = square.low > highest_place / 25;
      if (known) lean_on(w, square, speed, turn);
    }
    if (known && speed.high < 0) return; // an inner sheet of the locus
    const Range dy = speed * cosine, rail_dy = rail_speed * rail_cosine;
    const Range wheel_y = known ? speed.low >= 0 && cosine.low >= 0 ? Range::between(w.p0.place.y, w.p1.place.y)
                                                                    : (w.u1 - w.u0) * dy + w.p0.place.y
                                : Range{-1e9, 1e9};
    Range rail_y = (r.v1 - r.v0) * rail_dy + r.p0.y;
    if (rail_cosine.low >= 0) rail_y = Range::between(r.p0.y, r.p1.y);
    if (!wheel_y.meets({rail_y.low - rounding, rail_y.high + rounding})) return;

    const bool one_way = known && speed.low >= 0 && cosine.low > 0 && rail_cosine.low > 0;
    if (one_way && dy.low > 0 && rail_dy.low > 0) {
      // the difference of inclinations where both have the same y, from that of the first ends
      const Range common{std::max(wheel_y.low, rail_y.low), std::min(wheel_y.high, rail_y.high)};
      const Range change = turn / dy * (common + -w.p0.place.y) - rail_turn / rail_dy * (common + -r.p0.y);
      const Range left = change + std::asin(sine_between(r.p0, w.p0));
      if (left.low > rounding || left.high < -rounding) return;
    }
    const Range difference = turn * rail_dy - dy * rail_turn;
    const bool at_corner = r.arc.length == 0;
    if (depth >= finest || (one_way && (at_corner || !difference.holds(0)))) {
      if (at_corner)
        under_corner(w, r);
      else
        cross(w, r);
    } else if (one_way && wheel_high.cosine * rail_low.cosine > 0 && sine_between(rail_low, wheel_high) < parallel &&
               sine_between(wheel_low, rail_high) < parallel) {
      beside(w, r);
    } else {
      halve(w, r, depth);
    }
  }

  Range profile_cosine(const WheelPart& w) const {
    const ArcPoint a = w.u0 == 0 ? w.arc.ends[0] : wheel_arcs.at(w.arc, w.u0);
    const ArcPoint b = w.u1 == 1 ? w.arc.ends[1] : wheel_arcs.at(w.arc, w.u1);
    return between_angles(a.cosine, a.sine, b.cosine, b.sine);
  }

  /// cos^2 chi = 1 - e_x^2/cos^2 alpha; minus infinity where alpha reaches a right angle.
  Range square_of_chi(const WheelPart& w) const {
    const Range cosine = profile_cosine(w);
    const double least = std::min(cosine.low * cosine.low, cosine.high * cosine.high);
    const double most = std::max(cosine.low * cosine.low, cosine.high * cosine.high);
    return {cosine.holds(0) ? -std::numeric_limits<double>::infinity() : 1 - locus.lean() / least,
            1 - locus.lean() / most};
  }

  /// Speed and turn of the locus from those of the profile (W2).
  void lean_on(const WheelPart& w, const Range& square, Range& speed, Range& turn) const {
    const Range cosine = profile_cosine(w), chi{std::sqrt(square.low), std::sqrt(square.high)};
    const ProfileArc& arc = w.arc;
    const Range rho{locus.radius() - std::max(arc.ends[0].place.z, arc.ends[1].place.z),
                    locus.radius() - std::min(arc.ends[0].place.z, arc.ends[1].place.z)};
    const Range size = cosine.high < 0 ? -1.0 * cosine : cosine; // the locus takes |cos alpha|
    speed = speed * chi + locus.lean() * (turn * rho) / (chi * size * size * size);
    turn = turn / chi;
  }

  void halve(const WheelPart& w, const RailPart& r, int depth) {
    const double um = (w.u0 + w.u1) / 2, vm = (r.v0 + r.v1) / 2;
    const LocusPoint<double> wheel_middle = wheel_at(w.arc, um);
    const RailCurve::Point rail_middle = rail.at(r.arc, vm);
    const WheelPart lower{w.arc, w.u0, um, w.p0, wheel_middle}, upper{w.arc, um, w.u1, wheel_middle, w.p1};
    const RailPart first{r.arc, r.v0, vm, r.p0, rail_middle}, last{r.arc, vm, r.v1, rail_middle, r.p1};
    for (const WheelPart* a : {&lower, &upper})
      for (const RailPart* b : {&first, &last}) pair(*a, *b, depth + 1);
  }

  /// The wheel's arc over a corner of the rail.
  void under_corner(const WheelPart& w, const RailPart& r) {
    const double y = r.p0.y;
    if ((w.p0.place.y > y) == (w.p1.place.y > y) && w.p0.place.y != y) return;
    const double u = wheel_over(w, y);
    const LocusPoint<double> p = wheel_at(w.arc, u);
    const double from = sine_between(r.p0, p), to = sine_between(r.p1, p);
    if (from * to > 0) return;
    add(w.arc, u, p, r.arc, 0);
  }

  double wheel_over(const WheelPart& w, double y) const {
    if (w.p0.place.y == w.p1.place.y) return w.u0;
    const double guess = secant(w.u0, w.p0.place.y - y, w.u1, w.p1.place.y - y);
    return monotone_root(w.u0, w.u1, true, guess, [&](double u) {
      const LocusPoint<double> p = wheel_at(w.arc, u);
      return ValueAndSlope{p.place.y - y, p.speed * p.cosine};
    });
  }

  double rail_under(const RailPart& r, double y) const {
    return monotone_root(r.v0, r.v1, true, secant(r.v0, r.p0.y - y, r.v1, r.p1.y - y), [&](double v) {
      const RailCurve::Point p = rail.at(r.arc, v);
      return ValueAndSlope{p.y - y, p.speed * p.cosine};
    });
  }

  /// Two arcs with y rising on both, between which the difference of inclinations is monotone.
  void cross(const WheelPart& w, const RailPart& r) {
    const auto &a = w.p0.place.y, &b = w.p1.place.y;
    const double ua = a >= r.p0.y ? w.u0 : wheel_over(w, r.p0.y), va = a >= r.p0.y ? rail_under(r, a) : r.v0;
    const double ub = b <= r.p1.y ? w.u1 : wheel_over(w, r.p1.y), vb = b <= r.p1.y ? rail_under(r, b) : r.v1;
    const auto difference = [&](double u, double v) { return sine_between(rail.at(r.arc, v), wheel_at(w.arc, u)); };
    double low = difference(ua, va), high = difference(ub, vb);
    if (std::abs(low) <= rounding) low = 0;
    if (std::abs(high) <= rounding) high = 0;
    if (low * high > 0) return;
    double v = (va + vb) / 2;
    const RailPart between{r.arc, va, vb, rail.at(r.arc, va), rail.at(r.arc, vb)};
    const double u = monotone_root(ua, ub, high > low, secant(ua, low, ub, high), [&](double at) {
      const LocusPoint<double> p = wheel_at(w.arc, at);
      v = rail_under(between, p.place.y);
      const RailCurve::Point q = rail.at(r.arc, v);
      return ValueAndSlope{sine_between(q, p), p.turn - q.turn * p.speed * p.cosine / (q.speed * q.cosine)};
    });
    add(w.arc, u, wheel_at(w.arc, u), r.arc, v);
  }

  /// Two parallel arcs: the middle of their common range of y.
  void beside(const WheelPart& w, const RailPart& r) {
    const double low = std::max(w.p0.place.y, r.p0.y), high = std::min(w.p1.place.y, r.p1.y);
    const double middle = (low + high) / 2;
    const double u = wheel_over(w, middle);
    add(w.arc, u, wheel_at(w.arc, u), r.arc, rail_under(r, middle));
  }

  void add(const ProfileArc& wheel_arc, double u, const LocusPoint<double>& p, const ProfileArc& rail_arc, double v) {
    const RailCurve::Point q = rail.at(rail_arc, v);
    ContactPoint point;
    point.gap = p.place.z - q.z;
    if (point.gap > lowest + approach) return;
    point.s_wheel = wheel_arc.start + u * wheel_arc.length;
    point.s_rail = rail_arc.start + v * rail_arc.length;
    point.place = p.place;
    point.tau = std::atan2(p.ahead_sine, p.ahead_cosine);
    point.inclination = std::atan2(p.sine, p.cosine);
    point.radius = locus.radius() - (wheel_arc.length == 0 ? wheel_arc.ends[0] : wheel_arcs.at(wheel_arc, u)).place.z;
    point.curvature = p.turn / p.speed - q.turn / q.speed;
    point.minimum = p.speed >= 0 && point.curvature >= 0;
    point.wheel_arc = static_cast<double>(&wheel_arc - wheel_arcs.arcs().data()) + u;
    point.wheel_corner = wheel_arc.corner;
    point.rail_corner = rail_arc.corner;
    if (point.minimum) lowest = std::min(lowest, point.gap);
    search.points_.push_back(point);
  }
};

/// Follows the locus of a search over the rail.
struct LocusTracer {
  using KnownEdge = ContactSearch::KnownEdge;

  const ContactSearch& search;
  const ProfileArcs &rail_arcs = search.rail_, &wheel_arcs = search.wheel_;
  RailCurve rail{rail_arcs, search.turned_.rail.frame};
  WheelLocus<double> locus{search.turned_.wheel.frame, search.turned_.radius};
  std::size_t last_arc = 0;

  struct LocusGap {
    double gap = std::numeric_limits<double>::infinity(); ///< infinite where there is no rail below
    double slope = 0;                                     ///< by the parameter
    Vec3<double> point;
    double s_wheel = 0, s_rail = 0;
  };

  double end() const { return static_cast<double>(wheel_arcs.arcs().size()); }

  /// The point of the rail's surface under y that is highest, as an arc and the parameter on it; false if there is
  /// none.
  bool find_rail(double y, std::size_t& arc, double& v) {
    if (lies_under(rail_arcs.arcs()[last_arc], y)) {
      arc = last_arc;
    } else {
      double highest = -std::numeric_limits<double>::infinity();
      climb(0, y, highest, arc);
      if (std::isinf(highest)) return false;
      last_arc = arc;
    }
    v = parameter_under(rail_arcs.arcs()[arc], y);
    return true;
  }

  bool lies_under(const ProfileArc& arc, double y) const {
    const RailCurve::Point a = rail.at(arc, 0), b = rail.at(arc, 1);
    return a.y <= y && y <= b.y && a.cosine >= 0 && b.cosine >= 0 && arc.length > 0;
  }

  double parameter_under(const ProfileArc& arc, double y) const {
    const double guess = secant(0, rail.at(arc, 0).y - y, 1, rail.at(arc, 1).y - y);
    return monotone_root(0, 1, true, guess, [&](double v) {
      const RailCurve::Point p = rail.at(arc, v);
      return ValueAndSlope{p.y - y, p.speed * p.cosine};
    });
  }

  void climb(std::size_t n, double y, double& highest, std::size_t& arc) const {
    const ArcNode& node = rail_arcs.nodes()[n];
    if (!rail.y(node).holds(y) || rail.z(node).high <= highest) return;
    if (node.count > 1) {
      climb(n + 1, y, highest, arc);
      climb(node.second, y, highest, arc);
    } else if (const ProfileArc& leaf = rail_arcs.arcs()[node.first]; lies_under(leaf, y)) {
      const double z = rail.at(leaf, parameter_under(leaf, y)).z;
      if (z > highest) highest = z, arc = node.first;
    }
  }

  LocusGap at(double parameter) {
    const std::size_t index = std::min(static_cast<std::size_t>(parameter), wheel_arcs.arcs().size() - 1);
    const ProfileArc& arc = wheel_arcs.arcs()[index];
    const double u = parameter - static_cast<double>(index);
    const LocusPoint<double> p = locus.at(wheel_arcs.at(arc, u));
    LocusGap here;
    here.point = p.place;
    here.s_wheel = arc.start + u * arc.length;
    std::size_t rail_arc = 0;
    double v = 0;
    if (!p.exists || p.cosine <= 0 || !find_rail(p.place.y, rail_arc, v)) return here;
    const RailCurve::Point q = rail.at(rail_arcs.arcs()[rail_arc], v);
    here.gap = p.place.z - q.z;
    here.slope = p.speed * (p.sine - q.sine / q.cosine * p.cosine);
    here.s_rail = rail_arcs.arcs()[rail_arc].start + v * rail_arcs.arcs()[rail_arc].length;
    return here;
  }

  /// A step of Newton's method after which its error is rounding, in arcs.
  static constexpr double last_step = 1e-9;

  /// A path along the locus from a point of a region out of it. The gap grows on it up to the region's end.
  struct Path {
    double inside, bound; ///< from and to [arcs]
    bool to_point;        ///< the bound is another point, else the end of the wheel
    double direction() const { return bound < inside ? -1 : 1; }
  };

  /// Edge of the region: the point of the path where the gap is `lowering`. Starts from the edge that is known, which
  /// it becomes, or else from a `step`.
  ContactRegion::End edge(const Path& path, double step, double lowering, KnownEdge& known) {
    std::optional<ContactRegion::End> end;
    if (known.slope != 0) end = follow(path, lowering, known);
    return end ? *end : bracket(path, step, lowering, known);
  }

  /// Follows the edge by Newton's method from the known one; nothing where it leaves the path, or the part of it on
  /// which the gap grows.
  std::optional<ContactRegion::End> follow(const Path& path, double lowering, KnownEdge& known) {
    constexpr int most_steps = 6;
    last_arc = known.rail_arc;
    double u = known.parameter + (lowering - known.gap) / known.slope;
    for (int k = 0; k < most_steps; ++k) {
      if (!((u - path.inside) * (path.bound - u) > 0)) return {};
      const LocusGap here = at(u);
      const double change = (lowering - here.gap) / here.slope;
      if (!std::isfinite(change) || !(here.slope * path.direction() > 0)) return {};
      if (std::abs(change) <= last_step) return moved(here, u, change, lowering, known);
      u += change;
    }
    return {};
  }

  /// The edge that is a last step further.
  ContactRegion::End moved(const LocusGap& here, double u, double change, double lowering, KnownEdge& known) {
    known = {u + change, lowering, here.slope, last_arc};
    return end_at(change == 0 ? here : at(known.parameter), Corner::none);
  }

  /// The ends of a part of the path that holds the edge, `outside` with its gap; nothing if the wheel ends before.
  std::optional<std::array<double, 2>> enclose(const Path& path, double step, double lowering, LocusGap& here) {
    constexpr int most_halvings = 60;
    const double direction = path.direction();
    double inside = path.inside;
    for (int halvings = 0; halvings < most_halvings && inside != path.bound;) {
      const double outside = direction * std::min(direction * (inside + direction * step), direction * path.bound);
      here = at(outside);
      if (!(here.gap < lowering)) return std::array{inside, outside};
      const bool beyond_a_maximum = !(here.slope * direction > 0) || (path.to_point && outside == path.bound);
      if (beyond_a_maximum)
        step = direction * (outside - inside) / 2, ++halvings;
      else
        inside = outside, step *= 2;
    }
    return {};
  }

  ContactRegion::End bracket(const Path& path, double step, double lowering, KnownEdge& known) {
    const double direction = path.direction();
    LocusGap here;
    known = {};
    const auto ends = enclose(path, step, lowering, here);
    if (!ends) return end_at(at(path.bound), Corner::end);
    auto [inside, outside] = *ends;

    double u = (inside + outside) / 2;
    if (std::isfinite(here.gap)) u = outside - (here.gap - lowering) / here.slope;
    bool rail_ends = std::isinf(here.gap);
    for (int k = 0; k < 100; ++k) {
      if (!((u - inside) * direction > 0 && (outside - u) * direction > 0)) u = (inside + outside) / 2;
      here = at(u);
      const double change = (lowering - here.gap) / here.slope;
      if (here.gap < lowering) {
        inside = u;
      } else {
        outside = u;
        rail_ends = std::isinf(here.gap);
      }
      const double next = k % 8 == 7 || std::isinf(here.gap) ? (inside + outside) / 2 : u + change;
      if (std::isfinite(here.gap) && std::abs(change) <= last_step && (next - inside) * (outside - next) >= 0)
        return moved(here, u, change, lowering, known);
      if (std::abs(next - u) <= 1e-15 * (1 + std::abs(u)) || std::abs(outside - inside) <= 1e-15 * (1 + std::abs(u)))
        break;
      u = next;
    }
    return rail_ends ? end_at(at(inside), Corner::end) : end_at(here, Corner::none);
  }

  ContactRegion::End end_at(const LocusGap& here, Corner corner) const {
    return {here.s_wheel, here.s_rail, rotation_about_x(search.view_) * here.point, corner};
  }

  /// Arcs to the point where a parabola through the point reaches `lowering`.
  double first_step(const ContactPoint& point, double lowering) const {
    const ProfileArc& arc =
        wheel_arcs.arcs()[std::min(static_cast<std::size_t>(point.wheel_arc), wheel_arcs.arcs().size() - 1)];
    const double distance = std::sqrt(2 * (lowering - point.gap) / std::max(point.curvature, 1e-3));
    return std::clamp(distance / std::max(arc.length, 1e-6), 0.01, 1000.0);
  }
};

ContactSearch::ContactSearch(const Profile& rail, const Profile& wheel) : rail_(rail), wheel_(wheel) {
  if (rail.role() != ProfileRole::rail) throw Error("contact search: the first profile must be a rail's");
  if (wheel.role() != ProfileRole::wheel) throw Error("contact search: the second profile must be a wheel's");
  bounds_.resize(wheel_.nodes().size());
  bounds_of_.resize(bounds_.size());
  ends_.resize(wheel_.arcs().size());
  ends_of_.resize(ends_.size());
  points_.reserve(256);
  edges_.reserve(512);
  regions_.reserve(32);
  kept_.reserve(2048);
  middle_.radius = std::numeric_limits<double>::quiet_NaN();
}

std::span<const ContactPoint> ContactSearch::find(const WheelPlacement<double>& placement, double approach,
                                                  double view) {
  view_ = view;
  turned_ = placement;
  turned_.rail.frame = seen_from(placement.rail.frame, view);
  turned_.wheel.frame = seen_from(placement.wheel.frame, view);
  points_.clear();
  regions_.clear();
  ++search_;
  ArcPairSearch traversal{*this, approach};
  // the smallest gap is at most that of any point: that of the last search leaves little to look at in a similar state
  traversal.lowest = LocusTracer{*this}.at(nearest_arc_).gap + rounding;
  visit(traversal, traversal.lowest + approach);

  const auto nearest = std::min_element(points_.begin(), points_.end(),
                                        [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
  if (nearest == points_.end()) return {};
  nearest_arc_ = nearest->wheel_arc;
  const double limit = nearest->gap + approach;
  std::erase_if(points_, [&](const ContactPoint& p) { return p.gap > limit; });
  std::sort(points_.begin(), points_.end(),
            [](const ContactPoint& a, const ContactPoint& b) { return a.wheel_arc < b.wheel_arc; });
  // at the joints of arcs a point may be found from both sides
  constexpr double same = 1e-9;
  const auto repeated = std::unique(points_.begin(), points_.end(), [](const ContactPoint& a, const ContactPoint& b) {
    return a.minimum == b.minimum && std::abs(a.s_wheel - b.s_wheel) < same && std::abs(a.s_rail - b.s_rail) < same;
  });
  points_.erase(repeated, points_.end());
  for (ContactPoint& p : points_) {
    p.place = rotation_about_x(view) * p.place;
    p.inclination += view;
  }
  edges_.assign(2 * points_.size(), {});
  return points_;
}

/// Looks at pairs of arcs. From the second of states that are near each other on only those are looked at that any of
/// them may need; the points are the same.
void ContactSearch::visit(ArcPairSearch& traversal, double reach) {
  if (!is_near(middle_, turned_)) {
    middle_ = turned_, reach_ = -std::numeric_limits<double>::infinity();
    return traversal.visit_all();
  }
  if (!(reach - (offset(turned_).z - offset(middle_).z) <= reach_)) {
    middle_ = turned_, reach_ = reach + near_reach;
    if (!traversal.keep(reach_)) reach_ = -std::numeric_limits<double>::infinity();
  }
  reach_ > -std::numeric_limits<double>::infinity() ? traversal.visit_kept() : traversal.visit_all();
}

double ContactSearch::shift(const WheelPlacement<double>& placement) {
  turned_ = placement;
  return LocusTracer{*this}.at(nearest_arc_).gap;
}

std::span<const ContactRegion> ContactSearch::regions(double lowering) {
  regions_.clear();
  LocusTracer walk{*this};
  const std::size_t n = points_.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!(points_[k].gap < lowering)) continue;
    ContactRegion region;
    region.first = k;
    const ContactPoint& first = points_[k];
    region.inner = walk.edge({first.wheel_arc, k > 0 ? points_[k - 1].wheel_arc : 0, k > 0},
                             walk.first_step(first, lowering), lowering, edges_[2 * k]);
    // Between two minima there is a maximum: one that is not among the points is higher than they reach.
    while (k + 1 < n && points_[k + 1].gap < lowering && !(points_[k].minimum && points_[k + 1].minimum)) ++k;
    const ContactPoint& last = points_[k];
    const bool has_next = k + 1 < n;
    region.outer = walk.edge({last.wheel_arc, has_next ? points_[k + 1].wheel_arc : walk.end(), has_next},
                             walk.first_step(last, lowering), lowering, edges_[2 * k + 1]);
    region.count = k + 1 - region.first;
    regions_.push_back(region);
  }
  return regions_;
}

} // namespace microslip
