#include "vehicle_program.hpp"

#include "slv_c_utils.h"

#include <algorithm>

namespace microslip::adapters {
namespace {

void put(const Vec3<double>& v, double* states) {
  states[0] = v.x, states[1] = v.y, states[2] = v.z;
}

/// Numbers of a marker against a second one, in the axes of a third; as the manuals of SYSARY have them.
int relative(const std::string& name, const Marker& of, const Marker& from, const Marker& axes, double* states) {
  const Vec3<double> apart = of.position - from.position;
  if (name == "TDISP") {
    put((1 / program().length) * axes.axes.back(apart), states);
    return 3;
  }
  if (name == "UVY") {
    put(from.axes.back(of.axes.ey), states);
    return 3;
  }
  if (name == "DC") {
    const Vec3<double> x = from.axes.back(of.axes.ex), y = from.axes.back(of.axes.ey), z = from.axes.back(of.axes.ez);
    for (const auto part : {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z}) {
      put({x.*part, y.*part, z.*part}, states);
      states += 3;
    }
    return 9;
  }
  if (name == "VEL") {
    put((1 / program().length) * axes.axes.back(of.velocity - from.velocity - cross(from.angular_velocity, apart)),
        states);
    put(axes.axes.back(of.angular_velocity - from.angular_velocity), states + 3);
    return 6;
  }
  return 0;
}

} // namespace

Program& program() {
  static thread_local Program of_thread;
  return of_thread;
}

} // namespace microslip::adapters

void c_sysary(const char* name, const int* parameters, int size, double* states, int* count, int* failed) {
  using namespace microslip::adapters;
  Program& now = program();
  std::string call = name;
  for (int k = 0; k < size; ++k) call += ' ' + std::to_string(parameters[k]);
  now.asked.push_back(call);
  *count = 0;
  if (std::all_of(parameters, parameters + size, [&](int id) { return now.markers.contains(id); })) {
    const Marker& axes = now.markers[parameters[size > 2 ? 2 : 1]];
    *count = relative(name, now.markers[parameters[0]], now.markers[parameters[1]], axes, states);
  }
  *failed = *count == 0;
}

void c_errmes(int failed, const char* message, int id, const char* what) {
  if (!failed) return;
  microslip::adapters::program().errors.push_back(std::to_string(id) + ": " + message + " (" + what + ")");
}
