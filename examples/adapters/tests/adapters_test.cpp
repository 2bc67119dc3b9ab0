// The adapters as their programs call them: every wheel's load is that of the library, whatever was called before, in
// any order and from any thread; derivatives are those of differences; nothing is thrown.

#include "../wheel.h"
#include "io/profile_file.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "slv_c_utils.h"
#include "vehicle_program.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

extern "C" {
adams_c_Gfosub Gfosub;
void GFOSUB(int* id, double* time, double* par, int* npar, int* dflag, int* iflag, double* result);
void* microslip_modelica_create(const char* case_file);
void microslip_modelica_destroy(void* object);
int microslip_modelica_load(void* object, const double* motion, double curvature, double* load);
void microslip_modelica_load_der(void* object, const double* motion, double curvature, const double* motion_der,
                                 double* load_der);
void ModelicaFormatError(const char* text, ...);
void ModelicaFormatMessage(const char* text, ...);
}

namespace {
thread_local std::string modelica_error;
}

/// A tool's returns to the integrator, which this one notes only.
void ModelicaFormatError(const char* text, ...) {
  char message[512];
  va_list values;
  va_start(values, text);
  std::vsnprintf(message, sizeof message, text, values);
  va_end(values);
  modelica_error = message;
}
void ModelicaFormatMessage(const char*, ...) {}

namespace microslip::adapters {
namespace {

using Load = std::array<double, 6>;

constexpr int wheels = 8, track_marker = 500, first_marker = 100, ground_marker = 900;
constexpr double radius = 0.46, half_base = 1.36 / 2 + 0.07;
const Marker track{{10, 5, -2}, rotation_about_z(0.7), {}, {}}; ///< anywhere in the ground's axes

/// Wheels of the case files wheel_1.toml ...: left ones are odd.
bool is_left(int wheel) {
  return wheel % 2 == 1;
}

WheelRail library(int wheel) {
  const Material steel = Material::from_young(210e9, 0.28);
  return {{.rail = io::read_profile(PROFILES "/60e1.prr").profile,
           .wheel = io::read_profile(PROFILES "/s1002.prw").profile,
           .track = {.gauge = 1.435, .rail_origin = {}, .cant = 0.025},
           .wheelset = {.flange_back_distance = 1.36, .nominal_radius = radius, .tape_circle = {}},
           .side = is_left(wheel) ? TrackSide::left : TrackSide::right,
           .material = combine(steel, steel),
           .friction = {{0, 0.3}}}};
}

/// A wheelset in motion, on its treads to on its flanges.
WheelState<double> running(int k) {
  WheelState<double> s;
  s.longitudinal = 3 * k;
  s.lateral = 1.3e-3 * (k % 9 - 4), s.vertical = -1.5e-4 - 2e-5 * (k % 5), s.roll = 1e-4 * (k % 3),
  s.yaw = 1e-3 * (k % 4);
  s.forward_velocity = 20, s.lateral_velocity = 0.01 * (k % 5), s.vertical_velocity = 0.02;
  s.roll_velocity = 0.01, s.pitch_velocity = 20 / radius * (1 + 1e-3 * (k % 3)), s.yaw_velocity = 0.02 * (k % 2);
  return s;
}

/// The library's load on a wheelset about its centre.
Load wanted(WheelRail& contact, int wheel, const WheelState<double>& state) {
  contact.reset();
  const WheelRailSolution found = contact.solve(state);
  const Vec3<double> axle = (rotation_about_x(state.roll) * rotation_about_z(state.yaw)).ey;
  const Vec3<double> m = found.moment + cross((is_left(wheel) ? half_base : -half_base) * axle, found.force);
  return {found.force.x, found.force.y, found.force.z, m.x, m.y, m.z};
}

void place(const WheelState<double>& state, double rolled = 0.3) {
  program().markers[track_marker] = track;
  program().markers[first_marker] = placed(track, wheelset_marker(state, radius, rolled));
}

Load adams(int wheel, const WheelState<double>& state, int dflag = 0, int iflag = 0, double time = 0) {
  place(state);
  const double parameters[] = {static_cast<double>(wheel), program().length};
  const sAdamsGforce force{10 + wheel, 2, parameters, first_marker, track_marker, ground_marker};
  Load load;
  Gfosub(&force, time, dflag, iflag, load.data());
  return load;
}

Load motionsolve(int wheel, const WheelState<double>& state, int dflag = 0, int iflag = 0, double time = 0) {
  place(state);
  double parameters[] = {static_cast<double>(wheel), first_marker, track_marker, program().length};
  int id = 10 + wheel, count = 4;
  Load load;
  GFOSUB(&id, &time, parameters, &count, &dflag, &iflag, load.data());
  return load;
}

std::array<double, 12> motion_numbers(const WheelState<double>& state) {
  const Marker m = wheelset_marker(state, radius);
  std::array<double, 12> numbers;
  int k = 0;
  for (const Vec3<double>& v : {m.position, m.axes.ey, m.velocity, m.angular_velocity})
    for (const double x : {v.x, v.y, v.z}) numbers[k++] = x;
  return numbers;
}

/// One object for each wheel, as a model has them.
Load modelica(int wheel, const WheelState<double>& state, int = 0, int = 0, double = 0) {
  struct Object {
    void* made = nullptr;
    ~Object() { microslip_modelica_destroy(made); }
  };
  static thread_local std::array<Object, wheels + 1> objects;
  if (!objects[wheel].made)
    objects[wheel].made = microslip_modelica_create(("wheel_" + std::to_string(wheel) + ".toml").c_str());
  Load load{};
  microslip_modelica_load(objects[wheel].made, motion_numbers(state).data(), 0, load.data());
  return load;
}

using Adapter = Load (*)(int wheel, const WheelState<double>& state, int dflag, int iflag, double time);
struct NamedAdapter {
  const char* name;
  Adapter load;
};
void PrintTo(const NamedAdapter& adapter, std::ostream* out) {
  *out << adapter.name;
}

class EveryAdapter : public ::testing::TestWithParam<NamedAdapter> {
protected:
  EveryAdapter() { program() = {}, modelica_error = ""; }
  Load load(int wheel, const WheelState<double>& state, int dflag = 0, int iflag = 0, double time = 0) {
    return GetParam().load(wheel, state, dflag, iflag, time);
  }
};

INSTANTIATE_TEST_SUITE_P(Programs, EveryAdapter,
                         ::testing::Values(NamedAdapter{"adams", adams}, NamedAdapter{"motionsolve", motionsolve},
                                           NamedAdapter{"modelica", modelica}),
                         [](const auto& chosen) { return chosen.param.name; });

void expect_load(const Load& got, const Load& wanted, double length = 1) {
  for (int k = 0; k < 6; ++k) {
    const double unit = k < 3 ? 1 : length;
    EXPECT_NEAR(unit * got[k], wanted[k], 1e-6 * (1 + std::abs(wanted[2]))) << k;
  }
}

TEST_P(EveryAdapter, GivesTheLoadOfTheLibrary) {
  for (int wheel = 1; wheel <= wheels; ++wheel) {
    WheelRail contact = library(wheel);
    double largest = 0;
    for (int k = 0; k < 9; ++k) {
      const Load right = wanted(contact, wheel, running(k));
      expect_load(load(wheel, running(k)), right);
      largest = std::max(largest, right[2]);
    }
    EXPECT_GT(largest, 10e3);
  }
  EXPECT_TRUE(program().errors.empty() && modelica_error.empty());
}

/// Repeated, rejected, differenced and out of order: the same states have the same loads to the last bit.
TEST_P(EveryAdapter, TheOrderOfCallsChangesNoDigit) {
  struct Call {
    int wheel, state;
    double time;
  };
  std::vector<Call> calls;
  std::vector<Load> first;
  for (int wheel = 1; wheel <= wheels; ++wheel)
    for (int k = 0; k < 9; ++k) {
      calls.push_back({wheel, k, 1e-3 * k});
      first.push_back(load(wheel, running(k), 0, 0, 1e-3 * k));
    }
  std::vector<std::size_t> order(4 * calls.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k % calls.size();
  std::mt19937 random(7);
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t k : order) {
    const Call& call = calls[k];
    if (random() % 3 == 0) load(call.wheel, running(static_cast<int>(random() % 50)), 1, 0, call.time); // differences
    if (random() % 7 == 0) load(call.wheel, running(3), 0, 3, call.time);                               // dependencies
    EXPECT_EQ(load(call.wheel, running(call.state), static_cast<int>(random() % 2), 0, call.time), first[k]);
  }
}

TEST_P(EveryAdapter, ManyThreadsGetWhatOneGets) {
  std::vector<Load> serial;
  for (int k = 0; k < 24; ++k) serial.push_back(load(1 + k % wheels, running(k)));
  std::vector<std::vector<Load>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<Load>& mine : found)
    threads.emplace_back([&] {
      for (int k = 0; k < 24; ++k) mine.push_back(load(1 + k % wheels, running(k)));
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<Load>& mine : found) EXPECT_EQ(mine, serial);
}

/// In the air there is no force, deep in the rail and on its other side a finite one; where a state has no meaning the
/// force is zero and the program is told.
TEST_P(EveryAdapter, EveryStateHasAFiniteLoad) {
  WheelState<double> lifted = running(1);
  lifted.vertical = 0.01;
  EXPECT_EQ(load(1, lifted), Load{});
  EXPECT_TRUE(program().errors.empty() && modelica_error.empty());
  for (const double lateral : {0.02, 0.05, 0.2, -0.9})
    for (const double vertical : {-0.03, -1e-3, 0.03}) {
      WheelState<double> off = running(1);
      off.lateral = lateral, off.vertical = vertical;
      for (const double x : load(1, off)) EXPECT_TRUE(std::isfinite(x)) << lateral << ' ' << vertical;
    }
  EXPECT_TRUE(program().errors.empty() && modelica_error.empty());
  WheelState<double> gone = running(1);
  gone.lateral = 3;
  EXPECT_EQ(load(1, gone), Load{});
  EXPECT_FALSE(program().errors.empty() && modelica_error.empty());
  program().errors.clear(), modelica_error = "";
  WheelRail contact = library(1);
  expect_load(load(1, running(2)), wanted(contact, 1, running(2))); // steps back
}

TEST_P(EveryAdapter, ForcesVanishContinuouslyWhereAWheelLifts) {
  WheelState<double> state = running(4);
  state.roll = 0, state.yaw = 0;
  double above = 1e-3, below = -1e-3; // of no force and of some
  for (int k = 0; k < 40; ++k) {
    state.vertical = (above + below) / 2;
    (load(1, state)[2] > 0 ? below : above) = state.vertical;
  }
  double last = 0;
  for (int k = 1; k <= 6; ++k) {
    state.vertical = above - 1e-9 * std::pow(10, k - 1);
    const double force = load(1, state)[2];
    EXPECT_GT(force, last);
    EXPECT_LE(last, 0.1 * force); // at least linear in the depth
    last = force;
  }
}

TEST(Adams, ModelsInMillimetres) {
  program() = {};
  program().length = 1e-3;
  WheelRail contact = library(2);
  expect_load(adams(2, running(3)), wanted(contact, 2, running(3)), 1e-3);
  expect_load(motionsolve(2, running(3)), wanted(contact, 2, running(3)), 1e-3);
}

/// Adams learns from the calls of SYSARY what a force depends on: they are the same in every pass that may have them.
TEST(Adams, EveryPassAsksForTheSame) {
  for (const Adapter adapter : {Adapter(adams), Adapter(motionsolve)}) {
    program() = {};
    adapter(1, running(2), 0, 0, 0);
    const std::vector<std::string> asked = program().asked;
    EXPECT_EQ(asked.size(), 3U);
    for (const auto& [dflag, iflag] : {std::pair(1, 0), {0, 1}, {0, 3}}) {
      program().asked.clear();
      adapter(1, running(2), dflag, iflag, 0);
      EXPECT_EQ(program().asked, asked) << dflag << ' ' << iflag;
    }
  }
  for (const int iflag : {5, 7, 9}) {
    program().asked.clear();
    EXPECT_EQ(adams(1, running(2), 0, iflag), Load{});
    EXPECT_TRUE(program().asked.empty());
  }
}

TEST(Adams, RefusalsAreTold) {
  program() = {};
  EXPECT_EQ(adams(15, running(2)), Load{});
  ASSERT_EQ(program().errors.size(), 1U);
  EXPECT_EQ(program().errors[0], "25: wheel_15.toml: cannot be read (STOP)");
  EXPECT_EQ(adams(17, running(2)), Load{});
  EXPECT_EQ(program().errors.back(), "27: the wheel 17 of USER must be in [1, 16] (STOP)");
  double parameters[] = {1, 333, track_marker};
  int id = 11, count = 3, none = 0;
  double time = 0;
  Load load;
  GFOSUB(&id, &time, parameters, &count, &none, &none, load.data());
  EXPECT_EQ(program().errors.back(), "11: the markers of a wheel are not to be had (STOP)");
  EXPECT_EQ(microslip_modelica_create("nowhere.toml"), nullptr);
  EXPECT_EQ(modelica_error, "microslip: nowhere.toml: cannot be read");
}

// ------------------------------------------------------------------------------------------------------ derivatives --

struct Opened {
  rail_wheel made = {};
  explicit Opened(const char* file) {
    microslip_error error = {0, ""};
    EXPECT_EQ(wheel_create(&made, file, &error), MICROSLIP_OK) << error.text;
  }
  ~Opened() { wheel_destroy(&made); }
  Opened(const Opened&) = delete;
};

wheel_motion motion_of(const std::array<double, 12>& numbers) {
  wheel_motion m = {};
  std::copy_n(numbers.begin(), 3, m.position), std::copy_n(numbers.begin() + 3, 3, m.axle);
  std::copy_n(numbers.begin() + 6, 3, m.velocity), std::copy_n(numbers.begin() + 9, 3, m.angular_velocity);
  return m;
}

/// Moves the k-th of position, rotation, velocity and angular velocity; a rotation turns the axle.
wheel_motion moved(wheel_motion m, int k, double by) {
  double* const numbers[] = {m.position, nullptr, m.velocity, m.angular_velocity};
  if (k / 3 != 1) {
    numbers[k / 3][k % 3] += by;
    return m;
  }
  const int a = (k + 1) % 3, b = (k + 2) % 3; // k - 3 turns a towards b
  const double at = m.axle[a], bt = m.axle[b];
  m.axle[a] = std::cos(by) * at - std::sin(by) * bt, m.axle[b] = std::sin(by) * at + std::cos(by) * bt;
  return m;
}

TEST(WheelHeader, DerivativesAreThoseOfDifferences) {
  for (const char* file : {"wheel_1.toml", "wheel_2.toml"}) {
    const Opened opened(file);
    for (const int state : {2, 6, 7}) {
      WheelState<double> turned = running(state);
      turned.roll = 5e-4, turned.yaw = 0.01, turned.vertical = -7e-4;
      const wheel_motion motion = motion_of(motion_numbers(turned));
      wheel_load load, up, down;
      double jacobian[6][12];
      wheel_differentiate(&opened.made, &motion, &load, jacobian);
      ASSERT_TRUE(load.status == MICROSLIP_OK || load.status == MICROSLIP_IMPLAUSIBLE) << load.status;
      const double scales[] = {1e-3, 1e-3, 0.1, 0.2};
      std::array<double, 6> largest{};
      for (int row = 0; row < 6; ++row)
        for (int k = 0; k < 12; ++k) largest[row] = std::max(largest[row], std::abs(jacobian[row][k] * scales[k / 3]));
      for (int k = 0; k < 12; ++k) {
        const double by = 1e-4 * scales[k / 3];
        const wheel_motion plus = moved(motion, k, by), minus = moved(motion, k, -by);
        wheel_solve(&opened.made, &plus, &up), wheel_solve(&opened.made, &minus, &down);
        for (int row = 0; row < 6; ++row) {
          const double a = row < 3 ? up.force[row] : up.moment[row - 3];
          const double b = row < 3 ? down.force[row] : down.moment[row - 3];
          EXPECT_NEAR(jacobian[row][k] * scales[k / 3], (a - b) / (2e-4), 1e-3 * largest[row])
              << file << ' ' << state << ": " << row << ", " << k;
        }
      }
    }
  }
}

TEST(WheelHeader, TheDerivativeOfAModelicaModelIsThatAlongItsMotion) {
  void* const object = microslip_modelica_create("wheel_1.toml");
  const auto at = [](double time) {
    WheelState<double> s = running(6);
    s.lateral += 0.1 * time, s.vertical += 0.02 * time, s.yaw += 0.3 * time, s.roll += 0.05 * time;
    s.lateral_velocity += 2 * time, s.pitch_velocity -= 5 * time, s.yaw_velocity += 3 * time;
    return motion_numbers(s);
  };
  const double step = 1e-6;
  std::array<double, 12> rate;
  const auto before = at(-step), now = at(0), after = at(step);
  for (int k = 0; k < 12; ++k) rate[k] = (after[k] - before[k]) / (2 * step);
  Load found, up, down;
  microslip_modelica_load_der(object, now.data(), 0, rate.data(), found.data());
  microslip_modelica_load(object, after.data(), 0, up.data());
  microslip_modelica_load(object, before.data(), 0, down.data());
  for (int k = 0; k < 6; ++k) {
    const double difference = (up[k] - down[k]) / (2 * step);
    EXPECT_NEAR(found[k], difference, 1e-3 * std::abs(difference) + 10) << k;
  }
  microslip_modelica_destroy(object);
}

} // namespace
} // namespace microslip::adapters
