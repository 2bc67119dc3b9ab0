#include "binding/bindings.hpp"
#include "binding/value.hpp"
#include "binding/wheel_rail.hpp"
#include "binding/wheel_rail_fields.hpp"

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;

namespace {

constexpr std::size_t result_count = differentiated_results;

std::vector<std::string_view> results() {
  std::vector<std::string_view> names;
  for (const WheelQuantity& row : wheel_derivatives()) names.push_back(row.name);
  return names;
}

std::vector<std::string_view> variables() {
  std::vector<std::string_view> names;
  for (const StateQuantity& q : state_quantities()) names.push_back(q.name);
  names.push_back(force_name);
  return names;
}

} // namespace

/// Forces in one state or in many, with the derivatives of all.
template <class Solution> struct Differentiated {
  Solution solution;
  Shape shape; ///< of the states
  std::vector<double> jacobian;

  Differentiated() = default;
  Differentiated(Solution of, Shape states, std::size_t count)
      : solution(std::move(of)), shape(std::move(states)), jacobian(count * result_count * wheel_variables) {}

  void store(std::size_t state, const WheelRailDerivatives& d) {
    std::copy(d.values.begin(), d.values.end(), jacobian.data() + state * d.values.size());
  }
};
using DifferentiatedState = Differentiated<WheelRailSolution>;
using DifferentiatedStates = Differentiated<SolvedStates>;

template <>
inline constexpr auto fields<DifferentiatedState> =
    members<&DifferentiatedState::solution, &DifferentiatedState::jacobian>;

namespace {

DifferentiatedState differentiate(PythonWheelRail& self, const py::kwargs& given) {
  const auto [state, force] = StateArrays(given, self.bodies.wheelset.nominal_radius).single("differentiate");
  DifferentiatedState out({}, {}, 1);
  self.solver.run([&, state = state, force = force](WheelRail& solver, const Progress& progress) {
    WheelRailDerivatives derivatives;
    solver.reset();
    solver.differentiate(state, force, out.solution, derivatives, progress);
    out.store(0, derivatives);
  });
  return out;
}

DifferentiatedStates differentiate_batch(PythonWheelRail& self, int threads, const py::kwargs& given) {
  const StateArrays states(given, self.bodies.wheelset.nominal_radius);
  DifferentiatedStates out({states.shape(), std::vector<WheelRailSolution>(states.count())}, states.shape(),
                           states.count());
  self.for_batch(states, threads, [&](WheelRail& solver, std::size_t i, const Progress& progress) {
    const auto [state, force] = states[i];
    WheelRailDerivatives derivatives;
    solver.differentiate(state, force, out.solution.solutions[i], derivatives, progress);
    out.solution.solutions[i].fields.clear();
    out.store(i, derivatives);
  });
  return out;
}

/// Derivative in all states.
template <class Solution>
py::object derivative(const Differentiated<Solution>& self, const std::string& of, const std::string& by) {
  const std::size_t row = index_of(of, results(), "number that is differentiated"),
                    column = index_of(by, variables(), "number of the state");
  RealArray out(self.shape);
  for (std::size_t k = 0; k < static_cast<std::size_t>(out.size()); ++k)
    out.mutable_data()[k] = self.jacobian[(k * result_count + row) * wheel_variables + column];
  return self.shape.empty() ? py::object(py::float_(*out.data())) : py::object(std::move(out));
}

/// Binds what both classes have.
template <class Solution>
py::class_<Differentiated<Solution>> bind(py::module_& module, const char* name, const char* text, const char* shape) {
  using Self = Differentiated<Solution>;
  py::class_<Self> of(module, name, text);
  of.def_property_readonly(
        "jacobian",
        [](const py::object& self) {
          const auto& it = self.cast<const Self&>();
          Shape whole = it.shape;
          for (const std::size_t extent : {result_count, wheel_variables})
            whole.push_back(static_cast<py::ssize_t>(extent));
          return view(it.jacobian, whole, self);
        },
        (std::string("All derivatives of [N], [N m] and [m] by SI units, shape ") + shape +
         ",\nas `results` and `variables` say; zero by what was not given, vertical or vertical_force.")
            .c_str())
      .def_property_readonly(
          "results", [](const Self&) { return tuple_of(results()); },
          "Names of the Jacobian's rows: forces [N], moments [N m] and the height [m].")
      .def_property_readonly(
          "variables", [](const Self&) { return tuple_of(variables()); },
          "Names of its columns: the numbers of a state and vertical_force [SI units].")
      .def("derivative", &derivative<Solution>, "of"_a, "by"_a,
           "One column of one row by their names [SI units]: derivative(\"force_y\", \"lateral\").");
  return of;
}

} // namespace

void bind_wheel_rail_derivatives(py::module_& module, py::class_<PythonWheelRail>& wheel_rail) {
  auto one =
      bind<WheelRailSolution>(module, "WheelRailDerivatives", "Forces on a wheel and their derivatives.", "(7, 31)");
  one.def_property_readonly(
      "solution", [](const DifferentiatedState& self) -> const WheelRailSolution& { return self.solution; },
      "The WheelRailSolution.");
  add_value(one, {"solution"});
  auto many = bind<SolvedStates>(module, "WheelRailDerivativeArrays",
                                 "Forces on a wheel in many states and their derivatives.", "(..., 7, 31)");
  many.def_property_readonly(
      "solution", [](const DifferentiatedStates& self) -> const SolvedStates& { return self.solution; },
      "The WheelRailArrays.");
  add_description(many, {"solution"});
  wheel_rail
      .def("differentiate", &differentiate,
           "The WheelRailDerivatives in a state given as for solve [SI units]: of forces and moments, and of the\n"
           "height that a vertical force finds. They hold where no patch comes or goes; those of a state that is not\n"
           "ok are zero. With theory \"exact\" those by velocities are accurate to 1e-4, by positions to some percent.")
      .def("differentiate_batch", &differentiate_batch, "threads"_a = 0,
           "The WheelRailDerivativeArrays of many states, given as for solve_batch [SI units].");
}

} // namespace microslip::python
