#include "microslip/rolling/solver.hpp"

#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact_batch.hpp"
#include "binding/long_work.hpp"
#include "binding/rolling_problem.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "microslip/error.hpp"
#include "microslip/response/force_element.hpp"
#include "microslip/response/remington_filter.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using PythonSolver = OneAtATime<Solver>;

/// A method of Solver that any thread may call.
template <class Result> auto call(Result (Solver::*method)(const RollingProblem&, const Progress&)) {
  return [method](PythonSolver& self, const RollingProblem& given) {
    return self.run(
        [&, problem = given](Solver& solver, const Progress& progress) { return (solver.*method)(problem, progress); });
  };
}

py::array deformed_gap(PythonSolver& self, const RollingProblem& problem) {
  const GapValues found = call(&Solver::deformed_gap)(self, problem);
  py::array_t<double> out({found.grid.my, found.grid.mx});
  std::copy(found.gap.begin(), found.gap.end(), out.mutable_data());
  return out;
}

SolutionArrays solve_batch(const PythonSolver& self, const ContactBatch& batch, int threads) {
  SolutionArrays out(batch);
  run_batch(batch.count(), 1, threads, [&]() -> BatchWorker {
    return [&, solver = std::make_shared<Solver>(self.object.method())](std::size_t i, std::size_t,
                                                                        const Progress& progress) {
      const ContactSolution solved = solver->solve(batch.problem(i), progress);
      out.forces.put(i, solved.forces());
      out.residual[i] = solved.report.residual;
      out.newton_steps[i] = solved.report.newton_steps;
    };
  });
  return out;
}

py::array wavenumbers(const FrequencyResponse& self) {
  py::array_t<double> out(static_cast<py::ssize_t>(self.at.size()));
  for (std::size_t k = 0; k < self.at.size(); ++k) out.mutable_data()[k] = self.at[k].wavenumber;
  return out;
}
py::array responses_by_creepage(const FrequencyResponse& self) {
  py::array_t<std::complex<double>> out({static_cast<py::ssize_t>(self.at.size()), py::ssize_t(3), py::ssize_t(3)});
  for (std::size_t k = 0; k < self.at.size(); ++k)
    std::copy_n(&self.at[k].by_creepage[0][0], 9, out.mutable_data() + 9 * k);
  return out;
}
/// Three numbers of each response, or one.
template <std::complex<double> (ForceResponse::*member)[3]> py::array threes(const FrequencyResponse& self) {
  py::array_t<std::complex<double>> out({static_cast<py::ssize_t>(self.at.size()), py::ssize_t(3)});
  for (std::size_t k = 0; k < self.at.size(); ++k) std::copy_n(self.at[k].*member, 3, out.mutable_data() + 3 * k);
  return out;
}
template <std::complex<double> ForceResponse::*member> py::array ones(const FrequencyResponse& self) {
  py::array_t<std::complex<double>> out(static_cast<py::ssize_t>(self.at.size()));
  for (std::size_t k = 0; k < self.at.size(); ++k) out.mutable_data()[k] = self.at[k].*member;
  return out;
}

FrequencyResponse respond(PythonSolver& self, const RollingProblem& given, const std::vector<double>& wavenumber,
                          bool roughness) {
  const ResponseTo causes = roughness ? ResponseTo::roughness_too : ResponseTo::motion_and_load;
  return self.run([&, problem = given](Solver& solver, const Progress& progress) {
    return solver.respond(problem, wavenumber, progress, causes);
  });
}

py::tuple tuple_of(const ElementForces& forces) {
  return py::make_tuple(forces.fx, forces.fy, forces.mz);
}

ElementInput finite_input(double longitudinal, double lateral, double spin, double normal_force) {
  return {{require_finite("longitudinal", longitudinal, "-"), require_finite("lateral", lateral, "-"),
           require_finite("spin", spin, "1/m")},
          require_finite("normal_force", normal_force, "N")};
}

void bind_force_element(py::module_& module) {
  py::class_<ForceElement> element(
      module, "ForceElement",
      "Forces of a contact that remember the creepages and loads before: a rational fit of its responses over the\n"
      "wavenumber with common stable poles, by vector fitting. Linear, about the steady state; copy.copy keeps a "
      "state.");
  element
      .def(py::init([](const FrequencyResponse& response, double normal_force, int poles) {
             return ForceElement(fit_force_element(response, normal_force, poles));
           }),
           "response"_a, "normal_force"_a, "poles"_a = 12,
           "Fits a FrequencyResponse at ascending wavenumbers, about a normal force [N], to so many poles, pairs\n"
           "counting twice. Error for fewer than poles + 1 wavenumbers.")
      .def_static(
          "from_text", [](const std::string& text) { return ForceElement(force_element_from(text)); }, "text"_a,
          "The element of a fit that `microslip respond --poles` has written, or text().")
      .def(
          "text", [](const ForceElement& self) { return text_of(self.fit()); }, "The fit as text, for a file.")
      .def_property_readonly(
          "poles", [](const ForceElement& self) { return self.fit().poles; },
          "The poles [1/m]; those with a positive imaginary part stand for their conjugates, too.")
      .def_property_readonly(
          "error", [](const ForceElement& self) { return self.fit().largest_error(); },
          "Largest error of the fit, over the largest size of the response [-].")
      .def(
          "response",
          [](const ForceElement& self, double wavenumber) -> py::array {
            py::array_t<std::complex<double>> out({py::ssize_t(element_outputs), py::ssize_t(element_inputs)});
            for (std::size_t i = 0; i < element_outputs; ++i)
              for (std::size_t j = 0; j < element_inputs; ++j)
                out.mutable_at(i, j) = self.fit().response(i, j, wavenumber);
            return out;
          },
          "wavenumber"_a,
          "The fit's response of fx, fy [N], mz [N m] to xi, eta [-], phi [1/m], Fn [N] at a wavenumber [1/m], shape "
          "(3, 4).")
      .def(
          "step",
          [](ForceElement& self, double distance, double longitudinal, double lateral, double spin,
             double normal_force) {
            require_between("distance", distance, "m", 0, std::numeric_limits<double>::max());
            return tuple_of(self.step(distance, finite_input(longitudinal, lateral, spin, normal_force)));
          },
          "distance"_a, "longitudinal"_a, "lateral"_a, "spin"_a, "normal_force"_a,
          "Goes on by a distance rolled [m], over which creepages [-], spin [1/m] and normal force [N] become these,\n"
          "linearly. Returns (fx, fy, mz) [N], [N], [N m].")
      .def(
          "reset", [](ForceElement& self) { self.reset(); }, "Back to the steady state.")
      .def("__copy__", [](const ForceElement& self) { return self; })
      .def(
          "__deepcopy__", [](const ForceElement& self, const py::dict&) { return self; }, "memo"_a)
      .def(py::pickle([](const ForceElement& self) { return py::make_tuple(text_of(self.fit()), self.state()); },
                      [](const py::tuple& kept) {
                        ForceElement self(force_element_from(kept[0].cast<std::string>()));
                        self.set_state(kept[1].cast<std::vector<double>>());
                        return self;
                      }))
      .def("__repr__",
           [](const ForceElement& self) { return "ForceElement(" + std::to_string(self.fit().count()) + " poles)"; });
}

void bind_results(py::module_& module) {
  py::class_<ExactDerivatives> derivatives(module, "ExactDerivatives",
                                           "Forces in steady rolling and their derivatives.");
  derivatives.def_readonly("solution", &ExactDerivatives::solution, "The solution, as ContactSolution.")
      .def_property_readonly(
          "jacobian",
          [](const py::object& self) {
            return view(&self.cast<const ExactDerivatives&>().jacobian[0][0], {3, 3}, self);
          },
          "Derivatives of fx [N], fy [N], mz [N m] with respect to xi [-], eta [-] and phi [1/m], shape (3, 3).")
      .def_property_readonly(
          "by_load",
          [](const py::object& self) { return view(&self.cast<const ExactDerivatives&>().by_load[0], {3}, self); },
          "Derivatives of these with respect to the normal force [N], or to the approach [m] where that is given; the\n"
          "bodies' distance without load stays. Shape (3).")
      .def_readonly("products", &ExactDerivatives::products, "Products that the derivatives took [-].");
  add_value(derivatives, {"solution", "jacobian", "by_load"});

  py::class_<FrequencyResponse> response(
      module, "FrequencyResponse",
      "Responses of the forces to oscillations about steady rolling, over the wavenumber.");
  response.def_readonly("solution", &FrequencyResponse::solution, "The steady solution, as ContactSolution.")
      .def_property_readonly(
          "wavenumber", &wavenumbers,
          "k = omega/V = 2 pi/wavelength, shape (n) [1/m]; none where the steady state is not solved.")
      .def_property_readonly("by_creepage", &responses_by_creepage,
                             "Complex amplitudes of fx [N], fy [N], mz [N m] by those of xi [-], eta [-], phi [1/m], "
                             "e^(i omega t),\n"
                             "shape (n, 3, 3); at k = 0 the Jacobian of ExactDerivatives.")
      .def_property_readonly("by_load", &threes<&ForceResponse::by_load>,
                             "The same by that of the normal force [N], shape (n, 3).")
      .def_property_readonly(
          "by_roughness", &threes<&ForceResponse::by_roughness>,
          "The same by that of roughness [m] at a given approach, shape (n, 3); zero unless asked for.")
      .def_property_readonly("load_by_roughness", &ones<&ForceResponse::load_by_roughness>,
                             "Complex amplitude of the normal force by that of roughness [N/m], shape (n).")
      .def_property_readonly(
          "work_by_creepage", &threes<&ForceResponse::work_by_creepage>,
          "Complex amplitudes of the frictional work per metre of the surface by those of creepages\n"
          "[N], [N] and spin [N m], shape (n, 3); with roughness.")
      .def_property_readonly("work_by_load", &ones<&ForceResponse::work_by_load>,
                             "The same by that of the normal force [-], shape (n).")
      .def_property_readonly("work_by_roughness", &ones<&ForceResponse::work_by_roughness>,
                             "The same by that of roughness [N/m], shape (n).")
      .def_readonly("normal_stiffness", &FrequencyResponse::normal_stiffness, "dFn by the approach [N/m].")
      .def_readonly("products", &FrequencyResponse::products, "Products that the responses took [-].");
  add_value(response, {"solution", "wavenumber", "by_creepage", "by_load", "by_roughness", "load_by_roughness",
                       "work_by_creepage", "work_by_load", "work_by_roughness", "normal_stiffness"});

  py::class_<AccurateContact> accurate(module, "AccurateContact", "Steady rolling on two nested grids and its limit.");
  add_members(accurate, Shown<&AccurateContact::forces>{"The limit, extrapolated; areas and status of the finer grid."},
              Shown<&AccurateContact::creepage>{"The limit, where a force is prescribed [-], [-], [1/m]."},
              Shown<&AccurateContact::error>{
                  "Estimated error of the limit, in mu Fn for forces and mu Fn sqrt(a b) for the moment [-]."},
              Shown<&AccurateContact::elements>{"Elements across the ellipse, of the finer grid [-]."},
              Shown<&AccurateContact::finest>{"The solution on the finer grid, as ContactSolution."},
              Shown<&AccurateContact::coarser>{"The totals on half the elements, as ContactForces."},
              Shown<&AccurateContact::products>{"Products on all grids [-]."});
  add_value(accurate, {"forces", "creepage", "error", "elements"});
}

} // namespace

void bind_solver(py::module_& module) {
  bind_results(module);
  bind_force_element(module);
  module.def("remington_filter", &remington_filter, "radius"_a, "alpha"_a, "wavenumber"_a,
             "Remington's contact filter of roughness [-]: radius of the contact [m], alpha [-], wavenumber [1/m].");
  module.def(
      "contact_filter", &contact_filter, "a"_a, "b"_a, "wavenumber_x"_a, "wavenumber_y"_a = 0.0,
      "Normal force that a wave of roughness makes in a Hertzian contact at a given approach, over that of an endless\n"
      "one: sin(q)/q, q^2 = (k_x a)^2 + (k_y b)^2, with semi-axes [m] and wavenumbers [1/m].");
  py::class_<PythonSolver> solver(
      module, "Solver",
      "Solves any RollingProblem by one Method, and keeps for the next one what does not change: influence\n"
      "coefficients, transforms, pressures. An EllipticContact stands for the problem that it makes. Calls from\n"
      "several Python threads wait for each other; Ctrl-C ends them.");
  solver
      .def(py::init<const Method&>(), "method"_a, py::pos_only(),
           "Error if the grid needs more memory than the machine has [-].")
      .def(py::init(
               [](const py::kwargs& method) { return std::make_unique<PythonSolver>(method_from_keywords(method)); }),
           "Made with the keywords of a Method [-] instead of one.")
      .def_property_readonly(
          "method", [](const PythonSolver& self) { return self.object.method(); }, "The Method.")
      .def("solve", call(&Solver::solve), "problem"_a,
           "The ContactSolution of a problem [SI units]. Input out of range, not converging, no contact and a force\n"
           "beyond friction are a status with its reason, and NaN. Error for a problem that the method cannot\n"
           "honour, and of a gap on a grid for any input out of range. Cost of the exact theory O(N log N) in the\n"
           "number of elements, 2 ms at 24 x 24.")
      .def("differentiate", call(&Solver::differentiate), "problem"_a,
           "Steady rolling by the exact theory with creepages given and Coulomb friction: forces [N], [N m] and their\n"
           "derivatives with respect to xi [-], eta [-], phi [1/m] and the load, as ExactDerivatives, by the implicit\n"
           "function theorem, accurate to 1e-5 away from kinks.")
      .def("respond", &respond, "problem"_a, "wavenumber"_a, py::kw_only(), "roughness"_a = false,
           "Complex responses of the forces [N], [N m] to oscillations of creepages [-], spin [1/m] and normal force "
           "[N]\n"
           "about steady rolling at wavenumbers omega/V [1/m], as FrequencyResponse; with roughness also to that [m],\n"
           "and those of frictional work. Elastically similar bodies with Coulomb friction, by the exact theory at\n"
           "second order; else Error. Cost: 5 ms for each at 24 x 24, 15 ms with roughness.")
      .def("deformed_gap", &deformed_gap, "problem"_a,
           "Deformed distance of the bodies h - delta + u_n by the exact theory at the elements of the solution,\n"
           "shape (my, mx) [m]; zero in contact.")
      .def("__repr__", [](const py::object& self) { return py::str("Solver({!r})").format(self.attr("method")); });
  def_batch<RollingProblem>(solver, "solve_batch", solve_batch,
                            "A problem may stand for it. Returns SolutionArrays. Of the simplified theory\n"
                            "Fastsim2.solve_batch is much faster.");
}

} // namespace microslip::python
