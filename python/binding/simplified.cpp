#include "binding/bindings.hpp"
#include "binding/contact.hpp"
#include "binding/contact_batch.hpp"
#include "binding/long_work.hpp"
#include "binding/rolling_problem.hpp"
#include "binding/words.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"

#include <algorithm>
#include <array>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The options of a theory by the keywords of a Method. Throws Error for those of other theories.
SimplifiedOptions options_from(const char* theory, int mx, int my, RollingDirection direction, Precision precision,
                               const py::kwargs& keywords) {
  const py::dict all = py::module_::import("builtins").attr("dict")(keywords, "theory"_a = theory);
  Method method = method_from_keywords(all);
  method.mx = mx;
  method.my = my;
  method.precision = precision;
  require_compatible({}, method);
  return simplified_options(method, direction);
}

/// So many contacts take some ten milliseconds, at 10 ns for a cell.
std::size_t chunk_of(const RowSolver& solver) {
  const auto cells = static_cast<std::size_t>(solver.options().mx) * static_cast<std::size_t>(solver.options().my);
  return std::clamp<std::size_t>(1000000 / cells, 1, 256);
}

/// Answers all contacts of a batch, each thread with a copy of the solver.
template <class Arrays, class Answer>
auto batch_by(void (RowSolver::*answer)(std::span<const EllipticContact>, std::span<Answer>) noexcept) {
  return [answer](const RowSolver& solver, const ContactBatch& batch, int threads) {
    Arrays out(batch);
    // The object itself may be used by others while Python's lock is free.
    const RowSolver own(solver); // NOLINT(performance-unnecessary-copy-initialization)
    run_batch(batch.count(), chunk_of(own), threads, [&]() -> BatchWorker {
      return [&, mine = RowSolver(own), contacts = std::vector<EllipticContact>()](std::size_t first, std::size_t n,
                                                                                   const Progress&) mutable {
        contacts.clear();
        for (std::size_t i = 0; i < n; ++i) contacts.push_back(batch[first + i]);
        std::array<Answer, 256> answers;
        (mine.*answer)(contacts, std::span(answers).first(n));
        for (std::size_t i = 0; i < n; ++i) out.put(first + i, answers[i]);
      };
    });
    return out;
  };
}

RealArray pressures(const py::object& pressure, std::size_t rows) {
  auto array = real_array("pressure", pressure);
  if (array.ndim() != 2 || static_cast<std::size_t>(array.shape(0)) != rows || array.shape(1) < 1 ||
      array.shape(1) > most_cells)
    throw Error("pressure has shape " + to_text({array.shape(), array.shape() + array.ndim()}) + ": must be (" +
                std::to_string(rows) + ", mx), a row for each of y");
  return array;
}

ContactSolution patch_fields(RowSolver& solver, const py::object& y, const py::object& leading,
                             const py::object& trailing, const py::object& pressure, double row_width,
                             const std::array<double, 3>& flexibilities, const py::object& friction,
                             const py::object& creepage, double rolling_speed) {
  const auto rows = real_array("y", y);
  if (rows.ndim() != 1) throw Error("y: must be one number for each row");
  const auto front = real_array("leading", leading, {rows.size()}),
             back = real_array("trailing", trailing, {rows.size()});
  const auto cells = pressures(pressure, static_cast<std::size_t>(rows.size()));
  const auto& [l1, l2, l3] = flexibilities;
  return solver.fields(
      {static_cast<int>(cells.shape(1)), row_width, span_of(rows), span_of(front), span_of(back), span_of(cells)},
      {{l1, l2, l3}, friction_from(friction), creepage_from(creepage), rolling_speed});
}

void bind_row_solver(py::module_& module) {
  auto solver = py::class_<RowSolver>(module, "RowSolver",
                                      "Base of Fastsim and Fastsim2: all memory is taken when one is made, "
                                      "then it is used again and again.");
  const auto def_call = [&](const char* name, const auto& call, const char* text) {
    solver.def(name, call, "contact"_a, text)
        .def(
            name,
            [call](RowSolver& self, EllipticContact contact, double longitudinal, double lateral, double spin) {
              contact.creepage = {longitudinal, lateral, spin};
              return call(self, contact);
            },
            "contact"_a, "longitudinal"_a, "lateral"_a, "spin"_a,
            "Solves with other creepages [-], [-] and spin [1/m] than those of the contact.");
  };
  def_call(
      "solve", [](RowSolver& self, const EllipticContact& contact) { return self.solve(contact); },
      "Forces [N], [N m] and areas [m^2] of a contact, as ContactForces. Input out of range gives\n"
      "Status.invalid_input and NaN. Full sliding gives mu Fn to rounding on every grid. Cost O(mx my).");
  def_call(
      "differentiate", [](RowSolver& self, const EllipticContact& contact) { return self.differentiate(contact); },
      "Forces [N], [N m] and their derivatives with respect to xi [-], eta [-], phi [1/m] and Fn [N],\n"
      "as ContactDerivatives: forward differentiation of the same code.");
  solver
      .def(
          "fields", [](RowSolver& self, const EllipticContact& contact) { return self.fields(contact); }, "contact"_a,
          "Forces [N] with tractions [Pa], slip [-] and state of every cell, as ContactSolution.")
      .def("patch_fields", &patch_fields, "y"_a, "leading"_a, "trailing"_a, "pressure"_a, py::kw_only(), "row_width"_a,
           "flexibilities"_a, "friction"_a, "creepage"_a, "rolling_speed"_a = 1.0,
           "The fields of a patch of any outline, as ContactSolution: rows at y [m], shape (my), from their\n"
           "leading to their trailing edges x [m], shape (my), with the pressure p_n [Pa] at the centres of\n"
           "mx cells each, shape (my, mx), x ascending; row_width [m], flexibilities L [m/Pa] for\n"
           "longitudinal creepage, lateral creepage and spin, friction [-] or a law,\n"
           "creepages [-], [-], [1/m] and the speed V [m/s]. Error for an invalid patch.")
      .def_property_readonly(
          "mx", [](const RowSolver& self) { return self.options().mx; }, "Cells of a row [-].")
      .def_property_readonly(
          "my", [](const RowSolver& self) { return self.options().my; }, "Rows [-].")
      .def("__repr__", [](const py::object& self) {
        return py::str("{}({}, {})").format(py::type::of(self).attr("__name__"), self.attr("mx"), self.attr("my"));
      });
  def_batch(solver, "solve_batch", batch_by<ForceArrays, ContactForces>(&RowSolver::solve), "Returns ForceArrays.");
  def_batch(solver, "differentiate_batch", batch_by<DerivativeArrays, ContactDerivatives>(&RowSolver::differentiate),
            "Returns DerivativeArrays.");
}

constexpr const char* options_text =
    "mx cells in each of my rows [-], 1 to 10,000; direction 'forward' (along +x) or 'backward'; precision\n"
    "'double' or 'single', of forces of Coulomb friction only: about half the time, accurate to 1e-5 of mu Fn;\n"
    "bound, flexibility, coefficients and slope_reduction as in Method. Error if an option is out of range.";

} // namespace

void bind_simplified(py::module_& module) {
  bind_row_solver(module);
  py::class_<Fastsim2, RowSolver>(
      module, "Fastsim2",
      "FASTSIM2 (Vollebregt & Wilders 2010): the simplified theory by the trapezoidal rule with tracked\n"
      "boundaries between adhesion and slip, second order in the cell length. 10 x 10 cells are enough\n"
      "for forces.")
      .def(py::init([](int mx, int my, RollingDirection direction, Precision precision, const py::kwargs& keywords) {
             return Fastsim2(options_from("fastsim2", mx, my, direction, precision, keywords));
           }),
           "mx"_a = 10, "my"_a = 10, py::kw_only(), "direction"_a = RollingDirection::forward,
           "precision"_a = Precision::full, options_text);
  py::class_<Fastsim, RowSolver>(
      module, "Fastsim",
      "FASTSIM (Kalker 1982): the simplified theory by backward Euler, first order in the cell length.")
      .def(py::init([](int mx, int my, bool half_first_step, RollingDirection direction, Precision precision,
                       const py::kwargs& keywords) {
             return Fastsim(options_from("fastsim", mx, my, direction, precision, keywords),
                            half_first_step ? FirstStep::half : FirstStep::full);
           }),
           "mx"_a = 10, "my"_a = 10, py::kw_only(), "half_first_step"_a = false,
           "direction"_a = RollingDirection::forward, "precision"_a = Precision::full,
           (std::string(options_text) +
            "\nhalf_first_step: half a cell with the rigid slip in the step's middle, half the error; else as\n"
            "in (F16).")
               .c_str());
}

} // namespace microslip::python
