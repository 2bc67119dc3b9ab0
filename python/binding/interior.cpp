#include "binding/interior.hpp"
#include "binding/bindings.hpp"
#include "binding/grid.hpp"
#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "io/option_words.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <string>

namespace microslip::python {

template <> inline constexpr auto fields<States> = members<&States::shape, &States::states>;

namespace {

namespace py = pybind11;
using namespace py::literals;

/// Calls function(state) for all, which Ctrl-C ends.
void for_states(const States& self, auto function) {
  constexpr std::size_t at_once = 1024;
  SignalCheck signals;
  for (std::size_t k = 0; k < self.states.size(); ++k) {
    if (k % at_once == 0) signals();
    function(self.states[k]);
  }
}

RealArray values(const States& self, const auto& value) {
  RealArray out(self.shape);
  for_states(self, [&, next = out.mutable_data()](const InteriorState& s) mutable { *next++ = value(s); });
  return out;
}

auto displacement(double InteriorState::*member) {
  return [member](const States& self) { return values(self, [member](const InteriorState& s) { return s.*member; }); };
}

auto stress(double Stress::*member) {
  return [member](const States& self) {
    return values(self, [member](const InteriorState& s) { return s.stress.*member; });
  };
}

auto measure(StressMeasure of) {
  return [of](const States& self) { return values(self, [of](const InteriorState& s) { return of(s.stress); }); };
}

RealArray principal(const States& self) {
  auto shape = self.shape;
  shape.push_back(3);
  RealArray out(shape);
  for_states(self, [next = out.mutable_data()](const InteriorState& s) mutable {
    next = std::ranges::copy(principal_stresses(s.stress), next).out;
  });
  return out;
}

void bind_states(py::module_& module) {
  py::class_<States> states(module, "InteriorStates",
                            "Displacements and stresses at points of a body: arrays with the points' shape (...).");
  states.def_property_readonly("ux", displacement(&InteriorState::ux), "Displacement of this body, shape (...) [m].")
      .def_property_readonly("uy", displacement(&InteriorState::uy), "Displacement of this body, shape (...) [m].")
      .def_property_readonly("uz", displacement(&InteriorState::uz), "Displacement of this body, shape (...) [m].")
      .def_property_readonly("xx", stress(&Stress::xx), "sigma_xx, tension positive, shape (...) [Pa].")
      .def_property_readonly("yy", stress(&Stress::yy), "sigma_yy, tension positive, shape (...) [Pa].")
      .def_property_readonly("zz", stress(&Stress::zz), "sigma_zz, tension positive, shape (...) [Pa].")
      .def_property_readonly("xy", stress(&Stress::xy), "sigma_xy, shape (...) [Pa].")
      .def_property_readonly("xz", stress(&Stress::xz), "sigma_xz, shape (...) [Pa].")
      .def_property_readonly("yz", stress(&Stress::yz), "sigma_yz, shape (...) [Pa].")
      .def_property_readonly("hydrostatic", measure(&hydrostatic), "(xx + yy + zz)/3, shape (...) [Pa].")
      .def_property_readonly("von_mises", measure(&von_mises), "Von Mises' stress, the root of 3 J2, shape (...) [Pa].")
      .def_property_readonly("tresca", measure(&tresca),
                             "sigma1 - sigma3, twice the largest shear stress, shape (...) [Pa].")
      .def_property_readonly("principal", &principal, "sigma1 >= sigma2 >= sigma3, shape (..., 3) [Pa].");
  add_value(states, {"von_mises"});
  add_labelled_arrays(states);
}

Body body_from(int body) {
  return require_count("body", body, 1, 2) == 1 ? Body::first : Body::second;
}

RealArray tractions(const char* field, const py::object& given, const ElementGrid& grid) {
  return given.is_none() ? RealArray(0) : real_array(field, given, shape_of(grid));
}

InteriorField make_field(const Material& material, int body, const ElementGrid& grid, const py::object& px,
                         const py::object& py_, const py::object& pn) {
  const auto along = tractions("px", px, grid), across = tractions("py", py_, grid), down = tractions("pn", pn, grid);
  return {material, body_from(body), grid, {span_of(along), span_of(across), span_of(down)}};
}

States at_points(const InteriorField& field, const py::object& x, const py::object& y, const py::object& depth) {
  RealArray points[] = {real_array("x", x), real_array("y", y), real_array("depth", depth)};
  States out;
  broadcast(out.shape, "x", points[0]);
  broadcast(out.shape, "y", points[1]);
  broadcast(out.shape, "depth", points[2]);
  for (auto& array : points) array = spread(array, out.shape);
  const double *xs = points[0].data(), *ys = points[1].data(), *depths = points[2].data();
  const auto count = static_cast<std::size_t>(points[0].size());
  out.states.resize(count);
  const auto elements = std::max<std::size_t>(1, field.grid().count());
  run_batch(count, std::clamp<std::size_t>(50000 / elements, 1, 1000), thread_count(0), [&]() -> BatchWorker {
    return [&](std::size_t first, std::size_t n, const Progress& progress) {
      for (std::size_t i = first; i < first + n; ++i) out.states[i] = field.at({xs[i], ys[i], depths[i]}, progress);
    };
  });
  return out;
}

StressMeasure measure_named(const std::string& name) {
  static const std::string_view words[] = {"von_mises", "tresca", "hydrostatic"};
  static constexpr StressMeasure measures[] = {von_mises, tresca, hydrostatic};
  io::require_word("measure", name, words);
  return measures[std::find(std::begin(words), std::end(words), name) - std::begin(words)];
}

void bind_peak(py::module_& module) {
  auto peak =
      py::class_<InteriorPeak>(module, "InteriorPeak", "The largest value of a measure of stress, and where it is.");
  peak.def_readonly("value", &InteriorPeak::value, "The value [Pa].")
      .def_property_readonly(
          "x", [](const InteriorPeak& self) { return self.point.x; }, "Where it is [m].")
      .def_property_readonly(
          "y", [](const InteriorPeak& self) { return self.point.y; }, "Where it is [m].")
      .def_property_readonly(
          "depth", [](const InteriorPeak& self) { return self.point.depth; }, "Below the surface [m].");
  add_value(peak, {"value", "x", "y", "depth"});
}

void bind_field(py::module_& module) {
  const auto none = py::none();
  py::class_<InteriorField>(
      module, "InteriorField",
      "Displacements and stresses in a body from the tractions on its surface, as sums over the\n"
      "elements of a grid. Elastic half-space; a line contact gives the plane field of endless strips.\n"
      "Exact for tractions that are constant in each element; those of a contact are not, which is felt\n"
      "nearer to the surface than about an element.")
      .def(py::init(&make_field), "material"_a, "body"_a, "grid"_a, py::kw_only(), "px"_a = none, "py"_a = none,
           "pn"_a = none,
           "body 1 (wheel, z > 0) or 2 (rail) [-]; px, py, pn [Pa] are the tractions **on body 1** of the\n"
           "grid's elements, shape (my, mx), none: zero. Error for what is out of range or not finite.")
      .def("at", &at_points, "x"_a, "y"_a, "depth"_a,
           "At points x, y [m], depth >= 0 below the surface [m]: numbers or arrays that broadcast to\n"
           "shape (...). Returns InteriorStates. Cost 0.3 us for every point and element with tractions;\n"
           "Ctrl-C ends it.")
      .def_property_readonly("grid", &InteriorField::grid, "The elements, as ElementGrid.");

  py::class_<OneAtATime<InteriorLayers>>(
      module, "InteriorLayers",
      "States at the centres of all elements in planes of constant depth, by fast transforms: 4 to 8 us a point.")
      .def(py::init([](const InteriorField& field, int margin) {
             return long_work([&](const Progress& progress) {
               return std::make_unique<OneAtATime<InteriorLayers>>(field, margin, progress);
             });
           }),
           "field"_a, "margin"_a = 0,
           "Points at the centres of the field's elements and of `margin` more columns and rows on each side [-].")
      .def_property_readonly(
          "grid", [](const OneAtATime<InteriorLayers>& self) { return self.object.grid(); },
          "Grid of the points, an ElementGrid.")
      .def(
          "at_depth",
          [](OneAtATime<InteriorLayers>& self, double depth) {
            return States{shape_of(self.object.grid()),
                          self.run([depth](InteriorLayers& layers, const Progress& progress) {
                            return layers.at_depth(depth, progress);
                          })};
          },
          "depth"_a, "States at the points in the depth [m] >= 0, shape (my, mx), as InteriorStates.")
      .def(
          "find_largest",
          [](OneAtATime<InteriorLayers>& self, const py::object& depths, const std::string& name) {
            const auto planes = real_array("depths", depths);
            if (planes.ndim() != 1) throw Error("depths: must be a list of numbers");
            const auto of = measure_named(name);
            return self.run([&](InteriorLayers& layers, const Progress& progress) {
              return find_largest(layers, span_of(planes), of, progress);
            });
          },
          "depths"_a, "measure"_a = "von_mises",
          "The largest value [Pa] of 'von_mises', 'tresca' or 'hydrostatic' and where it is, as\n"
          "InteriorPeak: the best point of the planes `depths` [m], ascending, shape (n), and from there a\n"
          "search. The largest one if the planes are close enough.");
}

} // namespace

void bind_interior(py::module_& module) {
  bind_states(module);
  bind_peak(module);
  bind_field(module);
}

} // namespace microslip::python
