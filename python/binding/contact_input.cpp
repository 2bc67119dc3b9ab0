#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/grid.hpp"
#include "binding/long_work.hpp"
#include "binding/paths.hpp"
#include "binding/value.hpp"
#include "compat/contact/run.hpp"
#include "io/input_file.hpp"
#include "microslip/error.hpp"

#include <cerrno>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

namespace microslip::python {

using contact_program::PrintedTotals;

template <>
inline constexpr auto fields<PrintedTotals> =
    members<&PrintedTotals::fn, &PrintedTotals::fx, &PrintedTotals::fy, &PrintedTotals::mz,
            &PrintedTotals::elastic_energy, &PrintedTotals::friction, &PrintedTotals::fn_over_g, &PrintedTotals::x_name,
            &PrintedTotals::y_name, &PrintedTotals::x, &PrintedTotals::y, &PrintedTotals::approach,
            &PrintedTotals::peak_pressure, &PrintedTotals::temperature, &PrintedTotals::potential,
            &PrintedTotals::contact, &PrintedTotals::adhesion, &PrintedTotals::slip>;

namespace {

namespace py = pybind11;
using namespace py::literals;
using contact_program::Outcome;

/// A case of a CONTACT file and what became of it.
struct RunCase {
  int number = 0;
  std::size_t line = 0;
  Outcome outcome = {};
};

/// Reads and runs the cases of a file one after the other, in constant memory.
class Run {
public:
  explicit Run(const std::string& path) : file_(path) {}

  /// Throws py::stop_iteration at the end.
  RunCase next() {
    std::optional<RunCase> found = file_.run([](File& file, const Progress& progress) -> std::optional<RunCase> {
      const contact_program::Case* c = file.reader.next();
      if (c == nullptr) return std::nullopt;
      return RunCase{c->number, c->line, file.run.run(*c, progress)};
    });
    if (!found) throw py::stop_iteration();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return std::move(*found);
  }

private:
  struct File {
    explicit File(const std::string& path) : stream(io::open_input(path)), reader(stream, path) {}

    std::ifstream stream;
    contact_program::InputReader reader;
    contact_program::Run run;
  };
  OneAtATime<File> file_;
};

const char* name_of(Outcome::Kind kind) {
  constexpr const char* names[] = {"solved", "skipped", "refused"};
  return names[static_cast<int>(kind)];
}

/// A separate contact; the patches of a wheel have what follows from one.
bool is_solved(const RunCase& self) {
  return self.outcome.kind == Outcome::Kind::solved && !self.outcome.wheel;
}

/// A patch of a wheel; it shares its solution with the case.
struct RunPatch {
  contact_program::PatchLocation location; ///< in m; what follows in CONTACT's units
  double velocity = 0, xi = 0, eta = 0, phi = 0;
  std::vector<int> previous;
  std::shared_ptr<const Outcome> solution;
};

std::vector<double> components_of(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}
std::vector<double> in_mm(const Vec3<double>& v) {
  return components_of(1e3 * v);
}

std::vector<RunPatch> patches_of(const RunCase& self) {
  std::vector<RunPatch> patches;
  if (self.outcome.wheel)
    for (const auto& p : self.outcome.wheel->patches) {
      const contact_program::Digits& d = p.contact.digits;
      patches.push_back({p.location, p.contact.rolling ? p.contact.rolling->veloc * 1e3 : 0, in_file(p.contact.x, d),
                         in_file(p.contact.y, d), p.contact.phi / unit_of_spin(d), p.previous, p.solution});
    }
  return patches;
}

NormalResult normal_of(const Outcome& outcome) {
  return {outcome.solution.normal, shape_of(outcome.step.grid)};
}
TangentialResult tangential_of(const Outcome& outcome) {
  return {outcome.solution};
}

void bind_patch(py::module_& module) {
  py::class_<RunPatch> patch(module, "ContactPatch",
                             "A contact patch of a wheel on a rail (module 1), with CONTACT's signs and units.");
  patch
      .def_property_readonly(
          "track", [](const RunPatch& self) { return in_mm(self.location.track); },
          "XCP, YCP, ZCP in the track's axes [mm], shape (3,).")
      .def_property_readonly(
          "rail", [](const RunPatch& self) { return in_mm(self.location.rail); },
          "XCP, YCP, ZCP in the axes of the rail's profile [mm], shape (3,).")
      .def_property_readonly(
          "wheel", [](const RunPatch& self) { return in_mm(self.location.wheel); },
          "XCP, YCP, ZCP in the axes of the wheel's profile [mm], shape (3,).")
      .def_property_readonly(
          "angle", [](const RunPatch& self) { return self.location.angle; }, "DELTCP in the track's axes [rad].")
      .def_readonly("velocity", &RunPatch::velocity, "VELOC [mm/s].")
      .def_readonly("cksi", &RunPatch::xi, "CKSI [-], in a shift [mm].")
      .def_readonly("ceta", &RunPatch::eta, "CETA [-], in a shift [mm].")
      .def_readonly("cphi", &RunPatch::phi, "CPHI [rad/mm], in a shift [rad].")
      .def_readonly("previous", &RunPatch::previous,
                    "Numbers, from 1, of the patches of the case before that it goes on from [-].")
      .def_property_readonly(
          "totals", [](const RunPatch& self) { return self.solution->totals; },
          "ContactTotals, CONTACT's units [N], [mm]; fy is FS.")
      .def_property_readonly(
          "status", [](const RunPatch& self) { return self.solution->solution.report.status; },
          "Outcome of the calculation, a Status [-].")
      .def_property_readonly(
          "grid", [](const RunPatch& self) { return self.solution->step.grid; }, "The ElementGrid, SI units.")
      .def_property_readonly(
          "normal", [](const RunPatch& self) { return normal_of(*self.solution); }, "The NormalSolution, SI units.")
      .def_property_readonly(
          "tangential", [](const RunPatch& self) { return tangential_of(*self.solution); },
          "The TangentialSolution, SI units.");
  add_description(patch, {"track", "angle", "cksi", "ceta", "cphi", "totals"});
}

void bind_totals(py::module_& module) {
  py::class_<PrintedTotals> totals(
      module, "ContactTotals",
      "The quantities that CONTACT prints for a case, with its signs and units: mm and N, on body 1.");
  add_members(
      totals, Shown<&PrintedTotals::fn>{"FN [N]."}, Shown<&PrintedTotals::fx>{"FX [N]."},
      Shown<&PrintedTotals::fy>{"FY [N]."}, Shown<&PrintedTotals::mz>{"MZ [N mm]."},
      Shown<&PrintedTotals::elastic_energy>{"ELAST.EN. [J]."},
      Shown<&PrintedTotals::friction>{"FRIC.POWER [W], for shifts FRIC.WORK [J]; negative where energy is lost."},
      Shown<&PrintedTotals::fn_over_g>{"FN/G [mm^2]."},
      Shown<&PrintedTotals::x_name>{"What x is: FX/FSTAT/FN, or CREEP X, SHIFT X where the force is prescribed."},
      Shown<&PrintedTotals::x>{"[-], for a shift [mm]."},
      Shown<&PrintedTotals::y_name>{"What y is: FY/FSTAT/FN, or CREEP Y, SHIFT Y where the force is prescribed."},
      Shown<&PrintedTotals::y>{"[-], for a shift [mm]."}, Shown<&PrintedTotals::approach>{"APPROACH [mm]."},
      Shown<&PrintedTotals::peak_pressure>{"PMAX [N/mm^2]."},
      Shown<&PrintedTotals::potential>{"NPOT, elements of the potential contact [-]."},
      Shown<&PrintedTotals::contact>{"NCON, elements in contact [-]."},
      Shown<&PrintedTotals::adhesion>{"NADH, elements in adhesion [-]."},
      Shown<&PrintedTotals::slip>{"NSLIP, elements in slip [-]."});
  add_value(totals, {"fn", "fx", "fy", "mz", "approach", "peak_pressure", "contact", "adhesion", "slip"});
}

/// Attribute that solved cases have, except wheels: None of others.
template <class Get> auto of_solved(Get get) {
  return [get](const RunCase& self) { return is_solved(self) ? std::optional(get(self.outcome)) : std::nullopt; };
}

void bind_case(py::module_& module) {
  py::class_<RunCase> run_case(module, "ContactCase", "A case of a CONTACT input file and what became of it.");
  run_case.def_readonly("number", &RunCase::number, "In the file, from 1 [-].")
      .def_readonly("line", &RunCase::line, "Where it begins in the file, from 1 [-].")
      .def_property_readonly(
          "outcome", [](const RunCase& self) { return name_of(self.outcome.kind); },
          "solved, skipped (as the file says) or refused.")
      .def_property_readonly(
          "reasons", [](const RunCase& self) { return self.outcome.reasons; }, "Why it was refused.")
      .def_property_readonly(
          "notes", [](const RunCase& self) { return self.outcome.notes; }, "What was left out or done differently.")
      .def_property_readonly(
          "status", [](const RunCase& self) { return self.outcome.solution.report.status; },
          "Outcome of the calculation, a Status [-].")
      .def_property_readonly("totals", of_solved([](const Outcome& outcome) { return outcome.totals; }),
                             "ContactTotals, CONTACT's units [N], [mm]; None unless solved, and for a wheel.")
      .def_property_readonly("grid", of_solved([](const Outcome& outcome) { return outcome.step.grid; }),
                             "The ElementGrid, SI units; None unless solved, and for a wheel.")
      .def_property_readonly("normal", of_solved(normal_of),
                             "The NormalSolution, SI units; None unless solved, and for a wheel.")
      .def_property_readonly("tangential", of_solved(tangential_of),
                             "The TangentialSolution, SI units; None unless solved, and for a wheel.");
  const auto of_wheel = [&](const char* name, auto member, const char* text) {
    run_case.def_property_readonly(
        name,
        [member](const RunCase& self) {
          const auto& wheel = self.outcome.wheel;
          return wheel ? std::optional(components_of(member(*wheel))) : std::nullopt;
        },
        text);
  };
  using contact_program::WheelOutcome;
  of_wheel(
      "force_on_rail", [](const WheelOutcome& w) { return w.track.force; },
      "FX(TR), FY(TR), FZ(TR) of a wheel [N], shape (3,); None for an independent contact.");
  of_wheel(
      "moment_on_rail", [](const WheelOutcome& w) { return 1e3 * w.track.moment; },
      "About the rail's marker in the track's axes [N mm], shape (3,); None for an independent contact.");
  run_case.def_property_readonly("patches", patches_of,
                                 "ContactPatch of each patch of a wheel [-]; empty for an independent contact.");
  run_case.def_property_readonly(
      "wheel_height",
      [](const RunCase& self) {
        return self.outcome.wheel ? std::optional(self.outcome.wheel->z * 1e3) : std::nullopt;
      },
      "Z_WS of a wheel, as given or found [mm]; None for an independent contact.");
  add_description(run_case, {"number", "line", "outcome", "status", "totals"});
}

} // namespace

void bind_contact_input(py::module_& module) {
  bind_totals(module);
  bind_patch(module);
  bind_case(module);
  py::class_<Run>(module, "ContactRun",
                  "The cases of a CONTACT input file, solved one after the other as they are iterated over.")
      .def("__iter__", [](Run& self) -> Run& { return self; })
      .def("__next__", &Run::next);
  module.def(
      "run_contact_input", [](const py::object& path) { return std::make_unique<Run>(readable_path(path)); }, "path"_a,
      "Runs the cases of an input file of the program CONTACT, modules 1 and 3, in their order, each with what\n"
      "the ones before it have left: `for case in run_contact_input(path)` gives ContactCase, totals in\n"
      "CONTACT's units [N], [mm], fields in SI units. Memory does not grow with the number of cases. A\n"
      "case that asks for something unsupported is refused with its reasons, and the others run. Error\n"
      "with file, line and field for what is against the grammar, when the case is reached.");
}

} // namespace microslip::python
