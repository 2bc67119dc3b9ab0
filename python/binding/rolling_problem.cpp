#include "binding/rolling_problem.hpp"
#include "binding/bindings.hpp"
#include "binding/contact.hpp"
#include "binding/creep_table.hpp"
#include "binding/grid.hpp"
#include "binding/keywords.hpp"
#include "binding/words.hpp"
#include "io/case_file.hpp"

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Problem = const RollingProblem&;
using How = const Method&;

bool is_shift(Problem p) {
  return p.motion.kind == ContactMotion::shift;
}

/// A value where there is one.
template <class T> py::object given_if(bool is_there, const T& value) {
  return is_there ? py::cast(value) : py::none();
}

template <class Geometry> const Geometry* geometry(Problem p) {
  return std::get_if<Geometry>(&p.geometry);
}

py::object load_of(Problem p, NormalLoad::Given given) {
  return given_if(p.load.given == given, p.load.value);
}

py::object gap_of(Problem p) {
  if (const auto* curvatures = geometry<GapCurvatures>(p)) return py::cast(*curvatures);
  const auto* values = geometry<GapValues>(p);
  return values ? RealArray(shape_of(values->grid), values->gap.data()) : py::object(py::none());
}

py::object heat_of(Problem p) {
  return p.thermal ? py::object(py::make_tuple(p.thermal->body1, p.thermal->body2)) : py::none();
}

constexpr Keyword<RollingProblem> problem_keywords[] = {
    {"", "bodies", [](Problem p) { return p.layered ? py::cast(*p.layered) : py::cast(p.bodies); },
     "[-]: the CombinedMaterial of two bodies, or Bodies with a layer between them or viscoelastic ones, or "
     "LayeredBodies"},
    {"ellipse", "a", [](Problem p) { return geometry<Ellipse>(p) ? py::cast(geometry<Ellipse>(p)->a) : py::none(); }},
    {"ellipse", "b", [](Problem p) { return geometry<Ellipse>(p) ? py::cast(geometry<Ellipse>(p)->b) : py::none(); }},
    {"", "gap", gap_of,
     "[m]: in place of a and b, GapCurvatures or the distance h of the bodies at the centres of the grid's elements, "
     "shape (my, mx)"},
    {"", "grid", [](Problem p) { return geometry<GapValues>(p) ? py::cast(geometry<GapValues>(p)->grid) : py::none(); },
     "[m]: the ElementGrid of such a distance"},
    {"load", "normal_force", [](Problem p) { return load_of(p, NormalLoad::Given::force); }},
    {"load", "approach", [](Problem p) { return load_of(p, NormalLoad::Given::approach); }},
    {"", "friction", [](Problem p) { return py::cast(p.friction.law); },
     "[-]: a FrictionLaw, or a coefficient for Coulomb's"},
    {"friction", "memory_distance", [](Problem p) { return py::cast(p.friction.memory.distance); }},
    {"friction", "memory_speed", [](Problem p) { return py::cast(p.friction.memory.slowest); }},
    {"", "temperature_effect", [](Problem p) { return py::cast(p.friction.temperature_effect); },
     "[K]: the TemperatureEffect, what temperatures add to the friction"},
    {"", "thermal", heat_of, "[K]: the ThermalBody of both bodies, whose surfaces have temperatures then"},
    {"motion", "kind", [](Problem p) { return py::cast(p.motion.kind); }},
    {"motion", "creepage_longitudinal",
     [](Problem p) { return given_if(!is_shift(p) && !p.motion.force_x, p.motion.creepage.longitudinal); }},
    {"motion", "force_longitudinal", [](Problem p) { return py::cast(p.motion.force_x); }},
    {"motion", "creepage_lateral",
     [](Problem p) { return given_if(!is_shift(p) && !p.motion.force_y, p.motion.creepage.lateral); }},
    {"motion", "force_lateral", [](Problem p) { return py::cast(p.motion.force_y); }},
    {"motion", "spin", [](Problem p) { return given_if(!is_shift(p), p.motion.creepage.spin); }},
    {"motion", "shift_longitudinal",
     [](Problem p) { return given_if(is_shift(p) && !p.motion.force_x, p.motion.creepage.longitudinal); }},
    {"motion", "shift_lateral",
     [](Problem p) { return given_if(is_shift(p) && !p.motion.force_y, p.motion.creepage.lateral); }},
    {"motion", "rotation", [](Problem p) { return given_if(is_shift(p), p.motion.creepage.spin); }},
    {"motion", "rolling_speed", [](Problem p) { return given_if(!is_shift(p), p.motion.rolling_speed); }},
    {"motion", "direction", [](Problem p) { return py::cast(p.motion.direction); }},
    {"motion", "step", [](Problem p) { return given_if(p.motion.step > 0, p.motion.step); }},
    {"motion", "steps", [](Problem p) { return given_if(p.motion.kind == ContactMotion::transient, p.motion.steps); }},
};

constexpr Keyword<Method> method_keywords[] = {
    {"solution", "theory", [](How m) { return py::cast(m.theory); }},
    {"solution", "grid", [](How m) { return m.mx == m.my ? py::cast(m.mx) : py::make_tuple(m.mx, m.my); }},
    {"solution", "accuracy", [](How m) { return py::cast(m.accuracy); }},
    {"solution", "discretisation", [](How m) { return py::cast(m.discretisation); }},
    {"solution", "elements", [](How m) { return py::cast(m.elements); }},
    {"solution", "tolerance", [](How m) { return py::cast(m.tolerance); }},
    {"solution", "coupling", [](How m) { return py::cast(m.coupling); }},
    {"solution", "slip_start", [](How m) { return py::cast(m.slip_start); }},
    {"solution", "bound", [](How m) { return py::cast(m.bound); }},
    {"solution", "flexibility", [](How m) { return py::cast(m.flexibility); }},
    {"solution", "coefficients", [](How m) { return py::cast(m.coefficients); }},
    {"", "slope_reduction",
     [](How m) {
       const auto& [initial, at_infinity, decay] = m.slope_reduction;
       const bool reduces = m.slope_reduction != SlopeReduction{};
       return reduces ? py::make_tuple(initial, at_infinity, decay) : py::object(py::none());
     },
     "[-]: initial, at_infinity and decay, which lessen the creep curve's slope"},
    {"", "table", [](How m) { return py::cast(std::const_pointer_cast<CreepForceTable>(m.table)); },
     "[-]: the CreepForceTable of theory 'table'; left out: the one that microslip has"},
};

ContactGeometry geometry_from(const GivenKeywords& given) {
  if (given.has_section("ellipse") == given.has("gap")) throw Error("RollingProblem: needs either a and b or gap");
  const bool is_array = given.has("gap") && !py::isinstance<GapCurvatures>(given.object("gap"));
  if (given.has("grid") && !is_array) throw Error("RollingProblem: grid: needs gap as an array");
  if (!given.has("gap")) return io::read_ellipse(given.section("ellipse"));
  if (!is_array) return given.as<GapCurvatures>("gap");
  const auto grid = given.as<ElementGrid>("grid");
  const RealArray gap = real_array("gap", given.object("gap"), shape_of(grid));
  return GapValues{grid, {gap.data(), gap.data() + gap.size()}};
}

RollingProblem problem_from(const py::dict& keywords) {
  const GivenKeywords given("RollingProblem", keywords, known_of(problem_keywords));
  RollingProblem problem;
  problem.geometry = geometry_from(given);
  problem.load = io::read_load(given.section("load"));
  problem.friction.law = friction_from(given.object("friction"));
  problem.motion = io::read_motion(given.section("motion"));
  if (given.has("bodies") && py::isinstance<LayeredBodies>(given.object("bodies")))
    problem.layered = given.as<LayeredBodies>("bodies");
  else
    problem.bodies = given.as<Bodies>("bodies");
  const io::TomlSection friction = given.section("friction");
  problem.friction.memory = {friction.number("memory_distance"), friction.number("memory_speed")};
  if (given.has("temperature_effect"))
    problem.friction.temperature_effect = given.as<TemperatureEffect>("temperature_effect");
  if (!given.has("thermal")) return problem;
  const auto [body1, body2] = given.as<std::pair<ThermalBody, ThermalBody>>("thermal");
  problem.thermal = {body1, body2};
  return problem;
}

/// Reduction by the keywords of the table, in their order.
SlopeReduction slope_reduction_from(const GivenKeywords& given) {
  const auto values = given.as<std::array<double, 3>>("slope_reduction");
  const auto& inputs = description::rolling_inputs();
  auto value = values.begin();
  for (const std::string_view key : inputs.keys("solution.slope_reduction"))
    inputs.find("solution.slope_reduction", key)->bounds.require("slope_reduction." + std::string(key), *value++, "-");
  return {values[0], values[1], values[2]};
}

} // namespace

Method method_from_keywords(const py::dict& keywords) {
  const GivenKeywords given("Method", keywords, known_of(method_keywords));
  Method method = io::read_method(given.section("solution"));
  if (given.has("slope_reduction")) method.slope_reduction = slope_reduction_from(given);
  if (given.has("table") && method.theory != Theory::table) throw Incompatible(table_without_theory);
  if (given.has("table"))
    method.table = given.as<std::shared_ptr<CreepForceTable>>("table");
  else if (method.theory == Theory::table)
    method.table = std::make_shared<const CreepForceTable>(own_creep_table());
  return method;
}

namespace {

/// Keywords that stand for one another: a new one replaces those that a problem has.
constexpr std::pair<const char*, const char*> alternatives[] = {
    {"normal_force", "approach"},
    {"creepage_longitudinal", "force_longitudinal"},
    {"creepage_lateral", "force_lateral"},
    {"shift_longitudinal", "force_longitudinal"},
    {"shift_lateral", "force_lateral"},
    {"a", "gap"},
    {"b", "gap"},
    {"a", "grid"},
    {"b", "grid"},
};

RollingProblem replaced(const RollingProblem& problem, const py::dict& changes) {
  py::dict all = keywords_of(problem, problem_keywords);
  const auto drop = [&](const char* name) { all.attr("pop")(name, py::none()); };
  const auto changes_to = [&](const char* name) { return changes.contains(name) && !changes[name].is_none(); };
  if (changes_to("kind") && py::str("shift").equal(changes["kind"]) != is_shift(problem))
    for (const auto& keyword : problem_keywords)
      if (keyword.section == "motion") drop(keyword.name);
  for (const auto& [one, other] : alternatives) {
    if (changes_to(one)) drop(other);
    if (changes_to(other)) drop(one);
  }
  all.attr("update")(changes);
  return problem_from(all);
}

} // namespace

void bind_rolling_problem(py::module_& module) {
  py::class_<RollingProblem> problem(
      module, "RollingProblem",
      "Two bodies that roll or are shifted over each other: all that is given, by the keys of case files.");
  problem
      .def(py::init([](const EllipticContact& contact, const py::kwargs& beyond) {
             const RollingProblem of = rolling_problem(contact);
             return beyond.empty() ? of : replaced(of, beyond);
           }),
           "contact"_a, py::pos_only(),
           "That of an EllipticContact, whose numbers solvers check, with keywords beyond it or in place of its\n"
           "own ones [SI units].")
      .def(py::init([](const py::kwargs& given) { return problem_from(given); }),
           text_of("By keywords. Error for numbers out of range and what is missing.", problem_keywords).c_str())
      .def(
          "replace", [](const RollingProblem& self, const py::kwargs& changes) { return replaced(self, changes); },
          "Copy with other keywords [SI units]; None removes one. A force replaces a creepage, an\n"
          "approach in place of the force, and so on.");
  add_keywords(problem, problem_keywords, problem_from);
  py::implicitly_convertible<EllipticContact, RollingProblem>();

  py::class_<Method> method(module, "Method",
                            "Solution method of a RollingProblem; options left out take the best value for it.");
  method
      .def(py::init([](const py::kwargs& given) { return method_from_keywords(given); }),
           text_of("By keywords. Error for values out of range.", method_keywords).c_str())
      .def(
          "replace",
          [](const Method& self, const py::kwargs& changes) {
            py::dict all = keywords_of(self, method_keywords);
            all.attr("update")(changes);
            return method_from_keywords(all);
          },
          "Copy with other keywords [SI units]; None removes one.");
  add_keywords(method, method_keywords, method_from_keywords);
}

} // namespace microslip::python
