#include "cases/wheel_rail_result.hpp"

#include "cases/inputs.hpp"
#include "cases/interior_result.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/damage/contact_damage.hpp"
#include "microslip/railway/geometry/surface_hits.hpp"
#include "microslip/railway/geometry/wheel_locus.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace microslip::cases {
namespace {

/// Solutions, one of each state.
using Solutions = std::vector<const WheelRailSolution*>;

Solutions solutions_of(const WheelRailResult& result) {
  Solutions all;
  for (const WheelRailSolution& solution : result.solutions) all.push_back(&solution);
  return all;
}
Solutions solutions_of(const WheelsetResult& result, WheelRailSolution WheelsetSolution::*wheel) {
  Solutions all;
  for (const WheelsetSolution& solution : result.solutions) all.push_back(&(solution.*wheel));
  return all;
}

std::string of_states(std::size_t some, std::size_t all) {
  if (all == 1) return "";
  return " (" + std::to_string(some) + " of " + std::to_string(all) + " states)";
}

template <class Result> void add_status(Result& result) {
  const auto& all = result.solutions;
  const auto first = std::find_if(all.begin(), all.end(), [](const auto& s) { return s.status != Status::ok; });
  if (first == all.end()) return;
  result.status = first->status;
  const auto alike = std::count_if(all.begin(), all.end(), [&](const auto& s) { return s.status == first->status; });
  result.reason = std::string(to_string(first->reason)) + of_states(static_cast<std::size_t>(alike), all.size());
}

void add_profile_warnings(const io::PlacedProfile& profile, std::vector<std::string>& warnings) {
  for (const auto& warning : profile.report.warnings) warnings.push_back(profile.report.source + ": " + warning);
}

/// Adds what makes results doubtful, and how many of them; `which` wheel, if there are two; `only` one of the warnings,
/// by themselves unknown to wheels.
template <class Solutions>
void add_warnings(const Solutions& solutions, const std::string& which, std::vector<std::string>& warnings,
                  std::optional<Warning> only = {}) {
  for (const WarningInfo& one : warning_table()) {
    if (only && one.warning != *only) continue;
    const auto some = static_cast<std::size_t>(
        std::count_if(solutions.begin(), solutions.end(), [&](const auto* s) { return s->warnings.has(one.warning); }));
    if (some > 0) warnings.push_back(which + std::string(one.text) + of_states(some, solutions.size()));
  }
}

void write_varied(io::ResultWriter& file, const io::WheelRailSetting& input) {
  std::string varied;
  for (const auto name : input.varied) varied.append(varied.empty() ? "" : ", ").append(name);
  if (!varied.empty()) file.attribute("states", "varied", varied);
}

/// The numbers of the state that are not zero throughout, or that a sweep varies.
void write_states(io::ResultWriter& file, const io::WheelRailCase& input) {
  for (const StateQuantity& q : state_quantities()) {
    std::vector<double> values;
    for (const auto& [state, force] : input.states) values.push_back(q.value(state));
    const bool varies = std::find(input.varied.begin(), input.varied.end(), q.name) != input.varied.end();
    const bool is_zero = std::all_of(values.begin(), values.end(), [](double v) { return v == 0; });
    if (varies || !is_zero)
      file.array("states/" + std::string(q.name), values, std::string(q.unit), std::string(q.description));
  }
  if (input.states.front().vertical_force) {
    std::vector<double> values;
    for (const auto& [state, force] : input.states) values.push_back(force.value_or(0));
    const WheelInput& q = vertical_force_input();
    file.array("states/" + std::string(q.name), values, std::string(q.unit), std::string(q.description));
  }
  write_varied(file, input);
}

/// Writes the states of a wheelset, with the forces that are prescribed.
void write_states(io::ResultWriter& file, const io::WheelsetCase& input) {
  const auto varies = [&](std::string_view name) {
    return std::find(input.varied.begin(), input.varied.end(), name) != input.varied.end();
  };
  std::vector<double> values(input.states.size());
  for (const WheelsetStateQuantity& q : wheelset_state_quantities()) {
    std::transform(input.states.begin(), input.states.end(), values.begin(),
                   [&](const io::LoadedWheelsetState& s) { return q.value(s.state); });
    if (varies(q.name) || std::any_of(values.begin(), values.end(), [](double v) { return v != 0; }))
      file.array("states/" + q.name, values, std::string(q.of_wheel->unit), std::string(q.of_wheel->description));
  }
  for (const PrescribedForce& f : prescribed_forces()) {
    if (!(PrescribedWheelsetForces(input.states.front().load).*f.of)) continue;
    std::transform(input.states.begin(), input.states.end(), values.begin(), [&](const io::LoadedWheelsetState& s) {
      return (PrescribedWheelsetForces(s.load).*f.of).value_or(0);
    });
    file.array("states/" + std::string(f.name), values, std::string(f.unit),
               "prescribed, " + std::string(f.description));
  }
  write_varied(file, input);
}

std::uint8_t code_of(Status status) {
  return static_cast<std::uint8_t>(status);
}

template <class Of> void write_status(io::ResultWriter& file, const std::string& name, const std::vector<Of>& all) {
  std::vector<std::uint8_t> status(all.size());
  std::transform(all.begin(), all.end(), status.begin(), [](const auto& one) { return code_of(one->status); });
  file.array(name, status, "-", status_codes);
}

/// An array of each quantity that one of them has.
template <class Of>
void write_quantities(io::ResultWriter& file, const std::string& group, std::span<const RailwayQuantity<Of>> quantities,
                      const std::vector<const Of*>& all) {
  std::vector<double> values(all.size());
  for (const auto& q : quantities) {
    std::transform(all.begin(), all.end(), values.begin(), [&](const Of* one) { return q.value(*one); });
    if (std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); })) continue;
    file.array(group + std::string(q.name), values, std::string(q.unit), std::string(q.description));
  }
}

template <class Solutions>
void write_warning_codes(io::ResultWriter& file, const std::string& group, const Solutions& solutions) {
  std::vector<int> codes;
  codes.reserve(solutions.size());
  for (const auto* s : solutions) codes.push_back(static_cast<int>(s->warnings.code));
  file.array(group + "warning_code", codes, "-", warning_codes);
}

/// `group`: what stands before wheel/ and patches/.
void write_wheel(io::ResultWriter& file, const std::string& group, const Solutions& solutions) {
  write_quantities(file, group + "wheel/", wheel_quantities(), solutions);
  write_status(file, group + "wheel/status", solutions);
  std::vector<std::uint8_t> at_end;
  for (const WheelRailSolution* s : solutions) at_end.push_back(s->warnings.has(Warning::profile_end) ? 1 : 0);
  write_warning_codes(file, group + "wheel/", solutions);
  file.array(group + "wheel/at_profile_end", at_end, "-", profile_end_codes);
}

void write_patches(io::ResultWriter& file, const std::string& group, const Solutions& solutions) {
  std::vector<const WheelRailPatch*> patches;
  std::vector<int> of_state;
  for (std::size_t k = 0; k < solutions.size(); ++k)
    for (const WheelRailPatch& patch : solutions[k]->patches)
      patches.push_back(&patch), of_state.push_back(static_cast<int>(k));
  if (patches.empty()) return;
  file.array(group + "patches/state", of_state, "-", "index of the state that the patch belongs to, from 0");
  write_quantities(file, group + "patches/", patch_quantities(), patches);
  write_status(file, group + "patches/status", patches);
}

/// Stations of each piece of a profile, its ends included.
template <class Visit> void walk(const Profile& profile, const Visit& visit) {
  constexpr int stations = 4;
  for (const ProfilePiece& piece : profile.pieces())
    for (int k = 0; k < stations; ++k) visit(piece.at(piece.start + piece.length * k / stations));
  visit(profile.at(profile.length()));
}

void write_curve(io::ResultWriter& file, const std::string& group, const std::vector<double>& y,
                 const std::vector<double>& z, const std::string& axes) {
  file.array(group + "/y", y, "m", "y in " + axes);
  file.array(group + "/z", z, "m", "z in " + axes);
}

void write_profile(io::ResultWriter& file, const std::string& name, const PreparedProfile& prepared) {
  std::vector<double> y, z;
  walk(prepared.profile, [&](const CurvePoint& p) { y.push_back(p.value.y), z.push_back(p.value.z); });
  write_curve(file, "profiles/" + name, y, z, "the profile's axes: y to the field side, z up");
  file.attribute("profiles/" + name, "source", prepared.report.source);
}

/// Rail and wheel seen along the track, in track axes, at the height that was found.
void write_outlines(io::ResultWriter& file, const io::WheelRailCase& input, const WheelRailSolution& solution) {
  const double sign = input.side == TrackSide::right ? -1 : 1;
  WheelState<double> state = input.states.front().state;
  if (sign < 0) state = state.mirrored();
  state.vertical = solution.vertical;
  const auto nominal = nominal_placement(input.track, input.rail.profile, input.wheelset, input.wheel.profile);
  const WheelPlacement<double> placed = place(nominal, state);
  const bool touches = !solution.patches.empty(); // else a rail may be interrupted
  const auto section = [&](const io::PlacedProfile& profile, double u) {
    return touches ? section_at({&profile.profile, profile.surface.get()}, u).profile : profile.profile;
  };
  const Profile rail = section(input.rail, placed.longitudinal + placed.wheel.frame.origin.x),
                wheel = section(input.wheel, placed.pitch);
  std::vector<double> y, z;
  const auto add = [&](const Vec3<double>& point) { y.push_back(sign * point.y), z.push_back(point.z); };
  walk(rail, [&](const CurvePoint& p) { add(placed.rail_point(0, p.value.y, p.value.z)); });
  write_curve(file, "outlines/rail", y, z, "track axes: to the left, up");
  y.clear(), z.clear();
  const WheelLocus<double> locus(placed.wheel.frame, placed.radius);
  walk(wheel, [&](const CurvePoint& p) {
    const double speed = std::hypot(p.first.y, p.first.z);
    const auto point = locus.at({.place = p.value, .cosine = p.first.y / speed, .sine = p.first.z / speed});
    if (point.exists) add(point.place);
  });
  write_curve(file, "outlines/wheel", y, z, "track axes: to the left, up");
}

/// Writes the fields of a patch in its frame.
void write_fields(io::ResultWriter& file, const std::string& group, const ContactSolution& solution,
                  const WheelRailPatch& patch, const SurfaceStrength& strength) {
  const io::ResultWriter::Shape shape = {static_cast<std::size_t>(solution.elements.my()),
                                         static_cast<std::size_t>(solution.elements.mx())};
  for (const FieldQuantity& f : field_quantities())
    if (!f.values(solution).empty())
      file.array(group + std::string(f.name), f.values(solution), std::string(f.unit_of(solution)),
                 std::string(f.description), shape);
  for (const DamageField& f : damage_fields())
    if (const auto values = f.values(solution, strength, patch.rolling_speed); !values.empty())
      file.array(group + std::string(f.name), values, std::string(f.unit), std::string(f.description), shape);
  std::vector<std::uint8_t> states;
  for (const CellState state : solution.fields.state) states.push_back(static_cast<std::uint8_t>(state));
  file.array(group + "state", states, "-", "0 exterior, 1 adhesion, 2 slip", shape);
}

/// Writes the fields of all patches, one after another.
void write_fields(io::ResultWriter& file, const std::string& group, const Solutions& solutions,
                  const SurfaceStrength& strength) {
  std::size_t index = 0;
  for (const WheelRailSolution* solution : solutions) {
    for (std::size_t i = 0; i < solution->fields.size(); ++i)
      write_fields(file, group + "fields/" + std::to_string(index + i) + "/", solution->fields[i], solution->patches[i],
                   strength);
    index += solution->patches.size();
  }
}

void write_profiles(io::ResultWriter& file, const io::WheelRailSetting& input) {
  write_profile(file, "rail", input.rail);
  write_profile(file, "wheel", input.wheel);
}

void write_warnings(io::ResultWriter& file, const std::vector<std::string>& all) {
  std::string warnings;
  for (const auto& warning : all) warnings.append(warnings.empty() ? "" : "\n").append(warning);
  if (!warnings.empty()) file.attribute("/", "warnings", warnings);
}

template <class Input, class Result>
io::Json document_of(const Input& input, const Result& result, const io::Provenance& provenance,
                     io::JsonFields fields) {
  io::JsonResult written(provenance, fields);
  write_result(input, result, written);
  io::Json document = written.document();
  document["status"] = to_string(result.status);
  document["warnings"] = result.warnings;
  return document;
}

/// Solves all states; `solve` makes a solution of each and may report its progress, without a fraction.
template <class Result, class Input, class Solve>
Result solve_states(const Input& input, const Progress& progress, const Solve& solve) {
  Result result;
  for (const auto& state : input.states) {
    const double done = static_cast<double>(result.solutions.size()) / static_cast<double>(input.states.size());
    go_on(progress, done);
    result.solutions.push_back(solve(state, essential_part(progress, done, done)));
  }
  go_on(progress, 1);
  add_status(result);
  for (const io::PlacedProfile* profile : {&input.rail, &input.wheel}) add_profile_warnings(*profile, result.warnings);
  return result;
}

} // namespace

WheelRailMethod solving_method(const io::WheelRailCase& input) {
  WheelRailMethod method = input.method;
  method.fields = method.theory != Theory::table && (input.interior.count() > 0 || input.states.size() == 1);
  return method;
}

WheelRailResult solve_case(const io::WheelRailCase& input, const Progress& progress) {
  WheelRail solver = io::solver_of(input, solving_method(input));
  return solve_case(input, solver, progress);
}

WheelRailResult solve_case(const io::WheelRailCase& input, WheelRail& solver, const Progress& progress) {
  const bool has_points = input.interior.count() > 0, is_single = input.states.size() == 1;
  const std::optional<LayeredBodies> layered = input.layers.on(input.material);
  std::vector<std::vector<InteriorState>> interior;
  std::vector<LayeredPeaks> peaks;
  auto result =
      solve_states<WheelRailResult>(input, progress, [&](const io::LoadedWheelState& s, const Progress& within) {
        solver.reset(); // states do not depend on each other
        WheelRailSolution solution = solver.solve(s.state, s.vertical_force, within);
        for (const ContactSolution& fields : solution.fields)
          if (has_points)
            interior.push_back(interior_states(io::interior_body(input, Body::first),
                                               io::interior_body(input, Body::second), fields, input.interior, within));
        if (layered && is_single)
          for (const ContactSolution& fields : solution.fields)
            peaks.push_back(layered_peaks(*layered, fields, within));
        // Of a sweep with the theory fastsim2 they were needed for stresses only.
        if (!is_single && input.method.theory == Theory::fastsim2) solution.fields.clear();
        return solution;
      });
  result.interior = std::move(interior);
  result.peaks = std::move(peaks);
  add_warnings(solutions_of(result), "", result.warnings);
  return result;
}

WheelsetResult solve_case(const io::WheelsetCase& input, const Progress& progress) {
  WheelRailMethod method = input.method;
  method.fields = method.theory != Theory::table && input.states.size() == 1;
  WheelsetOnTrack solver = io::solver_of(input, method);
  auto result =
      solve_states<WheelsetResult>(input, progress, [&](const io::LoadedWheelsetState& s, const Progress& within) {
        solver.reset();
        return solver.solve(s.state, s.load, within);
      });
  for (const auto* profile : {&input.right_rail, &input.right_wheel})
    if (*profile) add_profile_warnings(**profile, result.warnings);
  std::vector<const WheelsetSolution*> wheelsets;
  for (const WheelsetSolution& solution : result.solutions) wheelsets.push_back(&solution);
  add_warnings(solutions_of(result, &WheelsetSolution::left), "left wheel: ", result.warnings);
  add_warnings(solutions_of(result, &WheelsetSolution::right), "right wheel: ", result.warnings);
  add_warnings(wheelsets, "", result.warnings, Warning::wheel_lifted);
  return result;
}

void write_result(const io::WheelRailCase& input, const WheelRailResult& result, io::ResultWriter& file) {
  write_inputs(file, input.inputs, description::wheel_inputs());
  write_states(file, input);
  const Solutions solutions = solutions_of(result);
  write_wheel(file, "", solutions);
  write_patches(file, "", solutions);
  write_profiles(file, input);
  if (input.states.size() == 1) write_outlines(file, input, result.solutions.front());
  write_fields(file, "", solutions, input.strength);
  for (std::size_t patch = 0; patch < result.interior.size(); ++patch)
    write_interior(file, "interior/" + std::to_string(patch) + "/", input.interior, result.interior[patch]);
  for (std::size_t patch = 0; patch < result.peaks.size(); ++patch)
    write_peaks(file, "layers/" + std::to_string(patch) + "/", result.peaks[patch]);
  write_warnings(file, result.warnings);
}

void write_result(const io::WheelsetCase& input, const WheelsetResult& result, io::ResultWriter& file) {
  write_inputs(file, input.inputs, description::wheelset_inputs());
  write_states(file, input);
  std::vector<const WheelsetSolution*> all;
  for (const WheelsetSolution& solution : result.solutions) all.push_back(&solution);
  write_quantities(file, "wheelset/", wheelset_quantities(), all);
  write_status(file, "wheelset/status", all);
  write_warning_codes(file, "wheelset/", all);
  for (const bool right : {false, true}) {
    const std::string group = right ? "right/" : "left/";
    const Solutions solutions = solutions_of(result, right ? &WheelsetSolution::right : &WheelsetSolution::left);
    write_wheel(file, group, solutions);
    write_patches(file, group, solutions);
    write_fields(file, group, solutions, input.strength);
  }
  write_profiles(file, input);
  if (input.right_rail) write_profile(file, "right_rail", *input.right_rail);
  if (input.right_wheel) write_profile(file, "right_wheel", *input.right_wheel);
  write_warnings(file, result.warnings);
}

io::Json case_document(const io::WheelRailCase& input, const WheelRailResult& result, const io::Provenance& provenance,
                       io::JsonFields fields) {
  io::Json document = document_of(input, result, provenance, fields);
  for (const auto& states : result.interior)
    document["interior_extremes"].push_back(extremes_json(input.interior, states));
  return document;
}
io::Json case_document(const io::WheelsetCase& input, const WheelsetResult& result, const io::Provenance& provenance,
                       io::JsonFields fields) {
  return document_of(input, result, provenance, fields);
}

} // namespace microslip::cases
