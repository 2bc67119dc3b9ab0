#include "creep_law.hpp"

#include <microslip.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace {

const double steel_poisson_ratio = 0.27; // of Cooperrider's bogie in DYTSI

void check(microslip_code code, const microslip_error& error) {
  if (code != MICROSLIP_OK) throw std::runtime_error(error.text);
}

microslip_contact library_contact(const WheelContact& contact) {
  microslip_contact result = {};
  result.a = contact.a;
  result.b = contact.b;
  result.shear_modulus = contact.shear_modulus;
  result.poisson_ratio = steel_poisson_ratio;
  result.normal_force = contact.normal_force;
  result.rolling_speed = 1; // without effect: friction is Coulomb's
  result.creepage_longitudinal = contact.longitudinal;
  result.creepage_lateral = contact.lateral;
  result.spin = contact.spin;
  result.friction = contact.friction;
  result.friction_law = MICROSLIP_COULOMB;
  return result;
}

CreepForces checked(const microslip_forces& forces, const microslip_contact& contact) {
  if (forces.status == MICROSLIP_INVALID_INPUT) {
    microslip_error error;
    check(microslip_contact_check(&contact, &error), error);
  }
  return {forces.fx, forces.fy};
}

class ShenHedrickElkins : public CreepLaw {
public:
  CreepForces forces(const WheelContact& contact) override {
    const double stiffness = contact.shear_modulus * contact.a * contact.b;
    const double fx = -stiffness * contact.c11 * contact.longitudinal;
    const double fy =
        -stiffness * (contact.c22 * contact.lateral + std::sqrt(contact.a * contact.b) * contact.c23 * contact.spin);
    const double u = std::hypot(fx, fy) / (contact.friction * contact.normal_force);
    const double reduction = u < 3 ? 1 - u / 3 + u * u / 27 : 1 / u;
    return {reduction * fx, reduction * fy};
  }
};

class Fastsim2 : public CreepLaw {
public:
  Fastsim2() {
    microslip_error error;
    check(microslip_fastsim2_create(nullptr, &solver_, &error), error);
  }
  Fastsim2(const Fastsim2&) = delete;
  Fastsim2& operator=(const Fastsim2&) = delete;
  ~Fastsim2() override { microslip_fastsim2_destroy(solver_); }

  CreepForces forces(const WheelContact& contact) override {
    const microslip_contact input = library_contact(contact);
    microslip_forces result;
    microslip_fastsim2_solve(solver_, 1, &input, &result);
    return checked(result, input);
  }

private:
  microslip_fastsim2* solver_ = nullptr;
};

class Table : public CreepLaw {
public:
  Table() {
    const char* file = std::getenv("MICROSLIP_CREEP_TABLE");
    if (file == nullptr) throw std::runtime_error("MICROSLIP_CREEP_TABLE: names no file of a creep-force table");
    microslip_error error;
    check(microslip_creep_table_read(file, MICROSLIP_FORWARD, &table_, &error), error);
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() override { microslip_creep_table_destroy(table_); }

  CreepForces forces(const WheelContact& contact) override {
    const microslip_contact input = library_contact(contact);
    microslip_forces result;
    microslip_creep_table_solve(table_, 1, &input, &result);
    return checked(result, input);
  }

private:
  microslip_creep_table* table_ = nullptr;
};

class Exact : public CreepLaw {
public:
  Exact() {
    microslip_error error;
    check(microslip_problem_create(MICROSLIP_BODIES, &problem_, &error), error);
    check(microslip_set_text(problem_, "solution.theory", "exact", &error), error);
    set("solution.grid", 24);
    set("solution.tolerance", 1e-10);
    set("motion.rolling_speed", 1);
    set("body1.poisson_ratio", steel_poisson_ratio);
    set("body2.poisson_ratio", steel_poisson_ratio);
  }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() override { microslip_problem_destroy(problem_); }

  CreepForces forces(const WheelContact& contact) override {
    set("ellipse.a", contact.a);
    set("ellipse.b", contact.b);
    set("body1.shear_modulus", contact.shear_modulus);
    set("body2.shear_modulus", contact.shear_modulus);
    set("load.normal_force", contact.normal_force);
    set("friction.coefficient", contact.friction);
    set("motion.creepage_longitudinal", contact.longitudinal);
    set("motion.creepage_lateral", contact.lateral);
    set("motion.spin", contact.spin);
    microslip_error error;
    const microslip_code code = microslip_solve(problem_, &error);
    if (code != MICROSLIP_IMPLAUSIBLE) check(code, error);
    return {number("fx"), number("fy")};
  }

private:
  void set(const char* path, double value) {
    microslip_error error;
    check(microslip_set(problem_, path, value, &error), error);
  }

  double number(const char* name) const {
    double value;
    microslip_error error;
    check(microslip_number(problem_, name, &value, &error), error);
    return value;
  }

  microslip_problem* problem_ = nullptr;
};

template <class Law> std::unique_ptr<CreepLaw> made() {
  return std::unique_ptr<CreepLaw>(new Law);
}

struct NamedLaw {
  const char* name;
  std::unique_ptr<CreepLaw> (*make)();
};

const NamedLaw laws[] = {{"shen_hedrick_elkins", made<ShenHedrickElkins>},
                         {"fastsim2", made<Fastsim2>},
                         {"table", made<Table>},
                         {"exact", made<Exact>}};

/// DYTSI calls its law from within its components and has no handle to pass on, so the law in use is a static here.
struct LawInUse {
  std::unique_ptr<CreepLaw> law;
  double shear_modulus = 0;

  LawInUse() {
    if (const char* name = std::getenv("MICROSLIP_CREEP_LAW")) law = make_creep_law(name);
    if (const char* value = std::getenv("MICROSLIP_SHEAR_MODULUS")) shear_modulus = std::stod(value);
  }
};

LawInUse& in_use() {
  static LawInUse in_use;
  return in_use;
}

} // namespace

std::vector<std::string> creep_law_names() {
  std::vector<std::string> names;
  for (const NamedLaw& law : laws) names.push_back(law.name);
  return names;
}

std::unique_ptr<CreepLaw> make_creep_law(const std::string& name) {
  std::string names;
  for (const NamedLaw& law : laws) {
    if (name == law.name) return law.make();
    names += std::string(names.empty() ? "" : ", ") + law.name;
  }
  throw std::invalid_argument("no creep law " + name + "; there are " + names);
}

void use_creep_law(std::unique_ptr<CreepLaw> law, double shear_modulus) {
  in_use().law = std::move(law);
  in_use().shear_modulus = shear_modulus;
}

void replace_creep_forces(const WheelContact& contact, double forces[2]) {
  if (!in_use().law) return;
  WheelContact given = contact;
  if (in_use().shear_modulus > 0) given.shear_modulus = in_use().shear_modulus;
  const CreepForces found = in_use().law->forces(given);
  forces[0] = found.longitudinal;
  forces[1] = found.lateral;
}
