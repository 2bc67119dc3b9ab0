// Contact problems of module 3 through the library: the numbers of the code that runs CONTACT's files, bit for bit, and
// Hertz's.

#include "compat/libcontact/tests/library_test.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/contact_input_cases.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

using contact_program::Outcome;
using contact_program::outcomes_of;

class ContactProblems : public LibraryTest {
protected:
  void SetUp() override {
    LibraryTest::SetUp();
    ASSERT_EQ(initialize(7, 3), 0);
  }

  void expect_same(const Outcome& o, int icp) {
    const auto& t = o.totals;
    EXPECT_EQ(scalars(cntc_getcontactforces, 7, icp), (Values{t.fn, t.fx, t.fy, t.mz}));
    EXPECT_EQ(scalars(cntc_getpenetration, 7, icp), Values{t.approach});
    const double element = o.step.grid.element_area() * 1e6;
    EXPECT_EQ(scalars(cntc_getcontactpatchareas, 7, icp),
              (Values{t.contact * element, t.adhesion * element, t.slip * element}));
    const SurfaceFields& f = o.solution.fields;
    for (const auto& [code, wanted] : {std::pair{CNTC_fld_px, &f.traction.x}, {CNTC_fld_py, &f.traction.y}}) {
      const Values found = field(7, icp, code, elements(7, icp));
      ASSERT_EQ(found.size(), wanted->size());
      for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k], (*wanted)[k] * 1e-6);
    }
    const Values slip = field(7, icp, CNTC_fld_sx, elements(7, icp));
    const bool shifts = o.step.motion.motion == ContactMotion::shift;
    for (std::size_t k = 0; k < slip.size(); ++k) ASSERT_EQ(slip[k], f.slip.x[k] * (shifts ? 1e3 : 1));
  }
};

/// Cattaneo's shift, as CONTACT's example has it: first pressed together, then shifted by a force.
TEST_F(ContactProblems, AreCattaneosShift) {
  const auto outcomes = outcomes_of(R"( 3 MODULE
 200100
 022020
 0000331
 999 20 25 1 1e-5
 9.1954 0 0 0
 .4 .4
 .42 .42 200. 200.
 1
 19 19 -1.26667 -1.26667 .13333 .13333
 1 1
 .01 0 .01 0 0 0
 3 MODULE
 001120
 022020
 0000331
 999 20 25 1 1e-5
 9.1954 -.875 0 0
 .4 .4
 .42 .42 200. 200.
 1
 19 19 -1.26667 -1.26667 .13333 .13333
 1 1
 .01 0 .01 0 0 0
)");
  int ire = 7, icp = 2;
  double force = 9.1954, fx = -0.875, fy = 0;
  ASSERT_EQ(set(cntc_setmaterialparameters, 7, 2, 0, {0.42, 0.42, 200, 200}), 0);
  ASSERT_EQ(set(cntc_setfrictionmethod, 7, 2, 0, {0.4, 0.4}), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 7, 2, 1, {19, 19, -1.26667, -1.26667, 0.13333, 0.13333}), 0);
  ASSERT_EQ(set(cntc_setundeformeddistc, 7, 2, 1, {0.01, 0, 0.01, 0, 0, 0}), 0);
  ASSERT_EQ(cntc_setnormalforce(&ire, &icp, &force), 0);
  ASSERT_EQ(set_flag(7, 2, CNTC_ic_tang, 0), 0);
  ASSERT_EQ(set_flag(7, 2, CNTC_ic_pvtime, 0), 0); // the first call begins anew all the same
  ASSERT_EQ(calculate(7, 2), 0) << library_.log();
  EXPECT_EQ(scalars(cntc_getpenetration, 7, 2), Values{outcomes[0].totals.approach});
  ASSERT_EQ(set_flag(7, 2, CNTC_ic_tang, 1), 0);
  ASSERT_EQ(set_flag(7, 2, CNTC_ic_force, 2), 0);
  ASSERT_EQ(cntc_settangentialforces(&ire, &icp, &fx, &fy), 0);
  ASSERT_EQ(calculate(7, 2), 0) << library_.log();
  expect_same(outcomes[1], 2);
  EXPECT_EQ(scalars(cntc_getcreepages, 7, 2)[0], outcomes[1].totals.x) << "the shift that the force has led to";
}

TEST_F(ContactProblems, RollSteadily) {
  const auto outcomes = outcomes_of(R"( 3 MODULE
 203100
 022020
 0000331
 999 20 25 1 1e-5
 1000. .001 -.0005 .0001
 .3 .3
 0d .2 1000.
 .28 .28 82000. 82000.
 1
 21 21 -1.05 -1.05 .1 .1
 1 1
 .005 0 .005 0 0 0
)");
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(calculate(7, 1), 0) << library_.log();
  expect_same(outcomes[0], 1);
  const Values w = field(7, 1, CNTC_fld_wx, 441), pn = field(7, 1, CNTC_fld_pn, 441);
  EXPECT_NEAR(w[0], 1e-3 + 1e-4, 1e-15) << "xi - phi y at y = -1";
  double force = 0;
  for (const double p : pn) force += p * 0.01;
  EXPECT_NEAR(force, 1000, 1e-6 * 1000);
}

/// Creepages and slip of the elements are those of a shift if it is one, whichever call comes first.
TEST_F(ContactProblems, ShiftAsFarInAnyOrderOfCalls) {
  const auto forces = [](int icp, bool first) {
    int ire = 7, count = 441;
    Values wx(441, 1e-4), wy(441, -2e-4);
    EXPECT_EQ(set_up_sphere(7, icp), 0);
    EXPECT_EQ(set_flag(7, icp, CNTC_ic_tang, first ? 1 : 3), 0);
    EXPECT_EQ(set(cntc_setcreepages, 7, icp, 5e-4, 1e-4, 1e-4), 0);
    EXPECT_EQ(cntc_setextrarigidslip(&ire, &icp, &count, wx.data(), wy.data()), 0);
    EXPECT_EQ(set_flag(7, icp, CNTC_ic_tang, 1), 0);
    EXPECT_EQ(calculate(7, icp), 0);
    return scalars(cntc_getcontactforces, 7, icp);
  };
  const Values found = forces(1, true);
  EXPECT_GT(std::abs(found[1]), 20);
  EXPECT_LT(std::abs(found[1]), 290) << "it does not slide";
  EXPECT_EQ(forces(2, false), found);
}

/// Of a shift the deformation is against the slip and along the traction; of one more only its length is known.
TEST_F(ContactProblems, HaveLayersThatYield) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(set(cntc_setmaterialparameters, 7, 1, 4, {0.28, 0.28, 82000, 82000, 8200, 0.02, 60, 500}), 0);
  ASSERT_EQ(set_flag(7, 1, CNTC_ic_tang, 1), 0);
  ASSERT_EQ(calculate(7, 1), 0) << library_.log();
  const Values x = field(7, 1, CNTC_fld_uplsx, 441), y = field(7, 1, CNTC_fld_uplsy, 441),
               px = field(7, 1, CNTC_fld_px, 441), py = field(7, 1, CNTC_fld_py, 441),
               yield = field(7, 1, CNTC_fld_taucrt, 441);
  ASSERT_EQ(x.size(), 441u) << library_.log();
  EXPECT_GT(*std::max_element(yield.begin(), yield.end()), 60);
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_NEAR(std::hypot(x[k], y[k]), (yield[k] - 60) / 500, 1e-12);
    EXPECT_NEAR(x[k] * py[k], y[k] * px[k], 1e-9);
    EXPECT_GE(x[k] * px[k], 0);
  }
  ASSERT_EQ(set_flag(7, 1, CNTC_ic_pvtime, 0), 0);
  ASSERT_EQ(calculate(7, 1), 0);
  EXPECT_EQ(field(7, 1, CNTC_fld_uplsx, 441), Values()) << "-99";
}

TEST_F(ContactProblems, AreHertzs) {
  ASSERT_EQ(set(cntc_setmaterialparameters, 7, 1, 0, {0.28, 0.28, 82000, 82000}), 0);
  ASSERT_EQ(set(cntc_sethertzcontact, 7, 1, -1, {30, 30, 0.001, 0.002, 1.2}), 0);
  ASSERT_EQ(set(cntc_setnormalforce, 7, 1, 10e3), 0);
  ASSERT_EQ(calculate(7, 1), 0) << library_.log();
  const Values h = list(cntc_gethertzcontact, 7, 1, 10);
  const HertzContact wanted = hertz_from_load({1, 2}, combine({82e9, 0.28}, {82e9, 0.28}), 10e3);
  EXPECT_NEAR(h[0], 0.001, 1e-12);
  EXPECT_NEAR(h[2], wanted.a * 1e3, 1e-9);
  EXPECT_NEAR(h[3], wanted.b * 1e3, 1e-9);
  EXPECT_NEAR(h[4], 2 / 0.003, 1e-6);
  EXPECT_NEAR(h[9], wanted.a / wanted.b, 1e-9);
  EXPECT_NEAR(scalars(cntc_getpenetration, 7, 1)[0] / (wanted.approach * 1e3), 1, 0.01);
  const Values p = list(cntc_getpotcontact, 7, 1, 6);
  EXPECT_NEAR(p[2], -1.2 * wanted.a * 1e3 + p[4] / 2, 1e-9) << "the first element's centre";
}

/// A potential contact that is too small: the number of elements that lie at its border.
TEST_F(ContactProblems, CountElementsAtTheBorder) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 7, 1, 1, {5, 4, -0.25, -0.2, 0.1, 0.1}), 0);
  EXPECT_EQ(calculate(7, 1), 14) << "all of the rim of 5 x 4";
}

/// As exact as differences of the whole solution can be.
TEST_F(ContactProblems, HaveSensitivities) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(set_flag(7, 1, CNTC_ic_sens, 3), 0);
  ASSERT_EQ(calculate(7, 1), 0);
  const Values s = sensitivities(7, 1);
  ASSERT_EQ(s.size(), 16u);
  const double approach = scalars(cntc_getpenetration, 7, 1)[0];
  EXPECT_NEAR(s[0] * approach / 1000, 1.5, 0.05) << "Hertz: FN ~ approach^1.5";
  const double xi = 1e-3, step = 1e-6;
  const auto ratio = [&](double x) {
    EXPECT_EQ(set(cntc_setcreepages, 7, 1, x, -5e-4, 1e-4), 0);
    EXPECT_EQ(calculate(7, 1), 0);
    return scalars(cntc_getcontactforces, 7, 1)[1] / 300;
  };
  ASSERT_EQ(set_flag(7, 1, CNTC_ic_sens, 0), 0);
  const double wanted = (ratio(xi + step) - ratio(xi - step)) / (2 * step);
  EXPECT_NEAR(s[5], wanted, 1e-3 * std::abs(wanted));
}

TEST_F(ContactProblems, TellTheirParameters) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(calculate(7, 1), 0);
  EXPECT_EQ(parameters(7, 1, 1, 3), (Values{1000, 0, 0.2}));
  const Values material = parameters(7, 1, 2, 7);
  EXPECT_NEAR(material[2], 82000, 1e-9);
  EXPECT_NEAR(material[6], 0, 1e-15) << "K of similar bodies";
  EXPECT_EQ(parameters(7, 1, 3, 7), (Values{0, 1, 0, 0, 0, 0.3, 0.3}));
  const auto flag = [](int code) {
    int ire = 7, icp = 1, one = 1, value = -1;
    EXPECT_EQ(cntc_getflags(&ire, &icp, &one, &code, &value), 0);
    return value;
  };
  EXPECT_EQ(flag(CNTC_ic_tang), 3);
  EXPECT_EQ(flag(CNTC_ic_norm), 1);
  EXPECT_EQ(flag(CNTC_ic_mater), 0);
}

/// The temperature law's data, FASTSIM, a layer and viscoelastic bodies are taken and solved.
TEST_F(ContactProblems, TakeAllMaterials) {
  const struct {
    int method;
    Values extra;
  } materials[] = {{1, {1, 1, 0.001, 0.001}}, {3, {1, 1, 1}}, {4, {8200, 0.02, 0, 0}}, {5, {1, 1, 1}}};
  for (const auto& [method, extra] : materials) {
    ASSERT_EQ(set_up_sphere(7, 1), 0);
    Values values = {0.28, 0.28, 82000, 82000};
    values.insert(values.end(), extra.begin(), extra.end());
    ASSERT_EQ(set(cntc_setmaterialparameters, 7, 1, method, values), 0) << method;
    EXPECT_GE(calculate(7, 1), 0) << method << library_.log();
    EXPECT_LT(scalars(cntc_getcontactforces, 7, 1)[1], -50) << method;
  }
}

/// Areas and elements say the same, where a layer yields as well.
TEST_F(ContactProblems, CountTheElementsOfALayerThatYields) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(set(cntc_setmaterialparameters, 7, 1, 4, {0.28, 0.28, 82000, 82000, 8200, 0.02, 50, 0}), 0);
  ASSERT_GE(calculate(7, 1), 0) << library_.log();
  int ire = 7, icp = 1, count = 441, counts[4] = {0, 0, 0, 0};
  std::vector<int> division(441);
  ASSERT_EQ(cntc_getelementdivision(&ire, &icp, &count, division.data()), 0);
  for (const int state : division) ++counts[state];
  const Values areas = scalars(cntc_getcontactpatchareas, 7, 1); // elements of 0.01 mm2
  EXPECT_NEAR(areas[0], 0.01 * (441 - counts[0]), 1e-9);
  EXPECT_NEAR(areas[1], 0.01 * counts[1], 1e-9);
  EXPECT_NEAR(areas[2], 0.01 * counts[2], 1e-9);
  EXPECT_GT(counts[3], 0);
  const Values tau = field(7, 1, CNTC_fld_taucrt, 441);
  EXPECT_EQ(*std::max_element(tau.begin(), tau.end()), 50) << "no hardening";
}

TEST_F(ContactProblems, HaveTemperatures) {
  ASSERT_EQ(set_up_sphere(7, 1), 0);
  ASSERT_EQ(set(cntc_settemperaturedata, 7, 1, 3, {20, 450, 0.05, 7.85e-6, 20, 450, 0.05, 7.85e-6, 1}), 0);
  ASSERT_EQ(calculate(7, 1), 0) << library_.log();
  const Values highest = scalars(cntc_getmaximumtemperature, 7, 1);
  EXPECT_GT(highest[0], 20.1);
  const Values t = field(7, 1, CNTC_fld_temp1, 441);
  EXPECT_EQ(*std::max_element(t.begin(), t.end()), highest[0]);
}

} // namespace
} // namespace microslip::libcontact
