#include "microslip/error.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/table/creep_coordinates.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "microslip/table/making/creep_table_maker.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double mu = 0.3, load = 80e3;

/// Two Poisson's ratios, few nodes, and few elements: made in a second.
CreepTableMaking small_making(int threads) {
  return {.axes = {.least_ratio = 0.5,
                   .largest_ratio = 2,
                   .ratios = 7,
                   .poisson_ratios = {0.28, 0.4},
                   .levels = 8,
                   .elevations = 7,
                   .azimuths = 9},
          .elements = 8,
          .threads = threads};
}

const CreepTableNodes& small_nodes() {
  static const CreepTableNodes nodes = make_creep_table(small_making(2));
  return nodes;
}

const CreepForceTable& small_table() {
  static const CreepForceTable table(small_nodes());
  return table;
}

/// The contact at scaled creepages (X, Y, Z).
EllipticContact contact_at(double x, double y, double z, double ratio = 1.3, double nu = 0.28) {
  const creep_coordinates::LinearTheory linear(creepage_coefficients(ratio, nu, CreepageTable::computed),
                                               creep_coordinates::spin_scale(ratio));
  const double c = 5e-3;
  EllipticContact contact = steel_contact(c * std::sqrt(ratio), c / std::sqrt(ratio), load);
  contact.poisson_ratio = nu;
  const double g = contact.shear_modulus * c * c / (mu * load);
  contact.creepage = {x / (g * linear.x), y / (g * linear.y), z / (g * linear.z * c)};
  return contact;
}

struct Relative {
  double fx, fy, mz;
};
Relative relative(const ContactForces& f, const EllipticContact& k) {
  const double capacity = k.friction.static_coefficient() * k.normal_force;
  return {f.fx / capacity, f.fy / capacity, f.mz / (capacity * std::sqrt(k.a * k.b))};
}
std::vector<EllipticContact> random_contacts(int count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  std::vector<EllipticContact> contacts;
  for (int i = 0; i < count; ++i) {
    const double ratio = 0.5 * std::pow(4, uniform(random)), t = 0.98 * uniform(random), r = 1.5 * t / (1 - t);
    const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
    contacts.push_back(
        contact_at(r * x / length, r * y / length, r * z / length, ratio, 0.28 + 0.12 * uniform(random)));
  }
  return contacts;
}

TEST(CreepTable, VanishingCreepagesHaveTheForcesOfLinearTheory) {
  for (const double ratio : {0.5, 0.7, 1.0, 1.9})
    for (const auto& [x, y, z] : {Relative{1e-6, 0, 0}, {0, -1e-6, 0}, {0, 0, 1e-6}, {1e-6, 2e-6, -3e-6}}) {
      const auto k = contact_at(x, y, z, ratio);
      const auto c = creepage_coefficients(ratio, k.poisson_ratio, CreepageTable::computed);
      const double arm = std::sqrt(k.a * k.b), stiffness = k.shear_modulus * k.a * k.b;
      const Creepage& creep = k.creepage;
      const auto forces = small_table().solve(k);
      const double tolerance = 2e-5 * 1e-6 * mu * load; // of a coefficient, between its nodes
      expect_forces(forces,
                    {-stiffness * c.c11 * creep.longitudinal,
                     -stiffness * (c.c22 * creep.lateral + arm * c.c23 * creep.spin),
                     -stiffness * arm * (-c.c23 * creep.lateral + arm * c.c33 * creep.spin)},
                    tolerance, tolerance * arm);
      const auto derivatives = small_table().differentiate(k);
      EXPECT_NEAR(derivatives.jacobian[0][0] / (stiffness * c.c11), -1, 2e-4);
      EXPECT_NEAR(derivatives.jacobian[1][1] / (stiffness * c.c22), -1, 2e-4);
    }
}

TEST(CreepTable, LargeCreepagesSlideFully) {
  for (const double angle : {0.0, 0.5, 1.5, 2.5}) {
    const double direction[] = {std::cos(angle), std::sin(angle)};
    const auto k = contact_at(1e7 * direction[0], 1e7 * direction[1], 0);
    const double creep = std::hypot(k.creepage.longitudinal, k.creepage.lateral);
    expect_forces(relative(small_table().solve(k), k),
                  {-k.creepage.longitudinal / creep, -k.creepage.lateral / creep, 0}, 1e-3);
  }
  // Pure spin: rotation about the centre, without forces and with the moment of all tractions along circles.
  const auto spin = contact_at(0, 0, 1e7, 1.0);
  expect_forces(relative(small_table().solve(spin), spin), {0, 0, -3 * std::numbers::pi / 16}, 2e-3);
}

TEST(CreepTable, MirrorImagesHaveMirroredForces) {
  for (const EllipticContact& k : random_contacts(200)) {
    const auto found = small_table().differentiate(k);
    EllipticContact reversed = k, mirrored = k;
    reversed.creepage = {-k.creepage.longitudinal, -k.creepage.lateral, -k.creepage.spin};
    mirrored.creepage.longitudinal *= -1;
    const auto of_reversed = small_table().differentiate(reversed), of_mirrored = small_table().differentiate(mirrored);
    EXPECT_DOUBLE_EQ(of_reversed.forces.fx, -found.forces.fx);
    EXPECT_DOUBLE_EQ(of_reversed.forces.mz, -found.forces.mz);
    EXPECT_DOUBLE_EQ(of_mirrored.forces.fx, -found.forces.fx);
    EXPECT_DOUBLE_EQ(of_mirrored.forces.fy, found.forces.fy);
    EXPECT_DOUBLE_EQ(of_mirrored.jacobian[0][1], -found.jacobian[0][1]);
    EXPECT_DOUBLE_EQ(of_mirrored.jacobian[1][1], found.jacobian[1][1]);
    EXPECT_DOUBLE_EQ(of_reversed.jacobian[2][0], found.jacobian[2][0]);
  }
}

TEST(CreepTable, RollingBackwardIsRollingForwardInAMirror) {
  const CreepForceTable backward(small_nodes(), RollingDirection::backward);
  for (const EllipticContact& k : random_contacts(50)) {
    EllipticContact mirrored = k;
    mirrored.creepage.longitudinal *= -1;
    mirrored.creepage.spin *= -1;
    const auto forward = small_table().differentiate(mirrored), found = backward.differentiate(k);
    EXPECT_DOUBLE_EQ(found.forces.fx, -forward.forces.fx);
    EXPECT_DOUBLE_EQ(found.forces.fy, forward.forces.fy);
    EXPECT_DOUBLE_EQ(found.forces.mz, -forward.forces.mz);
    EXPECT_DOUBLE_EQ(found.jacobian[0][1], -forward.jacobian[0][1]);
    EXPECT_DOUBLE_EQ(found.jacobian[2][2], forward.jacobian[2][2]);
  }
}

TEST(CreepTable, OneTableServesAllLoadsModuliSizesAndFriction) {
  for (const EllipticContact& k : random_contacts(50)) {
    EllipticContact other = k;
    const double size = 3, modulus = 0.1, weight = 7, friction = 0.5;
    other.a *= size;
    other.b *= size;
    other.shear_modulus *= modulus;
    other.normal_force *= weight;
    other.friction = FrictionLaw::coulomb(mu * friction);
    const double g = size * size * modulus / (weight * friction);
    other.creepage = {k.creepage.longitudinal / g, k.creepage.lateral / g, k.creepage.spin / (g * size)};
    expect_forces(relative(small_table().solve(other), other), relative(small_table().solve(k), k), 1e-11);
  }
}

TEST(CreepTable, ForcesAreNeverBeyondFriction) {
  double largest = 0;
  for (const EllipticContact& k : random_contacts(20000)) {
    const auto f = small_table().solve(k);
    largest = std::max(largest, std::hypot(f.fx, f.fy) / (mu * load));
    ASSERT_GE(f.adhesion_area, 0);
    ASSERT_GE(f.slip_area, 0);
  }
  EXPECT_LE(largest, 1);
  EXPECT_GE(largest, 0.999);
}

TEST(CreepTable, DerivativesAreThoseOfTheForces) {
  for (const EllipticContact& k : random_contacts(300)) {
    const auto found = small_table().differentiate(k);
    const double arm = std::sqrt(k.a * k.b), units[] = {1e-2, 1e-2, 1e-2 / arm, load};
    for (int n = 0; n < 4; ++n) {
      const auto moved = [&](double step) {
        EllipticContact other = k;
        double* const numbers[] = {&other.creepage.longitudinal, &other.creepage.lateral, &other.creepage.spin,
                                   &other.normal_force};
        *numbers[n] += step * units[n];
        return small_table().solve(other);
      };
      const double h = 1e-6;
      const auto above = moved(h), below = moved(-h);
      const double differences[] = {above.fx - below.fx, above.fy - below.fy, (above.mz - below.mz) / arm};
      for (int m = 0; m < 3; ++m)
        EXPECT_NEAR(differences[m] / (2 * h), found.jacobian[m][n] * units[n] / (m == 2 ? arm : 1), 2e-5 * mu * load);
    }
  }
}

/// On both sides of a point the derivatives are the same.
void expect_smooth_across(double x, double y, double z, double dx, double dy, double dz) {
  const double h = 1e-7;
  const auto before = small_table().differentiate(contact_at(x - h * dx, y - h * dy, z - h * dz));
  const auto after = small_table().differentiate(contact_at(x + h * dx, y + h * dy, z + h * dz));
  const double arm = 5e-3, stiffness = 82e9 * arm * arm;
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) {
      const double unit = stiffness * (m == 2 ? arm : 1) * (n == 2 ? arm : 1);
      EXPECT_NEAR(after.jacobian[m][n] / unit, before.jacobian[m][n] / unit, 2e-5) << m << n;
    }
}

TEST(CreepTable, DerivativesAreContinuousAcrossBordersNodesAndThePole) {
  expect_smooth_across(0, 0.7, 0.4, 1, 0, 0); // the border of X
  expect_smooth_across(0.4, 0.7, 0, 0, 0, 1); // the border of Z
  expect_smooth_across(0, 0.7, 0, 1, 0, 1);   // both
  expect_smooth_across(0, 0, 1.1, 1, 0, 0);   // the pole
  expect_smooth_across(0, 0, 1.1, 0.6, 0.8, 0);
  expect_smooth_across(0, 0, 0, 0.3, -0.8, 0.5); // no creepage at all
  const double t = 3.5 / 8;                      // midway between two nodes of the level
  expect_smooth_across(1.5 * t / (1 - t), 0, 0, 1, 0, 0);
  const double tilt = creep_coordinates::elevation(1.5 / 6); // midway between two nodes of the elevation
  const auto [x, y, z] = creep_coordinates::direction(1.3, tilt, 0);
  expect_smooth_across(x, y, z, 0, 0, 1);
}

TEST(CreepTable, NodesHaveTheLimitOfTheExactTheory) {
  Solver coarse({.mx = 4, .my = 4}), fine({.mx = 8, .my = 8}), finest({.mx = 16, .my = 16});
  const CreepTableAxes& axes = small_nodes().axes;
  for (const auto& [level, elevation, azimuth] : {std::array{3, 2, 4}, {5, 1, 6}, {6, 5, 1}}) {
    const double t = axes.level(level), r = creep_coordinates::half_way * t / (1 - t);
    const auto [x, y, z] =
        creep_coordinates::direction(axes.ratio(2), axes.elevation(elevation), axes.azimuth(azimuth));
    const auto k = contact_at(r * x, r * y, r * z, axes.ratio(2));
    const auto from = relative(coarse.solve(rolling_problem(k)).forces(), k),
               to = relative(fine.solve(rolling_problem(k)).forces(), k),
               last = relative(finest.solve(rolling_problem(k)).forces(), k);
    const auto limit = [](const Relative& p, const Relative& q) {
      return Relative{limit_of_second_order(p.fx, q.fx), limit_of_second_order(p.fy, q.fy),
                      limit_of_second_order(p.mz, q.mz)};
    };
    const auto first = limit(from, to);
    const bool doubtful =
        std::max({std::abs(first.fx - to.fx), std::abs(first.fy - to.fy), std::abs(first.mz - to.mz)}) > 0.002;
    // 1e-4 of the units that numbers are kept in
    expect_forces(relative(small_table().solve(k), k), doubtful ? limit(to, last) : first, 1e-4);
  }
}

TEST(CreepTable, OneMaterialIsAsInTheTableOfAll) {
  for (const double nu : {0.28, 0.31, 0.4}) {
    const CreepForceTable one(small_nodes(), nu);
    const auto k = contact_at(0.5, -0.4, 0.3, 0.8, nu);
    expect_forces(relative(one.solve(k), k), relative(small_table().solve(k), k), 1e-6);
    EXPECT_EQ(one.solve(k).status, Status::ok);
    EXPECT_EQ(one.solve(contact_at(0.5, -0.4, 0.3, 0.8, 0.5)).status, Status::out_of_range);
  }
  expect_error([] { CreepForceTable(small_nodes(), 0.1); }, "poisson_ratio", "[-]: must be in [0.28, 0.4]");
}

/// The splines are made once: the nodes are not looked at again.
TEST(CreepTable, TablesOfOneSourceShareTheirNumbers) {
  std::vector<std::int16_t> numbers(small_nodes().values.begin(), small_nodes().values.end());
  CreepTableNodes nodes = small_nodes();
  nodes.values = numbers;
  const CreepTableSource source(nodes);
  const auto between = contact_at(0.5, -0.4, 0.3, 0.8, 0.33), at_node = contact_at(0.5, -0.4, 0.3, 0.8, 0.28);
  const ContactForces expected = CreepForceTable(small_nodes(), 0.33).solve(between);
  const ContactForces expected_at_node = small_table().solve(at_node);
  {
    const CreepForceTable first(source, 0.33), all(source);
    std::ranges::fill(numbers, std::int16_t{0});
    EXPECT_EQ(CreepForceTable(source, 0.33).solve(between).fx, expected.fx);
    EXPECT_EQ(CreepForceTable(source).solve(at_node).fx, expected_at_node.fx);
  }
  // What belongs to Poisson's ratios of the nodes stays, other things are made again.
  EXPECT_EQ(CreepForceTable(source, 0.28, RollingDirection::backward).solve(at_node).fy,
            CreepForceTable(small_nodes(), 0.28, RollingDirection::backward).solve(at_node).fy);
  EXPECT_NE(CreepForceTable(source, 0.33).solve(between).fx, expected.fx);
}

TEST(CreepTable, ManyThreadsMayAskOneSourceAtOnce) {
  const auto contact = contact_at(0.5, -0.4, 0.3, 0.8, 0.33);
  const double expected = CreepForceTable(small_nodes(), 0.33).solve(contact).fx;
  const CreepTableSource source = small_nodes();
  std::vector<double> found(8);
  std::vector<std::thread> threads;
  for (double& fx : found)
    threads.emplace_back([&] {
      for (int k = 0; k < 5; ++k) fx = CreepForceTable(source, 0.33).solve(contact).fx;
    });
  for (std::thread& thread : threads) thread.join();
  for (const double fx : found) EXPECT_EQ(fx, expected);
}

TEST(CreepTable, BeyondTheRangeAreLimits) {
  // Linear theory of the contact itself.
  const auto slender = contact_at(1e-6, 0, 0, 9);
  const auto found = small_table().solve(slender);
  EXPECT_EQ(found.status, Status::out_of_range);
  EXPECT_NEAR(found.fx / (mu * load), -1e-6, 1e-11);
  // Full sliding with the longer semi-axis, and continuity at the end of the range.
  const auto sliding = contact_at(0, 1e7, 0, 9);
  EXPECT_NEAR(small_table().solve(sliding).fy / (mu * load), -1, 1e-3);
  const auto inside = contact_at(0.6, 0.5, 0.7, 2 * (1 - 1e-9)), outside = contact_at(0.6, 0.5, 0.7, 2 * (1 + 1e-9));
  EXPECT_EQ(small_table().solve(inside).status, Status::ok);
  EXPECT_EQ(small_table().solve(outside).status, Status::out_of_range);
  expect_forces(relative(small_table().solve(outside), outside), relative(small_table().solve(inside), inside), 1e-5);
}

TEST(CreepTable, InputOutOfRangeIsRefusedOneByOne) {
  std::vector<EllipticContact> contacts(4, contact_at(0.5, 0.2, 0.1));
  contacts[1].a = std::numeric_limits<double>::quiet_NaN();
  contacts[2].dissimilarity = 0.1;
  std::vector<ContactForces> forces(4);
  small_table().solve(contacts, forces);
  EXPECT_EQ(forces[0].status, Status::ok);
  EXPECT_EQ(forces[1].status, Status::invalid_input);
  EXPECT_TRUE(std::isnan(forces[1].fx));
  EXPECT_EQ(forces[2].status, Status::invalid_input);
  EXPECT_EQ(forces[3].fx, forces[0].fx);
  contacts[0].creepage = {};
  EXPECT_EQ(small_table().solve(contacts[0]).fx, 0);
  contacts[0].friction = FrictionLaw::coulomb(0);
  EXPECT_EQ(small_table().differentiate(contacts[0]).jacobian[0][0], 0);
}

void expect_same(const ContactDerivatives& found, const ContactDerivatives& expected) {
  EXPECT_EQ(found.forces.fx, expected.forces.fx);
  EXPECT_EQ(found.forces.fy, expected.forces.fy);
  EXPECT_EQ(found.forces.mz, expected.forces.mz);
  EXPECT_EQ(found.forces.adhesion_area, expected.forces.adhesion_area);
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 4; ++n) EXPECT_EQ(found.jacobian[m][n], expected.jacobian[m][n]);
}

TEST(CreepTable, BatchesAndSingleContactsAreTheSameBitsWithEveryInstructionSet) {
  const auto contacts = random_contacts(203); // the last batch is not full
  std::vector<ContactDerivatives> batch(contacts.size());
  std::vector<ContactForces> forces(contacts.size());
  small_table().differentiate(contacts, batch);
  small_table().solve(contacts, forces);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    expect_same(small_table().differentiate(contacts[i]), batch[i]);
    EXPECT_EQ(small_table().solve(contacts[i]).mz, forces[i].mz);
    EXPECT_NEAR(forces[i].fx, batch[i].forces.fx, 1e-12 * mu * load);
  }
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) {
      EXPECT_THROW(CreepForceTable(small_nodes(), RollingDirection::forward, set), Error);
      continue;
    }
    const CreepForceTable table(small_nodes(), RollingDirection::forward, set);
    std::vector<ContactDerivatives> found(contacts.size());
    table.differentiate(contacts, found);
    for (std::size_t i = 0; i < contacts.size(); ++i) expect_same(found[i], batch[i]);
  }
}

TEST(CreepTable, FallingFrictionIsThatOfTheRigidSlip) {
  EllipticContact falling = contact_at(0.9, 0.7, 0.3);
  falling.rolling_speed = 20;
  falling.friction = FrictionLaw::polach(0.4, 0.5, 2);
  EllipticContact constant = falling;
  const double slip = 20 * std::hypot(falling.creepage.longitudinal, falling.creepage.lateral);
  constant.friction = FrictionLaw::coulomb(falling.friction.coefficient(slip));
  EXPECT_DOUBLE_EQ(small_table().solve(falling).fy, small_table().solve(constant).fy);
  const double h = 1e-8;
  EllipticContact more = falling, less = falling;
  more.creepage.lateral += h;
  less.creepage.lateral -= h;
  const double slope = (small_table().solve(more).fy - small_table().solve(less).fy) / (2 * h);
  EXPECT_NEAR(small_table().differentiate(falling).jacobian[1][1] / slope, 1, 1e-5);
}

TEST(CreepTable, TheNumbersDoNotDependOnTheThreads) {
  CreepTableMaking making = small_making(3);
  making.axes.poisson_ratios = {0.28};
  making.axes.ratios = making.axes.levels = making.axes.elevations = making.axes.azimuths = 4;
  const auto three = make_creep_table(making);
  making.threads = 1;
  const auto one = make_creep_table(making);
  EXPECT_TRUE(std::ranges::equal(three.values, one.values));
  EXPECT_EQ(three.origin, one.origin);
  EXPECT_EQ(one.origin.not_converged, 0);
}

TEST(CreepTable, MakingRefusesAxesThatMakeNoSense) {
  CreepTableMaking making = small_making(1);
  making.axes.azimuths = 3;
  expect_error([&] { make_creep_table(making); }, "nodes of the direction of the creepage", "[-]: must be in [4, 200]");
  making = small_making(1);
  making.axes.poisson_ratios = {0.4, 0.28};
  expect_error([&] { make_creep_table(making); }, "poisson_ratio", "[-]: must be above the one before");
  making = small_making(1);
  making.elements = 9;
  expect_error([&] { make_creep_table(making); }, "elements", "[-]: must be even");
  making = small_making(1);
  making.progress = [](double) { return false; };
  EXPECT_THROW(make_creep_table(making), Stopped);
}

std::vector<std::byte> bytes() {
  return encode(small_nodes());
}
std::string refusal(const std::vector<std::byte>& bytes) {
  return error_of([&] { decode(bytes, nullptr); });
}

TEST(CreepTableBytes, AreReadAsTheyWereWritten) {
  const auto written = bytes();
  const CreepTableNodes nodes = decode(written, nullptr);
  EXPECT_EQ(nodes.axes, small_nodes().axes);
  EXPECT_EQ(nodes.origin, small_nodes().origin);
  EXPECT_EQ(nodes.unit, small_nodes().unit);
  EXPECT_TRUE(std::ranges::equal(nodes.values, small_nodes().values));
}

TEST(CreepTableBytes, CutShortOrTooLongAreRefused) {
  const auto whole = bytes();
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{511}, std::size_t{512}, whole.size() - 1}) {
    const std::vector<std::byte> some(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(refusal(some), "no error") << size;
  }
  auto longer = whole;
  longer.push_back({});
  EXPECT_NE(refusal(longer).find("cut short or too long"), std::string::npos);
}

TEST(CreepTableBytes, AnyChangedByteIsFound) {
  const auto whole = bytes();
  for (std::size_t i = 0; i < whole.size(); i += i < 512 ? 1 : 997) {
    auto changed = whole;
    changed[i] ^= std::byte{0x10};
    EXPECT_NE(refusal(changed), "no error") << i;
  }
}

TEST(CreepTableBytes, AnotherByteOrderVersionOrFormatIsNamed) {
  auto other = bytes();
  std::reverse(other.begin() + 8, other.begin() + 12);
  EXPECT_NE(refusal(other).find("another byte order"), std::string::npos);
  other = bytes();
  other[12] = std::byte{9};
  EXPECT_NE(refusal(other).find("is of version 9; this program reads version 2"), std::string::npos);
  other[12] = std::byte{1};
  EXPECT_NE(refusal(other).find("is of version 1; this program reads version 2: make it again"), std::string::npos);
  other[0] = std::byte{0};
  EXPECT_EQ(refusal(other), "is no creep-force table");
}

} // namespace
} // namespace microslip
