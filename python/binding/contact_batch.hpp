#pragma once

#include "binding/arrays.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace microslip::python {

/// Values that may be given as arrays instead of the contact's value: keyword arguments of the batches.
struct ContactArrays {
  pybind11::object longitudinal, lateral, spin; ///< [-], [-], [1/m]
  pybind11::object a, b;                        ///< [m]
  pybind11::object shear_modulus, poisson_ratio, normal_force, friction, rolling_speed, dissimilarity;
};

/// The columns of a batch, in the order of ContactBatch::inputs.
inline constexpr std::array<std::string_view, 11> input_names = {
    "creepage_longitudinal", "creepage_lateral", "spin",         "a",        "b",
    "shear_modulus",         "poisson_ratio",    "normal_force", "friction", "rolling_speed",
    "dissimilarity"};

/// Many contacts: one that the others are like, and arrays that broadcast by numpy's rules. None: as in that one.
class ContactBatch {
public:
  /// Throws Error for arrays that are no real numbers or do not go together, and for friction coefficients out of
  /// range.
  ContactBatch(const EllipticContact& like, const ContactArrays& arrays);

  const Shape& shape() const { return shape_; }
  std::size_t count() const { return count_; }
  /// Needs no Python.
  EllipticContact operator[](std::size_t i) const;
  /// Returns of each column one number, or as many as there are contacts. Of friction that at rest.
  std::vector<std::vector<double>> inputs() const;

private:
  EllipticContact like_;
  Shape shape_;
  std::size_t count_ = 1;
  std::array<RealArray, 11> columns_;
  std::array<const double*, 11> values_ = {}; ///< null where the contact's value holds
  std::array<bool, 11> constant_ = {};
};

/// Forces of many contacts.
struct ForceArrays {
  ForceArrays() = default;
  explicit ForceArrays(const ContactBatch& batch);
  void put(std::size_t i, const ContactForces& forces);

  Shape shape;
  std::vector<double> fx, fy, mz, adhesion_area, slip_area;
  std::vector<unsigned char> status;
  std::vector<std::vector<double>> inputs; ///< as ContactBatch::inputs
};

/// Forces of many contacts with their derivatives, 3 x 4 for each.
struct DerivativeArrays {
  DerivativeArrays() = default;
  explicit DerivativeArrays(const ContactBatch& batch);

  ForceArrays forces;
  std::vector<double> jacobian;
};

/// Forces of many contacts by the exact theory.
struct ExactForceArrays {
  ExactForceArrays() = default;
  explicit ExactForceArrays(const ContactBatch& batch);

  ForceArrays forces;
  std::vector<double> residual;
  std::vector<int> newton_steps;
};

void bind_contact_batch(pybind11::module_& module);

} // namespace microslip::python
