// Worn hollow wheels, alike and beside new ones: rolling radius difference against a dense grid of both profiles,
// equivalent conicity against the motion integrated in time.

#include "microslip/railway/geometry/conicity.hpp"

#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace microslip {
namespace {

const WheelsetBase base{1.5, 0.46};

/// S1002 with a tread that is worn by `depth` [m] in the middle of a hollow from y = -20 to 30 mm.
Profile hollow_wheel(double depth) {
  const Profile whole = example_profile("s1002.prw");
  std::vector<ProfilePoint> points;
  const auto add = [&](ProfilePoint p) {
    const double t = std::clamp((p.y - 0.005) / 0.025, -1.0, 1.0);
    points.push_back({p.y, p.z + depth * (1 - t * t) * (1 - t * t)});
  };
  for (const ProfilePiece& piece : whole.pieces()) add(piece.c[0]);
  add(whole.at(whole.length()).value);
  return Profile(ProfileRole::wheel, points);
}

/// Both profiles in the track's axes of the left side without roll and yaw, sampled every hundredth of a millimetre.
class DenseSide {
public:
  DenseSide(const Track& track, const Profile& rail, const Profile& wheel) : wheel_(wheel) {
    const Frame<double> frame = place_rail(track, rail);
    lateral_ = place_wheel({}, wheel).lateral;
    const int count = static_cast<int>(rail.length() / 1e-5);
    for (int k = 0; k <= count; ++k) {
      const ProfilePoint p = rail.at(rail.length() * k / count).value;
      const Vec3<double> place = frame.outer({0, p.y, p.z});
      if (y_.empty() || place.y > y_.back()) y_.push_back(place.y), z_.push_back(place.z);
    }
  }

  /// The wheel's height above the profile's zero where it touches first, or nothing where another point is as near
  /// within a micrometre and a millimetre away.
  std::optional<double> touched_height(double lateral) const {
    struct GapPoint {
      double gap, y, z;
    };
    std::vector<GapPoint> points;
    GapPoint least{1, 0, 0};
    const int count = static_cast<int>(wheel_.length() / 1e-5);
    for (int k = 0; k <= count; ++k) {
      const ProfilePoint p = wheel_.at(wheel_.length() * k / count).value;
      const double y = lateral_ + lateral + p.y;
      const auto after = std::upper_bound(y_.begin(), y_.end(), y);
      if (after == y_.begin() || after == y_.end()) continue;
      const auto i = static_cast<std::size_t>(after - y_.begin());
      const double t = (y - y_[i - 1]) / (y_[i] - y_[i - 1]);
      points.push_back({p.z - (1 - t) * z_[i - 1] - t * z_[i], y, p.z});
      if (points.back().gap < least.gap) least = points.back();
    }
    for (const GapPoint& other : points)
      if (std::abs(other.y - least.y) > 1e-3 && other.gap < least.gap + 1e-6) return std::nullopt;
    return least.z;
  }

private:
  Profile wheel_;
  double lateral_ = 0;
  std::vector<double> y_, z_;
};

TEST(HollowWheel, RollingRadiiAreThoseOfADenseGrid) {
  Track track;
  track.cant = 1.0 / 40;
  const Profile rail = example_profile("60e1.prr"), worn = hollow_wheel(2e-3), fresh = example_profile("s1002.prw");
  for (const Profile* right : {&worn, &fresh}) {
    WheelsetSearch search(track, {}, {rail, worn}, {rail, *right});
    const DenseSide dense_left(track, rail, worn), dense_right(track, rail, *right);
    int compared = 0;
    for (double y = -6.9e-3; y < 7e-3; y += 1.13e-3) {
      const auto left_z = dense_left.touched_height(y), right_z = dense_right.touched_height(-y);
      if (!left_z || !right_z) continue;
      const WheelsetContact contact = search.solve(y, 0, RollRule::none);
      ASSERT_EQ(contact.status, Status::ok);
      // The radius is the nominal one less the profile's height.
      EXPECT_NEAR(contact.left.radius, 0.46 - *left_z, 1e-5) << y;
      EXPECT_NEAR(contact.right.radius, 0.46 - *right_z, 1e-5) << y;
      ++compared;
    }
    EXPECT_GT(compared, 8);
  }
}

/// Half a wavelength [m] and the turning points of y'' = -dr(y)/(e r0) from rest at `start` > 0, by the velocity Verlet
/// scheme in steps of a tenth of a millimetre.
struct Motion {
  double half_wavelength, other_end;
};
Motion integrated(const RollingRadiusDifference& difference, double start) {
  const double step = 1e-4, stiffness = 1 / (base.contact_distance * base.nominal_radius);
  double y = start, velocity = 0, s = 0;
  while (true) {
    const double half = velocity - stiffness * difference.at(y) * step / 2;
    const double next = y + half * step, after = half - stiffness * difference.at(next) * step / 2;
    s += step;
    if (after >= 0) { // at rest between the last two steps
      const double t = velocity / (velocity - after);
      return {s - step + t * step, y + t * (next - y)};
    }
    y = next, velocity = after;
  }
}

TEST(HollowWheel, ConicityIsThatOfTheMotionInTime) {
  Track track;
  track.cant = 1.0 / 40;
  const Profile rail = example_profile("60e1.prr"), fresh = example_profile("s1002.prw");
  const struct {
    double depth;
    bool alike;
    RollRule rule;
  } wheelsets[] = {{1e-3, true, RollRule::none}, {3e-3, true, RollRule::none}, {2e-3, false, RollRule::equilibrium}};
  for (const auto& [depth, alike, rule] : wheelsets) {
    const Profile worn = hollow_wheel(depth);
    WheelsetSearch search(track, {}, {rail, worn}, {rail, alike ? worn : fresh});
    const double reach = alike ? 4.6e-3 : 6.5e-3;
    const RollingRadiusDifference difference(wheelset_curve(search, -reach, reach, rule));
    for (const double amplitude : {1e-3, 3e-3, 4.5e-3}) {
      const auto found = kinematic_oscillation(difference, amplitude, base);
      ASSERT_TRUE(found) << depth << " " << amplitude;
      const Motion motion = integrated(difference, found->to);
      EXPECT_NEAR(motion.other_end, found->from, 0.01 * amplitude);
      EXPECT_NEAR(2 * motion.half_wavelength / found->wavelength, 1, 5e-3) << depth << " " << amplitude;
      const double number = 2 * std::numbers::pi / found->wavelength;
      EXPECT_NEAR(found->conicity, number * number * base.contact_distance * base.nominal_radius / 2,
                  1e-9 * found->conicity);
    }
  }
}

} // namespace
} // namespace microslip
