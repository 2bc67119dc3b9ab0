// The calls that a vehicle simulation makes millions of times take no memory and no lock, write nothing and throw
// nothing.

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "microslip/table/making/creep_table_maker.hpp"
#include "tests/support/call_counters.hpp"
#include "tests/test_cases.hpp"

#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Contacts = std::span<const EllipticContact>;
static_assert(noexcept(std::declval<RowSolver&>().solve(std::declval<const EllipticContact&>())));
static_assert(noexcept(std::declval<RowSolver&>().solve(Contacts{}, std::span<ContactForces>{})));
static_assert(noexcept(std::declval<RowSolver&>().differentiate(std::declval<const EllipticContact&>())));
static_assert(noexcept(std::declval<RowSolver&>().differentiate(Contacts{}, std::span<ContactDerivatives>{})));

/// Of all friction laws, with invalid ones and extreme ones among them.
std::vector<EllipticContact> contacts() {
  std::vector<EllipticContact> contacts = every_nth_case(31);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EllipticContact& contact = contacts[k];
    const FrictionTerm term{.drop = 0.2, .half_velocity = 1e-3};
    if (k % 7 == 1) contact.friction = FrictionLaw::linear(0.1, term);
    if (k % 7 == 2) contact.friction = FrictionLaw::rational(0.1, term);
    if (k % 7 == 3) contact.friction = FrictionLaw::exponential(0.1, term);
    if (k % 11 == 4) contact.a = std::numeric_limits<double>::quiet_NaN();
    if (k % 11 == 5) contact.normal_force = -1;
    if (k % 11 == 6) contact.creepage.spin = 1e300;
    if (k % 11 == 7) contact.b = 1e-9;
  }
  return contacts;
}

static_assert(noexcept(std::declval<const CreepForceTable&>().solve(Contacts{}, std::span<ContactForces>{})));
static_assert(noexcept(std::declval<const CreepForceTable&>().differentiate(Contacts{},
                                                                            std::span<ContactDerivatives>{})));

TEST(HotCall, CountersCount) {
  counting = true;
  delete new int(1);
  try {
    throw 1;
  } catch (int) {
  }
  counting = false;
  EXPECT_GE(counts.allocations, 2);
  EXPECT_EQ(counts.throws, 1);
#ifndef MICROSLIP_SANITIZED
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  counting = true;
  pthread_mutex_lock(&mutex);
  pthread_mutex_unlock(&mutex);
  [[maybe_unused]] const auto written = write(STDOUT_FILENO, "", 0);
  counting = false;
  EXPECT_EQ(counts.locks, 1);
  EXPECT_EQ(counts.writes, 1);
#endif
  Silence silence;
  std::printf("heard");
  EXPECT_EQ(silence.end(), 5);
}

TEST(HotCall, TakesNoMemoryNorLockWritesNothingAndThrowsNothing) {
  const auto all = contacts();
  std::vector<ContactForces> forces(all.size());
  std::vector<ContactDerivatives> derivatives(all.size());
  for (RowSolver& solver : all_solvers(10, 10)) {
    SCOPED_TRACE(describe(solver));
    expect_silent([&] {
      for (std::size_t k = 0; k < all.size(); ++k) forces[k] = solver.solve(all[k]);
    });
    expect_silent([&] { solver.solve(all, forces); });
    expect_silent([&] {
      for (std::size_t k = 0; k < all.size(); ++k) derivatives[k] = solver.differentiate(all[k]);
    });
    expect_silent([&] { solver.differentiate(all, derivatives); });
  }
}

CreepTableNodes few_nodes() {
  return make_creep_table(
      {.axes = {.ratios = 4, .poisson_ratios = {0.28}, .levels = 4, .elevations = 4, .azimuths = 4}, .elements = 8});
}

TEST(HotCall, LookingUpForcesInATableTakesNoMemory) {
  const CreepForceTable table(few_nodes());
  const std::vector<EllipticContact> all = contacts();
  std::vector<ContactForces> forces(all.size());
  std::vector<ContactDerivatives> derivatives(all.size());
  expect_silent([&] { table.solve(all, forces); });
  expect_silent([&] { table.differentiate(all, derivatives); });
}

/// z = slope y + curvature y^2.
Profile parabola(ProfileRole role, double slope, double curvature) {
  std::vector<ProfilePoint> points;
  for (int k = -100; k <= 100; ++k) {
    const double y = 3e-4 * k;
    points.push_back({y, slope * y + curvature * y * y});
  }
  return Profile(role, points);
}
Profile head() {
  return parabola(ProfileRole::rail, 0, -1.6);
}
Profile tread() {
  return parabola(ProfileRole::wheel, 0.05, -1.2);
}

TEST(HotCall, SearchingForContactsTakesNoMemory) {
  ContactSearch search(head(), tread());
  std::size_t points = 0, regions = 0;
  expect_silent([&] {
    for (int k = -10; k <= 10; ++k) {
      WheelPlacement<double> placement;
      placement.radius = 0.46;
      placement.wheel.frame = {{0, 1e-3 * k, 0.46}, rotation_about_z(2e-3 * k)};
      for (const double view : {0.0, 1.0}) {
        points += search.find(placement, 3e-4, view).size();
        for (const ContactPoint& point : search.find(placement, 3e-4, view))
          regions += search.regions(point.gap + 1e-5).size();
      }
    }
  });
  EXPECT_GT(points, 21U);
  EXPECT_GT(regions, 21U);
}

TEST(HotCall, AWheelOnARailTakesNoMemory) {
  for (const TrackSide side : {TrackSide::left, TrackSide::right}) {
    WheelRailBodies bodies{
        head(), tread(), {.rail_origin = ProfilePoint{0.75, 0}}, {}, side, steel, {{0, 0.3}, {0.1, 0.2}}};
    const auto table = std::make_shared<const CreepForceTable>(few_nodes());
    for (const WheelRailMethod& method :
         {WheelRailMethod{}, WheelRailMethod{.theory = Theory::table, .table = table}}) {
      WheelRail contact(bodies, method);
      WheelRailSolution found;
      WheelRailDerivatives derivatives;
      WheelState<double> state;
      state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46;
      contact.solve(state, 50e3, found); // gives the solution its size
      int solved = 0;
      expect_silent([&] {
        for (int k = -10; k <= 10; ++k) {
          WheelState<double> there = state;
          there.lateral = 5e-4 * k, there.yaw = 1e-3 * (k % 3);
          if (k == 3) there.yaw = std::numeric_limits<double>::quiet_NaN();
          if (k == 4) there.vertical = 0.1;
          contact.solve(there, k == 4 ? std::nullopt : std::optional(20e3 + 5e3 * k * k), found);
          solved += is_solved(found.status);
          contact.differentiate(there, k == 4 ? std::nullopt : std::optional(50e3), found, derivatives);
          solved += is_solved(found.status);
        }
      });
      EXPECT_GE(solved, 30);
    }
  }
}

TEST(HotCall, MakingAFrictionLawTakesNoMemory) {
  const FrictionTerm term{.drop = 0.1, .half_velocity = 1};
  double sum = 0;
  expect_silent([&] {
    for (const FrictionLaw& law : {FrictionLaw::coulomb(0.3), FrictionLaw::linear(0.1, term, term),
                                   FrictionLaw::rational(0.1, term), FrictionLaw::polach(0.4, 0.5, 0.6)})
      sum += law.static_coefficient();
  });
  EXPECT_NEAR(sum, 0.3 + 0.3 + 0.2 + 0.4, 1e-15);
}

} // namespace
} // namespace microslip
