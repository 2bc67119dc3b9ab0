#pragma once

#include <pybind11/pybind11.h>

namespace microslip::python {

// Each adds the classes and functions of a part to the module, in this order: later ones use the types of earlier ones.
void bind_elasticity(pybind11::module_& module);
void bind_layered_bodies(pybind11::module_& module);
void bind_friction(pybind11::module_& module);
void bind_contact(pybind11::module_& module);
void bind_grid(pybind11::module_& module);
void bind_interior(pybind11::module_& module);
void bind_solution(pybind11::module_& module);
void bind_damage(pybind11::module_& module);
void bind_simplified(pybind11::module_& module);
void bind_grid_problems(pybind11::module_& module);
void bind_creep_table(pybind11::module_& module);
void bind_rolling_problem(pybind11::module_& module);
void bind_solver(pybind11::module_& module);
void bind_nip(pybind11::module_& module);
void bind_case_files(pybind11::module_& module);
void bind_inputs_of_cases(pybind11::module_& module);
void bind_creep_curve_fit(pybind11::module_& module);
void bind_contact_input(pybind11::module_& module);
void bind_profile(pybind11::module_& module);
void bind_wheel_rail(pybind11::module_& module);
void bind_wheelset_on_track(pybind11::module_& module);
void bind_wheelset_geometry(pybind11::module_& module);

} // namespace microslip::python
