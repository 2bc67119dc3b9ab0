// The cost of a call of FASTSIM2 through each interface, over the 3,220 cases on one core: directly in C++, through the
// C interface, and as a step of the functional mock-up unit. Interfaces take turns; each figure is the shortest of many
// rounds.

#include "fmi/description.hpp"
#include "fmi/fmi2.h"
#include "microslip.h"
#include "microslip/simplified/fastsim2.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

namespace {

using namespace microslip;

const std::vector<EllipticContact>& contacts() {
  static const std::vector<EllipticContact> all = validation::test_set_contacts();
  return all;
}

std::vector<microslip_contact> c_contacts() {
  std::vector<microslip_contact> all;
  for (const EllipticContact& e : contacts()) {
    microslip_contact c{};
    c.a = e.a, c.b = e.b;
    c.shear_modulus = e.shear_modulus, c.poisson_ratio = e.poisson_ratio;
    c.normal_force = e.normal_force, c.rolling_speed = e.rolling_speed;
    c.creepage_longitudinal = e.creepage.longitudinal, c.creepage_lateral = e.creepage.lateral,
    c.spin = e.creepage.spin;
    c.friction = e.friction.kinetic_coefficient();
    all.push_back(c);
  }
  return all;
}

/// Solves all cases; returns something that depends on every result.
struct Interface {
  const char* name;
  std::function<double()> solve_all;
  double shortest = std::numeric_limits<double>::infinity(); ///< [ns] for a contact
};

/// An instance of the unit, in the middle of a simulation.
class UnitInterface {
public:
  UnitInterface() : handle_(dlopen(MICROSLIP_FMU_BINARY, RTLD_NOW)) {
    if (!handle_) throw std::runtime_error(dlerror());
    const fmi2CallbackFunctions functions = {};
    const auto instantiate = find<decltype(fmi2Instantiate)>("fmi2Instantiate");
    const std::string guid = fmi::guid(fmi::model_info(), fmi::Version::fmi2);
    unit_ = instantiate("bench", fmi2CoSimulation, guid.c_str(), "", &functions, fmi2False, fmi2False);
    if (!unit_) throw std::runtime_error("the unit refuses to be made");
    find<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(unit_);
    find<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(unit_);
    set_ = find<decltype(fmi2SetReal)>("fmi2SetReal");
    get_ = find<decltype(fmi2GetReal)>("fmi2GetReal");
    step_ = find<decltype(fmi2DoStep)>("fmi2DoStep");
  }
  double solve(const EllipticContact& c) const {
    constexpr fmi2ValueReference inputs[] = {0, 1, 2, 3, 4}, outputs[] = {5, 6, 7};
    const double values[] = {c.creepage.longitudinal, c.creepage.lateral, c.creepage.spin, c.normal_force, 0.3};
    double forces[3] = {};
    set_(unit_, inputs, 5, values);
    step_(unit_, 0, 1e-3, fmi2True);
    get_(unit_, outputs, 3, forces);
    return forces[0];
  }

private:
  template <class Function> Function* find(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }
  void* handle_;
  fmi2Component unit_;
  decltype(&fmi2SetReal) set_;
  decltype(&fmi2GetReal) get_;
  decltype(&fmi2DoStep) step_;
};

double nanoseconds_per_contact(const std::function<double()>& solve_all, double& sum) {
  const auto before = std::chrono::steady_clock::now();
  sum += solve_all();
  const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - before;
  return passed.count() / static_cast<double>(contacts().size());
}

template <class Contacts, class Solve> double one_by_one(const Contacts& all, Solve solve) {
  double sum = 0;
  for (const auto& contact : all) sum += solve(contact);
  return sum;
}

} // namespace

int main() try {
  Fastsim2 solver;
  microslip_fastsim2* handle = nullptr;
  if (microslip_fastsim2_create(nullptr, &handle, nullptr) != MICROSLIP_OK) return 1;
  const std::vector<microslip_contact> c = c_contacts();
  std::vector<ContactForces> forces(c.size());
  std::vector<microslip_forces> c_forces(c.size());
  const UnitInterface unit;
  Interface interfaces[] = {
      {"C++, one by one",
       [&] { return one_by_one(contacts(), [&](const auto& contact) { return solver.solve(contact).fx; }); }},
      {"C, one by one",
       [&] {
         return one_by_one(c, [&](const auto& contact) {
           microslip_forces found;
           microslip_fastsim2_solve(handle, 1, &contact, &found);
           return found.fx;
         });
       }},
      {"FMU, a step each", [&] { return one_by_one(contacts(), [&](const auto& k) { return unit.solve(k); }); }},
      {"C++ with derivatives, one by one",
       [&] {
         return one_by_one(contacts(),
                           [&](const auto& contact) { return solver.differentiate(contact).jacobian[0][0]; });
       }},
      {"C with derivatives, one by one",
       [&] {
         return one_by_one(c, [&](const auto& contact) {
           microslip_derivatives found;
           microslip_fastsim2_differentiate(handle, 1, &contact, &found);
           return found.jacobian[0][0];
         });
       }},
      {"C++, all in a call",
       [&] {
         solver.solve(contacts(), forces);
         return forces[0].fx;
       }},
      {"C, all in a call",
       [&] {
         microslip_fastsim2_solve(handle, c.size(), c.data(), c_forces.data());
         return c_forces[0].fx;
       }},
  };
  double sum = 0;
  for (int round = 0; round < 100; ++round)
    for (Interface& one : interfaces)
      one.shortest = std::min(one.shortest, nanoseconds_per_contact(one.solve_all, sum));
  for (const Interface& one : interfaces) std::printf("%-34s %7.0f ns per contact\n", one.name, one.shortest);
  std::printf("(sum of results %g)\n", sum);
  microslip_fastsim2_destroy(handle);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
