#include "binding/bindings.hpp"

#include "binding/value.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/elasticity/shore_hardness.hpp"

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

void bind_viscoelastic_material(py::module_& module) {
  auto term = py::class_<PronyTerm>(
      module, "PronyTerm", "A term of a Prony series: a share of the modulus at short times relaxes as exp(-t/tau).");
  term.def(init_fields<PronyTerm>(), "share"_a, "time"_a,
           "Made from the share g [-], > 0, and tau [s], > 0; a tuple of both stands for it. The sum of a\n"
           "series' shares is below 1. Values are checked where they are used.")
      .def(py::init([](const std::pair<double, double>& of) {
             return PronyTerm{of.first, of.second};
           }),
           "of"_a, "The same from (g [-], tau [s]).");
  add_fields(term, {"g [-].", "tau [s]."});
  add_value(term);
  py::implicitly_convertible<py::tuple, PronyTerm>();

  auto material = py::class_<ViscoelasticMaterial>(module, "ViscoelasticMaterial",
                                                   "A linearly viscoelastic, isotropic material, or an elastic one.");
  material.def(init_fields<ViscoelasticMaterial>(), "instantaneous"_a, "shear_relaxation"_a = PronySeries(),
               "bulk_relaxation"_a = py::none(),
               "Made from the Material of short times, with G [Pa] and nu [-], and the PronyTerm lists [-, s] of\n"
               "its shear and bulk modulus, of any length. Without one for the bulk modulus that relaxes as the\n"
               "shear modulus does, and Poisson's ratio is constant; with an empty one it is elastic. A Material\n"
               "stands for an elastic one.");
  material.def(py::init([](const Material& elastic) { return ViscoelasticMaterial{elastic}; }), "elastic"_a,
               "An elastic one.");
  add_fields(material, {"The Material at t = 0 of a relaxation.", "List of PronyTerm of the shear modulus.",
                        "The same of the bulk modulus, or None."});
  add_value(material);
  py::implicitly_convertible<Material, ViscoelasticMaterial>();

  module.def("standard_solid", &standard_solid, "instantaneous"_a, "creep"_a,
             "The ViscoelasticMaterial [Pa] of a standard linear solid, from its Material and MaterialCreep.\n"
             "Error for constants out of range.");
}

} // namespace

void bind_layered_bodies(py::module_& module) {
  bind_viscoelastic_material(module);
  auto layer = py::class_<BodyLayer>(module, "BodyLayer", "A layer of constant thickness, bonded to what is below it.");
  layer.def(init_fields<BodyLayer>(), "thickness"_a, "material"_a,
            "Made from the thickness h [m], > 0, and a Material or ViscoelasticMaterial.");
  add_fields(layer, {"h [m].", "Its ViscoelasticMaterial."});
  add_value(layer);

  auto body = py::class_<LayeredBody>(module, "LayeredBody", "A half-space or rigid core below layers.");
  body.def(py::init([](const ViscoelasticMaterial& substrate, const std::vector<BodyLayer>& layers) {
             LayeredBody made{layers, substrate};
             check("LayeredBody", made);
             return made;
           }),
           "substrate"_a, "layers"_a = std::vector<BodyLayer>(),
           "Made from what is below, a Material or ViscoelasticMaterial, of infinite modulus a rigid core, and\n"
           "up to 20 BodyLayer [m] from the surface inwards. Error for values out of range.");
  add_fields(body, {"List of BodyLayer, from the surface inwards.", "The ViscoelasticMaterial below them."});
  body.def_property_readonly("is_elastic", &LayeredBody::is_elastic, "Whether no material of it relaxes.");
  add_value(body);

  auto bodies = py::class_<LayeredBodies>(
      module, "LayeredBodies",
      "Two bodies with layers in contact, in place of half-spaces, for the exact theory on classical elements.");
  bodies
      .def(init_fields<LayeredBodies>(), "body1"_a, "body2"_a, "rolling_velocity"_a = 0.0,
           "Made from two LayeredBody and the velocity V [m/s] of steady rolling, which viscoelastic ones\n"
           "need: positive along +x, negative with direction 'backward'.")
      .def_readonly("body1", &LayeredBodies::body1, "The LayeredBody that forces act on.")
      .def_readonly("body2", &LayeredBodies::body2, "The other LayeredBody.")
      .def_readonly("rolling_velocity", &LayeredBodies::speed, "V [m/s].")
      .def_property_readonly("are_elastic", &LayeredBodies::are_elastic, "Whether no material of them relaxes.");
  add_value(bodies, {"body1", "body2", "rolling_velocity"});

  module.def("young_modulus_of_shore_a", &young_modulus_of_shore_a, "hardness"_a,
             "Young's modulus [Pa] of rubber of a Shore A hardness [-], 20 to 90, by Gent's relation (1958):\n"
             "an estimate, by which others are up to twice as stiff. Error out of that range.");
  module.def("shore_a_of_young_modulus", &shore_a_of_young_modulus, "young_modulus"_a,
             "Shore A hardness [-] of rubber of a Young's modulus [Pa], the inverse of young_modulus_of_shore_a.\n"
             "Error for one whose hardness is not in [20, 90].");
}

} // namespace microslip::python
