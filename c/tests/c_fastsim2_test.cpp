#include "c/tests/c_cases.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/same_bits.hpp"
#include "tests/test_cases.hpp"

#include <memory>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Solver = std::unique_ptr<microslip_fastsim2, decltype(&microslip_fastsim2_destroy)>;

microslip_fastsim2_options defaults() {
  microslip_fastsim2_options options;
  EXPECT_EQ(microslip_fastsim2_options_init(&options, sizeof options), MICROSLIP_OK);
  return options;
}

Solver make(const microslip_fastsim2_options* options = nullptr) {
  microslip_fastsim2* solver = nullptr;
  microslip_error error;
  EXPECT_EQ(microslip_fastsim2_create(options, &solver, &error), MICROSLIP_OK) << error.text;
  return {solver, &microslip_fastsim2_destroy};
}

std::span<const double> entries(const double (&jacobian)[3][4]) {
  return {&jacobian[0][0], 12};
}

std::vector<microslip_contact> c_forms(const std::vector<EllipticContact>& contacts) {
  std::vector<microslip_contact> all;
  for (const EllipticContact& contact : contacts) all.push_back(c_form(contact));
  return all;
}

/// Results of a call for contacts, all at once.
template <class Found, class Call>
std::vector<Found> found_by(const Call& call, const Solver& solver, const std::vector<microslip_contact>& contacts) {
  std::vector<Found> found(contacts.size());
  EXPECT_EQ(call(solver.get(), contacts.size(), contacts.data(), found.data()), MICROSLIP_OK);
  return found;
}

TEST(CFastsim2, ForcesAreThoseOfTheLibraryToTheLastBit) {
  const std::vector<EllipticContact> contacts = every_nth_case(7); // several chunks, the last not full
  const std::vector<microslip_contact> all = c_forms(contacts);
  const Solver solver = make();
  const auto together = found_by<microslip_forces>(microslip_fastsim2_solve, solver, all);
  Fastsim2 wanted;
  for (std::size_t k = 0; k < all.size(); ++k) {
    microslip_forces alone;
    ASSERT_EQ(microslip_fastsim2_solve(solver.get(), 1, &all[k], &alone), MICROSLIP_OK);
    const ContactForces forces = wanted.solve(contacts[k]);
    EXPECT_TRUE(same_bits(alone, forces)) << k;
    EXPECT_TRUE(same_bits(together[k], forces)) << k;
  }
}

TEST(CFastsim2, DerivativesAreThoseOfTheLibraryToTheLastBit) {
  const std::vector<EllipticContact> contacts = every_nth_case(23);
  const auto found = found_by<microslip_derivatives>(microslip_fastsim2_differentiate, make(), c_forms(contacts));
  Fastsim2 wanted;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const ContactDerivatives derivatives = wanted.differentiate(contacts[k]);
    EXPECT_TRUE(same_bits(found[k].forces, derivatives.forces)) << k;
    EXPECT_TRUE(same_bits(entries(found[k].jacobian), entries(derivatives.jacobian))) << k;
  }
}

TEST(CFastsim2, EveryOptionReachesTheSolver) {
  const EllipticContact contact = every_nth_case(1)[1000];
  const microslip_contact c = c_form(contact);
  const SimplifiedOptions plain;
  std::vector<SimplifiedOptions> wanted(9, plain);
  std::vector<microslip_fastsim2_options> given(9, defaults());
  wanted[1].mx = given[1].mx = 7;
  wanted[2].my = given[2].my = 13;
  wanted[3].bound = TractionBound::elliptic, given[3].bound = MICROSLIP_ELLIPTIC;
  wanted[4].flexibility = FlexibilityModel::blended, given[4].flexibility = MICROSLIP_BLENDED;
  wanted[5].creepage_table = CreepageTable::computed, given[5].coefficients = MICROSLIP_COMPUTED;
  wanted[6].direction = RollingDirection::backward, given[6].direction = MICROSLIP_BACKWARD;
  wanted[7].slope_reduction = {0.5, 0.3, 2};
  given[7].slope_initial = 0.5, given[7].slope_at_infinity = 0.3, given[7].slope_decay = 2;
  wanted[8].precision = Precision::single, given[8].precision = MICROSLIP_SINGLE;
  const ContactForces of_defaults = Fastsim2().solve(contact);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    microslip_forces found;
    ASSERT_EQ(microslip_fastsim2_solve(make(&given[k]).get(), 1, &c, &found), MICROSLIP_OK);
    EXPECT_TRUE(same_bits(found, Fastsim2(wanted[k]).solve(contact))) << k;
    EXPECT_EQ(same_bits(found, of_defaults), k == 0) << k;
  }
}

TEST(CFastsim2, FrictionLawsReachTheSolver) {
  EllipticContact contact = every_nth_case(1)[1000];
  contact.rolling_speed = 30;
  microslip_contact c = c_form(contact);
  c.friction_drop[0] = 0.1, c.friction_drop[1] = 0.2;
  c.friction_half_velocity[0] = 0.05, c.friction_half_velocity[1] = 0.3;
  const FrictionTerm first{0.1, 0.05}, second{0.2, 0.3};
  const FrictionLaw laws[] = {contact.friction, FrictionLaw::linear(c.friction, first, second),
                              FrictionLaw::rational(c.friction, first, second),
                              FrictionLaw::exponential(c.friction, first, second)};
  const Solver solver = make();
  Fastsim2 wanted;
  for (int law = MICROSLIP_COULOMB; law <= MICROSLIP_EXPONENTIAL; ++law) {
    c.friction_law = law;
    contact.friction = laws[law];
    microslip_derivatives found;
    ASSERT_EQ(microslip_fastsim2_differentiate(solver.get(), 1, &c, &found), MICROSLIP_OK);
    const ContactDerivatives derivatives = wanted.differentiate(contact);
    EXPECT_TRUE(same_bits(found.forces, derivatives.forces)) << law;
    EXPECT_TRUE(same_bits(entries(found.jacobian), entries(derivatives.jacobian))) << law;
  }
}

TEST(CFastsim2, ABadContactSpoilsNoOther) {
  const Solver solver = make();
  const microslip_contact good = some_contact();
  microslip_forces alone;
  ASSERT_EQ(microslip_fastsim2_solve(solver.get(), 1, &good, &alone), MICROSLIP_OK);
  std::vector<microslip_contact> contacts;
  for (const auto& [name, field, value] : wrong_fields) {
    contacts.push_back(good);
    contacts.push_back(good);
    contacts.back().*field = value;
  }
  std::vector<microslip_derivatives> found(contacts.size());
  EXPECT_EQ(microslip_fastsim2_differentiate(solver.get(), contacts.size(), contacts.data(), found.data()),
            MICROSLIP_INVALID_INPUT);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const microslip_derivatives& one = found[k];
    if (k % 2 == 0) {
      EXPECT_TRUE(same_bits(std::span(&one.forces.fx, 5), std::span(&alone.fx, 5)));
      EXPECT_EQ(one.forces.status, MICROSLIP_OK);
    } else {
      EXPECT_TRUE(std::isnan(one.forces.fx) && std::isnan(one.jacobian[2][3])) << wrong_fields[k / 2].name;
      EXPECT_EQ(one.forces.status, MICROSLIP_INVALID_INPUT);
    }
  }
}

TEST(CFastsim2, AContactIsRefusedExactlyIfItsCheckRefusesIt) {
  const Solver solver = make();
  RandomContacts random(5);
  const double numbers[] = {-0.1, 0, 0.2, 5, 9.9, 11, not_a_number, infinite};
  const auto any = [&] { return numbers[static_cast<int>(random.between(0, 8))]; };
  int valid = 0;
  for (int k = 0; k < 4000; ++k) {
    microslip_contact contact = some_contact();
    contact.friction_law = static_cast<int>(random.between(-1, 6));
    contact.friction = random.between(0, 1) < 0.7 ? 0.3 : any();
    for (int i = 0; i < 2; ++i) contact.friction_drop[i] = any(), contact.friction_half_velocity[i] = any();
    microslip_forces forces;
    const microslip_code code = microslip_fastsim2_solve(solver.get(), 1, &contact, &forces);
    EXPECT_EQ(code, microslip_contact_check(&contact, nullptr));
    valid += code == MICROSLIP_OK;
  }
  EXPECT_GT(valid, 400);
  EXPECT_LT(valid, 3600);
}

TEST(CFastsim2, FieldsSumUpToTheForces) {
  const Solver solver = make();
  const microslip_contact contact = some_contact();
  microslip_forces forces, totals;
  ASSERT_EQ(microslip_fastsim2_solve(solver.get(), 1, &contact, &totals), MICROSLIP_OK);
  ASSERT_EQ(microslip_fastsim2_solve_fields(solver.get(), &contact, &forces, nullptr), MICROSLIP_OK);
  std::vector<std::vector<double>> field(9, std::vector<double>(100));
  const char* const names[] = {"x", "y", "area", "bound", "px", "py", "sx", "sy", "state"};
  for (std::size_t k = 0; k < field.size(); ++k)
    ASSERT_EQ(microslip_fastsim2_field(solver.get(), names[k], 100, field[k].data(), nullptr), MICROSLIP_OK);
  const auto& [x, y, area, bound, px, py, sx, sy, state] =
      std::tie(field[0], field[1], field[2], field[3], field[4], field[5], field[6], field[7], field[8]);
  double fx = 0, fy = 0, mz = 0;
  for (std::size_t k = 0; k < 100; ++k) {
    fx += area[k] * px[k];
    fy += area[k] * py[k];
    mz += area[k] * (x[k] * py[k] - y[k] * px[k]);
    EXPECT_TRUE(state[k] == 1 || state[k] == 2);
    EXPECT_LE(std::hypot(px[k], py[k]), bound[k] * (1 + 1e-12));
    if (state[k] == 2) {
      EXPECT_LE(px[k] * sx[k] + py[k] * sy[k], 0);
    }
  }
  expect_forces({fx, fy, mz}, totals, 1e-9 * 24e3, 1e-9 * 24e3 * 5e-3);
  EXPECT_EQ(forces.status, MICROSLIP_OK);
}

TEST(CFastsim2, RefusesWithWords) {
  microslip_error error;
  microslip_fastsim2* none = nullptr;
  const auto refused = [&](auto change, microslip_code code, const char* words) {
    microslip_fastsim2_options options = defaults();
    change(options);
    EXPECT_EQ(microslip_fastsim2_create(&options, &none, &error), code);
    EXPECT_EQ(error.code, code);
    EXPECT_NE(std::string(error.text).find(words), std::string::npos) << error.text;
    EXPECT_EQ(none, nullptr);
  };
  refused([](auto& o) { o.mx = 0; }, MICROSLIP_INVALID_OPTION, "mx = 0");
  refused([](auto& o) { o.my = 10001; }, MICROSLIP_INVALID_OPTION, "my = 10001");
  refused([](auto& o) { o.bound = 2; }, MICROSLIP_INVALID_OPTION, "bound = 2 [-]: must be in [0, 1]");
  refused([](auto& o) { o.flexibility = -1; }, MICROSLIP_INVALID_OPTION, "flexibility = -1");
  refused([](auto& o) { o.coefficients = 2; }, MICROSLIP_INVALID_OPTION, "coefficients = 2");
  refused([](auto& o) { o.direction = 2; }, MICROSLIP_INVALID_OPTION, "direction = 2");
  refused([](auto& o) { o.slope_initial = 0; }, MICROSLIP_INVALID_OPTION, "initial");
  refused([](auto& o) { o.struct_size = 0; }, MICROSLIP_WRONG_SIZE, "struct_size = 0");
  EXPECT_EQ(microslip_fastsim2_create(nullptr, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_options_init(nullptr, 8), MICROSLIP_NULL_POINTER);
  microslip_fastsim2_destroy(nullptr);

  const Solver solver = make();
  const microslip_contact contact = some_contact();
  microslip_forces forces;
  double values[100];
  EXPECT_EQ(microslip_fastsim2_field(solver.get(), "x", 100, values, &error), MICROSLIP_NO_RESULT);
  microslip_contact bad = contact;
  bad.spin = not_a_number;
  EXPECT_EQ(microslip_fastsim2_solve_fields(solver.get(), &bad, &forces, &error), MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(microslip_fastsim2_field(solver.get(), "x", 100, values, &error), MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_fastsim2_solve_fields(solver.get(), &contact, nullptr, &error), MICROSLIP_OK);
  EXPECT_EQ(microslip_fastsim2_field(solver.get(), "x", 99, values, &error), MICROSLIP_WRONG_SIZE);
  EXPECT_STREQ(error.text, "count = 99: must be 100");
  EXPECT_EQ(microslip_fastsim2_field(solver.get(), "pressure", 100, values, &error), MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_fastsim2_field(solver.get(), "x", 100, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_field(nullptr, "x", 100, values, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_solve(nullptr, 1, &contact, &forces), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_solve(solver.get(), 1, nullptr, &forces), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_solve(solver.get(), 1, &contact, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_differentiate(solver.get(), 1, &contact, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_fastsim2_solve(solver.get(), 0, nullptr, nullptr), MICROSLIP_OK);
}

} // namespace
} // namespace microslip
