#include "binding/contact.hpp"

#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact_batch.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "microslip/rolling/contact_warnings.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;

FrictionLaw friction_from(const py::object& friction) {
  if (py::isinstance<FrictionLaw>(friction)) return friction.cast<FrictionLaw>();
  try {
    return FrictionLaw::coulomb(friction.cast<double>());
  } catch (const py::cast_error&) {
    throw py::type_error("friction: must be a FrictionLaw or a coefficient, not " +
                         py::repr(friction).cast<std::string>());
  }
}

double coulomb_coefficient_from(const py::object& friction) {
  const FrictionLaw law = friction_from(friction);
  if (law.kind() != FrictionLaw::Kind::coulomb) throw Error("friction: must be a coefficient or Coulomb's law here");
  return law.kinetic_coefficient();
}

Creepage creepage_from(const py::object& creepage) {
  if (py::isinstance<Creepage>(creepage)) return creepage.cast<Creepage>();
  try {
    const auto [xi, eta, phi] = creepage.cast<std::tuple<double, double, double>>();
    return {xi, eta, phi};
  } catch (const py::cast_error&) {
    throw py::type_error("creepage: must be a Creepage or three numbers, not " +
                         py::repr(creepage).cast<std::string>());
  }
}

namespace {

void bind_creepage(py::module_& module) {
  auto creepage = py::class_<Creepage>(
      module, "Creepage",
      "Rigid relative motion of the bodies per metre rolled: relative rigid slip w = (xi - phi y, eta + phi x).");
  creepage
      .def(init_fields<Creepage>(), "longitudinal"_a = 0.0, "lateral"_a = 0.0, "spin"_a = 0.0,
           "Made from xi [-], eta [-] and phi [1/m].")
      .def_readwrite("longitudinal", &Creepage::longitudinal, "xi [-]; of a braked wheel positive. For a shift [m].")
      .def_readwrite("lateral", &Creepage::lateral, "eta [-]. For a shift [m].")
      .def_readwrite("spin", &Creepage::spin, "phi [1/m]. For a shift [rad].")
      .def("__iter__",
           [](const Creepage& self) { return py::iter(py::make_tuple(self.longitudinal, self.lateral, self.spin)); });
  add_value(creepage, {"longitudinal", "lateral", "spin"});

  auto coefficients = py::class_<CreepageCoefficients>(
      module, "CreepageCoefficients",
      "Kalker's creepage coefficients: for vanishing creepages, with c = sqrt(a b), Fx = -G c^2 C11 xi,\n"
      "Fy = -G c^2 (C22 eta + c C23 phi), Mz = -G c^3 (C32 eta + c C33 phi), C32 = -C23.");
  add_fields(coefficients, {"C11 [-].", "C22 [-].", "C23 [-].", "C33 [-]."});
  add_value(coefficients);
  module.def("creepage_coefficients", &creepage_coefficients, "a_over_b"_a, "poisson_ratio"_a,
             "coefficients"_a = CreepageTable::kalker,
             "The coefficients [-] for a/b [-] and Poisson's ratio [-] in [0, 0.5], from the table 'kalker'\n"
             "(Kalker 1990, table E.3) or 'computed' (accurate to 1e-4 from a/b = 0.05 to 20). Beyond a table\n"
             "they tend to the limits of slender ellipses.");
}

EllipticContact make_contact(double a, double b, double shear_modulus, double poisson_ratio, double normal_force,
                             const py::object& friction, const py::object& creepage,
                             std::optional<double> rolling_speed, double dissimilarity) {
  const FrictionLaw law = friction_from(friction);
  if (!rolling_speed && law.kind() != FrictionLaw::Kind::coulomb)
    throw Error("rolling_speed: must be given for friction that depends on the slip velocity");
  return {.a = a,
          .b = b,
          .shear_modulus = shear_modulus,
          .poisson_ratio = poisson_ratio,
          .normal_force = normal_force,
          .friction = law,
          .creepage = creepage_from(creepage),
          .rolling_speed = rolling_speed.value_or(1),
          .dissimilarity = dissimilarity};
}

EllipticContact contact_from_hertz(const HertzContact& hertz, const CombinedMaterial& material,
                                   const py::object& friction, const py::object& creepage,
                                   std::optional<double> rolling_speed) {
  return make_contact(hertz.a, hertz.b, material.shear_modulus, material.poisson_ratio, hertz.normal_force, friction,
                      creepage, rolling_speed, material.dissimilarity);
}

void bind_elliptic_contact(py::module_& module) {
  auto contact = py::class_<EllipticContact>(
      module, "EllipticContact",
      "A Hertzian ellipse with material, load, friction and creepages: what the solvers of either\n"
      "theory take. Fields may be changed between calls; solvers check them, and what is out of range\n"
      "gives Status.invalid_input and NaN.");
  contact
      .def(py::init(&make_contact), "a"_a, "b"_a, "shear_modulus"_a, "poisson_ratio"_a, "normal_force"_a, "friction"_a,
           "creepage"_a = Creepage{}, "rolling_speed"_a = py::none(), "dissimilarity"_a = 0.0,
           "Made from the semi-axes a along x and b along y [m], the combined shear modulus [Pa] and Poisson's\n"
           "ratio [-], the normal force [N], a friction coefficient [-] or FrictionLaw, a Creepage or\n"
           "(xi [-], eta [-], phi [1/m]), the speed V [m/s] and the combined K [-] of dissimilar bodies. Without a\n"
           "speed it is 1 m/s; Error if friction depends on it.")
      .def_static("from_hertz", &contact_from_hertz, "hertz"_a, "material"_a, "friction"_a, "creepage"_a = Creepage{},
                  "rolling_speed"_a = py::none(),
                  "From a HertzContact and the CombinedMaterial of its bodies, with G, nu and K [-]; the others as "
                  "above.")
      .def(
          "check", [](const EllipticContact& self) { check(self); },
          "Raises Error, which names field, value and range, if a field is out of range: solvers answer such a\n"
          "contact with Status.invalid_input and NaN.")
      .def(
          "check_simplified", [](const EllipticContact& self) { check_simplified(self); },
          "Checks for the simplified theory, in which dissimilarity must be 0.")
      .def_property_readonly(
          "warnings",
          [](const EllipticContact& self) {
            return is_valid(self) ? contact_warnings(self).texts : std::vector<std::string>();
          },
          "Reasons to doubt the contact, as texts with its numbers: the peak pressure beside Young's modulus, a\n"
          "modulus that may be in MPa; empty where check() raises.")
      .def_readwrite("a", &EllipticContact::a, "Semi-axis along the rolling direction [m], > 0.")
      .def_readwrite("b", &EllipticContact::b, "Lateral semi-axis [m], > 0.")
      .def_readwrite("shear_modulus", &EllipticContact::shear_modulus, "Combined G [Pa], > 0.")
      .def_readwrite("poisson_ratio", &EllipticContact::poisson_ratio, "Combined nu [-], in [0, 0.5].")
      .def_readwrite("normal_force", &EllipticContact::normal_force, "Fn [N], > 0.")
      .def_property(
          "friction", [](EllipticContact& self) -> FrictionLaw& { return self.friction; },
          [](EllipticContact& self, const py::object& value) { self.friction = friction_from(value); },
          "The friction law, mu [-] of the slip velocity [m/s]; a number is taken for Coulomb's.")
      .def_property(
          "creepage", [](EllipticContact& self) -> Creepage& { return self.creepage; },
          [](EllipticContact& self, const py::object& value) { self.creepage = creepage_from(value); },
          "Creepages [-], [-] and spin [1/m]; three numbers may be assigned.")
      .def_readwrite("rolling_speed", &EllipticContact::rolling_speed,
                     "V [m/s], > 0; matters for falling friction and for the frictional power.")
      .def_readwrite("dissimilarity", &EllipticContact::dissimilarity,
                     "Combined K [-], in [-0.5, 0.5], which couples pressure and tractions of dissimilar bodies; the\n"
                     "simplified theory refuses it.");
  add_value(contact, {"a", "b", "shear_modulus", "poisson_ratio", "normal_force", "friction", "creepage",
                      "rolling_speed", "dissimilarity"});
}

void bind_forces(py::module_& module) {
  auto forces = py::class_<ContactForces>(
      module, "ContactForces", "Totals, acting on body 1, the wheel. Positive creepage gives negative force.");
  add_fields(forces, {"Longitudinal force on body 1 [N].", "Lateral force on body 1 [N].",
                      "Moment about z on body 1, integral of x py - y px [N m].", "Area in adhesion [m^2].",
                      "Area in slip [m^2].", "How the calculation ended, a Status [-]."});
  add_value(forces);

  auto derivatives = py::class_<ContactDerivatives>(module, "ContactDerivatives", "Totals and their derivatives.");
  derivatives.def_readonly("forces", &ContactDerivatives::forces, "The totals, as ContactForces.")
      .def_property_readonly(
          "jacobian",
          [](const py::object& self) {
            return view(&self.cast<const ContactDerivatives&>().jacobian[0][0], {3, 4}, self);
          },
          "Derivatives of fx [N], fy [N], mz [N m] with respect to xi [-], eta [-], phi [1/m] and Fn [N],\n"
          "shape (3, 4); that with respect to Fn keeps the ellipse as it is.");
  add_value(derivatives, {"forces", "jacobian"});
}

} // namespace

void bind_contact(py::module_& module) {
  bind_codes(module);
  bind_creepage(module);
  bind_elliptic_contact(module);
  bind_forces(module);
  bind_contact_batch(module);
}

} // namespace microslip::python
