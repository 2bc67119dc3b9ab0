#pragma once

#include <complex>
#include <span>
#include <vector>

namespace microslip {

/// Functions of s that are real for real s, h_f(s) = d_f + sum over n of r_fn/(s - p_n), with common poles. A pole with
/// an imaginary part, which is positive, stands for itself and its conjugate, whose residue is the conjugate.
struct RationalFit {
  std::vector<std::complex<double>> poles;
  std::vector<std::vector<std::complex<double>>> residues; ///< of each function, by the poles
  std::vector<double> constants;                           ///< d_f
  std::vector<double> errors; ///< largest difference from the data, over the largest value of the function [-]

  std::complex<double> value(std::size_t function, std::complex<double> s) const;
};

/// Fits functions given at s = i omega, omega >= 0 ascending: values[f][k] at omega[k]. `order` counts a pair of poles
/// twice. By relaxed vector fitting (Gustavsen & Semlyen 1999; Gustavsen 2006) with common poles, which are found from
/// all functions, each over its largest value, with the parts of the equations that belong to single functions
/// eliminated (Deschrijver et al. 2008). Poles that are not stable are mirrored at the imaginary axis in each
/// iteration, so that all have negative real parts; of 30 iterations' fits the best one is returned. Throws Error for
/// values that are not finite, and for fewer than order + 1 frequencies.
RationalFit fit_rational(std::span<const double> omega, const std::vector<std::vector<std::complex<double>>>& values,
                         int order);

} // namespace microslip
