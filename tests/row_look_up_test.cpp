// The theory `table` of wheel on rail.

#include "microslip/railway/rows/row_look_up.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

constexpr double a = 6e-3, b = 4e-3, mu = 0.3, load = 60e3, speed = 2;

std::shared_ptr<const CreepForceTable> steel_table() {
  static const auto table = std::make_shared<const CreepForceTable>(
      io::read_creep_table(std::string(MICROSLIP_SOURCE_DIR) + "/python/microslip/hertz.creep"), steel.poisson_ratio);
  return table;
}

/// The loads of an ellipse with its centre at (x, y), in rows of equal width of which the outer ones lie partly beside
/// it. The rows move as one plane body does.
std::vector<LoadedRow> ellipse_rows(int count, double x, double y, const Creepage& at_centre) {
  const auto integral = [](double t) {
    t = std::clamp(t, -1.0, 1.0);
    return t - t * t * t / 3;
  };
  std::vector<LoadedRow> rows;
  const double width = 2.3 * b / count;
  for (int k = 0; k < count; ++k) {
    const double from = -1.15 * b + k * width;
    const double part = (integral((from + width) / b) - integral(from / b)) * b / width;
    LoadedRow row{.y = y + from + width / 2, .width = width, .centre = x, .half_length = 1e-9, .friction = mu};
    row.load = 0.75 * load * part * width / b;
    if (part > 0) row.half_length = a * std::sqrt(part);
    row.creepage = {at_centre.longitudinal - at_centre.spin * (row.y - y), at_centre.lateral - at_centre.spin * x,
                    at_centre.spin};
    rows.push_back(row);
  }
  return rows;
}

ContactForces table_forces(const Creepage& creepage) {
  return steel_table()->solve({.a = a,
                               .b = b,
                               .shear_modulus = steel.shear_modulus,
                               .poisson_ratio = steel.poisson_ratio,
                               .normal_force = load,
                               .friction = FrictionLaw::coulomb(mu),
                               .creepage = creepage});
}

/// Forces of all rows, and the moment about the ellipse's centre.
struct Sum {
  double fx = 0, fy = 0, mz = 0;
};
Sum sum_of(const std::vector<LoadedRow>& rows, double x, double y, double side = 1) {
  RowLookUp look_up(steel_table(), rows.size());
  std::vector<RowForces> forces(rows.size());
  look_up.solve(steel, rows, side, forces);
  Sum sum;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    sum.fx += forces[k].fx, sum.fy += forces[k].fy;
    sum.mz += forces[k].mz - x * forces[k].fy - (rows[k].y - y) * forces[k].fx;
  }
  return sum;
}

const Creepage creepages[] = {{1e-3, 0, 0}, {-3e-4, 8e-4, 0.2}, {2e-4, -5e-4, -0.8}, {1e-4, -1e-4, 1.5}};

TEST(RowLookUp, RowsOfAnEllipseTellWhichItIs) {
  // Errors of the ellipse fall with the third power of the rows' width: with 13 they are some thousandths.
  for (const Creepage& w : creepages) {
    const ContactForces wanted = table_forces(w);
    const auto error = [&](int count) {
      const Sum found = sum_of(ellipse_rows(count, 0, 0, w), 0, 0);
      return std::hypot(found.fx - wanted.fx, found.fy - wanted.fy) / (mu * load);
    };
    EXPECT_LT(error(13), 4e-3);
    EXPECT_LT(error(52), 1.5e-4);
  }
}

TEST(RowLookUp, BackwardIsForwardInAMirror) {
  for (const Creepage& w : creepages) {
    const Creepage mirrored{-w.longitudinal, w.lateral, -w.spin};
    const Sum forward = sum_of(ellipse_rows(13, 1e-3, 0, w), 1e-3, 0),
              backward = sum_of(ellipse_rows(13, -1e-3, 0, mirrored), -1e-3, 0, -1);
    expect_forces(backward, {-forward.fx, forward.fy, -forward.mz}, 1e-9 * mu * load, 1e-12 * load);
  }
}

TEST(RowLookUp, ForcesAreContinuousWhereTwoEllipsesMeet) {
  const auto forces_with = [](double saddle) {
    const Creepage w{3e-4, 2e-4, 0.3};
    std::vector<LoadedRow> rows = ellipse_rows(13, 0, -1.15 * b, w);
    for (const LoadedRow& row : ellipse_rows(13, 0, 1.15 * b, w)) rows.push_back(row);
    for (const std::size_t k : {12U, 13U}) rows[k].load = saddle, rows[k].half_length = 1e-4 * std::sqrt(saddle + 1e-9);
    return sum_of(rows, 0, 0);
  };
  const auto change = [&, apart = forces_with(0)](double saddle) {
    const Sum together = forces_with(saddle);
    return std::hypot(together.fx - apart.fx, together.fy - apart.fy) / (mu * load);
  };
  // In proportion to the load between them: no jump.
  for (const double saddle : {1e-3, 1e-2, 1e-1})
    EXPECT_NEAR(change(saddle), saddle * change(1e-3) / 1e-3, 3e-4 * saddle);
  EXPECT_LT(change(1e-3), 1e-5);
  EXPECT_GT(change(1e3), 5e-3) << "united they have other forces";
}

/// Two halves of ellipses of the widths (1 - psi) b and (1 + psi) b with the same semi-axis a, about the centre of its
/// load: as rows, and as pressures on elements for the exact theory.
struct DoubleEllipse {
  double psi;

  double centre() const { return -0.75 * psi * b; }
  /// Squared half-length over a^2, y from the common axis.
  double square(double y) const {
    const double t = y / (y > 0 ? (1 - psi) * b : (1 + psi) * b);
    return std::max(0.0, 1 - t * t);
  }
  std::vector<LoadedRow> rows(int count, const Creepage& w) const {
    std::vector<LoadedRow> rows;
    const double width = 2 * b / count;
    for (int k = 0; k < count; ++k) {
      const double from_axis = -(1 + psi) * b + (k + 0.5) * width, part = square(from_axis), y = from_axis - centre();
      rows.push_back({.y = y,
                      .width = width,
                      .centre = 0,
                      .half_length = a * std::sqrt(part),
                      .load = 0.75 * load * part * width / b,
                      .friction = mu,
                      .creepage = {w.longitudinal - w.spin * y, w.lateral, w.spin}});
    }
    double sum = 0;
    for (const LoadedRow& row : rows) sum += row.load;
    for (LoadedRow& row : rows) row.load *= load / sum;
    return rows;
  }
  Sum by_table(const Creepage& w) const { return sum_of(rows(30, w), 0, 0); }
  /// The same without strips, by the ellipse alone.
  Sum by_ellipse(const Creepage& w) const {
    const double second = 0.2 + 0.6 * psi * psi - 0.5625 * psi * psi, width = std::sqrt(5 * second) * b;
    const ContactForces f = steel_table()->solve({.a = a * std::sqrt(b / width),
                                                  .b = width,
                                                  .shear_modulus = steel.shear_modulus,
                                                  .poisson_ratio = steel.poisson_ratio,
                                                  .normal_force = load,
                                                  .friction = FrictionLaw::coulomb(mu),
                                                  .creepage = w});
    return {f.fx, f.fy, f.mz};
  }
  PatchRolling exact(int n) const {
    const int before = n / 2 + 4;
    const double dx = 2 * a / n, dy = 2 * b / n;
    const ElementGrid grid{
        .mx = n + 9, .my = n, .x0 = -before * dx, .y0 = -(1 + psi) * b + dy / 2 - centre(), .dx = dx, .dy = dy};
    const auto integral = [](double t) {
      t = std::clamp(t, -1.0, 1.0);
      return t * std::sqrt(1 - t * t) + std::asin(t);
    };
    NormalSolution normal;
    for (int j = 0; j < grid.my; ++j) {
      const double part = square(grid.y(j) + centre()), length = a * std::sqrt(part);
      for (int i = 0; i < grid.mx; ++i) {
        const double x = grid.x(i);
        normal.pressure.push_back(part * (integral((x + dx / 2) / length) - integral((x - dx / 2) / length)));
        normal.contact_elements += normal.pressure.back() > 0;
      }
    }
    const double sum = std::accumulate(normal.pressure.begin(), normal.pressure.end(), 0.0) * grid.element_area();
    for (double& p : normal.pressure) p *= load / sum;
    normal.normal_force = load;
    normal.gap.assign(grid.count(), 0), normal.displacement = normal.gap;
    return PatchRolling(steel, grid, std::move(normal));
  }
};

/// Creepages with the scaled size `size` in every direction of a lattice.
std::vector<Creepage> in_all_directions(double size) {
  const double unit = size * mu * load / (steel.shear_modulus * a * b), c = std::sqrt(a * b);
  std::vector<Creepage> all;
  for (const double x : {-1, 0, 1})
    for (const double y : {-1, 0, 1})
      for (const double z : {-1, 0, 1})
        if (x != 0 || y != 0 || z != 0) all.push_back({unit * x / 4, unit * y / 4, unit * z / (4 * c)});
  return all;
}

TEST(RowLookUp, TheMirrorImageOfAPatchHasTheMirroredForces) {
  for (const double size : {0.5, 2.0, 30.0})
    for (const Creepage& w : in_all_directions(size)) {
      const Sum forces = DoubleEllipse{0.5}.by_table(w),
                image = DoubleEllipse{-0.5}.by_table({w.longitudinal, -w.lateral, -w.spin});
      expect_forces(image, {forces.fx, -forces.fy, -forces.mz}, 1e-9 * mu * load, 1e-9 * mu * load * std::sqrt(a * b));
    }
}

TEST(RowLookUp, ForcesOfAPatchStayBelowWhatFrictionBears) {
  for (const double psi : {0.0, 0.6, -0.9})
    for (const double size : {0.1, 1.0, 3.0, 10.0, 100.0, 1e4})
      for (const Creepage& w : in_all_directions(size)) {
        const Sum forces = DoubleEllipse{psi}.by_table(w);
        EXPECT_LT(std::hypot(forces.fx, forces.fy), mu * load);
        if (size == 1e4 && w.spin == 0) {
          EXPECT_GT(std::hypot(forces.fx, forces.fy), 0.999 * mu * load);
        }
      }
}

TEST(RowLookUp, SmallCreepagesOfALopsidedPatchHaveTheForcesOfLinearTheory) {
  const DoubleEllipse shape{0.6};
  PatchRolling exact = shape.exact(32);
  const double c = std::sqrt(a * b), small = 2e-3 * mu * load / (steel.shear_modulus * a * b);
  for (const Creepage& w : {Creepage{small, 0, 0}, Creepage{0, small, 0}, Creepage{0, 0, small / c}}) {
    const ContactSolution s = exact.solve({.friction = mu, .creepage = w});
    const Sum found = shape.by_table(w);
    const double unit = steel.shear_modulus * a * b * small;
    expect_forces(found, s.totals, 0.15 * unit,
                  0.15 * unit * c); // of some 4: on these elements linear theory itself is by 0.1 off
  }
}

TEST(RowLookUp, ALopsidedPatchHasTheForcesOfTheExactTheory) {
  const DoubleEllipse shape{0.6};
  PatchRolling exact = shape.exact(24);
  const double c = std::sqrt(a * b);
  double of_table = 0, of_ellipse = 0, largest = 0;
  for (const double size : {1.0, 4.0, 16.0})
    for (const Creepage& w : in_all_directions(size)) {
      const ContactSolution s = exact.solve({.friction = mu, .creepage = w});
      ASSERT_EQ(s.report.status, Status::ok);
      const auto square = [&](const Sum& f) {
        const double x = f.fx - s.totals.fx, y = f.fy - s.totals.fy, z = (f.mz - s.totals.mz) / c;
        return (x * x + y * y + z * z) / (mu * load * mu * load);
      };
      const double error = square(shape.by_table(w));
      of_table += error, of_ellipse += square(shape.by_ellipse(w)), largest = std::max(largest, error);
    }
  EXPECT_LT(of_table, 0.5 * of_ellipse) << "squares of errors";
  EXPECT_LT(std::sqrt(largest), 0.06);
}

/// A wheel on the right.
WheelRailBodies example_bodies() {
  return s1002_on_60e1(TrackSide::right);
}

WheelRail table_level(WheelRailBodies bodies) {
  return WheelRail(std::move(bodies), {.theory = Theory::table, .table = steel_table()});
}

/// The roll angle in equilibrium, yaw in proportion.
WheelState<double> state_at(const WheelRailBodies& bodies, double lateral, double yaw_per_metre, double braking) {
  const WheelsetSearch::Side pair{bodies.rail, bodies.wheel};
  WheelState<double> state;
  state.lateral = lateral, state.yaw = yaw_per_metre * lateral;
  state.roll = WheelsetSearch(bodies.track, bodies.wheelset, pair, pair).solve(lateral, state.yaw).roll;
  state.forward_velocity = speed;
  state.pitch_velocity = (1 - braking) * speed / bodies.wheelset.nominal_radius;
  return state;
}

TEST(TableLevel, ForcesAreThoseOfTheExactLevelWithinAFewPercent) {
  const WheelRailBodies bodies = example_bodies();
  WheelRail exact(bodies, {.theory = Theory::exact}), table = table_level(bodies);
  std::vector<double> errors;
  for (int k = 0; k < 24; ++k) {
    const WheelState<double> state = state_at(bodies, -4e-4 * (k + 0.5), k % 2 == 0 ? 2.4 : 0.2, 3e-4 * (k % 3 - 1));
    const WheelRailSolution wanted = exact.solve(state, 10e3), found = table.solve(state, 10e3);
    ASSERT_EQ(wanted.status, Status::ok);
    ASSERT_EQ(found.status, Status::ok);
    double capacity = 0, fx = 0, fs = 0;
    for (const WheelRailPatch& p : wanted.patches) capacity += mu * p.normal_force, fx -= p.fx, fs -= p.fs;
    for (const WheelRailPatch& p : found.patches) fx += p.fx, fs += p.fs;
    errors.push_back(std::hypot(fx, fs) / capacity);
  }
  const double rms = std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0) / 24);
  EXPECT_LT(rms, 0.04);
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[12], 0.01) << "median";
  EXPECT_LT(errors.back(), 0.15);
}

TEST(TableLevel, LeftAndRightAreMirrorImages) {
  WheelRailBodies bodies = example_bodies();
  WheelRail right = table_level(bodies);
  bodies.side = TrackSide::left;
  WheelRail left = table_level(bodies);
  for (const double lateral : {-1e-3, -4e-3, -7e-3}) {
    const WheelState<double> state = state_at(example_bodies(), lateral, 0.5, 2e-4);
    const auto r = right.solve(state, 50e3), l = left.solve(state.mirrored(), 50e3);
    EXPECT_NEAR(l.force.x, r.force.x, 1e-9 * 50e3);
    EXPECT_NEAR(l.force.y, -r.force.y, 1e-9 * 50e3);
    EXPECT_NEAR(l.moment.z, -r.moment.z, 1e-9 * 50e3);
  }
}

TEST(TableLevel, DerivativesAreThoseOfDifferences) {
  const WheelRailBodies bodies = example_bodies();
  WheelRail contact = table_level(bodies);
  for (const double lateral : {-1.5e-3, -3.5e-3}) {
    const WheelState<double> state = state_at(bodies, lateral, 0.3, 1e-4);
    WheelRailSolution here;
    WheelRailDerivatives d;
    contact.differentiate(state, 50e3, here, d);
    ASSERT_EQ(here.status, Status::ok);
    const auto check = [&](WheelVariable variable, double step) {
      const auto k = static_cast<std::size_t>(variable);
      WheelState<double> up = state, down = state;
      *up.numbers()[k] += step, *down.numbers()[k] -= step;
      const Vec3<double> wanted = 1 / (2 * step) * (contact.solve(up, 50e3).force - contact.solve(down, 50e3).force);
      const double size = std::sqrt(dot(wanted, wanted));
      EXPECT_NEAR(d.force(k).x, wanted.x, 2e-3 * size) << "variable " << k;
      EXPECT_NEAR(d.force(k).y, wanted.y, 2e-3 * size) << "variable " << k;
    };
    check(WheelVariable::lateral_velocity, 1e-6 * speed);
    check(WheelVariable::pitch_velocity, 1e-6 * speed);
    check(WheelVariable::yaw_velocity, 1e-6 * speed);
    check(WheelVariable::yaw, 1e-6);
  }
}

void expect_refused(const WheelRailMethod& method, const std::string& reason) {
  expect_words([&] { WheelRail(example_bodies(), method); }, reason);
}

TEST(TableLevel, WhatItCannotDoIsSaid) {
  WheelRailMethod method{.theory = Theory::table};
  expect_refused(method, "needs a creep-force table, and none is given");
  method.table = steel_table();
  method.fields = true;
  expect_refused(method, "fields");
  method.fields = false, method.shape = PatchShape::flat;
  expect_refused(method, "shape");
  method.shape.reset();
  method.table = std::make_shared<const CreepForceTable>(
      io::read_creep_table(std::string(MICROSLIP_SOURCE_DIR) + "/python/microslip/hertz.creep"), steel.poisson_ratio,
      RollingDirection::backward);
  expect_refused(method, "rolling forward");
  WheelRail contact = table_level(example_bodies());
  WheelState<double> state;
  state.yaw = NAN;
  EXPECT_EQ(contact.solve(state, 50e3).status, Status::invalid_input);
}

} // namespace
} // namespace microslip
