// Patches of any outline, given row by row.

#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A patch with the memory behind it.
struct Patch {
  int mx;
  double row_width;
  std::vector<double> y, leading, trailing, pressure;

  PatchRows rows() const { return {mx, row_width, y, leading, trailing, pressure}; }
};

/// Rows between y = low and y = high; edge(y) is x of the edge in front, back(y) of the one behind; the pressure in a
/// row is a parabola with the peak peak(y).
template <class Front, class Back, class Peak>
Patch make_patch(int mx, int my, double low, double high, RollingDirection direction, Front front, Back back,
                 Peak peak) {
  Patch patch{mx, (high - low) / my, {}, {}, {}, {}};
  for (int j = 0; j < my; ++j) {
    const double y = low + (j + 0.5) * patch.row_width;
    const bool forward = direction == RollingDirection::forward;
    patch.y.push_back(y);
    patch.leading.push_back(forward ? front(y) : back(y));
    patch.trailing.push_back(forward ? back(y) : front(y));
    for (int i = 0; i < mx; ++i) {
      const double t = 2 * (i + 0.5) / mx - 1;
      patch.pressure.push_back(peak(y) * (1 - t * t));
    }
  }
  return patch;
}

/// The ellipse of a contact with the parabolic pressure (F13).
Patch ellipse(const EllipticContact& contact, const SimplifiedOptions& options) {
  const auto share = [&](double y) { return 1 - y * y / (contact.b * contact.b); };
  const double p0 = 2 * contact.normal_force / ellipse_area(contact);
  return make_patch(
      options.mx, options.my, -contact.b, contact.b, options.direction,
      [&](double y) { return contact.a * std::sqrt(share(y)); },
      [&](double y) { return -contact.a * std::sqrt(share(y)); }, [&](double y) { return p0 * share(y); });
}

PatchMotion motion_of(const EllipticContact& contact, FlexibilityModel model) {
  return {.flexibilities = flexibilities(model, {}, contact),
          .friction = contact.friction,
          .creepage = contact.creepage,
          .rolling_speed = contact.rolling_speed};
}

/// Besides the weights, which make up the load exactly on an ellipse and are the cells' areas on a patch.
TEST(Patch, EllipseAsAPatchIsTheEllipse) {
  std::vector<EllipticContact> contacts = every_nth_case(301);
  for (EllipticContact contact : every_nth_case(397)) {
    contact.friction = FrictionLaw::exponential(0.15, {.drop = 0.25, .half_velocity = 0.002});
    contacts.push_back(contact);
  }
  for (RowSolver& solver : all_solvers(7, 9)) {
    const SimplifiedOptions& options = solver.options();
    if (options.bound != TractionBound::parabolic) continue;
    SCOPED_TRACE(describe(solver));
    for (const EllipticContact& contact : contacts) {
      const ContactSolution f = solver.fields(contact);
      const ContactSolution p =
          solver.fields(ellipse(contact, options).rows(), motion_of(contact, options.flexibility));
      const double peak = *std::max_element(f.fields.bound.begin(), f.fields.bound.end());
      const double weight = f.elements.area[0] / p.elements.area[0];
      for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
        ASSERT_NEAR(p.elements.x[k], f.elements.x[k], 1e-15 * contact.a);
        ASSERT_NEAR(p.elements.y[k], f.elements.y[k], 1e-15 * contact.b);
        ASSERT_NEAR(p.fields.bound[k], f.fields.bound[k], 1e-12 * peak);
        ASSERT_NEAR(p.fields.traction.x[k], f.fields.traction.x[k], 1e-12 * peak);
        ASSERT_NEAR(p.fields.traction.y[k], f.fields.traction.y[k], 1e-12 * peak);
        ASSERT_NEAR(p.elements.area[k] * weight, f.elements.area[k], 1e-13 * f.elements.area[k]);
      }
      const double force = friction_force(contact);
      expect_forces({p.totals.fx * weight, p.totals.fy * weight, p.totals.mz * weight}, f.totals, 1e-12 * force,
                    1e-12 * force * std::max(contact.a, contact.b));
      ASSERT_NEAR(p.totals.frictional_power * weight, f.totals.frictional_power, 1e-10 * f.totals.frictional_power);
    }
  }
}

/// A rectangle of 2a x 2b, 8 x 12 mm: in no row anything changes but the rigid slip.
Patch rectangle(int n, RollingDirection direction) {
  return make_patch(
      n, n, -6e-3, 6e-3, direction, [](double) { return 4e-3; }, [](double) { return -4e-3; },
      [](double) { return 1e9; });
}

/// Two half ellipses that meet at y = 0, 3 mm wide on one side, 9 mm on the other, askew to the rolling direction.
Patch egg(int n, RollingDirection direction) {
  const auto share = [](double y) { return 1 - std::pow(y / (y < 0 ? 3e-3 : 9e-3), 2); };
  return make_patch(
      n, n, -3e-3, 9e-3, direction, [=](double y) { return 0.2 * y + 5e-3 * std::sqrt(share(y)); },
      [=](double y) { return 0.2 * y - 5e-3 * std::sqrt(share(y)); }, [=](double y) { return 1e9 * share(y); });
}

constexpr Creepage creepages[] = {{1e-3, 0, 0},          {0, -2e-3, 0},        {0, 0, 0.8},        {2e-3, 1e-3, 0.3},
                                  {-1e-3, 1.5e-3, -0.6}, {0.5e-3, -2e-3, 0.4}, {4e-3, 1e-3, -0.2}, {1e-3, 3e-3, 1}};

PatchMotion steel_motion(const Creepage& creepage) {
  return {.flexibilities = {3e-14, 3.5e-14, 4e-14},
          .friction = FrictionLaw::exponential(0.2, {.drop = 0.1, .half_velocity = 0.003}),
          .creepage = creepage};
}

template <class Shape>
std::vector<ContactForces> patch_forces(MarchingScheme scheme, RollingDirection direction, Shape shape, int n) {
  RowSolver solver(scheme, {.direction = direction});
  const Patch patch = shape(n, direction);
  std::vector<ContactForces> forces;
  for (const Creepage& creepage : creepages)
    forces.push_back(solver.fields(patch.rows(), steel_motion(creepage)).forces());
  return forces;
}

/// Root of the mean square difference, in units of the size of mu Fn.
double difference(const std::vector<ContactForces>& one, const std::vector<ContactForces>& other) {
  const double force = 0.3 * 1e9 * 100e-6, moment = force * 5e-3;
  double sum = 0;
  for (std::size_t k = 0; k < one.size(); ++k)
    sum += std::pow((one[k].fx - other[k].fx) / force, 2) + std::pow((one[k].fy - other[k].fy) / force, 2) +
           std::pow((one[k].mz - other[k].mz) / moment, 2);
  return std::sqrt(sum / (3.0 * static_cast<double>(one.size())));
}

template <class Shape> void expect_orders(Shape shape) {
  for (const auto direction : all_directions) {
    const auto reference = patch_forces(MarchingScheme::fastsim2, direction, shape, 400);
    for (const auto scheme : all_schemes) {
      SCOPED_TRACE(describe(RowSolver(scheme, {.direction = direction})));
      const double coarse = difference(patch_forces(scheme, direction, shape, 10), reference);
      const double fine = difference(patch_forces(scheme, direction, shape, 80), reference);
      EXPECT_NEAR(std::log2(coarse / fine) / 3, scheme == MarchingScheme::fastsim2 ? 2 : 1, 0.2);
    }
  }
}

TEST(Patch, RectangleConvergesWithTheOrderOfTheScheme) {
  expect_orders(rectangle);
}

TEST(Patch, TwoHalfEllipsesConvergeWithTheOrderOfTheScheme) {
  expect_orders(egg);
}

/// Full sliding along x: the integral of mu p_n, here over a rectangle, where all of it is exact but the midpoint rule
/// along x, which has a relative error of 1/(2 mx^2) for a parabola.
TEST(Patch, FullSlidingGivesFrictionTimesTheIntegralOfThePressure) {
  for (const auto scheme : all_schemes)
    for (const int n : {4, 20}) {
      RowSolver solver(scheme, {});
      const auto f =
          solver
              .fields(rectangle(n, RollingDirection::forward).rows(), {.flexibilities = {1e-14, 1e-14, 1e-14},
                                                                       .friction = FrictionLaw::coulomb(0.25),
                                                                       .creepage = {.longitudinal = -1e3}})
              .forces();
      const double force = 0.25 * 1e9 * 2. / 3 * 8e-3 * 12e-3;
      EXPECT_NEAR(f.fx, force * (1 + 0.5 / (n * n)), 1e-13 * force);
      EXPECT_EQ(f.fy, 0);
      EXPECT_NEAR(f.slip_area, 8e-3 * 12e-3, 1e-17);
      EXPECT_NEAR(f.adhesion_area, 0, 1e-17);
    }
}

/// A row does not know of the others: a patch of two rows is the sum of two patches, moments apart by their lever arms.
TEST(Patch, RowsDoNotInfluenceEachOther) {
  Fastsim2 solver;
  const Patch both = egg(2, RollingDirection::forward);
  const PatchMotion motion = steel_motion({1e-3, 2e-3, 0.4});
  double fx = 0, fy = 0, mz = 0, power = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const Patch one{.mx = 2,
                    .row_width = both.row_width,
                    .y = {both.y[j]},
                    .leading = {both.leading[j]},
                    .trailing = {both.trailing[j]},
                    .pressure = {both.pressure[2 * j], both.pressure[2 * j + 1]}};
    const ContactSolution f = solver.fields(one.rows(), motion);
    fx += f.totals.fx;
    fy += f.totals.fy;
    mz += f.totals.mz;
    power += f.totals.frictional_power;
  }
  const ContactSolution f = solver.fields(both.rows(), motion);
  EXPECT_DOUBLE_EQ(f.totals.fx, fx);
  EXPECT_DOUBLE_EQ(f.totals.fy, fy);
  EXPECT_DOUBLE_EQ(f.totals.mz, mz);
  EXPECT_DOUBLE_EQ(f.totals.frictional_power, power);
}

/// A row of pressure zero carries nothing; pressures that are no parabola do no harm.
TEST(Patch, AnyPressureIsTaken) {
  for (const auto scheme : all_schemes)
    for (const int mx : {1, 2, 3, 4, 9}) {
      RowSolver solver(scheme, {});
      Patch patch = rectangle(mx, RollingDirection::forward);
      for (std::size_t k = 0; k < patch.pressure.size(); ++k)
        patch.pressure[k] = (k / mx) % 2 == 0 ? 0 : 1e9 * static_cast<double>((k * 7) % 5);
      const ContactSolution f = solver.fields(patch.rows(), steel_motion({1e-3, 2e-3, 0.4}));
      EXPECT_EQ(f.report.status, Status::ok);
      for (std::size_t k = 0; k < patch.pressure.size(); ++k) {
        ASSERT_LE(std::hypot(f.fields.traction.x[k], f.fields.traction.y[k]), f.fields.bound[k] * (1 + 4e-16));
        ASSERT_TRUE(std::isfinite(f.fields.slip.x[k]) && std::isfinite(f.fields.slip.y[k]));
        if (patch.pressure[k] == 0) {
          ASSERT_EQ(f.fields.traction.x[k], 0);
        }
      }
    }
}

class BadPatch : public testing::Test {
protected:
  Patch patch = rectangle(3, RollingDirection::forward);
  PatchMotion motion = steel_motion({1e-3, 0, 0});
  Fastsim2 solver;

  void expect(const std::string& field, const std::string& unit_and_range) {
    expect_error([&] { solver.fields(patch.rows(), motion); }, field, unit_and_range);
  }
  void expect_text(const std::string& text) {
    expect_words([&] { solver.fields(patch.rows(), motion); }, text);
  }
};

TEST_F(BadPatch, NumberOfCellsIsRefused) {
  for (const int bad : {0, -1, 10001}) {
    patch.mx = bad;
    expect("mx", "must be in [1, 10000]");
  }
}

TEST_F(BadPatch, RowWidthIsRefused) {
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    patch.row_width = bad;
    expect("row_width", "[m]: must be positive and finite");
  }
}

TEST_F(BadPatch, LengthsThatDoNotMatchAreRefused) {
  patch.leading.pop_back();
  expect_text("leading, trailing: must have as many rows as y, 3");
  patch = rectangle(3, RollingDirection::forward);
  patch.trailing.push_back(0);
  expect_text("leading, trailing: must have as many rows as y, 3");
  patch = rectangle(3, RollingDirection::forward);
  patch.pressure.pop_back();
  expect_text("pressure: must have mx times rows = 9 values");
}

TEST_F(BadPatch, PositionsAreRefused) {
  const Patch good = patch;
  for (const double bad : {infinity, -infinity, nan}) {
    patch.y[1] = bad;
    expect("y[1]", "[m]: must be finite");
    patch = good;
    patch.leading[2] = bad;
    expect("leading[2]", "[m]: must be finite");
    patch = good;
    patch.trailing[0] = bad;
    expect("trailing[0]", "[m]: must be finite");
    patch = good;
  }
}

TEST_F(BadPatch, RowsThatRunTheWrongWayAreRefused) {
  patch.trailing[1] = patch.leading[1];
  expect("leading[1]", "[m]: must be ahead of trailing in the rolling direction");
  patch = rectangle(3, RollingDirection::backward);
  expect("leading[0]", "[m]: must be ahead of trailing in the rolling direction");
}

TEST_F(BadPatch, PressuresAreRefused) {
  for (const double bad : {-1.0, infinity, nan}) {
    patch.pressure[5] = bad;
    expect("pressure[5]", "[Pa]: must be finite and not negative");
  }
}

TEST_F(BadPatch, MotionIsRefused) {
  const PatchMotion good = motion;
  const auto refuses = [&](double& value, double bad, const std::string& field, const std::string& range) {
    value = bad;
    expect(field, range);
    motion = good;
  };
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    const std::string range = "[m/Pa]: must be positive and finite";
    refuses(motion.flexibilities.longitudinal, bad, "flexibilities.longitudinal", range);
    refuses(motion.flexibilities.lateral, bad, "flexibilities.lateral", range);
    refuses(motion.flexibilities.spin, bad, "flexibilities.spin", range);
    refuses(motion.rolling_speed, bad, "rolling_speed", "[m/s]: must be positive and finite");
  }
  for (const double bad : {infinity, -infinity, nan}) {
    refuses(motion.creepage.longitudinal, bad, "creepage.longitudinal", "[-]: must be finite");
    refuses(motion.creepage.lateral, bad, "creepage.lateral", "[-]: must be finite");
    refuses(motion.creepage.spin, bad, "creepage.spin", "[1/m]: must be finite");
  }
}

} // namespace
} // namespace microslip
