#include "microslip/elasticity/interior_influence.hpp"

#include "interior_states.hpp"
#include "microslip/elasticity/influence.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using Real = long double;
constexpr double pi = std::numbers::pi;
constexpr Material rubber{2e6, 0.41};
constexpr double dx = 3e-4, dy = 2e-4;

struct Point {
  double x, y, depth; ///< x in units of dx, y of dy, depth of dx
};
std::string text(const Point& p) {
  return "(" + std::to_string(p.x) + " dx, " + std::to_string(p.y) + " dy), depth " + std::to_string(p.depth) + " dx";
}

InteriorInfluence at(const Point& p, Body body = Body::first, const Material& material = steel_body) {
  return interior_influence(material, body, dx, dy, p.x * dx, p.y * dy, p.depth * dx);
}
/// The displacement by which differences of displacements are measured.
double unit(const Material& material = steel_body) {
  return dx / material.shear_modulus;
}

/// Inside, outside, beneath edges and corners, near and far.
std::vector<Point> points() {
  std::vector<Point> all;
  for (const double depth : {0.01, 0.1, 0.5, 1.0, 4.0})
    for (const double x : {0.0, 0.3, -0.5, 0.51, 1.7})
      for (const double y : {0.0, -0.2, 0.5, 3.0}) all.push_back({x, y, depth});
  return all;
}

// --- point forces as an oracle, written from other formulas

using Sum = std::array<Real, 9>;

/// Boussinesq's solution for a unit force along z (Johnson 1985, section 3.2b, freed of its divisions by x^2 + y^2).
Sum normal_force(const Material& m, Real x, Real y, Real z) {
  const Real r = std::sqrt(x * x + y * y + z * z), r3 = r * r * r, r5 = r3 * r * r, q = r + z;
  const Real k = 1 - 2 * Real(m.poisson_ratio), f = 1 / (4 * Real(pi) * m.shear_modulus), g = 1 / (2 * Real(pi));
  const Real w = (2 * r + z) / (r3 * q * q), v = z / r3 - 1 / (r * q);
  return {f * (x * z / r3 - k * x / (r * q)),
          f * (y * z / r3 - k * y / (r * q)),
          f * (z * z / r3 + (1 + k) / r),
          g * (k * (v + x * x * w) - 3 * x * x * z / r5),
          g * (k * (v + y * y * w) - 3 * y * y * z / r5),
          -3 * g * z * z * z / r5,
          g * (k * x * y * w - 3 * x * y * z / r5),
          -3 * g * x * z * z / r5,
          -3 * g * y * z * z / r5};
}

/// Cerruti's solution for a unit force along x (Johnson 1985, section 3.6).
Sum tangential_force(const Material& m, Real x, Real y, Real z) {
  const Real r = std::sqrt(x * x + y * y + z * z), r3 = r * r * r, r5 = r3 * r * r, q = r + z, q2 = q * q;
  const Real k = 1 - 2 * Real(m.poisson_ratio), f = 1 / (4 * Real(pi) * m.shear_modulus), g = 1 / (2 * Real(pi));
  const Real w = 1 / (r3 * q2) + 2 / (r * r * q2 * q);
  return {f * (1 / r + x * x / r3 + k * (1 / q - x * x / (r * q2))),
          f * (x * y / r3 - k * x * y / (r * q2)),
          f * (x * z / r3 + k * x / (r * q)),
          g * (-3 * x * x * x / r5 + k * (x / r3 - 3 * x / (r * q2) + x * x * x * w)),
          g * (-3 * x * y * y / r5 + k * (x / r3 - x / (r * q2) + x * y * y * w)),
          -3 * g * x * z * z / r5,
          g * (-3 * x * x * y / r5 + k * (-y / (r * q2) + x * x * y * w)),
          -3 * g * x * x * z / r5,
          -3 * g * x * y * z / r5};
}

constexpr std::array<Real, 5> nodes = {0.1488743389816312L, 0.4333953941292472L, 0.6794095682990244L,
                                       0.8650633666889845L, 0.9739065285171717L};
constexpr std::array<Real, 5> weights = {0.2955242247147529L, 0.2692667193099964L, 0.2190863625159820L,
                                         0.1494513491505806L, 0.0666713443086881L};

/// Gauss's rule of ten points on panels from -half to half that grow twofold from where the integrand is steep.
std::vector<std::pair<Real, Real>> rule(double half, double steep, double width) {
  std::vector<double> cuts = {-half, half};
  if (std::abs(steep) < half) cuts.push_back(steep);
  for (double w = width; w < 4 * half + std::abs(steep); w *= 2)
    for (const double cut : {steep - w, steep + w})
      if (std::abs(cut) < half) cuts.push_back(cut);
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::pair<Real, Real>> all;
  for (std::size_t p = 0; p + 1 < cuts.size(); ++p)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const int sign : {-1, 1}) {
        const Real size = (Real(cuts[p + 1]) - cuts[p]) / 2;
        all.emplace_back((Real(cuts[p + 1]) + cuts[p]) / 2 + sign * size * nodes[i], size * weights[i]);
      }
  return all;
}

/// The force's field integrated over the rectangle; `near` is the distance from it.
template <class Force> Nine integrated(Force force, const Material& m, const Point& p, double near) {
  const double x = p.x * dx, y = p.y * dy, z = p.depth * dx;
  const auto rule_y = rule(dy / 2, y, near);
  Sum sum{};
  for (const auto& [xi, wx] : rule(dx / 2, x, near))
    for (const auto& [eta, wy] : rule_y) {
      const Sum s = force(m, x - xi, y - eta, z);
      for (std::size_t k = 0; k < s.size(); ++k) sum[k] += wx * wy * s[k];
    }
  Nine rounded;
  for (std::size_t k = 0; k < sum.size(); ++k) rounded[k] = static_cast<double>(sum[k]);
  return rounded;
}

TEST(InteriorInfluence, IsTheIntegralOfPointForces) {
  for (const Point& p : points()) {
    if (p.depth < 0.05) continue;
    const InteriorInfluence a = at(p);
    EXPECT_LT(difference(nine(a.pn), integrated(normal_force, steel_body, p, p.depth * dx / 2), unit(), 1), 2e-14)
        << text(p);
    EXPECT_LT(difference(nine(a.px), integrated(tangential_force, steel_body, p, p.depth * dx / 2), unit(), 1), 2e-14)
        << text(p);
  }
}

/// Beside the rectangle at the surface, on its edges' lines, and just below them.
TEST(InteriorInfluence, IsTheIntegralOfPointForcesBesideTheRectangle) {
  for (const double depth : {0.0, 1e-10, 1e-6, 1e-3})
    for (const Point& p :
         {Point{0.5, 0.7, depth}, {-0.5, 2, depth}, {0.8, 0.5, depth}, {5, -0.5, depth}, {1, 1, depth}}) {
      const InteriorInfluence a = at(p);
      EXPECT_LT(difference(nine(a.pn), integrated(normal_force, steel_body, p, 0.05 * dy), unit(), 1), 2e-14)
          << text(p);
      EXPECT_LT(difference(nine(a.px), integrated(tangential_force, steel_body, p, 0.05 * dy), unit(), 1), 2e-14)
          << text(p);
    }
}

/// Relative to the size of the field, which falls like 1/R and 1/R^2, errors grow like R/dx.
TEST(InteriorInfluence, FarAwayIsAPointForce) {
  const double area = dx * dy;
  for (const double distance : {30.0, 1e3, 1e5, 1e7})
    for (const Point& way : {Point{0.6, 0.3, 0.7}, {-0.2, 1.2, 0}, {0, 0, 1}, {1, 0, 0}}) {
      const Point p = {way.x * distance, way.y * distance, way.depth * distance};
      const double r = distance * dx, stress = area / (r * r), displacement = area / (r * steel_body.shear_modulus);
      const InteriorInfluence a = at(p);
      const auto point = [&](auto force) {
        const Sum s = force(steel_body, Real(p.x) * dx, Real(p.y) * dy, Real(p.depth) * dx);
        Nine rounded;
        for (std::size_t k = 0; k < s.size(); ++k) rounded[k] = static_cast<double>(s[k] * area);
        return rounded;
      };
      const double rounding = 2e-15 * distance, size = 3 / (distance * distance);
      EXPECT_LT(difference(nine(a.pn), integrated(normal_force, steel_body, p, r), displacement, stress), rounding);
      EXPECT_LT(difference(nine(a.px), integrated(tangential_force, steel_body, p, r), displacement, stress), rounding);
      EXPECT_LT(difference(nine(a.pn), point(normal_force), displacement, stress), rounding + size) << text(p);
      EXPECT_LT(difference(nine(a.px), point(tangential_force), displacement, stress), rounding + size) << text(p);
    }
}

// --- the equations of elasticity

/// Derivative along an axis by differences of sixth order.
template <class F> Nine derivative(F f, int axis, double step) {
  Nine sum{};
  constexpr std::array<double, 3> c = {45.0 / 60, -9.0 / 60, 1.0 / 60};
  for (int k = 1; k <= 3; ++k)
    for (const int sign : {-1, 1}) {
      std::array<double, 3> shift{};
      shift[axis] = sign * k * step;
      sum = combine(sum, sign * c[k - 1] / step, f(shift));
    }
  return sum;
}

/// For each load in each body: stresses follow from displacements by Hooke's law, and balance.
TEST(InteriorInfluence, HookesLawAndEquilibrium) {
  for (const Material& m : {rubber, steel_body, Material{1, 0}})
    for (const Body body : {Body::first, Body::second})
      for (const Point& p : {Point{0.1, 0.2, 0.5}, {0.5, 0.5, 0.4}, {1.5, -0.3, 0.3}, {-0.7, 2, 1.5}})
        for (int load = 0; load < 3; ++load) {
          const double up = body == Body::first ? 1 : -1;
          const auto field = [&](const std::array<double, 3>& s) {
            return nines(
                interior_influence(m, body, dx, dy, p.x * dx + s[0], p.y * dy + s[1], p.depth * dx + up * s[2]))[load];
          };
          const double step = 2e-3 * dx;
          const Nine by_x = derivative(field, 0, step), by_y = derivative(field, 1, step),
                     by_z = derivative(field, 2, step), s = field({});
          const double g = m.shear_modulus, nu = m.poisson_ratio;
          const double volume = 2 * g * nu / (1 - 2 * nu) * (by_x[0] + by_y[1] + by_z[2]);
          const Nine hooke = {0,
                              0,
                              0,
                              volume + 2 * g * by_x[0],
                              volume + 2 * g * by_y[1],
                              volume + 2 * g * by_z[2],
                              g * (by_x[1] + by_y[0]),
                              g * (by_x[2] + by_z[0]),
                              g * (by_y[2] + by_z[1])};
          EXPECT_LT(difference(s, hooke, 1e300, 1), 1e-10) << text(p) << ", load " << load;
          for (const double balance :
               {by_x[3] + by_y[6] + by_z[7], by_x[6] + by_y[4] + by_z[8], by_x[7] + by_y[8] + by_z[5]})
            EXPECT_NEAR(balance * dx, 0, 1e-10) << text(p) << ", load " << load;
        }
}

/// Forces and moments of the stresses on a plane below the load, which act on what lies above it. With x = c sinh u and
/// equal steps of u the sum converges like exp(-1/step); the tail falls like the depth over the distance.
TEST(InteriorInfluence, PlanesBelowCarryTheLoad) {
  const double depth = 0.8 * dx, area = dx * dy, step = 0.125;
  std::array<std::array<double, 5>, 3> sums{}; // of sigma_xz, yz, zz, and of x zz, y zz
  for (double u = -12; u <= 12; u += step)
    for (double v = -12; v <= 12; v += step) {
      const double x = dx * std::sinh(u), y = dx * std::sinh(v);
      const double w = step * step * dx * dx * std::cosh(u) * std::cosh(v);
      const auto a = nines(interior_influence(steel_body, Body::first, dx, dy, x, y, depth));
      for (int load = 0; load < 3; ++load) {
        const Nine& s = a[load];
        const std::array<double, 5> terms = {s[7], s[8], s[5], x * s[5], y * s[5]};
        for (std::size_t k = 0; k < terms.size(); ++k) sums[load][k] += w * terms[k];
      }
    }
  for (int load = 0; load < 3; ++load) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sums[load][k] / area, load == k ? -1 : 0, 5e-5) << load << ", " << k;
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(sums[load][3 + k] / (area * depth), load == k ? -1 : 0, 5e-5) << load << ", " << k;
  }
}

// --- the surface

/// sigma_iz = -p_i inside, 0 outside, half of it on edges and a quarter at corners; in both bodies.
TEST(InteriorInfluence, TractionsAtTheSurface) {
  const std::vector<std::pair<Point, double>> shares = {{{0, 0, 0}, 1},
                                                        {{0.49, -0.49, 0}, 1},
                                                        {{0.5 - 1e-9, 0, 0}, 1},
                                                        {{0.5, 0.2, 0}, 0.5},
                                                        {{0.1, -0.5, 0}, 0.5},
                                                        {{-0.5, 0.5, 0}, 0.25},
                                                        {{0.5, 0.5, 1e-15}, 0.25},
                                                        {{0.5 + 1e-9, 0, 0}, 0},
                                                        {{0.5, 0.7, 0}, 0},
                                                        {{-3, 0.5, 0}, 0},
                                                        {{40, 7, 0}, 0}};
  for (const auto& [p, share] : shares)
    for (const Body body : {Body::first, Body::second}) {
      const InteriorInfluence a = at(p, body);
      const auto expect = [&, &where = p](const Stress& s, double xz, double yz, double zz) {
        EXPECT_NEAR(s.xz, xz, 1e-14) << text(where);
        EXPECT_NEAR(s.yz, yz, 1e-14) << text(where);
        EXPECT_NEAR(s.zz, zz, 1e-14) << text(where);
      };
      expect(a.px.stress, -share, 0, 0);
      expect(a.py.stress, 0, -share, 0);
      expect(a.pn.stress, 0, 0, -share);
    }
}

TEST(InteriorInfluence, TheSurfaceIsTheLimitFromWithin) {
  for (const Point& p : {Point{0, 0, 0}, {0.4, -0.3, 0}, {0.6, 0, 0}, {0.5, 0.8, 0}, {3, 4, 0}})
    for (const double depth : {1e-3, 1e-6, 1e-9, 1e-11, 1e-13, 1e-200}) {
      const auto surface = nines(at(p)), below = nines(at({p.x, p.y, depth}));
      for (int load = 0; load < 3; ++load)
        EXPECT_LT(difference(surface[load], below[load], unit(), 1), 20 * depth + 2e-14) << text(p) << ", " << depth;
    }
}

/// What influence() gives for two bodies, from each body alone; also for dissimilar ones.
TEST(InteriorInfluence, SurfaceDisplacementsAreThoseOfTheContactProblem) {
  for (const auto& [m1, m2] :
       {std::pair{steel_body, steel_body}, {rubber, steel_body}, {steel_body, Material{40e9, 0.33}}})
    for (const Point& p : {Point{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0}, {0.2, -0.4, 0}, {-3, 2, 0}, {0.5, 30, 0}}) {
      const CombinedMaterial combined = combine(m1, m2);
      const Influence both = influence(combined, dx, dy, p.x * dx, p.y * dy);
      const auto a = nines(at(p, Body::first, m1)), b = nines(at(p, Body::second, m2));
      const auto apart = [&](int load, int component) { return a[load][component] - b[load][component]; };
      const double tolerance = 1e-13 * unit(Material{combined.shear_modulus, 0});
      EXPECT_NEAR(apart(0, 0), both.xx, tolerance) << text(p);
      EXPECT_NEAR(apart(1, 0), both.xy, tolerance) << text(p);
      EXPECT_NEAR(apart(0, 1), both.xy, tolerance) << text(p);
      EXPECT_NEAR(apart(1, 1), both.yy, tolerance) << text(p);
      EXPECT_NEAR(apart(2, 2), both.zz, tolerance) << text(p);
      EXPECT_NEAR(apart(2, 0), both.xz, tolerance) << text(p);
      EXPECT_NEAR(apart(2, 1), both.yz, tolerance) << text(p);
      EXPECT_NEAR(apart(0, 2), -both.xz, tolerance) << text(p);
      EXPECT_NEAR(apart(1, 2), -both.yz, tolerance) << text(p);
    }
}

/// On and near edges and corners, at and below the surface; what is infinite there stays of the size of its logarithm.
TEST(InteriorInfluence, IsFiniteEverywhere) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double depth : {0.0, tiny, 1e-300, 1e-160, 1e-20, 1e-12, 1e-11, 1e-6})
    for (const double x : {-0.5, 0.5, 0.0, 0.5 + 1e-16, 0.5 - 1e-13, 0.5 + 1e-11, 1e6})
      for (const double y : {-0.5, 0.5, 0.0, 0.5 - 1e-16, 2.0, -1e6})
        for (const Body body : {Body::first, Body::second})
          for (const Nine& s : nines(at({x, y, depth}, body))) {
            EXPECT_TRUE(all_finite(s)) << text({x, y, depth});
            EXPECT_LT(difference(s, Nine{}, 10 * unit(), 1), 60) << text({x, y, depth});
          }
}

/// Traction on both sides of an edge leaves nothing of what one side alone does there.
TEST(InteriorInfluence, NeighboursMakeOneRectangle) {
  for (const double depth : {0.0, 1e-13, 1e-9, 1e-3, 0.3})
    for (const double y : {0.0, 0.5, -0.3, 1.2})
      for (const double off : {0.0, 1e-14, 1e-6, 0.2, 40.0}) {
        const double x = off * dx;
        const auto left = nines(interior_influence(steel_body, Body::first, dx, dy, x + dx / 2, y * dy, depth * dx));
        const auto right = nines(interior_influence(steel_body, Body::first, dx, dy, x - dx / 2, y * dy, depth * dx));
        const auto whole = nines(interior_influence(steel_body, Body::first, 2 * dx, dy, x, y * dy, depth * dx));
        for (int load = 0; load < 3; ++load) {
          EXPECT_LT(difference(combine(left[load], 1, right[load]), whole[load], unit(), 1), 1e-13)
              << load << ": " << off << ", " << y << ", " << depth;
        }
      }
}

// --- symmetries

/// A mirrored point sees mirrored states: a load or component along the mirrored axis changes its sign.
TEST(InteriorInfluence, Mirrors) {
  constexpr std::array<int, 3> load_x = {-1, 1, 1}, load_y = {1, -1, 1};
  constexpr std::array<int, 9> component_x = {-1, 1, 1, 1, 1, 1, -1, -1, 1},
                               component_y = {1, -1, 1, 1, 1, 1, -1, 1, -1};
  for (const Point& p : points()) {
    const auto here = nines(at(p)), x = nines(at({-p.x, p.y, p.depth})), y = nines(at({p.x, -p.y, p.depth}));
    for (int load = 0; load < 3; ++load)
      for (int c = 0; c < 9; ++c) {
        const double tolerance = 1e-15 * (c < 3 ? unit() : 1);
        EXPECT_NEAR(x[load][c], load_x[load] * component_x[c] * here[load][c], tolerance) << text(p);
        EXPECT_NEAR(y[load][c], load_y[load] * component_y[c] * here[load][c], tolerance) << text(p);
      }
  }
}

TEST(InteriorInfluence, ExchangeOfAxes) {
  constexpr std::array<int, 9> exchanged = {1, 0, 2, 4, 3, 5, 6, 8, 7};
  constexpr std::array<int, 3> exchanged_load = {1, 0, 2};
  for (const Point& p : points()) {
    const auto here = nines(at(p));
    const auto there = nines(interior_influence(steel_body, Body::first, dy, dx, p.y * dy, p.x * dx, p.depth * dx));
    for (int load = 0; load < 3; ++load)
      for (int c = 0; c < 9; ++c)
        EXPECT_NEAR(here[load][c], there[exchanged_load[load]][exchanged[c]], 1e-15 * (c < 3 ? unit() : 1));
  }
}

/// Body 2 is body 1 upside down, with the opposite tangential tractions on it.
TEST(InteriorInfluence, BodiesMirrorEachOther) {
  constexpr std::array<int, 9> sign = {1, 1, -1, 1, 1, 1, 1, -1, -1};
  for (const Point& p : points()) {
    const auto first = nines(at(p, Body::first, rubber)), second = nines(at(p, Body::second, rubber));
    for (int load = 0; load < 3; ++load)
      for (int c = 0; c < 9; ++c) EXPECT_EQ(second[load][c], (load < 2 ? -1 : 1) * sign[c] * first[load][c]);
  }
}

TEST(InteriorInfluence, ScalesWithLengthAndModulus) {
  for (const Point& p : points())
    for (const double k : {0x1p-12, 3.7, 1e4}) {
      const auto one = nines(at(p));
      const auto other = nines(interior_influence({k * steel_body.shear_modulus, steel_body.poisson_ratio}, Body::first,
                                                  k * dx, k * dy, k * p.x * dx, k * p.y * dy, k * p.depth * dx));
      for (int load = 0; load < 3; ++load) EXPECT_LT(difference(one[load], other[load], unit(), 1), 2e-13) << text(p);
    }
}

/// A rigid body has stresses but does not move; those of px are those of its Poisson's ratio.
TEST(InteriorInfluence, RigidBody) {
  const Material rigid{std::numeric_limits<double>::infinity(), 0.28};
  for (const Point& p : points()) {
    const auto a = nines(at(p, Body::first, rigid)), b = nines(at(p));
    for (int load = 0; load < 3; ++load)
      for (int c = 0; c < 9; ++c) EXPECT_EQ(a[load][c], c < 3 ? 0 : b[load][c]);
  }
}

// --- endless strips

InteriorInfluence strip_at(double x, double depth, double far = dx) {
  return line_interior_influence(steel_body, Body::first, dx, x * dx, depth * dx, far);
}

/// With the length L the rest falls like (size/L)^2; the normal stresses from pressure, some of which are drawn along y
/// where the rectangle ends, like 1/L. On the edge at the surface both are infinite.
TEST(LineInteriorInfluence, IsTheLimitOfLongRectangles) {
  for (const double x : {0.0, 0.2, 0.5, -0.5, -1.3, 6.0})
    for (const double depth : {0.0, 1e-13, 1e-4, 0.2, 1.0, 5.0})
      for (const double length : {1e3, 1e4}) {
        if (std::abs(x) == 0.5 && depth < 1e-12) continue;
        const auto strip = nines(strip_at(x, depth));
        const auto rectangle =
            nines(interior_influence(steel_body, Body::first, dx, length * dx, x * dx, 0, depth * dx));
        const double size = 1 + x * x + depth * depth, second = 10 * size / (length * length) + 1e-13;
        for (int load = 0; load < 3; ++load)
          EXPECT_LT(difference(strip[load], rectangle[load], 1e300, 1), load < 2 ? second : second + 0.3 / length)
              << load << ": " << x << ", " << depth << ", " << length;
      }
}

TEST(LineInteriorInfluence, HookesLaw) {
  for (const double x : {0.1, 0.5, 1.4})
    for (int load = 0; load < 3; ++load) {
      const double depth = 0.4, step = 2e-3 * dx, g = steel_body.shear_modulus, nu = steel_body.poisson_ratio;
      const auto field = [&](const std::array<double, 3>& s) {
        return nines(strip_at(x + s[0] / dx, depth + s[2] / dx))[load];
      };
      const Nine by_x = derivative(field, 0, step), by_z = derivative(field, 2, step), s = field({});
      const double volume = 2 * g * nu / (1 - 2 * nu) * (by_x[0] + by_z[2]);
      const Nine hooke = {0,           0,
                          0,           volume + 2 * g * by_x[0],
                          volume,      volume + 2 * g * by_z[2],
                          g * by_x[1], g * (by_x[2] + by_z[0]),
                          g * by_z[1]};
      EXPECT_LT(difference(s, hooke, 1e300, 1), 1e-10) << x << ", load " << load;
    }
}

TEST(LineInteriorInfluence, SurfaceDisplacementsAreThoseOfTheContactProblem) {
  for (const double x : {0.0, 0.3, 0.5, -0.5, 2.0, -70.0}) {
    const CombinedMaterial combined = combine(rubber, steel_body);
    const double far = 30 * dx;
    const Influence both = line_influence(combined, dx, x * dx, far);
    const auto a = nines(line_interior_influence(rubber, Body::first, dx, x * dx, 0, far));
    const auto b = nines(line_interior_influence(steel_body, Body::second, dx, x * dx, 0, far));
    const auto apart = [&](int load, int component) { return a[load][component] - b[load][component]; };
    const double tolerance = 1e-13 * unit(Material{combined.shear_modulus, 0});
    EXPECT_NEAR(apart(0, 0), both.xx, tolerance);
    EXPECT_NEAR(apart(1, 1), both.yy, tolerance);
    EXPECT_NEAR(apart(2, 2), both.zz, tolerance);
    EXPECT_NEAR(apart(2, 0), both.xz, tolerance);
    EXPECT_NEAR(apart(0, 2), -both.xz, tolerance);
  }
}

} // namespace
} // namespace microslip
