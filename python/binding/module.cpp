#include "binding/bindings.hpp"
#include "binding/sweep.hpp"

#include "microslip/error.hpp"
#include "microslip/rolling/incompatibility.hpp"
#include "microslip/version.hpp"

namespace microslip::python {
namespace {

namespace py = pybind11;

void bind_error(py::module_& module) {
  auto error = py::register_exception<Error>(module, "Error", PyExc_ValueError);
  error.attr("__doc__") = "An invalid set-up: the text names the field, its value, its unit and the allowed range.";
  // What cannot be combined, with keys as keyword parameters.
  // NOLINTNEXTLINE(performance-unnecessary-value-param): as pybind11 calls it
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Incompatible& refusal) {
      const py::object type = py::module_::import("microslip._core").attr("Error");
      PyErr_SetString(type.ptr(), refusal.of().message(KeyStyle::keyword).c_str());
    }
  });
}

void bind_build(py::module_& module) {
  module.def(
      "build_info",
      [] {
        const auto build = build_info();
        py::dict out;
        out["version"] = std::string(build.version);
        out["commit"] = std::string(build.commit);
        out["compiler"] = std::string(build.compiler);
        out["build_type"] = std::string(build.build_type);
        return out;
      },
      "Identification of the library's build: a dict of version, commit, compiler and build_type [-].");
}

} // namespace
} // namespace microslip::python

PYBIND11_MODULE(_core, module) {
  using namespace microslip::python;
  module.doc() =
      "The compiled part of microslip. All in SI units, all forces on body 1; use it through the package microslip.";
  const pybind11::object name = module.attr("__name__");
  module.attr("__name__") = "microslip"; // where users see its classes
  bind_error(module);
  bind_build(module);
  module.attr("__version__") = std::string(microslip::build_info().version);
  bind_elasticity(module);
  bind_layered_bodies(module);
  bind_friction(module);
  bind_contact(module);
  bind_grid(module);
  bind_interior(module);
  bind_solution(module);
  bind_damage(module);
  bind_simplified(module);
  bind_grid_problems(module);
  bind_creep_table(module);
  bind_rolling_problem(module);
  bind_solver(module);
  bind_nip(module);
  bind_case_files(module);
  bind_inputs_of_cases(module);
  bind_creep_curve_fit(module);
  bind_contact_input(module);
  bind_profile(module);
  bind_wheel_rail(module);
  bind_wheelset_on_track(module);
  bind_wheelset_geometry(module);
  bind_sweep(module);
  module.attr("__name__") = name;
}
