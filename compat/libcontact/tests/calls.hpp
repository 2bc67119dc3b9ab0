#pragma once

// Calls as programs make them, with whole numbers and lists instead of pointers.

#include "contact_addon.h"
#include "paths.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace microslip::libcontact {

inline constexpr int whole = -1;
inline const std::string profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";

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

/// ire, icp, numbers.
template <class... Numbers, class... Given>
int set(int (*setter)(int*, int*, Numbers...), int ire, int icp,
        Given... numbers) requires(sizeof...(Numbers) == sizeof...(Given) &&
                                   (std::is_same_v<Numbers, double*> && ...)) {
  const auto call = [&](auto... values) { return setter(&ire, &icp, &values...); };
  return call(static_cast<double>(numbers)...);
}
inline int set_force(int ire, double force) {
  return cntc_setverticalforce(&ire, &force);
}

/// A call as programs make it, of an element and a contact problem, or whole: its numbers, some of which may be others.
struct Setting {
  std::function<int(int ire, int icp, Values numbers)> set;
  Values numbers;

  int operator()(int ire, int icp) const { return set(ire, icp, numbers); }
};
inline Setting by(Setter setter, int method, Values numbers) {
  return {[=](int ire, int icp, Values v) { return set(setter, ire, icp, method, std::move(v)); }, std::move(numbers)};
}
inline Setting by(WheelSetter setter, int method, Values numbers) {
  return {[=](int ire, int, Values v) { return set(setter, ire, method, std::move(v)); }, std::move(numbers)};
}
template <class... Numbers> Setting by(int (*setter)(int*, int*, Numbers...), Values numbers) {
  return {[=](int ire, int icp, Values v) {
            v.resize(sizeof...(Numbers));
            return [&]<std::size_t... k>(std::index_sequence<k...>) {
              return setter(&ire, &icp, &v[k]...);
            }
            (std::index_sequence_for<Numbers...>());
          },
          std::move(numbers)};
}
inline Setting by_flag(int code, int value) {
  return {[=](int ire, int icp, const Values&) { return set_flag(ire, icp, code, value); }, {}};
}
inline Setting by_force(double force) {
  return {[](int ire, int, Values v) { return set_force(ire, v.empty() ? 0 : v[0]); }, {force}};
}
inline int set_profile(int ire, const std::string& file, int type);
inline Setting by_profile(const std::string& file, int type) {
  return {[=](int ire, int, const Values&) { return set_profile(ire, file, type); }, {}};
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
inline Values parameters(int ire, int icp, int task, int count) {
  Values values(static_cast<std::size_t>(count));
  return cntc_getparameters(&ire, &icp, &task, &count, values.data()) < 0 ? Values() : values;
}
/// Four outputs by the four inputs in turn.
inline Values sensitivities(int ire, int icp) {
  int four = 4;
  Values values(16);
  return cntc_getsensitivities(&ire, &icp, &four, &four, values.data()) < 0 ? Values() : values;
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
      set_force(ire, force),
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
  const int codes[] = {
      set_flag(ire, icp, CNTC_ic_tang, 3),
      set_flag(ire, icp, CNTC_ic_pvtime, 2),
      set(cntc_setmaterialparameters, ire, icp, 0, {0.28, 0.28, 82000, 82000}),
      set(cntc_setfrictionmethod, ire, icp, 0, {0.3, 0.3}),
      set(cntc_setpotcontact, ire, icp, 1, {21, 21, -1.05, -1.05, 0.1, 0.1}),
      set(cntc_setundeformeddistc, ire, icp, 1, {0.005, 0, 0.005, 0, 0, 0}),
      set(cntc_setreferencevelocity, ire, icp, 1000),
      set(cntc_setrollingstepsize, ire, icp, 0, 0.2),
      set(cntc_setnormalforce, ire, icp, 1000),
      set(cntc_setcreepages, ire, icp, 1e-3, -5e-4, 1e-4),
  };
  for (const int code : codes)
    if (code != 0) return code;
  return 0;
}

} // namespace microslip::libcontact
