#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/contact/force_response.hpp"

#include <array>
#include <complex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// What drives a contact: its creepages and its normal force, and the forces of it.
struct ElementInput {
  Creepage creepage = {};
  double normal_force = 0; ///< [N]
};
struct ElementForces {
  double fx = 0, fy = 0, mz = 0; ///< [N], [N], [N m]
};

inline constexpr std::size_t element_inputs = 4, element_outputs = 3; ///< xi, eta, phi, Fn; fx, fy, mz

/// Responses of the forces over the wavenumber as rational functions of s = i k [1/m], which vector fitting has found:
/// h(s) = d + sum over n of r_n/(s - p_n), with common poles. One with a positive imaginary part stands for its
/// conjugate, too.
struct ForceElementFit {
  ElementInput steady = {};                     ///< about which it is linear
  ElementForces forces = {};                    ///< there
  std::vector<std::complex<double>> poles = {}; ///< p_n [1/m], of negative real part
  std::vector<std::array<std::complex<double>, 12>> residues =
      {};                                ///< r_n of each pole: inputs of fx, of fy, of mz [./m]
  std::array<double, 12> constants = {}; ///< d
  std::array<double, 12> errors = {};    ///< largest difference from the responses, over the largest of them [-]

  /// The rational function at a wavenumber, of a force by an input.
  std::complex<double> response(std::size_t force, std::size_t input, double wavenumber) const;
  /// The order: a pair of poles counts twice.
  int count() const;
  /// The largest of the errors.
  double largest_error() const;
};

/// Fits responses at ascending wavenumbers, to `order` poles, of which pairs count twice. What is below 1e-6 of a
/// force's largest response, by inputs of a like size, counts as none. Throws Error for responses of
/// an unsolved state, and as fit_rational.
ForceElementFit fit_force_element(const FrequencyResponse& response, double normal_force, int order);

/// A fit as lines of text, and back. Throws Error for what is none, with the line.
std::string text_of(const ForceElementFit& fit);
ForceElementFit force_element_from(std::string_view text);

/// Forces of a contact that remember the creepages and loads before: a linear system with real coefficients, whose
/// memory is of the distance rolled, at whatever speed. Small changes about the steady state; steps are exact for
/// inputs that are linear over the distance. Copies are states that can be gone back to.
class ForceElement {
public:
  /// In the steady state.
  explicit ForceElement(ForceElementFit fit);

  const ForceElementFit& fit() const { return fit_; }
  /// Goes on by a distance [m] >= 0, over which inputs become these, and returns the forces. Throws nothing.
  ElementForces step(double distance, const ElementInput& input);
  /// The same with the inputs constant over the distance, at once those of its end.
  ElementForces step_held(double distance, const ElementInput& input);
  /// Forces with these inputs at once, and the memory as it is.
  ElementForces forces(const ElementInput& input) const;
  /// Back to the steady state, or to the forces of inputs that were always these.
  void reset() { reset(fit_.steady); }
  void reset(const ElementInput& input);

  /// The memory: of each pole the numbers of each input, real and imaginary part; and the last inputs.
  std::vector<double> state() const;
  /// The same into as many numbers; throws nothing.
  void copy_state(std::span<double> state) const;
  /// Throws Error unless it has as many numbers.
  void set_state(std::span<const double> state);
  std::size_t state_size() const { return 2 * memory_.size() + element_inputs; }

private:
  using Changes = std::array<double, element_inputs>;

  Changes changes_of(const ElementInput& input) const;
  void advance(double distance, const Changes& from, const Changes& to);

  ForceElementFit fit_;
  std::vector<std::complex<double>> memory_; ///< pole by pole, of each input
  Changes last_ = {};                        ///< inputs beyond the steady ones
  // Of the last distance, which most often stays:
  double distance_ = -1;
  struct Weights {
    std::complex<double> kept, before, after; ///< of memory, first and last input
  };
  std::vector<Weights> weights_;
};

} // namespace microslip
