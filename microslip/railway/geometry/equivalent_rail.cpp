#include "microslip/railway/geometry/equivalent_rail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

constexpr double nowhere = 1; // gap where there is no surface [m]

/// The unit normal at a profile's parameter, out of the rail and into the wheel.
ProfilePoint normal_at(const Profile& profile, double s) {
  const ProfilePoint d = profile.at(s).first;
  const double length = std::hypot(d.y, d.z);
  return {-d.z / length, d.y / length};
}

/// GapLine across the track through a point that moves along it, and where they meet both surfaces.
class GapLine {
public:
  GapLine(const TrueSurfaces& surfaces, const WheelPlacement<double>& placement, const Vec3<double>& point,
          const Vec3<double>& direction, SurfaceHit rail, SurfaceHit wheel)
      : surfaces_(&surfaces), placement_(&placement), point_(point), direction_(direction), rail_(rail), wheel_(wheel) {
  }

  /// Distance from the rail to the wheel at x of the track axes, by Newton's method from the last position.
  std::optional<double> distance(double x) {
    const Vec3<double> from{x, point_.y, point_.z};
    if (!find_on_rail(surfaces_->rail, *placement_, from, direction_, rail_)) return {};
    if (!find_on_wheel(surfaces_->wheel, *placement_, from, direction_, wheel_)) return {};
    return wheel_.n - rail_.n;
  }
  /// Distance from the point to the wheel alone.
  std::optional<double> distance_of_wheel(double x) {
    if (!find_on_wheel(surfaces_->wheel, *placement_, {x, point_.y, point_.z}, direction_, wheel_)) return {};
    return wheel_.n;
  }
  const SurfaceHit& rail() const { return rail_; }
  const SurfaceHit& wheel() const { return wheel_; }

private:
  const TrueSurfaces* surfaces_;
  const WheelPlacement<double>* placement_;
  Vec3<double> point_, direction_;
  SurfaceHit rail_, wheel_;
};

struct Least {
  double x = 0, value = 0, curvature = 0;
};

/// The least value of a function of x near by: Newton's method with differences.
template <class Function> std::optional<Least> find_least(Function function, double x) {
  constexpr int most_steps = 40;
  constexpr double step = 2e-4, exact = 1e-9, least_curvature = 0.05; // [m], [m], [1/m]
  double longest = 5e-3, before = 0;
  for (int k = 0; k < most_steps; ++k) {
    const auto low = function(x - step), here = function(x), high = function(x + step);
    if (!low || !here || !high) return {};
    const double slope = (*high - *low) / (2 * step), curvature = (*high - 2 * *here + *low) / (step * step);
    const double newton = curvature > least_curvature ? -slope / curvature : -std::copysign(longest, slope);
    if (newton * before < 0 && std::abs(newton) > std::abs(before) / 2) longest /= 2; // to and fro
    const double move = std::clamp(newton, -longest, longest);
    if (std::abs(move) < exact || k + 1 == most_steps)
      return Least{x + move, *here + move * slope / 2, std::max(curvature, least_curvature)};
    x += move, before = move;
  }
  return {};
}

/// Whether two positions along the track [m] are those of different least distances.
bool are_apart(double a, double b) {
  return std::abs(a - b) > 5e-3;
}

/// dn/dx of the rail; 0 where it begins or ends.
double rail_slope(GapLine line, double x) {
  constexpr double step = 2e-4; // [m]
  if (!line.distance(x - step)) return 0;
  const double behind = line.rail().n;
  return line.distance(x + step) ? (line.rail().n - behind) / (2 * step) : 0;
}

/// Position along the track, around x, of the least distance.
double position_of_least_distance(GapLine line, double x) {
  constexpr int to_each_side = 6;
  constexpr double apart = 5e-3; // [m]
  double lowest = std::numeric_limits<double>::infinity(), position = x;
  for (int k = -to_each_side; k <= to_each_side; ++k) {
    const auto distance = line.distance(x + k * apart);
    if (distance && *distance < lowest) lowest = *distance, position = x + k * apart;
  }
  return position;
}

/// The number of the profile's point that is nearest to a position.
double nearest_point(const Profile& profile, const ProfilePoint& position) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t number = 0;
  for (std::size_t k = 0; k < profile.pieces().size(); ++k) {
    const ProfilePoint p = profile.pieces()[k].c[0];
    const double distance = std::hypot(p.y - position.y, p.z - position.z);
    if (distance < nearest) nearest = distance, number = k;
  }
  return static_cast<double>(number);
}

} // namespace

/// A point of the rail's section, and what is above it.
struct EquivalentRail::Above {
  ProfilePoint point, normal; ///< in the axes of the rail's profile
  double number = 0;          ///< in the rail's section
  std::optional<Least> round; ///< distance of the round wheel from it
  double wheel_v = 0;         ///< there
  double moved = 0;           ///< along the normal [m]
  Along along = {};
  SurfaceHit rail_hit = {}, wheel_hit = {}; ///< where the true surfaces are nearest
  bool is_found = false;                    ///< these four

  Vec3<double> position(const WheelPlacement<double>& placement) const {
    return placement.rail.frame.outer({0, point.y, point.z});
  }
  Vec3<double> direction(const WheelPlacement<double>& placement) const {
    return placement.rail.frame.axes * Vec3<double>{0, normal.y, normal.z};
  }
};

/// Least distances of the round wheel from the points of the rail's section, each found from the one before. Beneath
/// the fillet of a yawed wheel's flange there are two along the track: where a point differs from the one behind it,
/// the lesser of both counts.
std::vector<EquivalentRail::Above> EquivalentRail::find_round_wheel(const TrueSurfaces& round,
                                                                    const WheelPlacement<double>& placement) {
  const Profile &rail = *round.rail.profile, &wheel = *round.wheel.profile;
  const Frame<double>& frame = placement.wheel.frame;
  const auto find = [&](Above& a, double x, double v) {
    GapLine line(round, placement, a.position(placement), a.direction(placement), {}, {0, v});
    const auto found = find_least([&](double at) { return line.distance_of_wheel(at); }, x);
    if (found && (!a.round || found->value < a.round->value)) a.round = found, a.wheel_v = line.wheel().v;
  };
  std::vector<Above> all;
  std::optional<double> start; // the wheel's v
  double x = frame.origin.x;
  for (std::size_t k = 0; k <= rail.pieces().size(); ++k) {
    const auto number = static_cast<double>(k);
    const double s = parameter_at(rail, number);
    Above& a = all.emplace_back(Above{rail.at(s).value, normal_at(rail, s), number, {}});
    if (!start) {
      const Vec3<double> position = frame.inner(a.position(placement) + Vec3<double>{x, 0, 0});
      start = nearest_point(wheel, {position.y, placement.radius + position.z});
    }
    find(a, x, *start);
    start.reset();
    if (a.round) start = a.wheel_v, x = a.round->x;
  }
  for (std::size_t k = all.size() - 1; k-- > 0;)
    if (const Above& next = all[k + 1]; next.round && (!all[k].round || are_apart(next.round->x, all[k].round->x)))
      find(all[k], next.round->x, next.wheel_v);
  return all;
}

EquivalentRail::EquivalentRail(const TrueSurfaces& surfaces, const WheelPlacement<double>& placement)
    : surfaces_(surfaces), rail_(*surfaces.rail.profile), wheel_(*surfaces.wheel.profile) {
  const double x = placement.wheel.frame.origin.x;
  const ProfileSection rail = section_at(surfaces.rail, placement.longitudinal + x);
  const ProfileSection wheel = section_at(surfaces.wheel, placement.pitch);
  first_rail_ = rail.first, first_wheel_ = wheel.first;
  wheel_ = wheel.profile;
  std::vector<Above> all = find_round_wheel({{&rail.profile, nullptr}, {&wheel.profile, nullptr}}, placement);
  move_points(placement, all);

  follow_neighbours(all);
  std::vector<ProfilePoint> points;
  for (const Above& a : all) {
    along_.push_back(a.along);
    points.push_back({a.point.y + a.moved * a.normal.y, a.point.z + a.moved * a.normal.z});
  }
  rail_ = Profile(ProfileRole::rail, points, rail.profile.kinks());
}

/// Moves the points that are not far from the wheel to the least distances of the true surfaces. These may be nearest
/// where the round wheel and the prismatic rail are not: a roller falls away beneath the flange of a yawed wheel.
void EquivalentRail::move_points(const WheelPlacement<double>& placement, std::vector<Above>& all) const {
  constexpr double near = 8e-3; // [m], over the least distance: beyond there is no contact
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity, before = -infinity;
  for (const Above& a : all) least = a.round ? std::min(least, a.round->value) : least;
  for (double most = least + near; most > before;) { // of the round wheel's distances: as many as may be the least ones
    const auto move_all = [&](auto first, auto last) {
      const Above* neighbour = nullptr;
      for (auto a = first; a != last; neighbour = &*a++)
        if (a->round && a->round->value <= most) move_point(placement, *a, neighbour);
    };
    move_all(all.begin(), all.end());
    move_all(all.rbegin(), all.rend());
    double most_moved = 0;
    least = infinity;
    for (const Above& a : all)
      if (a.is_found) least = std::min(least, a.round->value - a.moved), most_moved = std::max(most_moved, a.moved);
    before = std::exchange(most, least + most_moved + near);
  }
}

/// Moves a point to the least distance around the round wheel's, or to a lesser one where its neighbour's is.
void EquivalentRail::move_point(const WheelPlacement<double>& placement, Above& a, const Above* neighbour) const {
  const auto move = [&](GapLine line, double start) {
    const auto found = find_least([&](double x) { return line.distance(x); }, start);
    if (!found || !line.distance(found->x)) return;
    const double moved = a.round->value - found->value;
    if (a.is_found && moved <= a.moved) return;
    a.moved = moved, a.is_found = true;
    a.rail_hit = line.rail(), a.wheel_hit = line.wheel();
    a.along = {found->x, found->curvature, line.rail().n - a.moved, rail_slope(line, found->x)};
  };
  const auto line = [&](const SurfaceHit& rail, const SurfaceHit& wheel) {
    return GapLine(surfaces_, placement, a.position(placement), a.direction(placement), rail, wheel);
  };
  if (!a.is_found) {
    const GapLine of_round = line({0, first_rail_ + a.number}, {a.round->value, first_wheel_ + a.wheel_v});
    move(of_round, position_of_least_distance(of_round, a.round->x));
  }
  if (neighbour && neighbour->is_found && (!a.is_found || are_apart(neighbour->along.x, a.along.x)))
    move(line(neighbour->rail_hit, neighbour->wheel_hit), neighbour->along.x);
}

EquivalentRail::Along EquivalentRail::between(const Along& a, const Along& b, double share) {
  const auto of = [share](double from, double to) { return from + share * (to - from); };
  return {of(a.x, b.x), of(a.curvature, b.curvature), of(a.rise, b.rise), of(a.slope, b.slope)};
}

/// Moves the points that are not found: between two that are by what is interpolated between these, so that there is no
/// step for the wheel to touch, others as the nearest one.
void EquivalentRail::follow_neighbours(std::vector<Above>& all) {
  const auto is_found = [](const Above& a) { return a.is_found; };
  auto before = std::find_if(all.begin(), all.end(), is_found);
  if (before == all.end()) return;
  for (auto a = all.begin(); a != before; ++a) a->moved = before->moved, a->along = before->along;
  while (before != all.end()) {
    const auto first = before + 1, found = std::find_if(first, all.end(), is_found);
    const Above& after = found == all.end() ? *before : *found;
    for (auto a = first; a != found; ++a) {
      const double share = static_cast<double>(a - before) / static_cast<double>(found - before);
      a->moved = before->moved + share * (after.moved - before->moved);
      a->along = between(before->along, after.along, share);
    }
    before = found;
  }
}

EquivalentRail::Along EquivalentRail::at(double rail_s) const {
  const auto last = static_cast<double>(along_.size() - 1);
  const double number = std::clamp(number_at(rail_, rail_s), 0.0, last), share = number - std::floor(number);
  const auto k = static_cast<std::size_t>(number);
  return between(along_[k], along_[std::min(k + 1, along_.size() - 1)], share);
}

void EquivalentRail::find_gaps(const WheelPlacement<double>& placement, const Vec3<double>& point,
                               const Vec3<double>& normal, double rail_s, double& wheel_s, std::span<const double> x,
                               std::span<double> gaps) const {
  const GapLine first(surfaces_, placement, point, normal, {at(rail_s).rise, first_rail_ + number_at(rail_, rail_s)},
                      {0, first_wheel_ + number_at(wheel_, wheel_s)});
  GapLine line = first;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto gap = line.distance(point.x + x[i]);
    gaps[i] = gap.value_or(nowhere);
    if (!gap)
      line = first;
    else if (i == x.size() / 2)
      wheel_s = parameter_at(wheel_, line.wheel().v - first_wheel_);
  }
}

std::optional<EquivalentRail::Stretch> EquivalentRail::find_overlap(const WheelPlacement<double>& placement,
                                                                    double rail_s, double wheel_s) const {
  constexpr double step = 5e-4;               // [m]
  constexpr int most_steps = 400, apart = 16; // overlaps further apart are other contacts
  const Frame<double>& frame = placement.rail.frame;
  const ProfilePoint p = rail_.at(rail_s).value, n = normal_at(rail_, rail_s);
  const Along along = at(rail_s);
  Stretch stretch{along.x, along.x};
  bool overlaps = false;
  for (const double sign : {-1.0, 1.0}) {
    GapLine line(surfaces_, placement, frame.outer({0, p.y, p.z}), frame.axes * Vec3<double>{0, n.y, n.z},
                 {along.rise, first_rail_ + number_at(rail_, rail_s)}, {0, first_wheel_ + number_at(wheel_, wheel_s)});
    for (int k = 0, last = 0; k < most_steps && k - last <= apart; ++k) {
      const double x = along.x + sign * k * step;
      const auto distance = line.distance(x);
      if (!distance || !(*distance < 0)) continue;
      last = k, overlaps = true;
      (sign < 0 ? stretch.low : stretch.high) = x + sign * step;
    }
  }
  return overlaps ? std::optional(stretch) : std::nullopt;
}

} // namespace microslip
