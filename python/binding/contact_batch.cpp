#include "binding/contact_batch.hpp"

#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <algorithm>
#include <cstdint>

namespace microslip::python {

namespace py = pybind11;

template <>
inline constexpr auto fields<ForceArrays> =
    members<&ForceArrays::shape, &ForceArrays::fx, &ForceArrays::fy, &ForceArrays::mz, &ForceArrays::adhesion_area,
            &ForceArrays::slip_area, &ForceArrays::status, &ForceArrays::inputs>;
template <>
inline constexpr auto fields<DerivativeArrays> = members<&DerivativeArrays::forces, &DerivativeArrays::jacobian>;
template <>
inline constexpr auto fields<SolutionArrays> =
    members<&SolutionArrays::forces, &SolutionArrays::residual, &SolutionArrays::newton_steps>;

namespace {

/// A column of a batch: its argument, and what it is of a contact.
struct BatchColumn {
  const char* argument;
  py::object ContactArrays::*given;
  double (*get)(const EllipticContact& contact);
  void (*set)(EllipticContact& contact, double value);
};

template <double EllipticContact::*member> double get(const EllipticContact& contact) {
  return contact.*member;
}
template <double EllipticContact::*member> void set(EllipticContact& contact, double value) {
  contact.*member = value;
}
template <double Creepage::*member> double get(const EllipticContact& contact) {
  return contact.creepage.*member;
}
template <double Creepage::*member> void set(EllipticContact& contact, double value) {
  contact.creepage.*member = value;
}
template <auto member> constexpr BatchColumn column_of(const char* argument, py::object ContactArrays::*given) {
  return {argument, given, get<member>, set<member>};
}

/// Columns in the order of input_names.
const BatchColumn batch_columns[] = {
    column_of<&Creepage::longitudinal>("longitudinal", &ContactArrays::longitudinal),
    column_of<&Creepage::lateral>("lateral", &ContactArrays::lateral),
    column_of<&Creepage::spin>("spin", &ContactArrays::spin),
    column_of<&EllipticContact::a>("a", &ContactArrays::a),
    column_of<&EllipticContact::b>("b", &ContactArrays::b),
    column_of<&EllipticContact::shear_modulus>("shear_modulus", &ContactArrays::shear_modulus),
    column_of<&EllipticContact::poisson_ratio>("poisson_ratio", &ContactArrays::poisson_ratio),
    column_of<&EllipticContact::normal_force>("normal_force", &ContactArrays::normal_force),
    {"friction", &ContactArrays::friction, [](const EllipticContact& c) { return c.friction.static_coefficient(); },
     [](EllipticContact& c, double mu) { c.friction = FrictionLaw::coulomb(mu); }},
    column_of<&EllipticContact::rolling_speed>("rolling_speed", &ContactArrays::rolling_speed),
    column_of<&EllipticContact::dissimilarity>("dissimilarity", &ContactArrays::dissimilarity)};

} // namespace

ContactBatch::ContactBatch(const EllipticContact& like, const ContactArrays& arrays) : like_(like) {
  for (std::size_t k = 0; k < columns; ++k) {
    const auto& [argument, given, get, set] = batch_columns[k];
    if ((arrays.*given).is_none()) continue;
    columns_[k] = real_array(argument, arrays.*given);
    broadcast(shape_, argument, columns_[k]);
    values_[k] = columns_[k].data();
  }
  for (const auto extent : shape_) count_ *= static_cast<std::size_t>(extent);
  for (std::size_t k = 0; k < columns; ++k) {
    if (values_[k] == nullptr) continue;
    constant_[k] = columns_[k].size() == 1;
    if (!constant_[k]) columns_[k] = spread(columns_[k], shape_);
    values_[k] = columns_[k].data();
    if (batch_columns[k].argument == std::string_view("friction"))
      for (const double mu : span_of(columns_[k]))
        require_between("friction", mu, "-", 0, FrictionLaw::largest_coefficient);
  }
}

ContactBatch::ContactBatch(const RollingProblem& like, const ContactArrays& arrays)
    : ContactBatch(elliptic_contact(like), arrays) {
  problem_ = like;
  if (!like.bodies.are_elastic() && gives({"shear_modulus", "poisson_ratio", "dissimilarity"}))
    throw Error("shear_modulus, poisson_ratio, dissimilarity: viscoelastic bodies have their own");
  if (like.layered && gives({"a", "b", "shear_modulus", "poisson_ratio", "dissimilarity"}))
    throw Error("a, b, shear_modulus, poisson_ratio, dissimilarity: bodies with layers have their own");
}

EllipticContact ContactBatch::operator[](std::size_t i) const {
  EllipticContact contact = like_;
  for (std::size_t k = 0; k < columns; ++k)
    if (values_[k] != nullptr) batch_columns[k].set(contact, values_[k][constant_[k] ? 0 : i]);
  return contact;
}

RollingProblem ContactBatch::problem(std::size_t i) const {
  RollingProblem out = rolling_problem((*this)[i], problem_.motion);
  if (problem_.layered) {
    out.bodies = {};
    out.layered = problem_.layered;
    if (!out.layered->are_elastic()) out.layered->speed = rolling_velocity(out.motion);
  }
  out.bodies.retarded = problem_.bodies.retarded;
  out.bodies.layer = problem_.bodies.layer;
  out.friction.memory = problem_.friction.memory;
  out.friction.temperature_effect = problem_.friction.temperature_effect;
  out.thermal = problem_.thermal;
  const bool has_ellipse = std::holds_alternative<Ellipse>(problem_.geometry) || gives({"a", "b"});
  if (!has_ellipse) out.geometry = problem_.geometry; // whose ellipse follows the load
  return out;
}

bool ContactBatch::gives(std::initializer_list<std::string_view> names) const {
  for (std::size_t k = 0; k < columns; ++k)
    if (values_[k] != nullptr && std::find(names.begin(), names.end(), input_names[k]) != names.end()) return true;
  return false;
}

std::vector<std::vector<double>> ContactBatch::inputs() const {
  std::vector<std::vector<double>> out;
  for (std::size_t k = 0; k < columns; ++k)
    if (values_[k] == nullptr)
      out.push_back({batch_columns[k].get(like_)});
    else
      out.emplace_back(values_[k], values_[k] + (constant_[k] ? 1 : count_));
  return out;
}

ForceArrays::ForceArrays(const ContactBatch& batch)
    : shape(batch.shape()), fx(batch.count()), fy(fx), mz(fx), adhesion_area(fx), slip_area(fx), status(fx.size()),
      inputs(batch.inputs()) {}

void ForceArrays::put(std::size_t i, const ContactForces& forces) {
  fx[i] = forces.fx;
  fy[i] = forces.fy;
  mz[i] = forces.mz;
  adhesion_area[i] = forces.adhesion_area;
  slip_area[i] = forces.slip_area;
  status[i] = static_cast<unsigned char>(forces.status);
}

DerivativeArrays::DerivativeArrays(const ContactBatch& batch) : forces(batch), jacobian(12 * batch.count()) {}

void DerivativeArrays::put(std::size_t i, const ContactDerivatives& derivatives) {
  forces.put(i, derivatives.forces);
  std::copy_n(&derivatives.jacobian[0][0], 12, &jacobian[12 * i]);
}

SolutionArrays::SolutionArrays(const ContactBatch& batch)
    : forces(batch), residual(batch.count()), newton_steps(batch.count()) {}

namespace {

template <class T> auto column(std::vector<T> ForceArrays::*member) {
  return [member](const py::object& self) {
    const auto& forces = self.cast<const ForceArrays&>();
    return view(forces.*member, forces.shape, self);
  };
}
template <class T> auto column(std::vector<T> SolutionArrays::*member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const SolutionArrays&>();
    return view(result.*member, result.forces.shape, self);
  };
}

/// Warnings of two bodies, which follow from the inputs.
py::array warning_codes_of(const ForceArrays& self) {
  enum Column : std::size_t { a = 3, b, shear_modulus, poisson_ratio, normal_force };
  py::array_t<std::uint32_t> out(self.shape);
  std::uint32_t* const codes = out.mutable_data();
  EllipticContact contact;
  SignalCheck signals;
  for (std::size_t i = 0; i < self.status.size(); ++i) {
    if (i % 1024 == 0) signals();
    const auto input = [&](Column column) {
      const std::vector<double>& values = self.inputs[column];
      return values[values.size() == 1 ? 0 : i];
    };
    contact.a = input(a), contact.b = input(b), contact.normal_force = input(normal_force);
    contact.shear_modulus = input(shear_modulus), contact.poisson_ratio = input(poisson_ratio);
    const bool is_valid = static_cast<Status>(self.status[i]) != Status::invalid_input;
    codes[i] = is_valid ? contact_warnings(contact).all.code : 0;
  }
  return out;
}

/// Inputs by name, a number or an array that varies.
py::dict inputs_of(const py::object& self) {
  const auto& forces = self.cast<const ForceArrays&>();
  py::dict out;
  for (std::size_t k = 0; k < forces.inputs.size(); ++k) {
    const auto& values = forces.inputs[k];
    const py::str name{std::string(input_names[k])};
    if (values.size() == 1)
      out[name] = values[0];
    else
      out[name] = view(values, forces.shape, self);
  }
  return out;
}

} // namespace

void bind_contact_batch(py::module_& module) {
  py::class_<ForceArrays> force_arrays(
      module, "ForceArrays",
      "Forces of many contacts: arrays with the shape that the inputs broadcast to; read-only views.");
  force_arrays.def_property_readonly("fx", column(&ForceArrays::fx), "Longitudinal forces on body 1, shape (...) [N].")
      .def_property_readonly("fy", column(&ForceArrays::fy), "Lateral forces on body 1, shape (...) [N].")
      .def_property_readonly("mz", column(&ForceArrays::mz), "Moments about z on body 1, shape (...) [N m].")
      .def_property_readonly("adhesion_area", column(&ForceArrays::adhesion_area),
                             "Areas in adhesion, shape (...) [m^2].")
      .def_property_readonly("slip_area", column(&ForceArrays::slip_area), "Areas in slip, shape (...) [m^2].")
      .def_property_readonly("status", column(&ForceArrays::status),
                             "Codes of Status as uint8, shape (...) [-]; compare with Status.ok.")
      .def_property_readonly(
          "warning_code", &warning_codes_of,
          "Reasons to doubt contacts as uint32, shape (...) [-]: sum of 2^k of the warnings k of warning_texts().")
      .def_property_readonly(
          "inputs", &inputs_of,
          "Inputs as given: creepage_longitudinal [-], creepage_lateral [-], spin [1/m], a [m], b [m],\n"
          "shear_modulus [Pa], poisson_ratio [-], normal_force [N], friction [-] at rest, rolling_speed [m/s],\n"
          "dissimilarity [-]; by name numbers, or arrays of shape (...) of what varies.")
      .def("__len__", [](const ForceArrays& self) { return self.fx.size(); });
  add_value(force_arrays, {"fx", "fy", "mz", "status"});
  add_labelled_arrays(force_arrays);

  py::class_<DerivativeArrays> derivative_arrays(module, "DerivativeArrays",
                                                 "Forces of many contacts and their derivatives.");
  derivative_arrays
      .def_property_readonly(
          "forces", [](const DerivativeArrays& self) -> const ForceArrays& { return self.forces; }, "The forces.")
      .def_property_readonly(
          "jacobian",
          [](const py::object& self) {
            const auto& derivatives = self.cast<const DerivativeArrays&>();
            auto shape = derivatives.forces.shape;
            shape.insert(shape.end(), {3, 4});
            return view(derivatives.jacobian, shape, self);
          },
          "Derivatives of fx [N], fy [N], mz [N m] with respect to longitudinal and lateral creepage [-],\n"
          "spin [1/m] and normal force [N], shape (..., 3, 4); that with respect to the normal force keeps\n"
          "the ellipse as it is.");
  add_value(derivative_arrays, {"forces", "jacobian"});
  add_labelled_arrays(derivative_arrays);

  py::class_<SolutionArrays> exact_arrays(module, "SolutionArrays",
                                          "Forces of many contacts with what the solver reports.");
  exact_arrays
      .def_property_readonly(
          "forces", [](const SolutionArrays& self) -> const ForceArrays& { return self.forces; }, "The forces.")
      .def_property_readonly("residual", column(&SolutionArrays::residual),
                             "Relative residuals at the end of the iteration, shape (...) [-].")
      .def_property_readonly("newton_steps", column(&SolutionArrays::newton_steps),
                             "Steps of Newton's method, shape (...) [-].");
  add_value(exact_arrays, {"forces", "residual", "newton_steps"});
  add_labelled_arrays(exact_arrays);
}

} // namespace microslip::python
