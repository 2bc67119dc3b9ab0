#pragma once

#include "microslip/elasticity/viscoelastic.hpp"

#include <complex>
#include <string>
#include <vector>

namespace microslip {

/// A term of a Prony series: of the instantaneous modulus M0 the share g relaxes with the time tau.
struct PronyTerm {
  double share; ///< g [-], > 0
  double time;  ///< tau [s], > 0

  friend bool operator==(const PronyTerm&, const PronyTerm&) = default;
};

/// Relaxation of a modulus, M(t) = M0 (1 - sum of g (1 - exp(-t/tau))), in any order; no terms: elastic.
using PronySeries = std::vector<PronyTerm>;

/// Throws Error unless shares and times are positive and finite, and the shares' sum is below 1.
void check(const std::string& field, const PronySeries& series);

/// M(omega)/M0 = 1 - sum of g/(1 + i omega tau), for e^(+i omega t).
std::complex<double> relative_modulus(const PronySeries& series, double omega);

/// Creep that belongs to a relaxation: M0/M(omega) = 1 + sum of f/(1 + i omega T), terms of ascending T [s]. The 1/T
/// are the zeros of M(-1/T), one below each 1/tau (Gross 1953), and f = T/(sum of g tau/(1 - tau/T)^2).
std::vector<MaterialCreep> creep_of(const PronySeries& series);

} // namespace microslip
