#pragma once

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/geometry/wheel_locus.hpp"
#include "microslip/railway/profile/profile.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace microslip {

/// A point of the wheel's profile, its circle's lowest point, and where the profile's parameter leads next.
struct WheelAbove {
  ArcPoint profile;
  LocusPoint<double> locus;
  double s = 0; ///< [m]
};
/// The wheel's circle whose lowest line is above a point of the rail [m], found by Newton's method from the profile's
/// parameter on, to `precision` [m].
WheelAbove wheel_above(const WheelLocus<double>& locus, const Profile& wheel, const Vec3<double>& point,
                       double precision, double s);
/// Vertical distance from a point of the rail to the wheel there [m]: what is left to the circle, along the tangent.
double height_above(const LocusPoint<double>& wheel, const Vec3<double>& point);

/// Virtual penetration of wheel and rail in their positions, at points along the rail.
class VirtualPenetration {
public:
  struct Sample {
    double s = 0, wheel_s = 0; ///< parameters of the profiles [m]
    double overlap = 0;        ///< vertical [m]
    double level = 1;          ///< cosine of the rail's inclination
    double curvature = 0;      ///< of both surfaces against each other up to the next sample [1/m], >= 0
    bool last = false;         ///< of its region
  };

  static std::size_t most_samples(const Profile& rail, std::size_t most_regions);

  /// The profiles must outlive it; takes the memory for its samples.
  VirtualPenetration(const Profile& rail, const Profile& wheel, std::size_t most_regions);

  /// Forgets what was found for a wheel elsewhere. Between two calls the wheel may only be lowered or lifted.
  void start() { ++search_; }
  /// Takes the overlap of the wheel placed `depth` [m] below its first touch in its regions: at their ends and at all
  /// multiples of a spacing, 0.25 mm or a 12th of their length, so that sums over samples change continuously as
  /// regions come, part and merge. Cost some 100 ns for
  /// a sample that was not found before.
  void sample(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions, double depth);
  /// About the depth at which the wheel carries a vertical force [N], to some 20 % of the approach where the overlap is
  /// none of Hertz's: the force is that of the overlap's area S along the normal times E*/sqrt(2) r^(1/4) (1 + 0.0225
  /// ln^2 r), r = B/A, which is Hertz's for a parabola of curvature B across and the wheel's, A = level/(2 radius),
  /// along; B is that of a parabola of the same area and depth D, S = 4/3 D sqrt(D/B). `modulus` is E* [Pa].
  double depth_for(double vertical_force, double modulus, double radius) const;
  std::span<const Sample> samples() const { return samples_; }
  double depth() const { return depth_; } ///< [m]
  /// Calls f(k, sample k, sample k + 1) for the intervals between samples of one region.
  template <class Function> void for_each_interval(Function&& f) const {
    for (std::size_t k = 0; k + 1 < samples_.size(); ++k)
      if (!samples_[k].last) f(k, samples_[k], samples_[k + 1]);
  }

private:
  /// The wheel above a point of the rail.
  struct Overlap {
    double wheel_s = 0, overlap = 0, level = 1; ///< as in samples, but overlaps of any sign
    double lean = 0;                            ///< sine of the angle by which the wheel leans against the rail
    double height = 0;                          ///< of the wheel's origin [m]
    std::uint64_t search = 0;                   ///< in which it was found
  };

  Overlap find(const WheelPlacement<double>& placement, const WheelLocus<double>& locus, double s,
               double wheel_s) const;
  Overlap find_kept(const WheelPlacement<double>& placement, const WheelLocus<double>& locus, std::size_t multiple,
                    double wheel_s);
  double add(double s, const Overlap& there);

  const Profile* rail_;
  const Profile* wheel_;
  double depth_ = 0;
  std::uint64_t search_ = 0;
  std::vector<Overlap> overlaps_; ///< at multiples of the longest spacing
  std::vector<Sample> samples_;
};

} // namespace microslip
