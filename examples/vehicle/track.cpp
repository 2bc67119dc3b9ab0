#include "track.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

using SimTK::Rotation, SimTK::Vec3;

namespace {

constexpr double period = 2000, spacing = 0.5;   // of the table [m]
constexpr double shortest = 3, longest = 100;    // wavelengths [m]
constexpr double half_distance = 0.75;           // between the contacts [m]
constexpr double fade_begin = 30, fade_end = 60; // [m]
constexpr double piece = 5;                      // longest piece of the quadrature [m]

/// S(W) without its amplitude.
double spectrum(double w, bool cross_level) {
  constexpr double wr = 0.0206, wc = 0.8246, ws = 0.4380;
  const double s = wc * wc / ((w * w + wr * wr) * (w * w + wc * wc));
  return cross_level ? s * w * w / ((w * w + ws * ws) * half_distance * half_distance) : s;
}

/// The polynomial of degree 5 that has both nodes' values and derivatives, at a part t of the way from one to the
/// other.
Along between(const Along& a, const Along& b, double h, double t) {
  const double rest = b.value - a.value - h * a.slope - h * h / 2 * a.bend,
               slope = h * (b.slope - a.slope - h * a.bend), bend = h * h * (b.bend - a.bend);
  const double c3 = 10 * rest - 4 * slope + bend / 2, c4 = -15 * rest + 7 * slope - bend,
               c5 = 6 * rest - 3 * slope + bend / 2;
  return {a.value + t * (h * a.slope + t * (h * h / 2 * a.bend + t * (c3 + t * (c4 + t * c5)))),
          a.slope + t * (h * a.bend + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)) / h),
          a.bend + t * (6 * c3 + t * (12 * c4 + t * 20 * c5)) / (h * h)};
}

/// Rises from 0 to 1.
Along fade(double distance) {
  if (distance <= fade_begin) return {};
  if (distance >= fade_end) return {1, 0, 0};
  constexpr double length = fade_end - fade_begin;
  return between({}, {1, 0, 0}, length, (distance - fade_begin) / length);
}

} // namespace

Irregularity::Irregularity(std::uint64_t seed) {
  constexpr double amplitude[] = {2.119e-7, 4.032e-7, 4.032e-7}; // [m rad]
  const auto count = static_cast<std::size_t>(period / spacing);
  const int first = static_cast<int>(period / longest), last = static_cast<int>(period / shortest);
  std::mt19937_64 random(seed);
  for (int signal = 0; signal < signals; ++signal) {
    auto& nodes = nodes_[signal];
    nodes.assign(count, {});
    for (int wave = first; wave <= last; ++wave) {
      const double step = 2 * std::numbers::pi / period, w = wave * step;
      const double size = std::sqrt(2 * amplitude[signal] * spectrum(w, signal == cross_level) * step);
      const double phase = 2 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1p-53;
      for (std::size_t k = 0; k < count; ++k) {
        const double angle = w * spacing * static_cast<double>(k) + phase;
        const double c = size * std::cos(angle), s = size * std::sin(angle);
        nodes[k] = nodes[k] + Along{c, -w * s, -w * w * c};
      }
    }
  }
}

Along Irregularity::at(Signal signal, double distance) const {
  const auto& nodes = nodes_[signal];
  const double place = (distance / period - std::floor(distance / period)) * static_cast<double>(nodes.size());
  const auto k = std::min(static_cast<std::size_t>(place), nodes.size() - 1);
  return between(nodes[k], nodes[(k + 1) % nodes.size()], spacing, place - static_cast<double>(k));
}

RailLine Irregularity::left(double distance) const {
  const Along part = fade(distance);
  return {part * at(alignment, distance), part * (at(level, distance) + half_distance * at(cross_level, distance))};
}

RailLine Irregularity::right(double distance) const {
  const Along part = fade(distance);
  return {part * at(alignment, distance), part * (at(level, distance) + -half_distance * at(cross_level, distance))};
}

TrackLine::TrackLine(std::vector<Knot> knots, std::shared_ptr<const Irregularity> irregularity)
    : knots_(std::move(knots)), irregularity_(std::move(irregularity)) {
  Place place;
  for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
    const Knot &from = knots_[k], &to = knots_[k + 1];
    const double length = to.distance - from.distance;
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / piece)));
    place.bend = (to.curvature - from.curvature) / length, place.twist = (to.cant - from.cant) / length;
    place.curvature = from.curvature, place.cant = from.cant;
    for (int i = 0; i < pieces; ++i) {
      begins_.push_back(from.distance + length * i / pieces), starts_.push_back(place);
      place = on(place, length / pieces);
    }
  }
  place.bend = place.twist = 0, place.curvature = knots_.back().curvature, place.cant = knots_.back().cant;
  begins_.push_back(knots_.back().distance), starts_.push_back(place);
}

std::vector<TrackLine::Knot> TrackLine::curve(double radius, double cant, double begin, double transition, double arc) {
  const double angle = std::copysign(cant, radius);
  return {{0, 0, 0},
          {begin, 0, 0},
          {begin + transition, 1 / radius, angle},
          {begin + transition + arc, 1 / radius, angle},
          {begin + 2 * transition + arc, 0, 0}};
}

TrackLine TrackLine::mirrored() const {
  std::vector<Knot> knots = knots_;
  for (Knot& knot : knots) knot.curvature = -knot.curvature, knot.cant = -knot.cant;
  TrackLine track(std::move(knots), irregularity_);
  track.mirrored_ = !mirrored_;
  return track;
}

/// x = integral of cos of the heading, a polynomial of degree 2, by five points of Gauss and Legendre.
TrackLine::Place TrackLine::on(const Place& start, double length) {
  constexpr std::array points = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array weights = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const auto heading = [&](double s) { return start.heading + s * (start.curvature + s * start.bend / 2); };
  Place place = start;
  const double half = length / 2;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const double side : {-1.0, 1.0}) {
      if (k == 0 && side > 0) continue;
      const double angle = heading(half * (1 + side * points[k]));
      place.x += half * weights[k] * std::cos(angle), place.y += half * weights[k] * std::sin(angle);
    }
  place.heading = heading(length);
  place.curvature = start.curvature + length * start.bend, place.cant = start.cant + length * start.twist;
  return place;
}

TrackLine::Place TrackLine::along(double distance) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), distance);
  const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - begins_.begin() - 1));
  return on(starts_[k], distance - begins_[k]);
}

double TrackLine::nearest(const Vec3& p, double start) const {
  double s = start;
  for (int round = 0; round < 20; ++round) {
    const Place c = along(s);
    const double dx = p[0] - c.x, dy = p[1] - c.y, cosine = std::cos(c.heading), sine = std::sin(c.heading);
    const double step = (dx * cosine + dy * sine) / (1 - c.curvature * (dy * cosine - dx * sine));
    s += step;
    if (std::abs(step) < 1e-9) break;
  }
  return s;
}

TrackFrame TrackLine::centre(double distance) const {
  const Place p = along(distance);
  const Rotation axes = Rotation(p.heading, SimTK::ZAxis) * Rotation(-p.cant, SimTK::XAxis);
  return {{axes, Vec3(p.x, p.y, 0)},
          p.curvature,
          Vec3(-p.twist, -std::sin(p.cant) * p.curvature, std::cos(p.cant) * p.curvature)};
}

TrackFrame TrackLine::rail(double distance, bool left) const {
  TrackFrame frame = centre(distance);
  if (!irregularity_) return frame;
  RailLine line = left != mirrored_ ? irregularity_->left(distance) : irregularity_->right(distance);
  if (mirrored_) line.lateral = -1.0 * line.lateral;
  const Rotation turned =
      Rotation(std::atan(line.lateral.slope), SimTK::ZAxis) * Rotation(-std::atan(line.vertical.slope), SimTK::YAxis);
  frame.pose = frame.pose * SimTK::Transform(turned, Vec3(0, line.lateral.value, line.vertical.value));
  frame.curvature += line.lateral.bend;
  frame.turning += Vec3(0, -line.vertical.bend, line.lateral.bend);
  return frame;
}
