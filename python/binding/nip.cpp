#include "binding/nip.hpp"

#include "binding/bindings.hpp"
#include "binding/long_work.hpp"
#include "binding/value.hpp"

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::tuple place(const InteriorPoint& point) {
  return py::make_tuple(point.x, point.y, point.depth);
}

int number_of(Body body) {
  return body == Body::first ? 1 : 2;
}

void bind_rollers(py::module_& module) {
  auto roller = py::class_<RollerState>(module, "RollerState", "What a nip asks of one roller.");
  add_fields(roller, {"Power that pressure takes from it [W].",
                      "Torque over the radius that its drive must supply [N]; negative: it is driven.",
                      "Largest displacement inwards [m].", "Thickness of its cover [m].",
                      "Indentation over the cover's thickness [-], 0 without a cover."});
  add_value(roller);
  auto nip = py::class_<Nip>(module, "Nip", "Results of steady rolling as users of rollers name them.");
  nip.def_readonly("width", &Nip::width, "Length of the contact along x [m].")
      .def_readonly("peak_pressure", &Nip::peak_pressure, "[Pa].")
      .def_readonly("indentation", &Nip::indentation, "Approach of both rollers [m].")
      .def_readonly("traction", &Nip::traction, "Tangential force [N].")
      .def_readonly("traction_capacity", &Nip::traction_capacity, "mu Fn [N].")
      .def_readonly("utilisation", &Nip::utilisation, "Traction over its capacity [-].")
      .def_readonly("hysteresis_power", &Nip::hysteresis_power, "Power lost inside the rollers [W].")
      .def_readonly("slip_power", &Nip::slip_power, "Power lost in slip [W].")
      .def_readonly("rolling_resistance", &Nip::rolling_resistance, "Hysteresis over the speed [N].")
      .def_readonly("body1", &Nip::body1, "RollerState of body 1.")
      .def_readonly("body2", &Nip::body2, "RollerState of body 2.")
      .def_property_readonly(
          "warnings", [](const Nip& self) { return self.warnings.texts; },
          "Texts: strains beyond small ones, a cover or nip beside the radii.");
  add_value(nip, {"width", "indentation", "traction", "traction_capacity", "hysteresis_power", "slip_power"});
  auto free = py::class_<FreeRoller>(module, "FreeRoller", "Steady rolling in which one roller has no torque.");
  add_fields(free, {"Its surface speed over that of the other one [-]; above 1 it is overdriven.",
                    "Longitudinal creepage [-].", "Longitudinal force on body 1 [N].", "The ContactSolution."});
  add_value(free, {"speed_ratio", "creepage", "fx"});

  module.def(
      "nip_of",
      [](const RollingProblem& problem, const ContactSolution& solution, double radius1, double radius2) {
        return long_work([&](const Progress& progress) {
          return nip_of(problem, solution, {radius1, radius2}, progress);
        });
      },
      "problem"_a, "solution"_a, "radius1"_a, "radius2"_a,
      "The Nip of a solved RollingProblem of LayeredBodies, from its ContactSolution in steady rolling and\n"
      "the rollers' radii [m], positive convex, infinite flat. Error for others and without contact.");
}

void bind_peaks(py::module_& module) {
  py::class_<LayerPeak> layer(module, "LayerPeak", "The largest von Mises stress in a layer or what is below all.");
  layer
      .def_property_readonly(
          "body", [](const LayerPeak& self) { return number_of(self.body); }, "1 or 2 [-].")
      .def_readonly("layer", &LayerPeak::layer,
                    "From the surface inwards, from 0 [-]; the number of layers: below all.")
      .def_readonly("von_mises", &LayerPeak::von_mises, "[Pa].")
      .def_property_readonly(
          "place", [](const LayerPeak& self) { return place(self.place); }, "x, y and depth [m].");
  add_value(layer, {"body", "layer", "von_mises", "place"});
  py::class_<InterfacePeak> bond(module, "InterfacePeak", "The largest stresses between a layer and what is below.");
  bond.def_property_readonly(
          "body", [](const InterfacePeak& self) { return number_of(self.body); }, "1 or 2 [-].")
      .def_readonly("layer", &InterfacePeak::layer, "The one above, from 0 [-].")
      .def_readonly("shear", &InterfacePeak::shear, "[Pa].")
      .def_property_readonly(
          "shear_place", [](const InterfacePeak& self) { return place(self.shear_place); }, "x, y and depth [m].")
      .def_readonly("tension", &InterfacePeak::tension, "[Pa]; 0 if they are pressed together all over.")
      .def_property_readonly(
          "tension_place", [](const InterfacePeak& self) { return place(self.tension_place); },
          "x, y and depth [m], of tension above 0.");
  add_value(bond, {"body", "layer", "shear", "tension"});
  auto peaks = py::class_<LayeredPeaks>(module, "LayeredPeaks", "What loads layers and the bonds between them.");
  add_fields(peaks, {"List of LayerPeak.", "List of InterfacePeak."});
  add_value(peaks);
  module.def(
      "layered_peaks",
      [](const LayeredBodies& bodies, const ContactSolution& solution) {
        return long_work([&](const Progress& progress) { return layered_peaks(bodies, solution, progress); });
      },
      "bodies"_a, "solution"_a,
      "The LayeredPeaks [Pa] of LayeredBodies and a ContactSolution of them, to some 0.2 %. Error for a\n"
      "solution without pressures. Ctrl-C ends it.");
}

} // namespace

void bind_nip(py::module_& module) {
  bind_rollers(module);
  bind_peaks(module);
}

} // namespace microslip::python
