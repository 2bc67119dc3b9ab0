#pragma once

// Calls as programs make them, with whole numbers and lists instead of pointers.

#include "contact_addon.h"
#include "paths.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace microslip::libcontact {

inline constexpr int whole = -1;

inline int size_of(const auto& values) {
  return static_cast<int>(values.size());
}

/// The library from its beginning to its end, with its log in a folder.
class Library {
public:
  explicit Library(std::filesystem::path folder) : folder_(std::move(folder)) {
    const std::string name = folder_.string();
    int version = 0, error = 0, output = 0, length = static_cast<int>(name.size()), blank = 1;
    code = cntc_initializefirst(&version, &error, &output, " ", name.c_str(), " ", &blank, &length, &blank);
  }
  ~Library() { cntc_finalizelast(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  std::string log() const {
    std::ifstream file(folder_ / "contact_addon.out");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  int code = 0;

private:
  std::filesystem::path folder_;
};

inline int initialize(int ire, int module) {
  int version = 0, error = 0, blank = 1;
  return cntc_initialize(&ire, &module, &version, &error, " ", &blank);
}
inline int finalize(int ire) {
  return cntc_finalize(&ire);
}
inline int set_flag(int ire, int icp, int code, int value) {
  int one = 1;
  return cntc_setflags(&ire, &icp, &one, &code, &value);
}
inline int calculate(int ire, int icp = whole) {
  int error = 1;
  const int code = cntc_calculate(&ire, &icp, &error);
  return error == code ? code : 12345;
}

using Values = std::vector<double>;
using Setter = int (*)(int*, int*, int*, int*, double*);
using WheelSetter = int (*)(int*, int*, int*, double*);
/// ire, icp, method, values.
inline int set(Setter setter, int ire, int icp, int method, Values values) {
  int count = size_of(values);
  return setter(&ire, &icp, &method, &count, values.data());
}
/// ire, method, values.
inline int set(WheelSetter setter, int ire, int method, Values values) {
  int count = size_of(values);
  return setter(&ire, &method, &count, values.data());
}

/// Numbers of a function that fills an array.
inline Values list(int (*getter)(int*, int*, int*, double*), int ire, int icp, int count) {
  Values values(static_cast<std::size_t>(count));
  if (getter(&ire, &icp, &count, values.data()) < 0) return {};
  return values;
}
inline Values field(int ire, int icp, int code, int count) {
  Values values(static_cast<std::size_t>(count), -12345);
  if (cntc_getfielddata(&ire, &icp, &code, &count, values.data()) < 0) return {};
  return values;
}
/// Numbers of functions that return them one by one.
template <class... Places> Values scalars(int (*getter)(int*, int*, Places...), int ire, int icp) {
  Values values(sizeof...(Places), -12345);
  const auto call = [&]<std::size_t... k>(std::index_sequence<k...>) {
    return getter(&ire, &icp, &values[k]...);
  };
  if (call(std::index_sequence_for<Places...>()) < 0) return {};
  return values;
}
inline int elements(int ire, int icp) {
  int mx = 0, my = 0;
  return cntc_getnumelements(&ire, &icp, &mx, &my) < 0 ? 0 : mx * my;
}
inline int patches(int ire) {
  int count = -1;
  cntc_getnumcontactpatches(&ire, &count);
  return count;
}

inline const std::string profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";

inline int set_profile(int ire, const std::string& file, int type) {
  int length = size_of(file), ints = 3, reals = 2, choices[3] = {type, 0, 0};
  double numbers[2] = {1, 0};
  return cntc_setprofileinputfname(&ire, file.c_str(), &length, &ints, choices, &reals, numbers);
}

/// Makes the calls that a wheel of a wheelset needs once: 60E1 and S1002, elements of 0.5 mm, steel. Returns the first
/// code other than 0.
inline int set_up_wheel(int ire, bool is_right, double force = 80e3) {
  const int codes[] = {
      set_flag(ire, whole, CNTC_ic_config, is_right ? 1 : 0),
      set_flag(ire, whole, CNTC_ic_tang, 3),
      set_flag(ire, whole, CNTC_ic_pvtime, 2),
      set(cntc_setmaterialparameters, ire, whole, 0, {0.28, 0.28, 82000, 82000}),
      set(cntc_setfrictionmethod, ire, whole, 0, {0.3, 0.3}),
      cntc_setverticalforce(&ire, &force),
      set(cntc_setpotcontact, ire, whole, -1, {0.5, 0.5, 1.5707963267948966, 8, 4}),
      set(cntc_settrackdimensions, ire, 3, {14, 0, 1435, 0.05, 0, 0, 0, 0, 0, 0, 0}),
      set_profile(ire, profiles + "60e1.prr", 0),
      set(cntc_setwheelsetdimensions, ire, 3, {1360, -70, 460}),
      set_profile(ire, profiles + "s1002.prw", 1),
  };
  for (const int code : codes)
    if (code != 0) return code;
  return 0;
}

/// A state of the wheelset: aside by y [mm].
inline int set_wheel_state(int ire, double y) {
  const int at = set(cntc_setwheelsetposition, ire, 2, {0, y, 0, -1e-4 * y, 2e-3 * y, 0});
  return at != 0 ? at : set(cntc_setwheelsetvelocity, ire, 2, {30e3, 0, 0, 0, 0, -30e3 / 460.3});
}

/// A sphere on a plane of module 3 in steady rolling.
inline int set_up_sphere(int ire, int icp) {
  double speed = 1000, chi = 0, step = 0.2, force = 1000, xi = 1e-3, eta = -5e-4, phi = 1e-4;
  const int codes[] = {
      set_flag(ire, icp, CNTC_ic_tang, 3),
      set_flag(ire, icp, CNTC_ic_pvtime, 2),
      set(cntc_setmaterialparameters, ire, icp, 0, {0.28, 0.28, 82000, 82000}),
      set(cntc_setfrictionmethod, ire, icp, 0, {0.3, 0.3}),
      set(cntc_setpotcontact, ire, icp, 1, {21, 21, -1.05, -1.05, 0.1, 0.1}),
      set(cntc_setundeformeddistc, ire, icp, 1, {0.005, 0, 0.005, 0, 0, 0}),
      cntc_setreferencevelocity(&ire, &icp, &speed),
      cntc_setrollingstepsize(&ire, &icp, &chi, &step),
      cntc_setnormalforce(&ire, &icp, &force),
      cntc_setcreepages(&ire, &icp, &xi, &eta, &phi),
  };
  for (const int code : codes)
    if (code != 0) return code;
  return 0;
}

} // namespace microslip::libcontact
