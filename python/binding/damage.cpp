#include "binding/damage.hpp"

#include "binding/arrays.hpp"
#include "binding/bindings.hpp"
#include "microslip/damage/fatigue.hpp"
#include "microslip/damage/wear.hpp"
#include "microslip/railway/derailment.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// A value for each element, shape (my, mx).
py::array element_array(const ContactSolution& solution, const std::vector<double>& values) {
  py::array_t<double> out({solution.elements.my(), solution.elements.mx()});
  std::copy(values.begin(), values.end(), out.mutable_data());
  return out;
}

void bind_strength(py::module_& module) {
  const WearMap standard;
  auto map = py::class_<WearMap>(
      module, "WearMap",
      "Wear coefficients of Archard's law over sliding speed and pressure, by default the middles of the ranges that\n"
      "KTH measured for dry wheel and rail steels (Jendel 2002).");
  map.def(init_fields<WearMap>(), py::kw_only(), "slow"_a = standard.slow, "medium"_a = standard.medium,
          "fast"_a = standard.fast, "seizure"_a = standard.seizure, "medium_from"_a = standard.medium_from,
          "medium_to"_a = standard.medium_to, "seizure_above"_a = standard.seizure_above,
          "k [-] below the sliding speed medium_from [m/s], up to medium_to [m/s], beyond, and where the pressure is\n"
          "above seizure_above [-] times the hardness.");
  add_fields(map, {"k below medium_from [-]: mild.", "k from medium_from to medium_to [-]: severe.",
                   "k beyond medium_to [-].", "k at high pressure [-].", "Sliding speed [m/s].", "Sliding speed [m/s].",
                   "Pressure over hardness [-]."});
  add_value(map);

  auto strength = py::class_<SurfaceStrength>(module, "SurfaceStrength",
                                              "Strength of surfaces against wear and yield; None: not known.");
  strength.def(
      init_fields<SurfaceStrength>(), py::kw_only(), "hardness"_a = py::none(), "shear_yield_strength"_a = py::none(),
      "wear_map"_a = standard,
      "Hardness H [Pa] of the surface that wears, yield strength k [Pa] in shear of the work-hardened surface,\n"
      "and the WearMap. Values are checked where they are used.");
  add_fields(strength, {"H [Pa], or None.", "k [Pa], or None.", "The WearMap."});
  add_value(strength);
}

} // namespace

void bind_damage(py::module_& module) {
  bind_strength(module);
  module.def(
      "friction_work", [](const ContactSolution& solution) { return element_array(solution, friction_work(solution)); },
      "solution"_a, "T-gamma per area of each element, the work of friction per metre rolled [N/m^2], shape (my, mx).");
  module.def(
      "wear_depth",
      [](const ContactSolution& solution, double hardness, double rolling_speed, const WearMap& wear_map) {
        return element_array(solution, wear_depth(solution, {hardness, wear_map}, rolling_speed));
      },
      "solution"_a, py::kw_only(), "hardness"_a, "rolling_speed"_a, "wear_map"_a = WearMap(),
      "Depth [m] that each element of a contact wears off a surface that runs through it once, by Archard's law,\n"
      "shape (my, mx); the sum over a row is what a passage leaves there. hardness [Pa], rolling_speed V [m/s]. Error\n"
      "for a solution without pressures.");
  module.def(
      "shear_excess",
      [](const ContactSolution& solution, double shear_yield_strength) {
        return element_array(solution, shear_excess(solution, shear_yield_strength));
      },
      "solution"_a, "shear_yield_strength"_a,
      "Traction of each element less the yield strength in shear [Pa], shape (my, mx).");
  module.def("wear_rate_r8t", &wear_rate_r8t, "t_gamma_per_area"_a,
             "Mass that wheel steel R8T loses per metre rolled and square metre of contact [kg/m^3] with T-gamma per\n"
             "area [N/m^2] (Braghin et al. 2006).");
  module.def("worn_area_british_rail", &worn_area_british_rail, "t_gamma"_a, "diameter"_a,
             "Cross-section that a wheel of the diameter [m] loses per metre rolled [m], with T-gamma [N]\n"
             "(Pearce & Sherratt 1991).");
  module.def("surface_fatigue_index", &surface_fatigue_index, "traction_coefficient"_a, "peak_pressure"_a,
             "shear_yield_strength"_a,
             "Traction coefficient [-] less shear_yield_strength [Pa] over peak_pressure [Pa] (Ekberg et al. 2002).");
  module.def("line_shakedown_limit", &line_shakedown_limit, "traction_coefficient"_a,
             "Largest pressure over the yield strength in shear [-] up to which a line contact shakes down, with the\n"
             "traction coefficient [-].");
  module.def("point_shakedown_limit", &point_shakedown_limit, "traction_coefficient"_a,
             "Shakedown limit of a circular point contact [-].");
  module.def("nadal_limit", &nadal_limit, "angle"_a, "friction"_a,
             "Nadal's limit of Y/Q [-] at the contact angle [rad] with friction [-].");
}

} // namespace microslip::python
