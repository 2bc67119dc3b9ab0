#include "binding/bindings.hpp"

#include "binding/value.hpp"
#include "binding/words.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <pybind11/functional.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Term = std::pair<double, double>;

FrictionTerm term(const Term& given) {
  return {given.first, given.second};
}

/// Binds every kind that falls with the slip velocity.
void bind_falling_laws(py::class_<FrictionLaw>& law) {
  constexpr int begin = FrictionLaw::first_falling, end = begin + FrictionLaw::falling;
  for (int k = begin; k < end; ++k)
    law.def_static(
        std::string(FrictionLaw::names[static_cast<std::size_t>(k)]).c_str(),
        [kind = static_cast<FrictionLaw::Kind>(k)](double kinetic, const Term& first, const Term& second) {
          return FrictionLaw::make(kind, kinetic, term(first), term(second));
        },
        "kinetic"_a, "first"_a, "second"_a = Term{0, 1},
        "Made from the kinetic coefficient [-] and one or two terms (drop [-], half_velocity [m/s]).");
}

std::vector<double> list_of(const char* field, const py::object& numbers) {
  const RealArray array = real_array(field, numbers);
  return {array.data(), array.data() + array.size()};
}

/// Binds tables, given or sampled.
void bind_tables(py::class_<FrictionLaw>& law) {
  law.def_static(
         "table",
         [](const py::object& velocities, const py::object& coefficients, const py::object& pressures,
            const py::object& temperatures) {
           FrictionGrid grid{.slip_velocities = list_of("slip_velocities", velocities)};
           Shape shape = {static_cast<py::ssize_t>(grid.slip_velocities.size())};
           const auto add_axis = [&](const char* field, const py::object& given, std::vector<double>& axis) {
             if (given.is_none()) return;
             axis = list_of(field, given);
             shape.insert(shape.begin(), static_cast<py::ssize_t>(axis.size()));
           };
           add_axis("pressures", pressures, grid.pressures);
           add_axis("temperatures", temperatures, grid.temperatures);
           const RealArray mu = real_array("coefficients", coefficients, shape);
           grid.coefficients.assign(mu.data(), mu.data() + mu.size());
           return FrictionLaw::table(FrictionTable(std::move(grid)));
         },
         "slip_velocities"_a, "coefficients"_a, "pressures"_a = py::none(), "temperatures"_a = py::none(),
         "Coefficients [-] at slip velocities [m/s], at least two, ascending from 0 or more on; between them by\n"
         "monotone cubics (scipy's PchipInterpolator), beyond them constant. With pressures [Pa] or temperatures [deg "
         "C] of\n"
         "the surfaces, between which mu is linear, coefficients have the shape (temperatures, pressures, velocities)\n"
         "without the axes that are left out; such laws need the exact theory.")
      .def_static(
          "sampled",
          [](const std::function<double(double)>& coefficient, double fastest, double accuracy) {
            return FrictionLaw::table(FrictionTable::sampled(coefficient, fastest, accuracy));
          },
          "coefficient"_a, "fastest"_a, "accuracy"_a = 1e-6,
          "A table of any mu(v) [-], a function of the slip velocity [m/s] that is called here and never again, so\n"
          "that threads and pickles do with the law as with any other. Samples from 0 to `fastest` [m/s], beyond\n"
          "which mu is constant, lie so close that the table is within `accuracy` [-] of the function. Its\n"
          "exceptions are passed on. Error for coefficients out of range and where the function jumps.");
}

/// A table's numbers, None of another law.
py::object numbers_of(const FrictionLaw& law, std::vector<double> FrictionGrid::*numbers) {
  return law.table() == nullptr ? py::none() : py::object(py::cast(law.table()->grid().*numbers));
}

double coefficient_at(const FrictionLaw& law, double velocity) {
  if (!(velocity >= 0)) throw Error("slip_velocity", velocity, "m/s", "at least 0");
  return law.coefficient(velocity);
}

} // namespace

void bind_friction(py::module_& module) {
  std::string text = "The friction coefficient mu as a function of the slip velocity v [m/s]:\n";
  for (std::size_t k = 0; k < FrictionLaw::names.size(); ++k)
    text.append(FrictionLaw::names[k]).append(": ").append(FrictionLaw::formulas[k]).append(";\n");
  text += "polach: mu_s ((1 - A) exp(-B v) + A). A term is a pair (drop d [-], half_velocity v_i [m/s]).\n"
          "Makers raise Error for a coefficient outside [0, 10] or a velocity that is not positive.\n"
          "FrictionLaw() is frictionless.";
  auto law = py::class_<FrictionLaw>(module, "FrictionLaw", text.c_str());
  law.def(py::init<>(), "Frictionless, mu = 0 [-].")
      .def_static("coulomb", &FrictionLaw::coulomb, "coefficient"_a, "Coulomb friction, coefficient [-] in [0, 10].");
  bind_falling_laws(law);
  bind_tables(law);
  law.def_static("polach", &FrictionLaw::polach, "static_coefficient"_a, "ratio"_a, "decay"_a,
                 "Polach's law from mu_s [-], A [-] in [0, 1] and B [s/m] > 0. Kept as an exponential law.")
      .def_property_readonly(
          "kind", [](const FrictionLaw& self) { return FrictionLaw::names[static_cast<std::size_t>(self.kind())]; },
          "The name of its maker; Polach's law is an exponential one.")
      .def_property_readonly("kinetic_coefficient", &FrictionLaw::kinetic_coefficient, "mu_k [-].")
      .def_property_readonly("static_coefficient", &FrictionLaw::static_coefficient, "mu(0) [-].")
      .def_property_readonly(
          "peak_coefficient", [](const FrictionLaw& self) { return self.peak_coefficient(); },
          "The largest mu(v) [-]: mu(0), unless a table rises.")
      .def_property_readonly(
          "terms",
          [](const FrictionLaw& self) {
            const auto& [first, second] = self.terms();
            return std::pair(Term{first.drop, first.half_velocity}, Term{second.drop, second.half_velocity});
          },
          "Both terms as (drop [-], half_velocity [m/s]).")
      .def_property_readonly(
          "slip_velocities", [](const FrictionLaw& self) { return numbers_of(self, &FrictionGrid::slip_velocities); },
          "Those of a table [m/s], else None.")
      .def_property_readonly(
          "coefficients", [](const FrictionLaw& self) { return numbers_of(self, &FrictionGrid::coefficients); },
          "Those of a table [-], else None: of all velocities at the first pressure and temperature, then at the next\n"
          "pressure, and so on.")
      .def_property_readonly(
          "pressures", [](const FrictionLaw& self) { return numbers_of(self, &FrictionGrid::pressures); },
          "Those of a table [Pa], else None.")
      .def_property_readonly(
          "temperatures", [](const FrictionLaw& self) { return numbers_of(self, &FrictionGrid::temperatures); },
          "Those of a table [deg C], else None.")
      .def(
          "coefficient",
          [](const FrictionLaw& self, const py::object& velocity) {
            return mapped("slip_velocity", velocity, "slip_velocity", py::float_(0.0),
                          [&](double v, double) { return coefficient_at(self, v); });
          },
          "slip_velocity"_a, "mu(v) [-] for v >= 0 [m/s], a number or an array, shape (...).");
  add_value(law, {"kind", "kinetic_coefficient", "static_coefficient", "terms"});

  auto effect = py::class_<TemperatureEffect>(module, "TemperatureEffect",
                                              "Change of a friction coefficient with the surfaces' temperature T: "
                                              "change min(1, max(0, (T - begin)/range)).");
  effect.def(init_fields<TemperatureEffect>([](const TemperatureEffect& made) { check(made); }), "change"_a, "begin"_a,
             "range"_a,
             "Made from the whole change [-], the temperature [deg C] up to which there is none, and the range [K]\n"
             "> 0 over which it grows. Error for numbers out of range.");
  add_fields(effect,
             {"The whole change [-].", "Up to this temperature there is none [deg C].", "Over which it grows [K]."});
  add_value(effect);

  auto thermal = py::class_<ThermalBody>(module, "ThermalBody", "What a body is for heat.");
  thermal.def(init_fields<ThermalBody>([](const ThermalBody& made) {
                check(ThermalBodies{made, made});
              }),
              "bulk_temperature"_a, "conductivity"_a, "density"_a, "heat_capacity"_a,
              "Made from the temperature [deg C] with which it enters the contact, lambda [W/(m K)], rho [kg/m^3]\n"
              "and c [J/(kg K)], all three > 0. Error for numbers out of range.");
  add_fields(thermal, {"Where it enters the contact [deg C].", "lambda [W/(m K)].", "rho [kg/m^3].", "c [J/(kg K)]."});
  add_value(thermal);

  module.def(
      "traction_bound",
      [](TractionBound bound, double a, double b, double normal_force, double friction, const py::object& x,
         const py::object& y) {
        return mapped("x", x, "y", y, [&](double at_x, double at_y) {
          return traction_bound(bound, a, b, normal_force, friction, at_x, at_y);
        });
      },
      "bound"_a, "a"_a, "b"_a, "normal_force"_a, "friction"_a, "x"_a, "y"_a,
      "g(x, y) [Pa] for semi-axes a, b [m], normal force [N] and friction coefficient [-]; 0 outside\n"
      "the ellipse. 'parabolic': mu 2 Fn/(pi a b) (1 - (x/a)^2 - (y/b)^2); 'elliptic': mu 3\n"
      "Fn/(2 pi a b) times the root of the same. Both integrate to mu Fn. x, y [m] are numbers or\n"
      "arrays that broadcast, shape (...).");
}

} // namespace microslip::python
