#include "microslip/interior/interior_peak.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

constexpr double a = 2e-3;

std::vector<double> hertzian(const ElementGrid& grid) {
  return over_grid(grid, [&](double x, double y) {
    x /= a, y = grid.line ? 0 : y / a;
    return std::sqrt(std::max(0.0, 1 - x * x - y * y));
  });
}

struct Peak {
  double shear, depth;
};
/// The largest shear of a body under Hertz's pressure, over p0, at the depth over a; each within its tolerance.
InteriorPeak expect_peak(const Material& body, Body which, const ElementGrid& grid, const Peak& wanted,
                         const Peak& tolerance) {
  const auto pn = hertzian(grid);
  InteriorLayers layers(InteriorField(body, which, grid, {{}, {}, pn}));
  const InteriorPeak peak = find_largest(layers, equal_steps(0.2 * a, 1.2 * a, 6), tresca);
  EXPECT_NEAR(peak.value / 2, wanted.shear, tolerance.shear);
  EXPECT_NEAR(peak.point.depth / a, wanted.depth, tolerance.depth);
  return peak;
}

/// Johnson 1985, section 4.2 and 3.4: 0.31 p0 at 0.48 a below a sphere with nu = 0.3, 0.30 p0 at 0.786 a below a
/// cylinder. Elements that do not lie symmetrically, so that no point of the planes is the right one.
TEST(InteriorPeak, LargestShearBelowHertzsContacts) {
  const Material body{82e9, 0.3};
  auto grid = ElementGrid::across_ellipse(a, a, 40, 1);
  grid.x0 += 0.3 * grid.dx;
  grid.y0 += 0.2 * grid.dy;
  const InteriorPeak peak = expect_peak(body, Body::second, grid, {0.31, 0.48}, {0.001, 0.005});
  EXPECT_NEAR(peak.point.x / a, 0, 0.01);
  EXPECT_NEAR(peak.point.y / a, 0, 0.01);
  EXPECT_EQ(peak.value, tresca(peak.state.stress));

  const auto line = ElementGrid::across_line(a, 101);
  const InteriorPeak line_peak = expect_peak(body, Body::first, line, {0.300, 0.786}, {0.0005, 0.002});
  EXPECT_NEAR(line_peak.point.x / a, 0, 0.001);
}

/// No neighbour is larger, and no point of the planes.
TEST(InteriorPeak, NothingIsLarger) {
  const Material body{82e9, 0.28};
  const auto grid = ElementGrid::across_ellipse(a, a, 20);
  const auto pn = hertzian(grid);
  std::vector<double> px(pn.size());
  for (std::size_t k = 0; k < px.size(); ++k) px[k] = -0.2 * pn[k];
  InteriorLayers layers(InteriorField(body, Body::first, grid, {px, {}, pn}), 2);
  const auto planes = equal_steps(0.1 * a, a, 10);
  for (const StressMeasure measure : {StressMeasure(von_mises), StressMeasure(tresca)}) {
    const InteriorPeak peak = find_largest(layers, planes, measure);
    for (const double depth : planes)
      for (const InteriorState& s : layers.at_depth(depth)) EXPECT_LE(measure(s.stress), peak.value * (1 + 1e-12));
    const InteriorField& field = layers.field();
    for (const double step : {-2e-3, 2e-3})
      for (const InteriorPoint& p : {InteriorPoint{peak.point.x + step * grid.dx, peak.point.y, peak.point.depth},
                                     InteriorPoint{peak.point.x, peak.point.y + step * grid.dy, peak.point.depth},
                                     InteriorPoint{peak.point.x, peak.point.y, peak.point.depth + step * 0.1 * a}})
        EXPECT_LE(measure(field.at(p).stress), peak.value * (1 + 1e-12));
    EXPECT_GT(std::abs(peak.point.x), 0.02 * a); // traction draws it to the side
  }
}

/// Where the largest value lies at a border of what is searched, it is found there.
TEST(InteriorPeak, StaysWithinTheDepths) {
  const auto grid = ElementGrid::across_ellipse(a, a, 21);
  const auto pn = hertzian(grid);
  InteriorLayers layers(InteriorField({82e9, 0.3}, Body::first, grid, {{}, {}, pn}));
  EXPECT_EQ(find_largest(layers, equal_steps(0.7 * a, a, 4), tresca).point.depth, equal_steps(0.7 * a, a, 4).front());
  EXPECT_EQ(find_largest(layers, equal_steps(0.1 * a, 0.3 * a, 4), tresca).point.depth,
            equal_steps(0.1 * a, 0.3 * a, 4).back());
  const std::vector<double> one = {0.5 * a};
  EXPECT_EQ(find_largest(layers, one, tresca).point.depth, 0.5 * a);
}

TEST(InteriorPeak, RefusesDepthsOutOfOrder) {
  const auto grid = ElementGrid::across_ellipse(a, a, 5);
  InteriorLayers layers(InteriorField({82e9, 0.3}, Body::first, grid, {}));
  const std::vector<double> none, mixed = {1e-3, 5e-4}, above = {-1e-3, 1e-3};
  expect_error([&] { find_largest(layers, none, tresca); }, "number of depths", "[-]: must be at least 1");
  expect_error([&] { find_largest(layers, mixed, tresca); }, "depths", "[m]: must be ascending");
  expect_error([&] { find_largest(layers, above, tresca); }, "depth", "[m]: must be at least 0");
}

} // namespace
} // namespace microslip
