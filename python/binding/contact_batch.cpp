#include "binding/contact_batch.hpp"

#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <cstdint>

namespace microslip::python {

namespace py = pybind11;

template <>
inline constexpr auto fields<ForceArrays> = std::tuple{Field{"shape", &ForceArrays::shape},
                                                       Field{"fx", &ForceArrays::fx},
                                                       Field{"fy", &ForceArrays::fy},
                                                       Field{"mz", &ForceArrays::mz},
                                                       Field{"adhesion_area", &ForceArrays::adhesion_area},
                                                       Field{"slip_area", &ForceArrays::slip_area},
                                                       Field{"status", &ForceArrays::status},
                                                       Field{"inputs", &ForceArrays::inputs}};
template <>
inline constexpr auto fields<DerivativeArrays> =
    std::tuple{Field{"forces", &DerivativeArrays::forces}, Field{"jacobian", &DerivativeArrays::jacobian}};
template <>
inline constexpr auto fields<ExactForceArrays> =
    std::tuple{Field{"forces", &ExactForceArrays::forces}, Field{"residual", &ExactForceArrays::residual},
               Field{"newton_steps", &ExactForceArrays::newton_steps}};

ContactBatch::ContactBatch(const EllipticContact& like, const ContactArrays& arrays) : like_(like) {
  const std::pair<const char*, const py::object*> given[] = {{"longitudinal", &arrays.longitudinal},
                                                             {"lateral", &arrays.lateral},
                                                             {"spin", &arrays.spin},
                                                             {"a", &arrays.a},
                                                             {"b", &arrays.b},
                                                             {"shear_modulus", &arrays.shear_modulus},
                                                             {"poisson_ratio", &arrays.poisson_ratio},
                                                             {"normal_force", &arrays.normal_force},
                                                             {"friction", &arrays.friction},
                                                             {"rolling_speed", &arrays.rolling_speed},
                                                             {"dissimilarity", &arrays.dissimilarity}};
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (given[k].second->is_none()) continue;
    columns_[k] = real_array(given[k].first, *given[k].second);
    broadcast(shape_, given[k].first, columns_[k]);
  }
  for (const auto extent : shape_) count_ *= static_cast<std::size_t>(extent);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (given[k].second->is_none()) continue;
    constant_[k] = columns_[k].size() == 1;
    if (!constant_[k]) columns_[k] = spread(columns_[k], shape_);
    values_[k] = columns_[k].data();
  }
  if (values_[8] != nullptr)
    for (const double mu : span_of(columns_[8]))
      require_between("friction", mu, "-", 0, FrictionLaw::largest_coefficient);
}

EllipticContact ContactBatch::operator[](std::size_t i) const {
  EllipticContact contact = like_;
  double* const fields[] = {
      &contact.creepage.longitudinal, &contact.creepage.lateral, &contact.creepage.spin, &contact.a, &contact.b,
      &contact.shear_modulus,         &contact.poisson_ratio,    &contact.normal_force};
  for (std::size_t k = 0; k < std::size(fields); ++k)
    if (values_[k] != nullptr) *fields[k] = values_[k][constant_[k] ? 0 : i];
  if (values_[8] != nullptr) contact.friction = FrictionLaw::coulomb(values_[8][constant_[8] ? 0 : i]);
  if (values_[9] != nullptr) contact.rolling_speed = values_[9][constant_[9] ? 0 : i];
  if (values_[10] != nullptr) contact.dissimilarity = values_[10][constant_[10] ? 0 : i];
  return contact;
}

std::vector<std::vector<double>> ContactBatch::inputs() const {
  const double common[] = {like_.creepage.longitudinal,
                           like_.creepage.lateral,
                           like_.creepage.spin,
                           like_.a,
                           like_.b,
                           like_.shear_modulus,
                           like_.poisson_ratio,
                           like_.normal_force,
                           like_.friction.static_coefficient(),
                           like_.rolling_speed,
                           like_.dissimilarity};
  std::vector<std::vector<double>> out;
  for (std::size_t k = 0; k < columns_.size(); ++k)
    if (values_[k] == nullptr)
      out.push_back({common[k]});
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

ExactForceArrays::ExactForceArrays(const ContactBatch& batch)
    : forces(batch), residual(batch.count()), newton_steps(batch.count()) {}

namespace {

template <class T> auto column(std::vector<T> ForceArrays::*member) {
  return [member](const py::object& self) {
    const auto& forces = self.cast<const ForceArrays&>();
    return view(forces.*member, forces.shape, self);
  };
}

/// Those of two bodies, which follow from the inputs.
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

/// By name, a number or an array that varies.
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
          "What makes contacts doubtful as uint32, shape (...) [-]: sum of 2^k of the warnings k of warning_texts().")
      .def_property_readonly(
          "inputs", &inputs_of,
          "What was given: creepage_longitudinal [-], creepage_lateral [-], spin [1/m], a [m], b [m],\n"
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

  py::class_<ExactForceArrays> exact_arrays(module, "ExactForceArrays", "Forces of many contacts by the exact theory.");
  exact_arrays
      .def_property_readonly(
          "forces", [](const ExactForceArrays& self) -> const ForceArrays& { return self.forces; }, "The forces.")
      .def_property_readonly(
          "residual",
          [](const py::object& self) {
            const auto& result = self.cast<const ExactForceArrays&>();
            return view(result.residual, result.forces.shape, self);
          },
          "Relative residuals at the end of the iteration, shape (...) [-].")
      .def_property_readonly(
          "newton_steps",
          [](const py::object& self) {
            const auto& result = self.cast<const ExactForceArrays&>();
            return view(result.newton_steps, result.forces.shape, self);
          },
          "Steps of Newton's method, shape (...) [-].");
  add_value(exact_arrays, {"forces", "residual", "newton_steps"});
  add_labelled_arrays(exact_arrays);
}

} // namespace microslip::python
