// Contacts of any numbers, from none to infinity: status and numbers of the simplified theory and of creep-force tables
// agree, one by one and in batches.

#include "io/creep_table_file.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "paths.hpp"
#include "tests/support/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Numbers of a wheel on a rail, of which some are replaced by others from 1e-320 to the largest, zero, infinity, NaN.
class ExtremeContacts {
public:
  EllipticContact next() {
    odd_ = std::uniform_real_distribution(0.0, 0.6)(random_);
    EllipticContact contact;
    contact.a = number(6e-3, false), contact.b = number(5e-3, false);
    contact.shear_modulus = number(82e9, false), contact.normal_force = number(80e3, false);
    contact.poisson_ratio = is_odd() ? number(0.28, true) : pick({0, 0.28, 0.3, 0.5});
    contact.rolling_speed = number(30, false);
    contact.creepage = {number(1e-3, true), number(-5e-4, true), number(0.2, true)};
    contact.friction = FrictionLaw::coulomb(pick({0, 1e-320, 1e-30, 0.3, 10}));
    if (is_odd()) contact.friction = FrictionLaw::linear(0.1, {.drop = 0.2, .half_velocity = pick({1e-300, 1, 1e300})});
    return contact;
  }

private:
  bool is_odd() { return std::uniform_real_distribution(0.0, 1.0)(random_) < odd_; }
  double pick(const std::vector<double>& numbers) {
    return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random_)];
  }
  double number(double usual, bool is_signed) {
    if (!is_odd()) return usual;
    if (is_odd()) return pick({0, -usual, infinity, -infinity, std::nan(""), 1e-320, 1e-30, 1e30, 1.7e308});
    const double size = std::pow(10, std::uniform_real_distribution(-320.0, 308.0)(random_));
    return is_signed && pick({0, 1}) > 0 ? -size : size;
  }

  std::mt19937_64 random_{7};
  double odd_ = 0;
};

std::vector<EllipticContact> contacts() {
  ExtremeContacts extremes;
  std::vector<EllipticContact> all(6000);
  for (EllipticContact& contact : all) contact = extremes.next();
  return all;
}

/// Solved ones are in range and have no number that is not finite; others have none that is.
void expect_agreement(const ContactForces& f, const EllipticContact& contact, const std::string& who) {
  const double numbers[] = {f.fx, f.fy, f.mz, f.adhesion_area, f.slip_area};
  if (f.status == Status::ok || f.status == Status::out_of_range) {
    EXPECT_TRUE(is_valid_simplified(contact)) << who;
    EXPECT_TRUE(std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) << who;
    const double bound = contact.friction.static_coefficient() * contact.normal_force;
    EXPECT_LE(std::hypot(f.fx, f.fy), bound * (1 + 1e-9) + 1e-300) << who; // of which few bits are left
  } else {
    EXPECT_EQ(f.status, Status::invalid_input) << who;
    EXPECT_TRUE(std::ranges::all_of(numbers, [](double x) { return std::isnan(x); })) << who;
  }
}

void expect_agreement(const ContactDerivatives& d, const EllipticContact& contact, const std::string& who) {
  expect_agreement(d.forces, contact, who);
  const bool is_solved = d.forces.status != Status::invalid_input;
  for (const auto& row : d.jacobian)
    for (const double x : row) EXPECT_TRUE(is_solved ? std::isfinite(x) : std::isnan(x)) << who;
}

bool same(double x, double y) {
  return x == y || (std::isnan(x) && std::isnan(y));
}

template <class Solver> int count_solved(Solver& solver, const std::string& who, bool has_derivatives = true) {
  const std::vector<EllipticContact> all = contacts();
  std::vector<ContactForces> forces(all.size());
  std::vector<ContactDerivatives> derivatives(all.size());
  solver.solve(all, forces);
  if constexpr (requires { solver.differentiate(all, derivatives); })
    if (has_derivatives) solver.differentiate(all, derivatives);
  int solved = 0;
  for (std::size_t k = 0; k < all.size() && !testing::Test::HasFailure(); ++k) {
    const std::string name = who + ", contact " + std::to_string(k);
    expect_agreement(forces[k], all[k], name);
    const ContactForces alone = solver.solve(all[k]);
    EXPECT_TRUE(same(alone.fx, forces[k].fx) && alone.status == forces[k].status) << name;
    if constexpr (requires { solver.differentiate(all, derivatives); }) {
      if (!has_derivatives) continue;
      expect_agreement(derivatives[k], all[k], name);
      expect_agreement(solver.differentiate(all[k]), all[k], name);
    }
    solved += forces[k].status != Status::invalid_input;
  }
  return solved;
}

TEST(ExtremeContacts, BySimplifiedTheories) {
  for (const auto scheme : {MarchingScheme::fastsim, MarchingScheme::fastsim_half_step, MarchingScheme::fastsim2})
    for (const auto model : {FlexibilityModel::three, FlexibilityModel::one, FlexibilityModel::blended}) {
      RowSolver solver(scheme, {.mx = 4, .my = 3, .flexibility = model});
      const int solved = count_solved(solver, "scheme " + std::to_string(int(scheme)) + std::to_string(int(model)));
      EXPECT_GT(solved, 1000);
      EXPECT_LT(solved, 5000);
    }
}

TEST(ExtremeContacts, WithSlopeReductionAndInSinglePrecision) {
  RowSolver reduced(MarchingScheme::fastsim2, {.mx = 4, .my = 3, .slope_reduction = {0.8, 0.3, 2}});
  EXPECT_GT(count_solved(reduced, "reduced"), 1000);
  RowSolver single(MarchingScheme::fastsim2, {.mx = 4, .my = 3, .precision = Precision::single});
  std::vector<EllipticContact> all = contacts();
  std::vector<ContactForces> forces(all.size());
  single.solve(all, forces);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const ContactForces& f = forces[k];
    EXPECT_EQ(f.status == Status::invalid_input, std::isnan(f.fx)) << k;
    EXPECT_EQ(f.status == Status::ok, std::isfinite(f.fx + f.fy + f.mz + f.adhesion_area + f.slip_area)) << k;
  }
}

TEST(ExtremeContacts, ByFastrip) {
  Fastrip solver({.mx = 4, .my = 3, .bound = TractionBound::elliptic});
  EXPECT_GT(count_solved(solver, "fastrip"), 1000);
}

TEST(ExtremeContacts, ByATable) {
  const CreepTableSource source =
      io::creep_table_source(std::string(MICROSLIP_SOURCE_DIR) + "/python/microslip/hertz.creep");
  for (const auto direction : {RollingDirection::forward, RollingDirection::backward}) {
    const CreepForceTable all(source, direction), one(source, 0.28, direction);
    EXPECT_GT(count_solved(all, "all"), 1000);
    EXPECT_GT(count_solved(one, "one"), 1000);
  }
}

/// A solution with fields as well, with the reason in words.
TEST(ExtremeContacts, WithFields) {
  RowSolver solver(MarchingScheme::fastsim2, {.mx = 4, .my = 3});
  for (const EllipticContact& contact : contacts()) {
    const ContactSolution found = solver.fields(contact);
    expect_agreement(found.forces(), contact, "fields");
    EXPECT_EQ(found.report.status == Status::ok, std::isfinite(found.totals.frictional_power));
    EXPECT_EQ(found.report.status == Status::ok, found.report.reason.empty());
  }
}

/// Where one number is to blame, it is named with its range.
TEST(ExtremeContacts, NumbersBeyondTheRangeAreNamed) {
  EllipticContact contact;
  contact.a = 6e-3, contact.b = 5e-3, contact.shear_modulus = 82e9, contact.poisson_ratio = 0.28;
  contact.normal_force = 80e3, contact.friction = FrictionLaw::coulomb(0.3);
  RowSolver solver(MarchingScheme::fastsim2, {.mx = 4, .my = 3});
  const auto reason = [&](double EllipticContact::*number, double value) {
    EllipticContact changed = contact;
    changed.*number = value;
    return solver.fields(changed).report.reason;
  };
  EXPECT_EQ(reason(&EllipticContact::b, 1e-300), "b = 1e-300 [m]: must be in [1e-30, 1e+30]");
  EXPECT_EQ(reason(&EllipticContact::shear_modulus, 1e300), "shear_modulus = 1e+300 [Pa]: must be in [1e-30, 1e+30]");
  EXPECT_EQ(reason(&EllipticContact::normal_force, 1e-320).substr(0, 14), "normal_force =");
  contact.creepage.spin = -1e31;
  EXPECT_EQ(solver.fields(contact).report.reason, "creepage.spin = -1e+31 [1/m]: must be in [-1e+30, 1e+30]");
}

} // namespace
} // namespace microslip
