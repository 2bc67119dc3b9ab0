#pragma once

#include "simbody.hpp"

#include <cstdint>
#include <memory>
#include <vector>

/// A number along the track with its first two derivatives by the distance.
struct Along {
  double value = 0, slope = 0, bend = 0;

  friend Along operator+(const Along& a, const Along& b) {
    return {a.value + b.value, a.slope + b.slope, a.bend + b.bend};
  }
  friend Along operator*(double f, const Along& a) { return {f * a.value, f * a.slope, f * a.bend}; }
  friend Along operator*(const Along& a, const Along& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope,
            a.bend * b.value + 2 * (a.slope * b.slope) + a.value * b.bend};
  }
};

/// By how much a rail is off its nominal line: to the left and upwards [m].
struct RailLine {
  Along lateral, vertical;
};

/// Random irregularities with the spectra of ERRI B 176, one-sided over the wavenumber W [rad/m]:
///   alignment, longitudinal level  S = A Wc^2 / ((W^2 + Wr^2)(W^2 + Wc^2))                          [m^2/(rad/m)]
///   cross level as an angle        S = A_v/b^2 Wc^2 W^2 / ((W^2 + Wr^2)(W^2 + Wc^2)(W^2 + Ws^2))    [rad^2/(rad/m)]
/// with Wr = 0.0206, Wc = 0.8246, Ws = 0.4380 rad/m, b = 0.75 m, and for the lower level A = A_a = 2.119e-7 m rad of
/// the alignment and A_v = 4.032e-7 m rad of the level (Claus & Schiehlen 1998, after ERRI B 176 RP 1). Wavelengths
/// from 3 to 100 m with random phases, the whole again every 2 km.
class Irregularity {
public:
  explicit Irregularity(std::uint64_t seed);

  /// Lines of the left and the right rail. They begin between 30 and 60 m.
  RailLine left(double distance) const;
  RailLine right(double distance) const;

private:
  enum Signal { alignment, level, cross_level, signals };
  Along at(Signal signal, double distance) const;

  std::vector<Along> nodes_[signals];
};

/// Axes on the track with their origin: x along it, y to the left along its plane, z out of it.
struct TrackFrame {
  SimTK::Transform pose;        ///< in the ground
  double curvature = 0;         ///< [1/m], > 0 in a curve to the left
  SimTK::Vec3 turning{0, 0, 0}; ///< by which angle it turns, about its own axes, for each metre [rad/m]
};

/// A track on level ground that begins at the origin along x. Curvature and cant are linear between knots.
class TrackLine {
public:
  struct Knot {
    double distance = 0;  ///< [m], ascending
    double curvature = 0; ///< [1/m], > 0 in a curve to the left
    double cant = 0;      ///< angle of the track's plane [rad], > 0 where the right rail is higher
  };

  /// Straight for ever.
  TrackLine() : TrackLine({{0, 0, 0}}) {}
  explicit TrackLine(std::vector<Knot> knots, std::shared_ptr<const Irregularity> irregularity = {});
  /// Straight, a transition, an arc, a transition, straight. Curves to the right have a radius < 0.
  static std::vector<Knot> curve(double radius, double cant, double begin, double transition, double arc);
  /// The track in a mirror whose plane is x, z.
  TrackLine mirrored() const;

  /// The distance of the point of the centre line that is nearest to p; `start` [m] is near to it.
  double nearest(const SimTK::Vec3& p, double start) const;
  /// The frame of the track itself.
  TrackFrame centre(double distance) const;
  /// The frame of a rail: that of the track moved and turned as the rail is off its nominal line, where it is straight.
  TrackFrame rail(double distance, bool left) const;
  double curvature(double distance) const { return along(distance).curvature; }

private:
  struct Place {
    double x = 0, y = 0, heading = 0, curvature = 0, bend = 0, cant = 0, twist = 0;
  };
  Place along(double distance) const;
  static Place on(const Place& start, double length);

  std::vector<Knot> knots_;
  std::vector<double> begins_; ///< of pieces that are short enough for the quadrature
  std::vector<Place> starts_;
  std::shared_ptr<const Irregularity> irregularity_;
  bool mirrored_ = false;
};
