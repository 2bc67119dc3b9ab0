// Points inside the bodies, in grids.

#include "microslip/interior/interior_grid.hpp"

#include "microslip/rolling/solver.hpp"

#include "tests/test_cases.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr Material brass = {40e9, 0.34};

struct Loaded {
  ElementGrid grid = {9, 8, -4e-4, -3e-4, 1e-4, 8e-5};
  std::vector<double> px, py, pn;

  Loaded() {
    RandomContacts random(3);
    for (std::size_t k = 0; k < grid.count(); ++k) {
      pn.push_back(random.between(0, 1e9));
      px.push_back(random.between(-3e8, 3e8));
      py.push_back(random.between(-3e8, 3e8));
    }
  }
  SurfaceTractions tractions() const { return {px, py, pn}; }
};

void expect_near(const InteriorState& a, const InteriorState& b) {
  EXPECT_NEAR(a.ux, b.ux, 1e-18);
  EXPECT_NEAR(a.uz, b.uz, 1e-18);
  EXPECT_NEAR(a.stress.xx, b.stress.xx, 1e-3);
  EXPECT_NEAR(a.stress.xz, b.stress.xz, 1e-3);
  EXPECT_NEAR(a.stress.yy, b.stress.yy, 1e-3);
}

TEST(InteriorGrid, GivesTheFieldOfEachBodyInOrder) {
  const Loaded load;
  const InteriorGrid points = {{1e-4, -3.3e-4}, {0, 2e-4, 1.1e-4}, {2e-4, -1e-4, 0}};
  const auto states = interior_states(steel_body, brass, load.grid, load.tractions(), points);
  ASSERT_EQ(states.size(), 18U);
  EXPECT_EQ(points.count(), 18U);
  const InteriorField first(steel_body, Body::first, load.grid, load.tractions());
  const InteriorField second(brass, Body::second, load.grid, load.tractions());
  std::size_t k = 0;
  for (const double z : points.z)
    for (const double y : points.y)
      for (const double x : points.x) {
        EXPECT_EQ(points.x_of(k), x);
        EXPECT_EQ(points.y_of(k), y);
        EXPECT_EQ(points.z_of(k), z);
        expect_near(states[k++], (z < 0 ? second : first).at({x, y, std::abs(z)}));
      }
}

/// Many points below centres come from transforms, and must not differ.
TEST(InteriorGrid, TransformsAndSumsAgree) {
  const Loaded load;
  InteriorGrid points = {{}, {}, {1.5e-4, -1e-4}};
  for (const int i : {8, 0, 3, 4, 5, 6, 7, 1}) points.x.push_back(load.grid.x(i));
  for (const int j : {2, 3, 5, 7, 0}) points.y.push_back(load.grid.y(j));
  const auto states = interior_states(steel_body, brass, load.grid, load.tractions(), points);
  const InteriorField first(steel_body, Body::first, load.grid, load.tractions());
  const InteriorField second(brass, Body::second, load.grid, load.tractions());
  for (std::size_t k = 0; k < states.size(); ++k)
    expect_near(states[k], (k < 40 ? first : second).at({points.x_of(k), points.y_of(k), std::abs(points.z_of(k))}));
}

/// Whatever came before: other tractions, points, bodies, elements.
TEST(InteriorGrid, SequencesAreAsOneByOne) {
  Loaded load;
  InteriorGrid row = {{}, {load.grid.y(3)}, {1.5e-4, -1e-4}}, point = {{1e-5}, {2e-5}, {1e-4, -1e-4}};
  for (int i = 0; i < 9; ++i) row.x.push_back(load.grid.x(i));
  InteriorSequence sequence;
  const auto expect_same = [&](const InteriorBody& body1, const InteriorBody& body2, const InteriorGrid& points) {
    const auto kept = sequence.states(body1, body2, load.grid, load.tractions(), points);
    const auto alone = interior_states(body1, body2, load.grid, load.tractions(), points);
    ASSERT_EQ(kept.size(), points.count());
    for (std::size_t k = 0; k < kept.size(); ++k) expect_near(kept[k], alone[k]);
  };
  expect_same(steel_body, brass, row);
  expect_same(steel_body, brass, point);
  for (double& p : load.px) p *= -2;
  expect_same(steel_body, brass, row);
  expect_same(brass, steel_body, row);
  expect_same(brass, {steel_body, {0.5, 2e-4}}, row);
  load.grid.dx *= 1.01;
  for (int i = 0; i < 9; ++i) row.x[static_cast<std::size_t>(i)] = load.grid.x(i);
  expect_same(brass, {steel_body, {0.5, 2e-4}}, row);
}

/// Extremes among many random stresses are those found one by one.
TEST(InteriorGrid, ExtremesAreThoseOfAllPoints) {
  RandomContacts random(5);
  std::vector<InteriorState> states(500);
  for (InteriorState& s : states)
    for (double* component : {&s.stress.xx, &s.stress.yy, &s.stress.zz, &s.stress.xy, &s.stress.xz, &s.stress.yz})
      *component = random.between(-1, 1);
  for (std::size_t k = 0; k < 100; ++k) states[400 + k] = states[k]; // of equal ones the first counts
  const std::size_t same = 250;
  states[same].stress = {-9, -9, -9, 0, 0, 0}; // all principal stresses equal
  const auto extremes = interior_extremes(states);
  ASSERT_EQ(extremes.size(), 8U);
  const auto find = [&](const char* name, auto size) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < states.size(); ++k)
      if (size(states[k].stress) > size(states[best].stress)) best = k;
    for (const InteriorExtreme& e : extremes)
      if (e.name == name) {
        EXPECT_EQ(e.point, best) << name;
        EXPECT_EQ(std::abs(e.value), std::abs(size(states[best].stress))) << name;
      }
  };
  find("tresca", tresca);
  find("sigma_1", [](const Stress& s) { return principal_stresses(s)[0]; });
  find("sigma_3", [](const Stress& s) { return -principal_stresses(s)[2]; });
  find("von_mises", von_mises);
  find("sigma_hyd", [](const Stress& s) { return std::abs(hydrostatic(s)); });
}

EllipticContact rolling() {
  return steel_contact(6e-3, 4e-3, 50e3, {1e-3, -5e-4, 0.2});
}

/// Below a contact the classical and the second order's elements, rolling in either direction, give the same stresses
/// but for their discretisation; the mirror of rolling along -x exactly.
TEST(InteriorGrid, OfARollingContact) {
  const EllipticContact contact = rolling();
  const int n = 24;
  const InteriorGrid points = {{-2e-3, 0, 3e-3}, {-1e-3, 1e-3}, {1e-3, 3e-3, -2e-3}};
  const auto solve = [&](Discretisation discretisation, RollingDirection direction, const EllipticContact& c) {
    Solver solver({.mx = n, .my = n, .discretisation = discretisation});
    InteriorGrid at = points;
    if (direction == RollingDirection::backward)
      for (double& x : at.x) x = -x;
    return interior_states(steel_body, steel_body, solver.solve(rolling_problem(c, {.direction = direction})), at);
  };
  EllipticContact mirror = contact;
  mirror.creepage.longitudinal *= -1;
  mirror.creepage.spin *= -1;
  const double p0 = 1.5 * contact.normal_force / ellipse_area(contact);
  const auto classical = solve(Discretisation::classical, RollingDirection::forward, contact);
  for (const auto discretisation : {Discretisation::classical, Discretisation::second_order}) {
    const auto forward = solve(discretisation, RollingDirection::forward, contact);
    const auto backward = solve(discretisation, RollingDirection::backward, mirror);
    for (std::size_t k = 0; k < forward.size(); ++k) {
      EXPECT_NEAR(forward[k].stress.xx, classical[k].stress.xx, 0.01 * p0);
      EXPECT_NEAR(forward[k].stress.xz, classical[k].stress.xz, 0.01 * p0);
      EXPECT_NEAR(forward[k].stress.zz, classical[k].stress.zz, 0.01 * p0);
      EXPECT_NEAR(backward[k].stress.xx, forward[k].stress.xx, 1e-4 * p0);
      EXPECT_NEAR(backward[k].stress.xz, -forward[k].stress.xz, 1e-4 * p0);
      EXPECT_NEAR(backward[k].stress.yz, forward[k].stress.yz, 1e-4 * p0);
    }
  }
}

/// On the axis of Hertz's circle, nu = 0.28: the largest von Mises stress is 0.62 p0 at 0.48 a.
TEST(InteriorGrid, ExtremesBelowAHertzianContact) {
  EllipticContact contact = rolling();
  contact.b = contact.a;
  contact.creepage = {};
  Solver solver({.mx = 32, .my = 32});
  InteriorGrid points = {{0}, {0}, {}};
  for (int k = 0; k <= 60; ++k) points.z.push_back((0.2 + k * 0.01) * contact.a);
  const double p0 = 1.5 * contact.normal_force / ellipse_area(contact);
  const auto extremes =
      interior_extremes(interior_states(steel_body, steel_body, solver.solve(rolling_problem(contact)), points));
  ASSERT_EQ(extremes.size(), 8U);
  EXPECT_EQ(extremes[1].name, "von_mises");
  EXPECT_NEAR(extremes[1].value / p0, 0.626, 0.006);
  EXPECT_NEAR(points.z_of(extremes[1].point) / contact.a, 0.475, 0.02);
  EXPECT_NEAR(extremes[2].value, extremes[1].value, 1e-6 * p0); // two principal stresses are equal
  EXPECT_EQ(extremes[7].name, "sigma_zz");
  EXPECT_EQ(extremes[7].point, 0U);
  EXPECT_NEAR(extremes[7].value / p0, -1 / 1.04, 0.01); // -1/(1 + (z/a)^2)
  EXPECT_TRUE(interior_extremes({}).empty());
}

} // namespace
} // namespace microslip
