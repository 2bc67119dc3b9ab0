#include "microslip/rolling/solver.hpp"

#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact_batch.hpp"
#include "binding/long_work.hpp"
#include "binding/rolling_problem.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"

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
      .def("deformed_gap", &deformed_gap, "problem"_a,
           "Deformed distance of the bodies h - delta + u_n by the exact theory at the elements of the solution,\n"
           "shape (my, mx) [m]; zero in contact.")
      .def("__repr__", [](const py::object& self) { return py::str("Solver({!r})").format(self.attr("method")); });
  def_batch<RollingProblem>(solver, "solve_batch", solve_batch,
                            "A problem may stand for it. Returns SolutionArrays. Of the simplified theory\n"
                            "Fastsim2.solve_batch is much faster.");
}

} // namespace microslip::python
