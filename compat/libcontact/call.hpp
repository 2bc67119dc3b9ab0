#pragma once

#include "compat/libcontact/refusal.hpp"
#include "compat/libcontact/registry.hpp"
#include "microslip/error.hpp"

#include <new>
#include <string>
#include <type_traits>

namespace microslip::libcontact {

/// Which module a function is of.
enum class Module { any = 0, wheel = 1, contact = 3 };
/// Which icp a function takes in module 1: -1, either, or that of a patch.
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

/// A call for a patch of either module.
inline Call patch_call(const char* name, const int* ire, const int* icp) {
  return {name, ire, icp, Module::any, Scope::patch};
}

/// Runs the body of a call, which returns nothing or a code. Whatever it throws becomes a code, and a message in the
/// log.
template <class Body> int guarded(const std::string& heading, Body body) noexcept {
  const auto refuse = [&](int code, const std::string& why) {
    Registry::instance().log().write_once(heading + ": " + why);
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

/// The problem of a call, if it takes the module and icp. Throws Refusal.
std::shared_ptr<ContactProblem> find_problem(const Call& call);

/// The same with the problem, which no other thread works on meanwhile.
template <class Body> int guarded(const Call& call, Body body) noexcept {
  return guarded(call.heading(), [&] {
    const auto problem = find_problem(call);
    const std::unique_lock lock(problem->mutex, std::try_to_lock);
    if (!lock) throw Refusal(CNTC_err_other, "another thread works on this contact problem");
    return body(*problem);
  });
}

/// icp of functions that have none.
inline constexpr int whole_wheel = -1;

} // namespace microslip::libcontact

/// The name with an underscore behind it.
#define LIBCONTACT_UNDERSCORED(name) extern "C" __attribute__((alias(#name))) decltype(name) name##_;
