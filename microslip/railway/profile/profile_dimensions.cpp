#include "microslip/railway/profile/profile_dimensions.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace microslip {
namespace {

using Coordinate = double ProfilePoint::*;

constexpr double tape_to_back = 0.070; // of the flange, by EN 15313 [m]

double value_at(const ProfilePiece& piece, Coordinate coordinate, double t) {
  return piece.c[0].*coordinate +
         t * (piece.c[1].*coordinate + t * (piece.c[2].*coordinate + t * (piece.c[3].*coordinate)));
}

/// t of the ends of the parts on which a piece's coordinate is monotone, both ends of the piece included.
struct MonotoneParts {
  std::array<double, 4> t{};
  std::size_t count = 0;

  std::span<const double> ends() const { return std::span(t).first(count); }
};

MonotoneParts monotone_parts(const ProfilePiece& piece, Coordinate coordinate) {
  const double a = 3 * piece.c[3].*coordinate, b = 2 * piece.c[2].*coordinate, c = piece.c[1].*coordinate;
  MonotoneParts parts;
  const auto add = [&](double t) { parts.t[parts.count++] = t; };
  const auto add_inner = [&](double t) {
    if (t > parts.t[parts.count - 1] && t < piece.length) add(t);
  };
  add(0);
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0) { // the roots of a t^2 + b t + c, without cancellation
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    double first = a != 0 ? q / a : 0, second = q != 0 ? c / q : 0;
    if (first > second) std::swap(first, second);
    add_inner(first);
    add_inner(second);
  }
  add(piece.length);
  return parts;
}

/// The root of a monotone coordinate between two t at which it lies on either side of the value.
double root(const ProfilePiece& piece, Coordinate coordinate, double value, double low, double high) {
  const bool rises = value_at(piece, coordinate, high) > value_at(piece, coordinate, low);
  for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
    ((value_at(piece, coordinate, middle) < value) == rises ? low : high) = middle;
  return (low + high) / 2;
}

template <class Better>
double extreme(const Profile& profile, Coordinate coordinate, double first, double last, Better better) {
  double best = first, best_value = profile.at(first).value.*coordinate;
  const auto consider = [&](double s) {
    if (s < first || s > last) return;
    const double value = profile.at(s).value.*coordinate;
    if (better(value, best_value)) {
      best = s;
      best_value = value;
    }
  };
  for (std::size_t k = profile.piece_at(first); k <= profile.piece_at(last); ++k) {
    const auto parts = monotone_parts(profile.pieces()[k], coordinate);
    for (const double t : parts.ends()) consider(profile.pieces()[k].start + t);
  }
  consider(last);
  return best;
}

/// y of the first crossing of z = `height` after s = `from`.
std::optional<double> y_at_height(const Profile& profile, double height, double from) {
  for (const double s : crossings(profile, &ProfilePoint::z, height))
    if (s >= from) return profile.at(s).value.y;
  return {};
}

/// The largest inclination of the curve between two s [rad], by some points of each piece.
double steepest(const Profile& profile, double first, double last) {
  constexpr int points = 8;
  double most = 0;
  for (std::size_t k = profile.piece_at(first); k <= profile.piece_at(last); ++k)
    for (int i = 0; i <= points; ++i) {
      const ProfilePiece& piece = profile.pieces()[k];
      const double s = piece.start + piece.length * i / points;
      if (s < first || s > last) continue;
      const ProfilePoint along = piece.at(s).first;
      most = std::max(most, std::atan2(along.z, along.y));
    }
  return most;
}

} // namespace

std::vector<double> crossings(const Profile& profile, Coordinate coordinate, double value) {
  std::vector<double> found;
  for (const auto& piece : profile.pieces()) {
    const auto parts = monotone_parts(piece, coordinate);
    for (std::size_t i = 0; i + 1 < parts.count; ++i) {
      const double low = parts.t[i], high = parts.t[i + 1];
      const double before = value_at(piece, coordinate, low) - value, after = value_at(piece, coordinate, high) - value;
      const bool is_last = &piece == &profile.pieces().back() && i + 2 == parts.count;
      if (before == 0) found.push_back(piece.start + low);
      if (before * after < 0) found.push_back(piece.start + root(piece, coordinate, value, low, high));
      if (is_last && after == 0) found.push_back(piece.start + high);
    }
  }
  return found;
}

double lowest(const Profile& profile, Coordinate coordinate, double first, double last) {
  return extreme(profile, coordinate, first, last, [](double a, double b) { return a < b; });
}

double highest(const Profile& profile, Coordinate coordinate, double first, double last) {
  return extreme(profile, coordinate, first, last, [](double a, double b) { return a > b; });
}

double default_tape_line(const Profile& wheel) {
  constexpr double near = 3e-3;
  const double s = lowest(wheel, &ProfilePoint::y, 0, wheel.length());
  const double back = wheel.at(s).value.y;
  if (std::abs(back + tape_to_back) < near) return 0;
  return std::abs(back) < near ? tape_to_back : back + tape_to_back;
}

WheelDimensions wheel_dimensions(const Profile& wheel, double tape_line) {
  constexpr double below_tape = 0.010, above_tip = 0.002;
  require_finite("tape_line", tape_line, "m");
  WheelDimensions dimensions;
  dimensions.tape_line = tape_line;
  const double tip = lowest(wheel, &ProfilePoint::z, 0, wheel.length()), tip_z = wheel.at(tip).value.z;
  const auto at_tape = crossings(wheel, &ProfilePoint::y, tape_line);
  const auto tread = std::find_if(at_tape.begin(), at_tape.end(), [tip](double s) { return s > tip; });
  if (tread == at_tape.end()) return dimensions;
  const double tread_z = wheel.at(*tread).value.z;
  dimensions.tape_circle = tread_z;
  dimensions.flange_height = tread_z - tip_z;
  dimensions.flange_angle = steepest(wheel, tip, *tread);
  const auto front = y_at_height(wheel, tread_z - below_tape, tip);
  if (!front || tread_z - below_tape < tip_z) return dimensions;
  dimensions.flange_thickness = *front - (tape_line - tape_to_back);
  if (const auto near_tip = y_at_height(wheel, tip_z + above_tip, tip)) dimensions.flange_gradient = *front - *near_tip;
  return dimensions;
}

GaugePoint gauge_point(const Profile& rail, double height) {
  require_positive("gauge_height", height, "m");
  const double top = highest(rail, &ProfilePoint::z, 0, rail.length());
  GaugePoint gauge;
  gauge.top = rail.at(top).value;
  // The part between the top and the last passage of the height before it.
  double first = 0;
  for (const double s : crossings(rail, &ProfilePoint::z, gauge.top.z - height))
    if (s < top) {
      first = s;
      gauge.reaches_height = true;
    }
  gauge.s = lowest(rail, &ProfilePoint::y, first, top);
  gauge.point = rail.at(gauge.s).value;
  return gauge;
}

} // namespace microslip
