// Wheels through the library: the numbers of the code that runs CONTACT's files, bit for bit, from profiles in files
// and in arrays; forces in all axes; profiles, sensitivities.

#include "compat/libcontact/tests/calls.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

using contact_program::Outcome;
using contact_program::outcomes_of;
using contact_program::PatchLocation;
using contact_program::WheelOutcome;

/// The states of set_up_wheel and set_wheel_state as an input file.
std::string input_of(bool is_right, const std::vector<double>& sideways) {
  std::ostringstream text;
  text.precision(17);
  for (std::size_t k = 0; k < sideways.size(); ++k) {
    const double y = sideways[k];
    text << " 1 MODULE\n " << (is_right ? 1 : 0) << "203100\n 0022033\n 0000321\n 999 20 25 1 1e-5\n .3 .3\n"
         << " .28 .28 82000. 82000.\n .5 .5 1. 1.5707963267948966 8. 4.\n 14. 0 1435. .05\n '" << profiles
         << "60e1.prr' 0 1. 0.\n 0 0 0 0 0 0\n 1360. -70. 460.\n '" << profiles << "s1002.prw' 0 1. 0.\n 0 " << y
         << " 80000. " << -1e-4 * y << " " << 2e-3 * y << " 0\n 30000. 0 0 0 0 " << -30e3 / 460.3 << "\n";
  }
  return text.str();
}

class Wheels : public ::testing::TestWithParam<bool> {
protected:
  void SetUp() override {
    ASSERT_EQ(library_.code, 0);
    ASSERT_EQ(initialize(1, 1), 0);
    ASSERT_EQ(set_up_wheel(1, GetParam()), 0);
  }

  TemporaryFolder folder_;
  Library library_{folder_.path()};
};

INSTANTIATE_TEST_SUITE_P(Sides, Wheels, ::testing::Bool(),
                         [](const auto& side) { return side.param ? "Right" : "Left"; });

const std::vector<double> sideways = {0.5, 3, 7.5};

TEST_P(Wheels, HaveTheNumbersOfTheFiles) {
  const auto outcomes = outcomes_of(input_of(GetParam(), sideways));
  for (std::size_t k = 0; k < sideways.size(); ++k) {
    ASSERT_EQ(set_wheel_state(1, sideways[k]), 0);
    ASSERT_EQ(calculate(1), 0) << library_.log();
    const WheelOutcome& w = *outcomes[k].wheel;
    const Values f = list(cntc_getglobalforces, 1, whole, 24);
    EXPECT_EQ(Values(f.begin(), f.begin() + 6),
              (Values{w.track.force.x, w.track.force.y, w.track.force.z, 1e3 * w.track.moment.x, 1e3 * w.track.moment.y,
                      1e3 * w.track.moment.z}));
    EXPECT_EQ(Values(f.begin() + 6, f.begin() + 9),
              (Values{w.wheelset.force.x, w.wheelset.force.y, w.wheelset.force.z}));
    ASSERT_EQ(patches(1), static_cast<int>(w.patches.size()));
    for (int icp = 1; icp <= patches(1); ++icp) {
      const auto& patch = w.patches[static_cast<std::size_t>(icp) - 1];
      const auto& totals = patch.solution->totals;
      EXPECT_EQ(scalars(cntc_getcontactforces, 1, icp), (Values{totals.fn, totals.fx, totals.fy, totals.mz}));
      EXPECT_EQ(scalars(cntc_getcreepages, 1, icp),
                (Values{slip_of(patch.contact.x), slip_of(patch.contact.y), 1e-3 * patch.contact.phi}));
      EXPECT_EQ(scalars(cntc_getmaximumpressure, 1, icp), Values{totals.peak_pressure});
      const Values pn = field(1, icp, CNTC_fld_pn, elements(1, icp));
      ASSERT_EQ(pn.size(), patch.solution->solution.normal.pressure.size());
      for (std::size_t e = 0; e < pn.size(); ++e)
        ASSERT_EQ(pn[e], patch.solution->solution.normal.pressure[e] * 1e-6) << e;
      const Values l = list(cntc_getcontactlocation, 1, icp, 38);
      const PatchLocation& at = patch.location;
      EXPECT_EQ(Values(l.begin(), l.begin() + 7),
                (Values{1e3 * at.track.x, 1e3 * at.track.y, 1e3 * at.track.z, at.angle, 1e3 * at.rail.x,
                        1e3 * at.rail.y, 1e3 * at.rail.z}));
    }
  }
}

/// The same force, and the same moment, in other axes: what the locations' frames say.
TEST_P(Wheels, HaveForcesInTheAxesOfTheirProfiles) {
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  const Values f = list(cntc_getglobalforces, 1, whole, 24), l = list(cntc_getcontactlocation, 1, 1, 38);
  const double rail = l[27], c = std::cos(rail), s = std::sin(rail);
  EXPECT_NEAR(f[13], c * f[1] + s * f[2], 1e-9 * f[2]) << "the rail is turned by its cant";
  EXPECT_NEAR(f[14], c * f[2] - s * f[1], 1e-9 * f[2]);
  EXPECT_NEAR(std::abs(rail), 0.05, 1e-12);
  EXPECT_NEAR(std::hypot(f[0], f[1], f[2]), std::hypot(f[18], f[19], f[20]), 1e-9 * f[2]);
  Values sum(24);
  for (int icp = 1; icp <= patches(1); ++icp) {
    const Values part = list(cntc_getglobalforces, 1, icp, 24);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
  }
  for (std::size_t k = 0; k < sum.size(); ++k) EXPECT_NEAR(sum[k], f[k], 1e-6 * std::abs(f[2])) << k;
  // the reference in the track is that in the wheelset and that on the rail, put back
  EXPECT_NEAR(l[1], l[25] + c * l[5] - s * l[6], 1e-9 * std::abs(l[1]));
  EXPECT_NEAR(l[3], l[27] + l[8], 1e-12);
  EXPECT_NEAR(l[15], l[1], 2) << "the pressure's centre is near the reference";
  EXPECT_NEAR(l[34], (GetParam() ? 1 : -1) * (1360 / 2. + 70), 1e-9) << "the wheel's profile on the axle";
  EXPECT_NEAR(l[35], 460, 1e-9);
}

/// F = 3: the rail has moved as far to the right as its spring gives way to the force to the right.
TEST_P(Wheels, MoveARailOnASpring) {
  constexpr double stiffness = 5e4; // N/mm
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_force, 3), 0);
  ASSERT_EQ(set(cntc_settrackdimensions, 1, 32, {stiffness, 0, 0, 0}), 0);
  ASSERT_EQ(set_wheel_state(1, GetParam() ? 3 : -3), 0);
  ASSERT_EQ(calculate(1), 0) << library_.log();
  const double force = list(cntc_getglobalforces, 1, whole, 24)[1];
  EXPECT_GT(std::abs(force), 1000);
  EXPECT_NEAR(stiffness * list(cntc_getcontactlocation, 1, 1, 38)[17], force, 1e-4 * std::abs(force));
}

TEST_P(Wheels, TakeProfilesFromArrays) {
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  const Values wanted = list(cntc_getglobalforces, 1, whole, 24);
  ASSERT_EQ(initialize(2, 1), 0);
  ASSERT_EQ(set_up_wheel(2, GetParam()), 0);
  for (int type = 0; type < 2; ++type) {
    int one = 1, ints = 2, none = 0, task = 0, count = 1, points[2] = {type, 0};
    double number = 0;
    ASSERT_EQ(cntc_getprofilevalues(&one, &task, &ints, points, &none, nullptr, &count, &number), 0);
    count = 2 * static_cast<int>(number);
    Values yz(static_cast<std::size_t>(count)), pairs;
    task = 1;
    ASSERT_EQ(cntc_getprofilevalues(&one, &task, &ints, points, &none, nullptr, &count, yz.data()), 0);
    const std::size_t half = yz.size() / 2;
    for (std::size_t k = 0; k < half; ++k) pairs.insert(pairs.end(), {yz[k], yz[half + k]});
    EXPECT_EQ(pairs[0] < pairs[2], type == 0) << "rails from the gauge side, wheels from the field side";
    int two = 2, length = static_cast<int>(half), choices[4] = {type, 0, 0, -1}, four = 4, reals = 2;
    double numbers[2] = {1, 0};
    ASSERT_EQ(cntc_setprofileinputvalues(&two, &length, pairs.data(), &four, choices, &reals, numbers), 0);
  }
  ASSERT_EQ(set_wheel_state(2, 3), 0);
  ASSERT_EQ(calculate(2), 0);
  const Values found = list(cntc_getglobalforces, 2, whole, 24);
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-6 * 80e3) << k;
}

/// Values of a task about the rail, all of them; the code below 0 alone.
Values profile_values(int task, Values numbers, int type = 0) {
  int one = 1, ints = 2, choices[2] = {type, 0}, reals = size_of(numbers), count = 1;
  double number = 0;
  if (const int code = cntc_getprofilevalues(&one, &task, &ints, choices, &reals, numbers.data(), &count, &number))
    return {static_cast<double>(code)};
  count = 3 * static_cast<int>(number);
  Values values(static_cast<std::size_t>(count));
  EXPECT_EQ(cntc_getprofilevalues(&one, &task, &ints, choices, &reals, numbers.data(), &count, values.data()), 0);
  return values;
}

/// A ramp of 1 : 100 from u = 0 to 30 mm, 40 mm wide.
TEST_P(Wheels, HaveRailsThatVary) {
  std::ofstream list(folder_.path() / "ramp.slcs");
  list << "0 1\n4\n0\n1\n";
  for (int k = 0; k < 4; ++k) {
    const std::string name = "ramp" + std::to_string(k) + ".prr";
    list << 10 * k << " '" << name << "'\n";
    std::ofstream slice(folder_.path() / name);
    slice << "header.begin\n version = 1\n type = 0\nheader.end\nspline.begin\n units.len.f = 1000.\n point.begin\n";
    for (int y = -20; y <= 20; ++y) slice << y << " " << 0.1 * k << "\n";
    slice << " point.end\nspline.end\n";
  }
  list.close();
  EXPECT_EQ(profile_values(6, {}), Values{CNTC_err_profil}) << "a profile that does not vary";
  ASSERT_EQ(set_profile(1, (folder_.path() / "ramp.slcs").string(), 0), 0) << library_.log();
  const Values across = profile_values(6, {2, 15}); // steps of 2 v of half a millimetre, at u = 15
  const std::size_t n = across.size() / 3;
  ASSERT_EQ(n, 41u);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_EQ(across[k], 15);
    EXPECT_NEAR(across[n + k], -20 + static_cast<double>(k) * 40 / 40.5, 1e-9) << "81 segments";
    EXPECT_NEAR(across[2 * n + k], 0.15, 1e-12);
  }
  const Values along = profile_values(7, {5, 1}), at_y = profile_values(8, {5, 3.3, 10, 40});
  ASSERT_EQ(along.size(), 21u);
  ASSERT_EQ(at_y.size(), 21u);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(along[k], 5.0 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(along[7 + k], -20, 1e-12) << "v = 1 is the gauge side";
    EXPECT_NEAR(along[14 + k], 0.01 * along[k], 1e-12);
    EXPECT_EQ(at_y[7 + k], 3.3);
    EXPECT_NEAR(at_y[14 + k], 0.01 * std::min(at_y[k], 30.0), 1e-12) << "constant beyond the last slice";
  }
  EXPECT_EQ(profile_values(8, {5, 30})[14], 999) << "beside the rail";
  EXPECT_EQ(profile_values(9, {}), Values{CNTC_err_other});
  EXPECT_EQ(profile_values(6, {1e-9}), Values{CNTC_err_other});
}

/// A round wheel of 12 slices around it: without a range its slices from the first to the last, not what closes it.
TEST_P(Wheels, WithoutARangeRunOverTheSlicesOfAWheel) {
  constexpr double first = -3;
  std::ofstream list(folder_.path() / "round.slcw");
  list << "0 1\n12\n0\n1\n";
  for (int k = 0; k < 12; ++k) list << first + 0.5 * k << " 'round.prw'\n";
  list.close();
  std::ofstream slice(folder_.path() / "round.prw");
  slice << "header.begin\n version = 1\n type = 1\nheader.end\nspline.begin\n units.len.f = 1000.\n point.begin\n";
  for (int y = 20; y >= -20; --y) slice << y << " 0\n";
  slice << " point.end\nspline.end\n";
  slice.close();
  ASSERT_EQ(set_profile(1, (folder_.path() / "round.slcw").string(), 1), 0) << library_.log();
  for (const int task : {7, 8}) {
    const Values along = profile_values(task, {0.25, 1}, 1);
    ASSERT_EQ(along.size(), 3u * 23u) << task;
    EXPECT_NEAR(along[0], first, 1e-12);
    EXPECT_NEAR(along[22], first + 5.5, 1e-12);
  }
}

TEST_P(Wheels, TellTheHeightThatTheForceHasLedTo) {
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  const auto position = [] {
    int one = 1, six = 6;
    Values values(6);
    EXPECT_EQ(cntc_getwheelsetposition(&one, &six, values.data()), 0);
    return values;
  };
  const Values forces = list(cntc_getglobalforces, 1, whole, 24);
  const double height = position()[2];
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_norm, 0), 0);
  ASSERT_EQ(set(cntc_setwheelsetposition, 1, 2, {0, 3, height, -3e-4, 6e-3, 0}), 0);
  ASSERT_EQ(calculate(1), 0);
  EXPECT_NEAR(list(cntc_getglobalforces, 1, whole, 24)[2], forces[2], 1e-6 * 80e3);
}

/// With the differences of the height that one would make oneself.
TEST_P(Wheels, HaveSensitivitiesOfTheirPatches) {
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_sens, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  const Values forces = scalars(cntc_getcontactforces, 1, 1);
  const Values s = sensitivities(1, 1);
  ASSERT_EQ(s.size(), 16u);
  const double approach = scalars(cntc_getpenetration, 1, 1)[0];
  EXPECT_NEAR(s[0] * approach / forces[0], 1.5, 0.1) << "FN grows nearly as Hertz's";
  EXPECT_EQ(s[4], 0) << "elastically similar: FN does not depend on creepage";
  EXPECT_LT(s[5], 0) << "FX against xi";
  EXPECT_LT(s[10], 0) << "FY against eta";
  EXPECT_NEAR(s[6] / s[9], 1, 0.5) << "nearly symmetric";
}

/// The second of two steps: its forces' slopes are those of a step from the same tractions with other creepages, which
/// grow with the step as in adhesion, and of a left wheel they are the right one's.
TEST_P(Wheels, HaveSensitivitiesOfTransientRolling) {
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_tang, 2), 0);
  ASSERT_EQ(set_wheel_state(1, GetParam() ? 3 : -3), 0);
  ASSERT_GE(calculate(1), 0) << library_.log();
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_pvtime, 0), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_sens, 3), 0);
  ASSERT_GE(calculate(1), 0) << library_.log();
  const Values before = scalars(cntc_getcontactforces, 1, 1);
  const Values s = sensitivities(1, 1);
  ASSERT_EQ(s.size(), 16u);
  const double approach = scalars(cntc_getpenetration, 1, 1)[0];
  EXPECT_NEAR(s[0] * approach / before[0], 1.5, 0.1);
  EXPECT_LT(s[5], 0) << "FX against xi";
  EXPECT_LT(s[10], 0) << "FY against eta";
  // Another element, whose second step has a little more of xi.
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_sens, 0), 0);
  ASSERT_EQ(initialize(2, 1), 0);
  ASSERT_EQ(set_up_wheel(2, GetParam()), 0);
  ASSERT_EQ(set_flag(2, whole, CNTC_ic_tang, 2), 0);
  ASSERT_EQ(set_wheel_state(2, GetParam() ? 3 : -3), 0);
  ASSERT_GE(calculate(2), 0);
  ASSERT_EQ(set_flag(2, whole, CNTC_ic_pvtime, 0), 0);
  ASSERT_EQ(set(cntc_setwheelsetvelocity, 2, 2, {30e3, 0, 0, 0, 0, -30e3 / 460.3 * (1 + 1e-6)}), 0);
  ASSERT_GE(calculate(2), 0);
  const Values after = scalars(cntc_getcontactforces, 2, 1), xi = scalars(cntc_getcreepages, 2, 1),
               xi_before = scalars(cntc_getcreepages, 1, 1);
  const double slope = (after[1] - before[1]) / (xi[0] - xi_before[0]) / (0.3 * before[0]);
  EXPECT_NEAR(slope / s[5], 1, 0.1) << "eta and phi change a little, too";
}

int read_file(int ire, int kind, const std::string& name) {
  int length = size_of(name), error = 1;
  const int code = cntc_readinpfile(&ire, &kind, name.c_str(), &length, &error);
  return error == code ? code : 12345;
}

TEST_P(Wheels, ReadAnInputFile) {
  const std::string name = (folder_.path() / "a.inp").string();
  std::ofstream(name) << input_of(GetParam(), {3});
  ASSERT_EQ(initialize(3, 1), 0);
  ASSERT_EQ(read_file(3, CNTC_inp_modul1, name), 0) << library_.log();
  ASSERT_EQ(calculate(3), 0) << library_.log();
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  EXPECT_EQ(list(cntc_getglobalforces, 3, whole, 24), list(cntc_getglobalforces, 1, whole, 24));
}

/// The file of CONTACT's interface to Simpack has what does not move; digits of what does stay, whatever it has.
TEST_P(Wheels, ReadThePairOfSimpack) {
  const std::string settings = " 999 20 25 1 1e-5\n .25 .25\n .28 .28 82000. 82000.\n .4 .4 1. 90d 8. 4.\n",
                    track = " 14. 0 1435. .05\n '" + profiles + "60e1.prr' 0 1. 0.\n",
                    wheelset = " 1360. -70. 460.\n '" + profiles + "s1002.prw' 0 1. 0.\n";
  const std::string all = (folder_.path() / "pair.inp").string(), some = (folder_.path() / "settings.inp").string();
  std::ofstream(all) << " 11 MODULE\n " << (GetParam() ? 0 : 1) << "001010\n 0022033\n 0000021\n"
                     << settings << track << wheelset;
  std::ofstream(some) << " 11 MODULE\n 1001010\n 0022000\n 0000021\n" << settings;
  const auto forces = [](int ire) {
    EXPECT_EQ(set_wheel_state(ire, 3), 0);
    EXPECT_EQ(calculate(ire), 0);
    return list(cntc_getglobalforces, ire, whole, 24);
  };
  ASSERT_EQ(set(cntc_setfrictionmethod, 1, whole, 0, {.25, .25}), 0);
  ASSERT_EQ(set(cntc_setpotcontact, 1, whole, -1, {.4, .4, 1.5707963267948966, 8, 4}), 0);
  const Values wanted = forces(1);
  ASSERT_EQ(set_flag(4, whole, CNTC_ic_config, GetParam() ? 1 : 0), 0);
  ASSERT_EQ(set_force(4, 80e3), 0);
  ASSERT_EQ(read_file(4, CNTC_inp_spck, all), 0) << library_.log();
  EXPECT_EQ(forces(4), wanted);
  ASSERT_EQ(set_up_wheel(5, GetParam()), 0);
  ASSERT_EQ(read_file(5, CNTC_inp_spck, some), 0) << library_.log();
  EXPECT_EQ(forces(5), wanted);
  EXPECT_EQ(read_file(5, CNTC_inp_modul1, all), CNTC_err_input);
  EXPECT_EQ(read_file(5, CNTC_inp_vamp, all), CNTC_err_input);
  std::ofstream(some) << " 11 MODULE\n 1001010\n 0022010\n 0000021\n" << settings;
  EXPECT_EQ(read_file(5, CNTC_inp_spck, some), CNTC_err_input) << "Z = 1";
  std::ofstream(some) << " 3 MODULE\n";
  EXPECT_EQ(read_file(5, CNTC_inp_spck, some), CNTC_err_input);
  EXPECT_EQ(forces(5), wanted) << "what is refused changes nothing";
}

/// The force that is given is the contact's and its damping, C (F - F')/dt with dt = DX/VELOC.
TEST_P(Wheels, AreDamped) {
  ASSERT_EQ(set(cntc_setmaterialparameters, 1, whole, 12, {1e-4, 2e-4, 1e30, 1e30}), 0) << library_.log();
  ASSERT_EQ(set(cntc_setmaterialparameters, 1, whole, 12, {1, 1, -1, 1}), CNTC_err_other);
  ASSERT_EQ(set_wheel_state(1, 0), 0);
  ASSERT_EQ(calculate(1), 0);
  const auto contact_force = [] {
    double sum = 0;
    for (int icp = 1; icp <= patches(1); ++icp) sum += scalars(cntc_getcontactforces, 1, icp)[0];
    return sum;
  };
  const double before = contact_force(), share = 1e-4 / (0.5 / scalars(cntc_getreferencevelocity, 1, 1)[0]);
  ASSERT_EQ(set_force(1, 60e3), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_pvtime, 0), 0);
  ASSERT_EQ(calculate(1), 0);
  EXPECT_NEAR(list(cntc_getglobalforces, 1, whole, 24)[2], 60e3, 60e3 * 1e-5);
  EXPECT_NEAR(contact_force() / before, (60e3 / 80e3 + share) / (1 + share), 1e-3);
  const Values material = parameters(1, 1, 2, 22);
  EXPECT_EQ(Values(material.begin() + 18, material.end()), (Values{1e-4, 2e-4, 1e30, 1e30}));
}

/// Shifts and transient rolling go on from the tractions of the call before, as cases of a file do.
TEST_P(Wheels, GoOnFromTheCallBefore) {
  ASSERT_EQ(set_flag(1, whole, CNTC_ic_tang, 2), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  Values along;
  for (int k = 0; k < 3; ++k) {
    ASSERT_GE(calculate(1), 0) << library_.log();
    along.push_back(list(cntc_getglobalforces, 1, whole, 24)[0]);
    ASSERT_EQ(set_flag(1, whole, CNTC_ic_pvtime, 0), 0);
    ASSERT_EQ(set_flag(1, whole, CNTC_ic_iestim, 3), 0);
  }
  EXPECT_GT(std::abs(along[1]), std::abs(along[0]));
  EXPECT_GT(std::abs(along[2]), std::abs(along[1]));
}

} // namespace
} // namespace microslip::libcontact
