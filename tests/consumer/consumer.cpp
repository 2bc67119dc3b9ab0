// Uses both installed libraries and finds the same with them.

#include <microslip.h>
#include <microslip/rolling/solver.hpp>
#include <microslip/simplified/fastsim2.hpp>
#include <microslip/version.hpp>

#include <cstdio>

int main() {
  const microslip::EllipticContact contact{.a = 6e-3,
                                           .b = 5e-3,
                                           .shear_modulus = 82e9,
                                           .poisson_ratio = 0.28,
                                           .normal_force = 80e3,
                                           .friction = microslip::FrictionLaw::coulomb(0.3),
                                           .creepage = {0.001, 0.0005, 0.3}};
  const microslip_contact same = {6e-3, 5e-3, 82e9, 0.28, 80e3, 1, 0.001, 0.0005, 0.3, 0.3, MICROSLIP_COULOMB, {}, {}};
  const double cpp = microslip::Fastsim2().solve(contact).fx;
  const double exact = microslip::Solver({.mx = 12, .my = 12}).solve(microslip::rolling_problem(contact)).totals.fx;
  microslip_fastsim2* solver = nullptr;
  microslip_forces forces;
  microslip_fastsim2_create(nullptr, &solver, nullptr);
  microslip_fastsim2_solve(solver, 1, &same, &forces);
  microslip_fastsim2_destroy(solver);
  std::printf("version %s, fx = %.6g N by C++, %.6g N by C, %.6g N by the exact theory\n", microslip_version(), cpp,
              forces.fx, exact);
  const bool fine = cpp == forces.fx && cpp < 0 && exact < 0.9 * cpp && exact > 1.3 * cpp;
  return fine && microslip::build_info().version == microslip_version() ? 0 : 1;
}
