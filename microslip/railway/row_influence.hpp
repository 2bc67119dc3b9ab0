#pragma once

#include "microslip/numerics/bits.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace microslip {

/// The displacement of a half-space under strips on which the pressure is semi-elliptic along x, p = 2 q/(pi a)
/// sqrt(1 - x^2/a^2), and uniform across, as functions of the distance from a strip's edge over its half-length, delta:
/// at x = 0 the line of pressure at the distance delta gives u = C (2 q/pi) f(delta) for each unit of width over a,
/// with C = (1 - nu)/(pi G) and
///   f(delta) = integral over [-1, 1] of sqrt((1 - t^2)/(t^2 + delta^2)) dt = 2 D/sqrt(1 + delta^2),
/// D the elliptic integral of the complementary modulus delta/sqrt(1 + delta^2). As f is harmonic about the line,
/// its curvature along x is d^2 f/dx^2 = -f/(1 + delta^2), in units of a.
class RowInfluence {
public:
  RowInfluence();

  /// Integrals from 0 to delta: Phi of f, Psi of f/(1 + delta^2), both odd; and f and psi themselves.
  struct Values {
    double phi, psi, f, curvature;
  };
  /// To 1e-6 relative. Cost some 4 ns.
  Values at(double delta) const {
    const double size = std::abs(delta);
    if (!(size >= smallest)) return near(delta);
    if (!(size < largest)) return far(delta);
    // The first bits of a number's mantissa and its exponent count the segments, some of each octave.
    const auto segment = static_cast<std::size_t>((bit_cast<std::uint64_t>(size) >> bits_dropped) - first_segment);
    const Segment& s = segments_[segment];
    const double t = size - s.start;
    const double phi = s.phi[0] + t * (s.phi[1] + t * (s.phi[2] + t * s.phi[3]));
    const double psi = s.psi[0] + t * (s.psi[1] + t * (s.psi[2] + t * s.psi[3]));
    const double f = s.phi[1] + t * (2 * s.phi[2] + t * 3 * s.phi[3]);
    const double curvature = s.psi[1] + t * (2 * s.psi[2] + t * 3 * s.psi[3]);
    return {std::copysign(phi, delta), std::copysign(psi, delta), f, curvature};
  }
  /// f(delta) and f/(1 + delta^2) by the integral itself.
  static double line(double delta);

private:
  static constexpr int bits_dropped = 48; ///< leaves 16 segments in each octave
  static constexpr double smallest = 0x1p-10, largest = 0x1p8;
  static constexpr std::uint64_t first_segment = bit_cast<std::uint64_t>(smallest) >> bits_dropped;

  /// Cubics in delta - start.
  struct Segment {
    double start;
    std::array<double, 4> phi, psi;
  };
  Values near(double delta) const;
  Values far(double delta) const;

  std::vector<Segment> segments_;
  double phi_at_largest_ = 0, psi_at_largest_ = 0;
};

} // namespace microslip
