// Profiles that vary: tensor splines through their slices.

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_slices.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
using Field = std::function<ProfilePoint(double u, double v)>;

/// Slices at these u whose points at whole v are those of a field.
std::vector<SurfaceSlice> slices_of(const Field& field, const std::vector<double>& u, int points) {
  std::vector<SurfaceSlice> slices;
  for (const double at : u) {
    slices.push_back({at, 0, {}});
    for (int v = 0; v < points; ++v) slices.back().points.push_back(field(at, v));
  }
  return slices;
}

TEST(ProfileSurface, ReproducesCubicsWithTheirDerivatives) {
  const auto a = [](double u) { return 1 + u * (0.5 + u * (-0.2 + 0.1 * u)); };
  const auto da = [](double u) { return 0.5 + u * (-0.4 + 0.3 * u); };
  const auto dda = [](double u) { return -0.4 + 0.6 * u; };
  const auto b = [](double v) { return 2 - v * (0.3 - v * (0.05 - 0.004 * v)); };
  const auto db = [](double v) { return -0.3 + v * (0.1 - 0.012 * v); };
  const auto ddb = [](double v) { return 0.1 - 0.024 * v; };
  const ProfileSurface surface(slices_of(
      [&](double u, double v) {
        return ProfilePoint{v, a(u) * b(v)};
      },
      {0, 0.5, 1.2, 1.7, 2.5}, 9));
  for (const double u : {0.0, 0.3, 0.5, 1.0, 1.7, 2.2, 2.5})
    for (const double v : {0.0, 0.4, 3.0, 5.7, 8.0}) {
      const auto s = surface.at(u, v);
      ASSERT_TRUE(s);
      EXPECT_NEAR(s->value.y, v, 1e-12);
      EXPECT_NEAR(s->value.z, a(u) * b(v), 1e-11);
      EXPECT_NEAR(s->du.z, da(u) * b(v), 1e-11) << u << " " << v;
      EXPECT_NEAR(s->dv.z, a(u) * db(v), 1e-11);
      EXPECT_NEAR(s->duu.z, dda(u) * b(v), 1e-10);
      EXPECT_NEAR(s->duv.z, da(u) * db(v), 1e-10);
      EXPECT_NEAR(s->dvv.z, a(u) * ddb(v), 1e-10);
    }
}

TEST(ProfileSurface, DerivativesAreThoseOfDifferences) {
  const Field field = [](double u, double v) { return ProfilePoint{v + 0.1 * std::sin(u), std::cos(0.3 * v + u)}; };
  for (const SliceMethod method : {SliceMethod::interpolating, SliceMethod::approximating}) {
    const ProfileSurface surface(slices_of(field, equal_steps(0, 3, 12), 14), {method, {}, {{0.1, 2, 0.4}}});
    const double h = 1e-5, u = 1.37, v = 6.31;
    const SurfacePoint s = *surface.at(u, v);
    const auto at = [&](double du, double dv) { return surface.at(u + du, v + dv)->value; };
    EXPECT_NEAR(s.du.y, (at(h, 0).y - at(-h, 0).y) / (2 * h), 1e-9);
    EXPECT_NEAR(s.du.z, (at(h, 0).z - at(-h, 0).z) / (2 * h), 1e-9);
    EXPECT_NEAR(s.dv.z, (at(0, h).z - at(0, -h).z) / (2 * h), 1e-9);
    EXPECT_NEAR(s.duu.z, (at(h, 0).z - 2 * at(0, 0).z + at(-h, 0).z) / (h * h), 1e-4);
    EXPECT_NEAR(s.duv.z, (at(h, h).z - at(h, -h).z - at(-h, h).z + at(-h, -h).z) / (4 * h * h), 1e-4);
    EXPECT_NEAR(s.dvv.z, (at(0, h).z - 2 * at(0, 0).z + at(0, -h).z) / (h * h), 1e-4);
  }
}

TEST(ProfileSurface, BetweenTwoSlicesIsLinear) {
  const ProfileSurface surface(slices_of(
      [](double u, double v) {
        return ProfilePoint{v, u * std::sin(v)};
      },
      {1, 4}, 6));
  for (const double v : {0.0, 2.0, 5.0}) EXPECT_NEAR(surface.at(2.5, v)->value.z, 2.5 * std::sin(v), 1e-14);
  EXPECT_NEAR(surface.at(2.5, 3)->du.z, std::sin(3), 1e-14);
}

TEST(ProfileSurface, GoesOnAsItIsBeyondItsEnds) {
  const ProfileSurface surface(slices_of([](double u, double v) { return ProfilePoint{v, u * u}; }, {0, 1, 2, 3}, 4));
  EXPECT_EQ(surface.at(7, 1.5)->value.z, 9);
  EXPECT_EQ(surface.at(7, 1.5)->du.z, 0);
  EXPECT_EQ(surface.at(-7, 1.5)->value.z, 0);
  EXPECT_FALSE(surface.at(1, -0.1));
  EXPECT_FALSE(surface.at(1, 3.1));
  EXPECT_NEAR(surface.at(3, 1.5)->du.z, 6, 1e-12) << "at the last slice it is that of the inside";
}

TEST(ProfileSurface, InterpolationConvergesWithOrderFour) {
  const auto error = [](int n) {
    const ProfileSurface surface(slices_of(
        [](double u, double v) {
          return ProfilePoint{v, std::sin(u)};
        },
        equal_steps(0, 3, n + 1), 4));
    double worst = 0;
    for (const double u : equal_steps(0, 3, 500))
      worst = std::max(worst, std::abs(surface.at(u, 1)->value.z - std::sin(u)));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(60) / error(120)), 4, 0.3);
}

/// A B-spline with slices at equal distances for control points keeps straight lines, and a third of what alternates
/// from slice to slice: (1, 4, 1)/6.
TEST(ProfileSurface, ApproximationSmoothsWhatAlternates) {
  const std::vector<double> u = equal_steps(0, 7, 8);
  const SurfaceOptions approximating{SliceMethod::approximating, {}, {}};
  const ProfileSurface line(slices_of(
                                [](double t, double v) {
                                  return ProfilePoint{v, 2 + 3 * t};
                                },
                                u, 4),
                            approximating);
  for (const double t : {0.5, 2.5, 4.0, 6.1}) EXPECT_NEAR(line.at(t, 1.5)->value.z, 2 + 3 * t, 1e-12);
  const ProfileSurface wave(slices_of(
                                [](double t, double v) {
                                  return ProfilePoint{v, std::cos(pi * t)};
                                },
                                equal_steps(0, 20, 21), 4),
                            approximating);
  EXPECT_NEAR(wave.at(10, 1.5)->value.z, 1.0 / 3, 1e-12);
  EXPECT_NEAR(wave.at(11, 1.5)->value.z, -1.0 / 3, 1e-12);
}

/// The points 3 to 5 are there from the third slice to the fifth only.
TEST(ProfileSurface, IsInterruptedWhereSlicesAreShorter) {
  auto slices = slices_of([](double u, double v) { return ProfilePoint{v, 0.1 * u + v * v}; }, equal_steps(0, 6, 7), 6);
  for (const std::size_t k : {0u, 1u, 5u, 6u}) slices[k].points.resize(3);
  const ProfileSurface surface(slices);
  EXPECT_TRUE(surface.at(0.5, 1.5));
  EXPECT_FALSE(surface.at(0.5, 4));
  ASSERT_TRUE(surface.at(0.5, 2)) << "the last point";
  EXPECT_NEAR(surface.at(0.5, 2)->value.z, 0.05 + 4, 1e-12);
  EXPECT_NEAR(surface.v_at_y(0.5, 1.7).at(0), 1.7, 1e-12) << "next to the last point";
  EXPECT_EQ(surface.v_at_y(0.5, 2), std::vector<double>{2});
  EXPECT_FALSE(surface.at(1.5, 4)) << "from slice to slice only between what both have";
  EXPECT_TRUE(surface.at(3, 2.5));
  EXPECT_TRUE(surface.at(2, 4)) << "at the slice itself";
  EXPECT_NEAR(surface.at(2.7, 4.5)->value.z, 0.27 + 4.5 * 4.5, 1e-12);
  EXPECT_NEAR(surface.at(2.7, 4.5)->du.z, 0.1, 1e-12);
  EXPECT_EQ(surface.section(1.5).points.size(), 3u);
  EXPECT_EQ(surface.section(2.5).points.size(), 6u);
}

TEST(ProfileSurface, KinksCutItIntoSections) {
  const auto roof = [](double, double v) { return ProfilePoint{v, std::abs(v - 5)}; };
  SurfaceOptions options;
  options.kinks = {5};
  const ProfileSurface cut(slices_of(roof, {0, 1}, 11), options), smooth(slices_of(roof, {0, 1}, 11));
  EXPECT_NEAR(cut.at(0.5, 4.5)->value.z, 0.5, 1e-14);
  EXPECT_NEAR(cut.at(0.5, 5.2)->dv.z, 1, 1e-14);
  EXPECT_GT(std::abs(smooth.at(0.5, 4.5)->value.z - 0.5), 1e-2);
}

/// Where one field begins and the other ends; both are curved there, and vary along the track.
const Field before_kink = [](double u, double v) {
  return ProfilePoint{v + 0.1 * u * std::sin(v), 0.2 * (v - 5) * (v - 7) * (1 + 0.3 * std::cos(u))};
};
const Field behind_kink = [](double u, double v) {
  return ProfilePoint{5 + 0.1 * u * std::sin(5) + 0.5 * (v - 5) + 0.03 * u * (v - 5) * (v - 5),
                      std::expm1(0.4 * (v - 5)) * std::cos(u)};
};

std::vector<SurfaceSlice> bent_slices() {
  return slices_of([](double u, double v) { return v <= 5 ? before_kink(u, v) : behind_kink(u, v); },
                   {0, 0.8, 1.5, 2.6, 3.4}, 11);
}

void expect_same(const ProfileSurface& a, const ProfileSurface& b, double u, double v) {
  const auto p = a.at(u, v), q = b.at(u, v);
  ASSERT_TRUE(p && q) << u << " " << v;
  for (const auto part : {&SurfacePoint::value, &SurfacePoint::du, &SurfacePoint::dv, &SurfacePoint::duu,
                          &SurfacePoint::duv, &SurfacePoint::dvv}) {
    EXPECT_NEAR(((*p).*part).y, ((*q).*part).y, 1e-13) << u << " " << v;
    EXPECT_NEAR(((*p).*part).z, ((*q).*part).z, 1e-13) << u << " " << v;
  }
}

/// On either side of a kink the surface and its derivatives are those of that side alone.
TEST(ProfileSurface, SidesOfAKinkKnowNothingOfEachOther) {
  for (const SliceMethod method : {SliceMethod::interpolating, SliceMethod::approximating}) {
    const auto slices = bent_slices();
    auto left = slices, right = slices;
    for (SurfaceSlice& slice : left) slice.points.resize(6);
    for (SurfaceSlice& slice : right) {
      slice.points.erase(slice.points.begin(), slice.points.begin() + 5);
      slice.first = 5;
    }
    const ProfileSurface whole(slices, {method, {5}, {}}), before(left, {method, {}, {}}),
        behind(right, {method, {}, {}});
    for (const double u : {0.0, 0.3, 1.5, 2.1, 3.4}) {
      for (const double v : {0.0, 3.5, 4.0, 4.5, 4.999}) expect_same(whole, before, u, v);
      for (const double v : {5.0, 5.001, 5.5, 6.0, 9.3, 10.0}) expect_same(whole, behind, u, v);
    }
  }
}

/// The plane before a kink stays plane beside slices that begin at the kink.
TEST(ProfileSurface, SlicesThatBeginAtAKinkDoNotBendWhatIsBeforeIt) {
  auto slices = slices_of(
      [](double, double v) {
        return ProfilePoint{v, v <= 5 ? 0 : 0.5 * (v - 5) * (v - 5)};
      },
      {0, 1, 2, 3, 4}, 11);
  slices[0].points.erase(slices[0].points.begin(), slices[0].points.begin() + 5);
  slices[0].first = 5;
  const ProfileSurface surface(slices, {SliceMethod::interpolating, {5}, {}});
  for (const double v : {3.7, 4.5, 4.9}) EXPECT_NEAR(surface.at(1.5, v)->value.z, 0, 1e-14) << v;
  for (const double v : {5.5, 6.5}) EXPECT_NEAR(surface.at(0.5, v)->value.z, 0.5 * (v - 5) * (v - 5), 1e-13) << v;
  EXPECT_FALSE(surface.at(0.5, 4.5));
}

/// Of order five; the slices leave a gap at pi that is as wide as their distances.
TEST(ProfileSurface, AWheelIsClosed) {
  const Field polygon = [](double u, double v) { return ProfilePoint{v, 0.1 * std::cos(5 * u)}; };
  SurfaceOptions options;
  options.is_wheel = true;
  const int n = 100;
  const ProfileSurface wheel(slices_of(polygon, equal_steps(-pi + pi / n, pi - pi / n, n), 4), options);
  for (const double u : {-pi, -3.1, 0.3, 3.1, pi, 2 * pi + 0.3}) {
    EXPECT_NEAR(wheel.at(u, 1)->value.z, 0.1 * std::cos(5 * u), 5e-6) << u;
    EXPECT_NEAR(wheel.at(u, 1)->du.z, -0.5 * std::sin(5 * u), 2e-4) << u;
  }
  const ProfileSurface part(slices_of(polygon, equal_steps(-1, 1, 20), 4), options);
  EXPECT_EQ(part.at(2, 1)->value.z, part.at(1, 1)->value.z);
}

/// Also where slices at both ends are the same one, and of a wheel that is not closed.
TEST(ProfileSurface, AWheelTellsTheEndsOfTheSlicesThatItWasGiven) {
  const Field round = [](double, double v) { return ProfilePoint{v, 0}; };
  SurfaceOptions options;
  options.is_wheel = true;
  for (const std::vector<double>& u :
       {equal_steps(-pi, 35 * pi / 36, 36), equal_steps(-pi, pi, 36), equal_steps(-1, 2, 5)}) {
    const ProfileSurface wheel(slices_of(round, u, 4), options);
    EXPECT_EQ(wheel.first_u(), u.front());
    EXPECT_EQ(wheel.last_u(), u.back());
    EXPECT_EQ(wheel.in_units(1, 1e3, -1e3).last_u(), u.back());
  }
}

/// Wherever they begin, whatever turn an angle counts.
TEST(ProfileSurface, SlicesOfAWheelMayBeginAnywhere) {
  const Field eccentric = [](double u, double v) { return ProfilePoint{v, 0.1 * std::cos(u)}; };
  SurfaceOptions options;
  options.is_wheel = true;
  for (const double first : {-pi, -1.0, 0.0, 2.0, 11.0}) {
    const ProfileSurface wheel(slices_of(eccentric, equal_steps(first, first + 35 * pi / 18, 36), 4), options);
    for (const double u : equal_steps(-14, 14, 281)) {
      EXPECT_NEAR(wheel.at(u, 1)->value.z, 0.1 * std::cos(u), 1e-6) << first << " " << u;
      EXPECT_NEAR(wheel.at(u, 1)->du.z, -0.1 * std::sin(u), 1e-5) << first << " " << u;
    }
  }
  const ProfileSurface part(slices_of(eccentric, equal_steps(2, 4, 9), 4), options);
  EXPECT_NEAR(part.at(3.5 - 2 * pi, 1)->value.z, part.at(3.5, 1)->value.z, 1e-15);
  for (const double u : {4.5, 6.0, -0.3}) EXPECT_EQ(part.at(u, 1)->value.z, part.at(4, 1)->value.z) << u;
  for (const double u : {1.5, 0.0, 6.5}) EXPECT_EQ(part.at(u, 1)->value.z, part.at(2, 1)->value.z) << u;
}

TEST(ProfileSurface, WavesAreAddedToTheHeight) {
  const auto flat = slices_of([](double, double v) { return ProfilePoint{v, 1}; }, {0, 1}, 4);
  const ProfileSurface surface(flat, {SliceMethod::interpolating, {}, {{0.2, 3, 0.5}, {0.1, 7, 0}}});
  const double u = 40.3; // waves go on beyond the slices
  EXPECT_NEAR(surface.at(u, 1)->value.z, 1 + 0.2 * std::sin(3 * u + 0.5) + 0.1 * std::sin(7 * u), 1e-14);
  EXPECT_NEAR(surface.at(u, 1)->du.z, 0.6 * std::cos(3 * u + 0.5) + 0.7 * std::cos(7 * u), 1e-14);
  EXPECT_NEAR(surface.section(u).points[2].z, surface.at(u, 2)->value.z, 1e-14);
}

TEST(ProfileSurface, FindsWhereTheSectionHasAHeight) {
  const ProfileSurface ascending(slices_of(
      [](double u, double v) {
        return ProfilePoint{v + 0.2 * std::sin(v) + u, v};
      },
      {0, 1, 2, 3}, 20));
  for (const double v : {0.0, 0.3, 7.0, 18.9, 19.0}) {
    const double y = ascending.at(1.4, v)->value.y;
    const auto found = ascending.v_at_y(1.4, y);
    ASSERT_EQ(found.size(), 1u) << v;
    EXPECT_NEAR(found[0], v, 1e-12);
  }
  EXPECT_TRUE(ascending.v_at_y(1.4, -1).empty());
  const ProfileSurface arc(slices_of(
      [](double, double v) {
        return ProfilePoint{std::sin(0.3 * v), std::cos(0.3 * v)};
      },
      {0, 1}, 11));
  const auto twice = arc.v_at_y(0.5, 0.8);
  ASSERT_EQ(twice.size(), 2u);
  EXPECT_NEAR(twice[0], std::asin(0.8) / 0.3, 1e-4);
  EXPECT_NEAR(twice[1], (pi - std::asin(0.8)) / 0.3, 1e-4);
}

/// All v at which a section crosses y, from a walk in small steps.
std::vector<double> walked(const ProfileSurface& surface, double u, double y) {
  constexpr double step = 1e-2;
  std::vector<double> found;
  double before = surface.at(u, 0)->value.y - y;
  for (int k = 1; k <= std::lround(double(surface.last_v()) / step); ++k) {
    const double now = surface.at(u, k * step)->value.y - y;
    if (before * now < 0) found.push_back((k - 0.5) * step);
    before = now;
  }
  return found;
}

/// Slices from y = -4 on whose middle part has these widths; z falls by 0.1 from point to point there.
std::vector<SurfaceSlice> parts_of_widths(const std::vector<double>& widths) {
  std::vector<SurfaceSlice> slices;
  for (const double width : widths) {
    slices.push_back({static_cast<double>(slices.size()), 0, {}});
    auto& points = slices.back().points;
    for (int k = 0; k <= 4; ++k) points.push_back({k - 4.0, 0});
    for (int k = 1; k <= 4; ++k) points.push_back({width * k / 4, -0.1 * k});
    for (int k = 1; k <= 4; ++k) points.push_back({width + k, 1});
  }
  return slices;
}

void expect_all_found(const ProfileSurface& surface, double u, double y) {
  const auto found = surface.v_at_y(u, y), expected = walked(surface, u, y);
  ASSERT_EQ(found.size(), expected.size()) << u << " " << y;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k], expected[k], 1e-2) << u << " " << y;
    EXPECT_NEAR(surface.at(u, found[k])->value.y, y, 1e-12) << u << " " << y;
  }
}

/// y ascends from point to point of each slice. Between slices the spline along the track makes the part that becomes
/// narrow at once narrower than nothing, and where distances change at once the spline across folds between points.
TEST(ProfileSurface, FindsAllOfASectionThatFoldsBetweenItsPoints) {
  const ProfileSurface folded(parts_of_widths({10, 10, 10, 0.5, 0.5, 0.5}));
  const auto three = folded.v_at_y(3.5, -0.1);
  ASSERT_EQ(three.size(), 3u);
  EXPECT_NEAR(folded.at(3.5, three[0])->value.z, 0.006, 1e-3);
  EXPECT_NEAR(folded.at(3.5, three[1])->value.z, -0.075, 1e-3);
  EXPECT_NEAR(folded.at(3.5, three[2])->value.z, 0.548, 1e-3);
  EXPECT_EQ(folded.v_at_y(5, 0.13).size(), 3u);
  const ProfileSurface smoothed(parts_of_widths({10, 10, 10, 0.5, 0.5, 0.5}), {SliceMethod::approximating, {}, {}});
  for (const double u : {0.0, 2.5, 3.1, 3.5, 3.6, 5.0})
    for (const double y : {-3.3, -0.1, 0.03, 0.05, 0.13, 0.37, 2.0}) {
      expect_all_found(folded, u, y);
      expect_all_found(smoothed, u, y);
    }
}

TEST(ProfileSurface, RefusesWhatIsNoSurface) {
  EXPECT_THROW(ProfileSurface({}), Error);
  const auto slices = slices_of([](double, double v) { return ProfilePoint{v, 0}; }, {0, 0}, 4);
  EXPECT_THROW(ProfileSurface{slices}, Error);
  EXPECT_THROW(ProfileSurface({{0, 0, {{0, 0}}}}), Error);
  EXPECT_THROW(ProfileSurface({{0, 4'000'000, {{0, 0}, {1, 0}}}}), Error);
  EXPECT_THROW(ProfileSurface({{0, 0, {{0, 0}, {1, NAN}}}}), Error);
}

// Slices with features

Profile line_profile(double length, ProfileRole role = ProfileRole::rail) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 10; ++k) points.push_back({length * k / 10, 0});
  return {role, points};
}

/// Part lengths 1 and 2 in one slice, 3 and 1 in the other: lines of equal v join the features.
TEST(JoinedSlices, LinesOfEqualVJoinFeatures) {
  SliceOptions options;
  options.spacing = 0.5;
  const auto surface = join_slices({{0, line_profile(3), {0, 1, 99}}, {10, line_profile(4), {0, 3, 99}}}, options);
  EXPECT_EQ(surface.last_v(), 12u) << "1 + int(3/.5) and 1 + int(2/.5) pieces";
  EXPECT_NEAR(surface.at(0, 7)->value.y, 1, 1e-12);
  EXPECT_NEAR(surface.at(10, 7)->value.y, 3, 1e-12);
  EXPECT_NEAR(surface.at(5, 7)->value.y, 2, 1e-12);
  EXPECT_NEAR(surface.at(5, 12)->value.y, 3.5, 1e-12);
}

/// A wheel's features count from the field side, its v from the gauge side.
TEST(JoinedSlices, WheelsCountFromTheFieldSide) {
  SliceOptions options;
  options.spacing = 0.5;
  const auto wheel = ProfileRole::wheel;
  const auto surface =
      join_slices({{0, line_profile(3, wheel), {0, 1, 99}}, {1, line_profile(3, wheel), {0, 1, 99}}}, options);
  EXPECT_NEAR(surface.at(0.5, 0)->value.y, 0, 1e-12);
  EXPECT_NEAR(surface.at(0.5, 5)->value.y, 2, 1e-12);
}

TEST(JoinedSlices, PartsThatSlicesLackAreInterrupted) {
  SliceOptions options;
  options.spacing = 0.5;
  const auto surface = join_slices(
      {{0, line_profile(2), {-1, 0, 99}}, {1, line_profile(2), {-1, 0, 99}}, {2, line_profile(5), {0, 3, 99}}},
      options);
  EXPECT_FALSE(surface.at(0.5, 2));
  EXPECT_FALSE(surface.at(1.5, 2));
  EXPECT_TRUE(surface.at(1.5, 9));
  EXPECT_NEAR(surface.at(2, 2)->value.y, 3 * 2.0 / 7, 1e-12);
}

TEST(JoinedSlices, FeaturesThatCannotBeAreNamed) {
  const auto message = [](std::vector<double> features) {
    return error_of([&] {
      join_slices({{0, line_profile(3), {0, 1, 99}}, {1, line_profile(3), std::move(features)}}, {});
    });
  };
  EXPECT_EQ(message({0, 1}), "slice 2: has other features than the first slice");
  EXPECT_EQ(message({-1, -1, 2}), "slice 2: has fewer than two features");
  EXPECT_NE(message({0, 5, 99}).find("feature 3 at 3.000000 does not lie behind the one before, at 5.000000"),
            std::string::npos);
}

} // namespace
} // namespace microslip
