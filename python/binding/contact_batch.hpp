#pragma once

#include "binding/arrays.hpp"
#include "binding/long_work.hpp"
#include "microslip/rolling/rolling_problem.hpp"

#include <array>
#include <initializer_list>
#include <string>
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
  /// Throws Error for arrays that are no real numbers or whose shapes do not match, and for friction coefficients out
  /// of range.
  ContactBatch(const EllipticContact& like, const ContactArrays& arrays);
  /// Batch of contacts like a Hertzian problem. Throws Error for another problem and other constants.
  ContactBatch(const RollingProblem& like, const ContactArrays& arrays);

  const Shape& shape() const { return shape_; }
  std::size_t count() const { return count_; }
  /// Needs no Python.
  EllipticContact operator[](std::size_t i) const;
  /// Problem i, otherwise as the one they are like. Needs no Python.
  RollingProblem problem(std::size_t i) const;
  /// Returns of each column one number, or as many as there are contacts. Of friction that at rest.
  std::vector<std::vector<double>> inputs() const;

private:
  /// Returns true if an array or a number was given for one of these columns.
  bool gives(std::initializer_list<std::string_view> names) const;

  EllipticContact like_;
  RollingProblem problem_;
  Shape shape_;
  std::size_t count_ = 1;
  static constexpr std::size_t columns = input_names.size();
  std::array<RealArray, columns> columns_;
  std::array<const double*, columns> values_ = {}; ///< null where the contact's value holds
  std::array<bool, columns> constant_ = {};
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
  void put(std::size_t i, const ContactDerivatives& derivatives);

  ForceArrays forces;
  std::vector<double> jacobian;
};

/// Forces of many contacts with what the solver reports.
struct SolutionArrays {
  SolutionArrays() = default;
  explicit SolutionArrays(const ContactBatch& batch);

  ForceArrays forces;
  std::vector<double> residual;
  std::vector<int> newton_steps;
};

void bind_contact_batch(pybind11::module_& module);

inline constexpr const char* batch_text =
    "Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`\n"
    "is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:\n"
    "longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],\n"
    "normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the\n"
    "broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with\n"
    "KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out\n"
    "of range have Status.invalid_input and NaN. ";

/// Gives a class a batch method: `solve(self, batch, threads)` of what the others are like, and arrays. `returns`
/// ends its text.
template <class Like = EllipticContact, class Class, class... Options, class Solve>
void def_batch(pybind11::class_<Class, Options...>& of, const char* name, const Solve& solve, const char* returns) {
  namespace py = pybind11;
  using namespace py::literals;
  using Object = const py::object&;
  const auto none = py::none();
  of.def(
      name,
      [solve](const Class& self, const Like& like, Object longitudinal, Object lateral, Object spin, Object a, Object b,
              Object shear_modulus, Object poisson_ratio, Object normal_force, Object friction, Object rolling_speed,
              Object dissimilarity, int threads) {
        const ContactBatch batch(like, {longitudinal, lateral, spin, a, b, shear_modulus, poisson_ratio, normal_force,
                                        friction, rolling_speed, dissimilarity});
        return solve(self, batch, thread_count(threads));
      },
      "like"_a, "longitudinal"_a = none, "lateral"_a = none, "spin"_a = none, py::kw_only(), "a"_a = none, "b"_a = none,
      "shear_modulus"_a = none, "poisson_ratio"_a = none, "normal_force"_a = none, "friction"_a = none,
      "rolling_speed"_a = none, "dissimilarity"_a = none, "threads"_a = 0, (std::string(batch_text) + returns).c_str());
}

} // namespace microslip::python
