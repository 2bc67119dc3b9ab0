#include "binding/bindings.hpp"

#include "binding/value.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/viscoelastic.hpp"

#include <limits>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

void bind_materials(py::module_& module) {
  auto material = py::class_<Material>(module, "Material", "A linearly elastic, isotropic body.");
  material
      .def(init_fields<Material>(), "shear_modulus"_a, "poisson_ratio"_a,
           "Made from the shear modulus G [Pa], > 0, infinite for a rigid body, and Poisson's ratio [-],\n"
           "in [0, 0.5]. Values are checked where they are used.")
      .def_static("from_young", &Material::from_young, "young_modulus"_a, "poisson_ratio"_a,
                  "Made from Young's modulus E [Pa], > 0, infinite for a rigid body: G = E/(2 (1 + nu)). Poisson's\n"
                  "ratio [-] in [0, 0.5]. Error if out of range.");
  add_fields(material, {"Shear modulus G [Pa].", "Poisson's ratio nu [-]."});
  add_value(material);

  auto combined = py::class_<CombinedMaterial>(
      module, "CombinedMaterial",
      "The constants of two bodies in contact, as half-space theory needs them; combine() makes them.");
  combined
      .def(init_fields<CombinedMaterial>(), "shear_modulus"_a, "poisson_ratio"_a, "dissimilarity"_a = 0.0,
           "Made from combined constants: G [Pa], nu [-], K [-].")
      .def_readonly("shear_modulus", &CombinedMaterial::shear_modulus, "Combined shear modulus G [Pa].")
      .def_readonly("poisson_ratio", &CombinedMaterial::poisson_ratio, "Combined Poisson's ratio nu [-].")
      .def_readonly("dissimilarity", &CombinedMaterial::dissimilarity, "K [-]; 0 for elastically similar bodies.")
      .def_property_readonly("contact_modulus", &CombinedMaterial::contact_modulus, "E* = G/(1 - nu) [Pa].");
  add_value(combined, {"shear_modulus", "poisson_ratio", "dissimilarity"});

  module.def("combine", static_cast<CombinedMaterial (*)(const Material&, const Material&)>(&microslip::combine),
             "body1"_a, "body2"_a,
             "Combines two bodies: 1/G = (1/G1 + 1/G2)/2 [1/Pa], nu/G = (nu1/G1 + nu2/G2)/2 [1/Pa], K/G =\n"
             "((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4 [1/Pa] (Kalker 1990, section 1.6). Error if a modulus or\n"
             "Poisson's ratio is out of range or both bodies are rigid.");
}

void bind_hertz(py::module_& module) {
  auto gap = py::class_<GapCurvatures>(
      module, "GapCurvatures", "Shape of the gap between two bodies in first contact: h(x, y) = A x^2 + B y^2.");
  gap.def(init_fields<GapCurvatures>(), "x"_a, "y"_a, "From A and B [1/m].");
  add_fields(gap, {"A [1/m], along the rolling direction.", "B [1/m], lateral."});
  add_value(gap);

  module.def(
      "gap_curvatures",
      [](double rolling1, double rolling2, double transverse1, double transverse2) {
        return gap_curvatures({rolling1, rolling2, transverse1, transverse2});
      },
      "rolling1"_a, "rolling2"_a, "transverse1"_a, "transverse2"_a,
      "A = (1/rolling1 + 1/rolling2)/2, B = (1/transverse1 + 1/transverse2)/2 [1/m] from the radii [m]\n"
      "of bodies 1 and 2 in the plane of rolling and in the lateral plane: positive convex, negative\n"
      "concave, math.inf flat. Error for a radius that is zero or not a number, and unless A and B are\n"
      "positive.");

  auto hertz = py::class_<HertzContact>(module, "HertzContact",
                                        "A Hertzian contact: what follows from shape, material and load.");
  add_fields(hertz, {"Semi-axis along x, the rolling direction [m].", "Semi-axis along y [m].", "Fn [N].",
                     "Relative approach of distant points delta [m].", "p0 = 3 Fn/(2 pi a b) [Pa].",
                     "dFn/d(approach) = 3 Fn/(2 delta) [N/m].", "Curvatures of the gap [1/m]."});
  hertz.def(
      "pressure",
      [](const HertzContact& self, const py::object& x, const py::object& y) {
        return mapped("x", x, "y", y, [&](double at_x, double at_y) { return self.pressure(at_x, at_y); });
      },
      "x"_a, "y"_a,
      "p_n(x, y) = p0 sqrt(1 - (x/a)^2 - (y/b)^2), 0 outside the ellipse [Pa]; x, y [m] are numbers or\n"
      "arrays that broadcast, shape (...).");
  hertz.def("_repr_html_", [](const HertzContact& self) {
    return html_table("Hertzian contact", {{"a", self.a, "m", "semi-axis along x, the rolling direction"},
                                           {"b", self.b, "m", "semi-axis along y"},
                                           {"Fn", self.normal_force, "N", "normal force"},
                                           {"delta", self.approach, "m", "approach of distant points"},
                                           {"p0", self.peak_pressure, "Pa", "peak pressure"},
                                           {"dFn/ddelta", self.stiffness, "N/m", "stiffness"},
                                           {"A", self.gap.x, "1/m", "curvature of the gap A x^2 + B y^2"},
                                           {"B", self.gap.y, "1/m", "curvature of the gap A x^2 + B y^2"}});
  });
  add_value(hertz);

  module.def("hertz_from_load", &hertz_from_load, "gap"_a, "material"_a, "normal_force"_a,
             "Ellipse, approach and pressure from curvatures [1/m] and load [N] (Johnson 1985, section 4.2).\n"
             "Relative error below 1e-12 for a/b from 1e-4 to 1e4. Error for load or material out of range and\n"
             "for A/B outside [1e-9, 1e9].");
  module.def("hertz_from_approach", &hertz_from_approach, "gap"_a, "material"_a, "approach"_a,
             "Contact from the approach [m] instead of the load.");
  module.def(
      "hertz_from_ellipse", &hertz_from_ellipse, "a"_a, "b"_a, "material"_a, "normal_force"_a,
      "Contact from the semi-axes [m] and the load [N]: finds the curvatures. Error for a/b outside [1e-5, 1e5].");
}

void bind_bodies(py::module_& module) {
  auto creep = py::class_<MaterialCreep>(
      module, "MaterialCreep",
      "Constants of a Material as a standard linear solid: under a constant stress its elastic deformation grows by "
      "the share f (1 - exp(-t/tau)).");
  creep.def(init_fields<MaterialCreep>(), "ratio"_a, "time"_a,
            "Made from f [-] >= 0, 0 for an elastic body, and tau [s] >= 0.");
  add_fields(creep, {"f [-].", "tau [s]."});
  add_value(creep);

  auto layer = py::class_<InterfaceLayer>(
      module, "InterfaceLayer",
      "A thin layer between two bodies, rigid in the normal direction: tractions p shear it by p h/G;\n"
      "beyond the yield stress tau_c0 + k u_pl, with the plastic deformation u_pl, it deforms\n"
      "plastically.");
  layer.def(init_fields<InterfaceLayer>([](const InterfaceLayer& made) { check(made); }), "flexibility"_a,
            "yield_stress"_a = std::numeric_limits<double>::infinity(), "hardening"_a = 0.0,
            "Made from h/G [m/Pa] >= 0, tau_c0 [Pa] > 0, infinite: it stays elastic, and k [Pa/m], negative: it\n"
            "gets softer. Error for numbers out of range.");
  add_fields(layer, {"h/G [m/Pa].", "tau_c0 [Pa].", "k [Pa/m]."});
  add_value(layer);

  auto bodies = py::class_<Bodies>(module, "Bodies",
                                   "Two bodies in contact, as the exact theory needs them: elastic ones, or those that "
                                   "viscoelastic() makes.");
  bodies
      .def(py::init([](const CombinedMaterial& material, const std::optional<InterfaceLayer>& between) {
             Bodies made(material);
             if (between) made.layer = *between;
             return made;
           }),
           "material"_a, "layer"_a = py::none(),
           "Elastic bodies from their CombinedMaterial, with an InterfaceLayer between them or none [-].")
      .def_readonly("material", &Bodies::material, "Of the instantaneous deformation, as CombinedMaterial.")
      .def_readonly("layer", &Bodies::layer, "The InterfaceLayer; its flexibility is 0 without one.")
      .def_property_readonly("are_elastic", &Bodies::are_elastic, "Whether no part of the deformation is retarded.");
  add_value(bodies, {"material", "layer", "are_elastic"});
  py::implicitly_convertible<CombinedMaterial, Bodies>();

  module.def(
      "viscoelastic",
      [](const Material& body1, const MaterialCreep& creep1, const Material& body2, const MaterialCreep& creep2,
         double rolling_velocity, const std::optional<InterfaceLayer>& between) {
        Bodies made = viscoelastic(body1, creep1, body2, creep2, rolling_velocity);
        if (between) made.layer = *between;
        return made;
      },
      "body1"_a, "creep1"_a, "body2"_a, "creep2"_a, "rolling_velocity"_a, "layer"_a = py::none(),
      "Two standard linear solids that roll steadily, as Bodies: their Material of instantaneous\n"
      "deformation and MaterialCreep, the velocity V [m/s], positive along +x, negative with direction\n"
      "'backward', and an InterfaceLayer between them or none. Error for constants out of range.");
}

void bind_line_contact(py::module_& module) {
  auto line = py::class_<LineContact>(module, "LineContact", "Two cylinders with parallel axes, per unit length.");
  add_fields(line, {"a [m], along the rolling direction.", "fn [N/m].", "p0 = 2 fn/(pi a) [Pa].",
                    "A = 1/(2R) of the gap h = A x^2 [1/m]."});
  line.def(
      "pressure",
      [](const LineContact& self, const py::object& x) {
        return mapped("x", x, "x", py::float_(0.0), [&](double at, double) { return self.pressure(at); });
      },
      "x"_a, "p_n(x) = p0 sqrt(1 - (x/a)^2), 0 outside [Pa]; x [m] is a number or an array, shape (...).");
  add_value(line);

  module.def(
      "line_contact_from_load", &line_contact_from_load, "curvature"_a, "material"_a, "force_per_length"_a,
      "a = sqrt(4 R fn/(pi E*)), R = 1/(2A), from the curvature A [1/m] and fn [N/m] (Johnson 1985, section 4.2c).");
  module.def("line_contact_from_half_width", &line_contact_from_half_width, "curvature"_a, "material"_a, "half_width"_a,
             "Line contact from the half-width a [m].");
}

} // namespace

void bind_elasticity(py::module_& module) {
  bind_materials(module);
  bind_bodies(module);
  bind_hertz(module);
  bind_line_contact(module);
}

} // namespace microslip::python
