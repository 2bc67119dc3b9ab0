#include "microslip/railway/profile/profile_arcs.hpp"

#include "microslip/numerics/cubic_roots.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
/// [m], [rad], of positions and angles.
constexpr double rounding = 1e-13;

/// c0 + c1 t + c2 t^2
using Quadratic = std::array<double, 3>;

/// y' z'' - z' y'', of which the cubic terms cancel.
Quadratic turning(const ProfilePiece& piece) {
  const auto &a = piece.c[1], &b = piece.c[2], &c = piece.c[3];
  return {2 * (a.y * b.z - a.z * b.y), 6 * (a.y * c.z - a.z * c.y), 6 * (b.y * c.z - b.z * c.y)};
}

Quadratic derivative(const ProfilePiece& piece, double ProfilePoint::*coordinate) {
  return {piece.c[1].*coordinate, 2 * (piece.c[2].*coordinate), 3 * (piece.c[3].*coordinate)};
}

Range range_of(const Quadratic& q, double t0, double t1) {
  const auto value = [&](double t) { return q[0] + t * (q[1] + t * q[2]); };
  Range range = Range::between(value(t0), value(t1));
  const double extremum = -q[1] / (2 * q[2]);
  if (extremum > t0 && extremum < t1) range.include(value(extremum));
  return range;
}

/// The angle that differs from `angle` by whole turns and lies within half a turn of `near`.
double nearest(double angle, double near) {
  return angle - 2 * std::numbers::pi * std::round((angle - near) / (2 * std::numbers::pi));
}

double angle_of(const ArcPoint& p) {
  return std::atan2(p.sine, p.cosine);
}

} // namespace

ArcPoint arc_point(const CurvePoint& p, double length) {
  const double speed = std::sqrt(p.first.y * p.first.y + p.first.z * p.first.z), inverse = 1 / speed;
  return {p.value, p.first.y * inverse, p.first.z * inverse, speed * length,
          (p.first.y * p.second.z - p.first.z * p.second.y) * inverse * inverse * length};
}

ArcPoint ProfileArcs::at(const ProfileArc& arc, double u) const {
  if (arc.length == 0) {
    const double alpha = arc.alpha[0] + u * (arc.alpha[1] - arc.alpha[0]);
    return {arc.ends[0].place, std::cos(alpha), std::sin(alpha), 0, arc.alpha[1] - arc.alpha[0]};
  }
  return arc_point(profile_.pieces()[arc.piece].at(arc.start + u * arc.length), arc.length);
}

void ProfileArcs::bound_derivatives(const ProfileArc& arc, double u0, double u1, Range& speed, Range& turn) const {
  if (arc.length == 0) {
    speed = {0, 0};
    turn = {arc.alpha[1] - arc.alpha[0], arc.alpha[1] - arc.alpha[0]};
    return;
  }
  const ProfilePiece& piece = profile_.pieces()[arc.piece];
  const double offset = arc.start - piece.start, t0 = offset + u0 * arc.length, t1 = offset + u1 * arc.length;
  const auto square = [&](double ProfilePoint::*coordinate) {
    const Range r = range_of(derivative(piece, coordinate), t0, t1);
    const double a = r.low * r.low, b = r.high * r.high;
    return Range{r.holds(0) ? 0 : std::min(a, b), std::max(a, b)};
  };
  const Range squares = square(&ProfilePoint::y) + square(&ProfilePoint::z);
  speed = arc.length * Range{std::sqrt(squares.low), std::sqrt(squares.high)};
  turn = arc.length * (range_of(turning(piece), t0, t1) / squares);
}

ProfileArcs::ProfileArcs(Profile profile) : profile_(std::move(profile)) {
  // seen from the body, ends are convex: a rail's direction falls along its surface, a wheel's rises
  const bool rail = profile_.role() == ProfileRole::rail;
  const double outward = rail ? right_angle : -right_angle;
  const auto direction = [&](double s, std::size_t piece) {
    const CurvePoint p = profile_.pieces()[piece].at(s);
    return std::atan2(p.first.z, p.first.y);
  };
  const auto pieces = profile_.pieces();
  double alpha = direction(0, 0);
  if (rail ? alpha < outward : alpha > outward) add_corner(0, 0, Corner::end, outward, alpha);
  std::size_t kink = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (kink < profile_.kinks().size() && profile_.kinks()[kink] == k) {
      const double next = nearest(direction(pieces[k].start, k), alpha);
      if (next != alpha) add_corner(pieces[k].start, k, Corner::kink, alpha, next);
      alpha = next;
      ++kink;
    }
    add_piece(k, alpha);
  }
  if (rail ? alpha > -outward : alpha < -outward)
    add_corner(profile_.length(), pieces.size() - 1, Corner::end, alpha, -outward);
  for (ProfileArc& arc : arcs_) bound_derivatives(arc, 0, 1, arc.speed, arc.turn);
  nodes_.reserve(2 * arcs_.size());
  build(0, arcs_.size());
}

void ProfileArcs::add_corner(double s, std::size_t piece, Corner corner, double from, double to) {
  ProfileArc arc{s, 0, piece, corner, {}, {from, to}, {}, {}};
  arc.ends[0].place = profile_.pieces()[piece].at(s).value;
  arc.ends = {at(arc, 0), at(arc, 1)};
  arcs_.push_back(arc);
}

void ProfileArcs::add_piece(std::size_t k, double& alpha) {
  const ProfilePiece& piece = profile_.pieces()[k];
  std::vector<double> cuts{0, piece.length};
  for (const Quadratic& q : {turning(piece), derivative(piece, &ProfilePoint::y), derivative(piece, &ProfilePoint::z)})
    for (const double t : cubic_roots({q[0], q[1], q[2], 0}, 0, piece.length))
      if (t > 0 && t < piece.length) cuts.push_back(t);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (!(cuts[i + 1] > cuts[i])) continue;
    ProfileArc arc{piece.start + cuts[i], cuts[i + 1] - cuts[i], k, Corner::none, {}, {}, {}, {}};
    arc.ends = {at(arc, 0), at(arc, 1)};
    arc.alpha[0] = nearest(angle_of(arc.ends[0]), alpha);
    arc.alpha[1] = nearest(angle_of(arc.ends[1]), arc.alpha[0]);
    alpha = arc.alpha[1];
    arcs_.push_back(arc);
  }
}

void ProfileArcs::build(std::size_t first, std::size_t count) {
  const std::size_t place = nodes_.size();
  nodes_.emplace_back();
  ArcNode node;
  node.first = first;
  node.count = count;
  if (count > 1) {
    build(first, count / 2);
    node.second = nodes_.size();
    build(first + count / 2, count - count / 2);
    for (const std::size_t half : {place + 1, node.second}) {
      node.y.include(nodes_[half].y);
      node.z.include(nodes_[half].z);
      node.alpha.include(nodes_[half].alpha);
    }
  } else {
    const ProfileArc& arc = arcs_[first];
    for (const ArcPoint& end : arc.ends) {
      node.y.include(end.place.y);
      node.z.include(end.place.z);
    }
    node.alpha = Range::between(arc.alpha[0], arc.alpha[1]);
    // arcs that join must not leave a gap of rounding between them
    node.y = {node.y.low - rounding, node.y.high + rounding};
    node.z = {node.z.low - rounding, node.z.high + rounding};
    node.alpha = {node.alpha.low - rounding, node.alpha.high + rounding};
  }
  node.sine = {std::sin(node.alpha.low), std::sin(node.alpha.high)};
  node.cosine = {std::cos(node.alpha.low), std::cos(node.alpha.high)};
  node.one_branch = std::round(node.alpha.low / std::numbers::pi) == std::round(node.alpha.high / std::numbers::pi);
  node.tangent = {std::tan(node.alpha.low), std::tan(node.alpha.high)};
  nodes_[place] = node;
}

} // namespace microslip
