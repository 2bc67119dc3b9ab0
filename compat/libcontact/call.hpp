#pragma once

#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/refusal.hpp"
#include "compat/libcontact/registry.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace microslip::libcontact {

/// Module of a function.
enum class Module { any = 0, wheel = 1, contact = 3 };
/// Range of icp that a function takes in module 1: -1, either, or that of a patch.
enum class Scope { whole, either, patch };

/// A call of the interface: its name and the problem it is for.
struct Call {
  const char* name;
  const int* ire;
  const int* icp;
  Module module;
  Scope scope;

  std::string heading() const;
};

/// icp of functions that have none.
inline constexpr int whole_wheel = -1;

/// A call for a contact problem, or a whole wheel.
inline Call problem_call(const char* name, const int* ire, const int* icp) {
  return {name, ire, icp, Module::any, Scope::whole};
}
/// A call for a contact problem, a whole wheel or a patch.
inline Call either_call(const char* name, const int* ire, const int* icp) {
  return {name, ire, icp, Module::any, Scope::either};
}
/// A call for a patch of either module.
inline Call patch_call(const char* name, const int* ire, const int* icp) {
  return {name, ire, icp, Module::any, Scope::patch};
}
/// A call for a contact problem of module 3.
inline Call contact_call(const char* name, const int* ire, const int* icp) {
  return {name, ire, icp, Module::contact, Scope::patch};
}
/// A call for a whole wheel.
inline Call wheel_call(const char* name, const int* ire) {
  return {name, ire, &whole_wheel, Module::wheel, Scope::whole};
}

/// Prefix of a message about a call in the log.
inline const char* heading_of(const char* name) {
  return name;
}
inline std::string heading_of(const Call& call) {
  return call.heading();
}

/// Runs the body of a call, which returns nothing or a code. Whatever it throws becomes a code, and a message in the
/// log. `call` is a Call or the name of a function without a problem.
template <class Heading, class Body> int guarded_body(const Heading& call, Body body) noexcept {
  const auto refuse = [&](int code, const char* why) {
    Registry::instance().log().write_once([&] { return std::string(heading_of(call)) + ": " + why; });
    return code;
  };
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      body();
      return 0;
    } else {
      return body();
    }
  } catch (const Refusal& refusal) {
    return refuse(refusal.code, refusal.what());
  } catch (const Error& error) {
    return refuse(CNTC_err_other, error.what());
  } catch (const std::bad_alloc&) {
    return refuse(CNTC_err_other, "not enough memory");
  } catch (const std::exception& fault) {
    return refuse(CNTC_err_other, fault.what());
  } catch (...) {
    return refuse(CNTC_err_other, "unknown exception");
  }
}

template <class Body> int guarded(const char* name, Body body) noexcept {
  return guarded_body(name, body);
}

/// The problem of a call, if it takes the module and icp; a new one, and a new result element, if there is none yet: of
/// module 1 for icp = -1, as all functions without icp have it, of module 3 for others, as in CONTACT. Throws Refusal.
std::shared_ptr<ContactProblem> find_problem(const Call& call);

/// The same with the problem, which no other thread works on meanwhile.
template <class Body> int guarded(const Call& call, Body body) noexcept {
  return guarded_body(call, [&] {
    const auto problem = find_problem(call);
    const std::unique_lock lock(problem->mutex, std::try_to_lock);
    if (!lock) throw Refusal(CNTC_err_other, "another thread works on this contact problem");
    return body(*problem);
  });
}

/// A call that sets data by a method and its numbers: `set(problem, method, numbers)`.
template <class Set>
int set_by(const Call& call, Set set, const char* name, const int* method, const char* numbers_name, const int* count,
           const double* numbers) noexcept {
  return guarded(call, [&](ContactProblem& p) { set(p, integer(name, method), reals(numbers_name, count, numbers)); });
}

/// Destination of results of a call, and their values if it is refused.
template <class Value> struct Results {
  Value* places;
  std::size_t count;
  Value none;

  void clear() const {
    if (places) std::fill_n(places, count, none);
  }
};

/// A number.
template <class Value> Results<Value> result(Value* place, Value none = 0) {
  return {place, 1, none};
}

/// As a length; 0 for one that no array has: there are no more elements in a potential contact.
inline std::size_t believed(double length) {
  constexpr double longest = 1e8;
  return length > 0 && length <= longest ? static_cast<std::size_t>(length) : 0;
}

/// Numbers, of which the function has `most`.
template <class Value>
Results<Value> results(const int* length, Value* places, int most = std::numeric_limits<int>::max(), Value none = 0) {
  return {places, length ? believed(std::min(*length, most)) : 0, none};
}
/// A table.
template <class Value> Results<Value> results(const int* rows, const int* columns, Value* places) {
  const bool is_table = rows && columns && *rows > 0 && *columns > 0;
  return {places, is_table ? believed(static_cast<double>(*rows) * *columns) : 0, 0};
}

/// All results of a call.
template <class... Values> std::tuple<Results<Values>...> into(const Results<Values>&... all) {
  return {all...};
}

/// As guarded, of a function that gets results: callers that look at no code have defined numbers if it is refused.
template <class... Values, class Body>
int answered(const Call& call, const std::tuple<Results<Values>...>& found, Body body) noexcept {
  static_assert(std::is_void_v<decltype(body(std::declval<ContactProblem&>()))>, "a code would read like a refusal");
  const int code = guarded(call, body);
  if (code != 0) std::apply([](const auto&... each) { (each.clear(), ...); }, found);
  return code;
}

/// A place for a number: its name in messages, and what the place has if the call is refused.
template <class Value> struct Place {
  const char* name;
  Value* to;
  Value none = 0;
};

/// A call that gets numbers: `find(problem)` has them in the order of their places.
template <class Value, std::size_t count, class Find>
int get_numbers(const Call& call, const Place<Value> (&places)[count], Find find) noexcept {
  const int code = guarded(call, [&](ContactProblem& p) {
    for (const auto& place : places) given(place.name, place.to);
    const std::array<Value, count> found = find(p);
    for (std::size_t k = 0; k < count; ++k) *places[k].to = found[k];
  });
  for (const auto& place : places)
    if (code != 0 && place.to) *place.to = place.none;
  return code;
}

/// A call that gets an array, `most` numbers of which the function has; of `find(problem)` as many as fit.
template <class Find>
int get_array(const Call& call, const int* length, double* values, Find find,
              int most = std::numeric_limits<int>::max()) noexcept {
  return answered(call, into(results(length, values, most)),
                  [&](ContactProblem& p) { fill(room("values", length, values), std::vector<double>(find(p))); });
}

} // namespace microslip::libcontact
