#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact.hpp"
#include "binding/grid.hpp"
#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;

Shape shape_of(const ElementGrid& grid) {
  return {grid.my, grid.mx};
}

namespace {

RealArray centres(int count, double first, double apart) {
  RealArray out(count);
  for (int i = 0; i < count; ++i) out.mutable_data()[i] = first + i * apart;
  return out;
}

} // namespace

void bind_grid(py::module_& module) {
  auto grid = py::class_<ElementGrid>(
      module, "ElementGrid",
      "The potential contact: mx x my equal rectangles, x and y ascending. Fields on it have shape (my, mx).");
  grid.def(py::init([](int mx, int my, double x0, double y0, double dx, double dy) {
             ElementGrid made{mx, my, x0, y0, dx, dy};
             check(made);
             return made;
           }),
           "mx"_a, "my"_a, "x0"_a, "y0"_a, "dx"_a, "dy"_a,
           "mx, my elements [-] with sides dx, dy [m], the first one's centre at x0, y0 [m]. Error for sizes out of "
           "range.")
      .def_static("across_ellipse", py::overload_cast<double, double, int, int, int>(&ElementGrid::across_ellipse),
                  "a"_a, "b"_a, "mx"_a, "my"_a, "margin"_a = 0,
                  "mx x my elements [-] across an ellipse with semi-axes a, b [m], its centre at the origin, and\n"
                  "`margin` more on each side [-].")
      .def_static("across_line", &ElementGrid::across_line, "a"_a, "mx"_a, "margin"_a = 0, "length"_a = 1.0,
                  "A line contact: one row, endless in y, mx elements [-] across the half-width a [m], `margin`\n"
                  "more on each side [-]; forces are those of `length` [m].");
  add_members(grid, Shown<&ElementGrid::mx>{"Columns [-]."}, Shown<&ElementGrid::my>{"Rows [-]."},
              Shown<&ElementGrid::x0>{"Centre of the first element [m]."},
              Shown<&ElementGrid::y0>{"Centre of the first element [m]."},
              Shown<&ElementGrid::dx>{"Length of an element [m]."}, Shown<&ElementGrid::dy>{"Width of an element [m]."},
              Shown<&ElementGrid::line>{"Whether it is a line contact."});
  grid.def_property_readonly(
          "x", [](const ElementGrid& self) { return centres(self.mx, self.x0, self.dx); },
          "Centres of the columns, shape (mx) [m].")
      .def_property_readonly(
          "y", [](const ElementGrid& self) { return centres(self.my, self.y0, self.dy); },
          "Centres of the rows, shape (my) [m].");
  add_value(grid, {"mx", "my", "x0", "y0", "dx", "dy", "line"});

  module.def(
      "hertzian_gap",
      [](const GapCurvatures& gap, const ElementGrid& on) {
        RealArray out(shape_of(on));
        const auto values = hertzian_gap(gap, on);
        std::copy(values.begin(), values.end(), out.mutable_data());
        return out;
      },
      "gap"_a, "grid"_a, "The undeformed distance h = A x^2 + B y^2 at the elements' centres, shape (my, mx) [m].");
}

namespace {

using Force = std::optional<double>;

NormalLoad load_from(Force force, Force approach) {
  if (force.has_value() == approach.has_value()) throw Error("load: needs either normal_force or approach");
  return force ? NormalLoad{NormalLoad::Given::force, *force} : NormalLoad{NormalLoad::Given::approach, *approach};
}

template <class T> auto normal_field(std::vector<T> NormalSolution::*member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const NormalResult&>();
    return view(result.solution.*member, result.shape, self);
  };
}

void bind_normal(py::module_& module) {
  const auto number = [](auto member) { return [member](const NormalResult& self) { return self.solution.*member; }; };
  py::class_<NormalResult> normal(module, "NormalSolution",
                                  "The contact area and the pressure on it; read-only views of shape (my, mx).");
  normal.def_property_readonly("pressure", normal_field(&NormalSolution::pressure), "p_n >= 0, shape (my, mx) [Pa].")
      .def_property_readonly("displacement", normal_field(&NormalSolution::displacement), "u_n, shape (my, mx) [m].")
      .def_property_readonly("gap", normal_field(&NormalSolution::gap),
                             "Deformed distance h - delta + u_n, zero in contact, shape (my, mx) [m].")
      .def_property_readonly("approach", number(&NormalSolution::approach), "delta [m].")
      .def_property_readonly("normal_force", number(&NormalSolution::normal_force), "Fn [N].")
      .def_property_readonly("elastic_energy", number(&NormalSolution::elastic_energy), "Of the pressure [J].")
      .def_property_readonly("peak_pressure", number(&NormalSolution::peak_pressure),
                             "Largest pressure of an element [Pa].")
      .def_property_readonly("contact_elements", number(&NormalSolution::contact_elements), "Elements in contact [-].")
      .def_property_readonly("touches_border", number(&NormalSolution::touches_border),
                             "True if contact reaches the rim of the grid, which then is too small.")
      .def_property_readonly("residual", number(&NormalSolution::residual), "Relative to the largest displacement [-].")
      .def_property_readonly("products", number(&NormalSolution::products), "Products with the matrix [-].")
      .def_property_readonly("status", number(&NormalSolution::status), "How the calculation ended, a Status [-].");
  add_value(normal, {"status", "normal_force", "approach", "peak_pressure", "contact_elements", "residual"});

  struct Problem {
    Problem(const CombinedMaterial& material, const ElementGrid& on, const Progress& progress)
        : problem(material, on, progress), grid(on) {}
    OneAtATime<NormalProblem> problem;
    ElementGrid grid;
  };
  py::class_<Problem>(
      module, "NormalProblem",
      "The normal contact problem of any gap on a grid of elements with constant pressure: p_n >= 0, e\n"
      "= h - delta + u_n >= 0, p_n e = 0, by conjugate gradients, without friction: any K.")
      .def(py::init([](const CombinedMaterial& material, const ElementGrid& on) {
             return long_work(
                 [&](const Progress& progress) { return std::make_unique<Problem>(material, on, progress); });
           }),
           "material"_a, "grid"_a,
           "Error for a grid that needs more memory than the machine has; some 190 bytes for an element.")
      .def(
          "solve",
          [](Problem& self, const py::object& gap, Force normal_force, Force approach, double tolerance) {
            const auto h = real_array("gap", gap, shape_of(self.grid));
            const auto load = load_from(normal_force, approach);
            return NormalResult{self.problem.run([&](NormalProblem& problem, const Progress& progress) {
                                  return problem.solve(span_of(h), load, tolerance, progress);
                                }),
                                shape_of(self.grid)};
          },
          "gap"_a, py::kw_only(), "normal_force"_a = py::none(), "approach"_a = py::none(), "tolerance"_a = 1e-8,
          "Solves for the undeformed distance h [m] at the elements' centres, shape (my, mx), with either\n"
          "the normal force [N] or the approach [m] given. Returns NormalSolution. Error for a gap with NaN\n"
          "or a load out of range. Cost O(N log N).");
}

void bind_tangential_solution(py::module_& module) {
  const auto number = [](auto of) { return [of](const TangentialResult& self) { return of(self.solution); }; };
  py::class_<TangentialResult> tangential(
      module, "TangentialSolution",
      "Tractions and slip on a regular grid; read-only views of shape (my, mx), x and y ascending.");
  const auto add_field = [&](const char* name, const char* text, auto of) {
    const auto get = [of](const py::object& self) {
      const auto& solution = self.cast<const TangentialResult&>().solution;
      return view(of(solution.fields), shape_of(solution.elements.grid), self);
    };
    tangential.def_property_readonly(name, get, text);
  };
  using Fields = const SurfaceFields&;
  add_field(
      "px", "Tractions on body 1, shape (my, mx) [Pa].", [](Fields f) -> auto& { return f.traction.x; });
  add_field(
      "py", "Tractions on body 1, shape (my, mx) [Pa].", [](Fields f) -> auto& { return f.traction.y; });
  add_field(
      "bound", "g, shape (my, mx) [Pa].", [](Fields f) -> auto& { return f.bound; });
  add_field(
      "ux", "u1 - u2, shape (my, mx) [m].", [](Fields f) -> auto& { return f.displacement.x; });
  add_field(
      "uy", "u1 - u2, shape (my, mx) [m].", [](Fields f) -> auto& { return f.displacement.y; });
  add_field(
      "sx", "Relative slip, shape (my, mx) [-]; for a shift [m].", [](Fields f) -> auto& { return f.slip.x; });
  add_field(
      "sy", "Relative slip, shape (my, mx) [-]; for a shift [m].", [](Fields f) -> auto& { return f.slip.y; });
  add_field(
      "state", "Codes of CellState as uint8, shape (my, mx) [-].", [](Fields f) -> auto& { return f.state; });
  using Solution = const ContactSolution&;
  tangential
      .def_property_readonly("forces", number([](Solution s) { return s.forces(); }), "The totals, as ContactForces.")
      .def_property_readonly("creepage", number([](Solution s) { return s.creepage; }),
                             "Creepages as given, or as found where a force is prescribed [-], [-], [1/m].")
      .def_property_readonly("elastic_energy", number([](Solution s) { return s.totals.elastic_energy; }),
                             "Of the tractions [J].")
      .def_property_readonly("frictional_power", number([](Solution s) { return s.totals.frictional_power; }),
                             "[W]; for a shift the work [J].")
      .def_property_readonly("residual", number([](Solution s) { return s.report.residual; }), "Relative residual [-].")
      .def_property_readonly("newton_steps", number([](Solution s) { return s.report.newton_steps; }),
                             "Steps of Newton's method [-].")
      .def_property_readonly("products", number([](Solution s) { return s.report.products; }),
                             "Products with the matrix [-].");
  add_value(tangential, {"forces", "creepage", "residual"});
}

/// The tangential problem alone knows no pressure, with which dissimilar bodies couple it.
const CombinedMaterial& similar(const CombinedMaterial& material) {
  if (material.dissimilarity != 0)
    throw Error("material.dissimilarity", material.dissimilarity, "-",
                "0 for a tangential problem alone; a Solver couples it with the normal one");
  return material;
}

void bind_tangential(py::module_& module) {
  struct Problem {
    Problem(const CombinedMaterial& material, const ElementGrid& on) : problem(similar(material), on), grid(on) {}
    OneAtATime<TangentialProblem> problem;
    ElementGrid grid;
  };
  py::class_<Problem>(module, "TangentialProblem",
                      "The tangential contact problem of the exact theory on a grid of elements with constant\n"
                      "tractions, classical discretisation, elastically similar bodies: shifts, steps of transient\n"
                      "rolling, steady rolling.")
      .def(py::init<const CombinedMaterial&, const ElementGrid&>(), "material"_a, "grid"_a,
           "Error for bodies with K != 0 and for a grid that needs more memory than the machine has; some\n"
           "5,900 bytes for an element at most.")
      .def(
          "solve",
          [](Problem& self, const py::object& bound, const py::object& creepage, ContactMotion motion, Force force_x,
             Force force_y, double step, RollingDirection direction, double rolling_speed,
             const TangentialResult* previous, double tolerance) {
            TangentialInput input;
            if (previous != nullptr) {
              const Shape shape = shape_of(previous->solution.elements.grid), wanted = shape_of(self.grid);
              if (shape != wanted) throw Error("previous has shape " + to_text(shape) + ": must be " + to_text(wanted));
              input.previous = &previous->solution.fields.traction;
            }
            const auto g = real_array("bound", bound, shape_of(self.grid));
            input.motion = motion;
            input.creepage = creepage_from(creepage);
            input.force_x = force_x;
            input.force_y = force_y;
            input.step = step;
            input.direction = direction;
            input.rolling_speed = rolling_speed;
            input.tolerance = tolerance;
            return TangentialResult{self.problem.run([&](TangentialProblem& problem, const Progress& progress) {
              input.progress = progress;
              return problem.solve(span_of(g), input);
            })};
          },
          "bound"_a, "creepage"_a, py::kw_only(), "kind"_a = ContactMotion::steady, "force_longitudinal"_a = py::none(),
          "force_lateral"_a = py::none(), "step"_a = 0.0, "direction"_a = RollingDirection::forward,
          "rolling_speed"_a = 1.0, "previous"_a = py::none(), "tolerance"_a = 1e-6,
          "Solves one problem, or one step: bound g = mu p_n [Pa], shape (my, mx), zero outside the contact;\n"
          "creepages [-], [-], [1/m], for a shift [m], [m], [rad]; force_longitudinal, force_lateral [N]\n"
          "on body 1 instead of the creepage in that direction; step dq [m], 0 the elements' length; rolling_speed V "
          "[m/s];\n"
          "previous: the TangentialSolution that a shift or a step of transient rolling starts from, none:\n"
          "no tractions; tolerance of the relative residual [-]. Returns TangentialSolution. Error for\n"
          "input out of range.");
}

} // namespace

void bind_grid_problems(py::module_& module) {
  bind_normal(module);
  bind_tangential_solution(module);
  bind_tangential(module);
}

} // namespace microslip::python
