// A wheel on a rail, or MICROSLIP_FMU_WHEELS of a vehicle, as a unit. Parameters are the inputs of case files by their
// paths, inputs and results those of the tables of quantities.

#include "fmi/model.hpp"
#include "io/case_inputs.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/rows/row_contact.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace microslip::fmi {
namespace {

using description::InputKind;
using description::NamedInput;

constexpr std::string_view kind_of_case = description::case_kinds[1];
constexpr std::size_t patches_shown = MICROSLIP_FMU_PATCHES;
/// Of a vehicle the wheels are left and right ones by turns.
constexpr std::size_t wheels = MICROSLIP_FMU_WHEELS;
constexpr bool is_vehicle = wheels > 1;
/// Number of outputs of wheel_results(): forces, moments and height are outputs, since they have derivatives.
constexpr std::size_t outputs = differentiated_results;

/// Start values of inputs that a case file must have.
constexpr std::pair<std::string_view, double> start_numbers[] = {{"track.gauge", 1.435},
                                                                 {"wheelset.nominal_radius", 0.46},
                                                                 {"wheelset.flange_back_distance", 1.36},
                                                                 {"material.young_modulus", 210e9},
                                                                 {"material.poisson_ratio", 0.28},
                                                                 {"friction.coefficient", 0.3}};
constexpr std::pair<std::string_view, const char*> start_files[] = {{"rail.profile", "60e1.prr"},
                                                                    {"wheelset.profile", "s1002.prw"}};

bool is_text(const NamedInput& named) {
  return named.input->kind == InputKind::text || named.input->kind == InputKind::word;
}

/// Start value of a parameter; an empty text leaves the key out.
template <class Start, std::size_t count>
std::optional<Start> start_in(const std::pair<std::string_view, Start> (&starts)[count], const NamedInput& named) {
  for (const auto& [path, start] : starts)
    if (path == named.path) return start;
  return {};
}
std::optional<double> start_number(const NamedInput& named) {
  const auto given = start_in(start_numbers, named);
  return given ? given : named.input->missing;
}

/// Returns true for inputs of a wheel on a rail except lists and numbers that a case may leave open.
bool is_parameter(const NamedInput& named) {
  const std::string_view section = named.input->section, path = named.path;
  if (named.input->is_state || named.input->is_in_list || section.empty() || section == "interior" ||
      path.starts_with("right_") || (is_vehicle && path == "wheel.side"))
    return false;
  return is_text(named) || (named.input->kind != InputKind::numbers && start_number(named));
}

const std::vector<NamedInput>& parameters() {
  static const std::vector<NamedInput> all = [] {
    std::vector<NamedInput> some;
    for (const NamedInput& named : description::inputs_of(kind_of_case).named())
      if (is_parameter(named)) some.push_back(named);
    return some;
  }();
  return all;
}

Variable parameter(const NamedInput& named) {
  const description::Input& input = *named.input;
  Variable v{.name = named.path, .description = std::string(input.text), .causality = Causality::parameter};
  if (!is_text(named)) {
    v.kind = input.kind == InputKind::whole ? Kind::integer : Kind::real;
    v.unit = input.unit;
    v.start = *start_number(named);
    v.min = input.bounds.least(), v.max = input.bounds.largest();
    return v;
  }
  v.kind = Kind::text;
  v.start_text = start_in(start_files, named).value_or("");
  if (v.start_text.empty()) v.start_text = input.missing_word;
  if (!named.range.empty()) v.description += ": " + named.range;
  return v;
}

void set(io::CaseInputs& inputs, const NamedInput& named, const Values& v, std::size_t index) {
  if (!is_text(named))
    inputs.set(named.path, named.input->kind == InputKind::whole ? v.integer[index] : v.real[index]);
  else if (!v.text[index].empty())
    inputs.set(named.path, v.text[index]);
}

std::string numbered(const char* what, std::size_t k) {
  return what + ("[" + std::to_string(k + 1) + "].");
}
/// Beginnings of names of a wheel's inputs and of its results: "state.", "wheel.", of a vehicle's "wheel[3].".
std::string state_group(std::size_t wheel) {
  return is_vehicle ? numbered("wheel", wheel) + "state." : "state.";
}
std::string result_group(std::size_t wheel) {
  return is_vehicle ? numbered("wheel", wheel) : "wheel.";
}

/// A variable of a number of results, of a whole one if it is a code.
template <class Of>
Variable result(const std::string& group, const RailwayQuantity<Of>& q, Causality causality = Causality::local) {
  return {.name = group + std::string(q.name),
          .description = std::string(q.description),
          .kind = q.is_code ? Kind::integer : Kind::real,
          .causality = causality,
          .unit = std::string(q.unit)};
}

template <class Of> void store(Values& v, std::size_t index, const RailwayQuantity<Of>& q, double value) {
  if (q.is_code)
    v.integer[index] = static_cast<int>(value);
  else
    v.real[index] = value;
}

/// Number of variables of a wheel.
std::size_t wheel_variables() {
  return state_numbers + 1 + wheel_results().size() + 1 + patches_shown * patch_results().size();
}

/// The real inputs of a wheel: its state, and the vertical force.
using Inputs = std::array<double, state_numbers + 1>;

/// What was found last for a wheel, and for which inputs: only wheels whose inputs have changed are solved.
struct Wheel {
  std::optional<Inputs> solved, differentiated;
  WheelRailSolution found;
};

class WheelRailModel final : public Model {
public:
  explicit WheelRailModel(const std::filesystem::path& resources) : folder_((resources / "parameters").string()) {
    for (Wheel& wheel : wheels_) wheel.found.patches.reserve(most_patches);
    differentiated_.patches.reserve(most_patches);
  }

  /// Reads the profiles, each of them once unless the parameters of its file change.
  std::vector<std::string> set_parameters(const Values& v) override {
    io::CaseInputs inputs(kind_of_case, folder_);
    for (std::size_t index = 0; index < parameters().size(); ++index) set(inputs, parameters()[index], v, index);
    inputs.set("wheel.forward_velocity", 0.0); // of some state
    inputs.set("wheel.vertical", 0.0);
    solvers_.clear();
    for (Wheel& wheel : wheels_) wheel.solved.reset(), wheel.differentiated.reset();
    std::vector<std::string> warnings;
    for (const std::string_view side : {"left", "right"}) {
      if (is_vehicle) inputs.set("wheel.side", std::string(side));
      const io::WheelRailCase input = io::read_wheel_rail_case(inputs.root(), tables_, &profiles_);
      solvers_.push_back(io::solver_of(input, input.method));
      if (solvers_.size() == 1) warnings = warnings_of(input);
      if (!is_vehicle) break;
    }
    return warnings;
  }

  void evaluate(Values& v) override {
    for (std::size_t k = 0; k < wheels; ++k)
      solve_if_new(v, k, wheels_[k].solved, [&](WheelRail& solver, const WheelState<double>& state, auto force) {
        solver.solve(state, force, wheels_[k].found);
      });
    for (std::size_t k = 0; k < wheels; ++k) store_results(v, first_input(k) + state_numbers + 1, wheels_[k].found);
  }

  std::span<const double> differentiate(const Values& v) override {
    for (std::size_t k = 0; k < wheels; ++k)
      solve_if_new(v, k, wheels_[k].differentiated,
                   [&](WheelRail& solver, const WheelState<double>& state, auto force) {
                     solver.differentiate(state, force, differentiated_, by_inputs_);
                     std::ranges::copy(by_inputs_.values, derivatives_.begin() + k * by_inputs_.values.size());
                   });
    return derivatives_;
  }

private:
  static std::vector<std::string> warnings_of(const io::WheelRailCase& input) {
    std::vector<std::string> warnings;
    for (const auto& [path, profile] : {std::pair("rail.profile: ", &input.rail), {"wheelset.profile: ", &input.wheel}})
      for (const std::string& warning : profile->report.warnings) warnings.push_back(path + warning);
    return warnings;
  }

  std::size_t first_input(std::size_t wheel) const { return parameters().size() + wheel * wheel_variables(); }

  /// Solves a wheel as a function of its inputs alone, unless these are as they were.
  template <class Solve>
  void solve_if_new(const Values& v, std::size_t k, std::optional<Inputs>& solved, const Solve& solve) {
    Inputs now;
    std::copy_n(v.real.begin() + static_cast<std::ptrdiff_t>(first_input(k)), now.size(), now.begin());
    if (solved == now) return;
    solved.reset();
    const WheelState<double> of_wheel = state(now, k);
    const std::optional<double> force = vertical_force(now, k);
    WheelRail& solver = solvers_[k % solvers_.size()];
    solver.reset();
    solve(solver, of_wheel, force);
    solved = now;
  }

  static void store_results(Values& v, std::size_t index, const WheelRailSolution& found) {
    for (const WheelQuantity& q : wheel_results()) store(v, index++, q, q.value(found));
    v.integer[index++] = static_cast<int>(found.status);
    for (std::size_t k = 0; k < patches_shown; ++k)
      for (const PatchQuantity& q : patch_results())
        store(v, index++, q, k < found.patches.size() ? q.value(found.patches[k]) : 0);
  }

  static WheelState<double> state(const Inputs& inputs, std::size_t wheel) {
    WheelState<double> state;
    for (std::size_t k = 0; k < state_numbers; ++k) {
      const StateQuantity& q = state_quantities()[k];
      if (!(std::abs(inputs[k]) <= q.limit)) // makes the texts of errors only then
        require_between(state_group(wheel) + std::string(q.name), inputs[k], std::string(q.unit), -q.limit, q.limit);
      q.of(state) = inputs[k];
    }
    return state;
  }

  static std::optional<double> vertical_force(const Inputs& inputs, std::size_t wheel) {
    const double force = inputs.back();
    if (force != 0 && !is_vertical_force(force))
      require_between(state_group(wheel) + "vertical_force", force, "N", least_vertical_force, largest_vertical_force);
    return force > 0 ? std::optional(force) : std::nullopt;
  }

  std::string folder_; ///< the file that the parameters would be in, beside the unit's ones
  io::CreepTables tables_;
  io::ProfileFiles profiles_;
  std::vector<WheelRail> solvers_; ///< of a vehicle for left and for right wheels
  std::array<Wheel, wheels> wheels_;
  WheelRailSolution differentiated_;
  WheelRailDerivatives by_inputs_;
  std::vector<double> derivatives_ = std::vector<double>(wheels * by_inputs_.values.size());
};

} // namespace

namespace {

/// Adds the inputs and results of a wheel, a part of the unit.
void add_wheel(std::size_t wheel, std::vector<Variable>& all) {
  const std::size_t first = all.size();
  for (const StateQuantity& q : state_quantities())
    all.push_back({.name = state_group(wheel) + std::string(q.name),
                   .description = std::string(q.description),
                   .unit = std::string(q.unit),
                   .min = -q.limit,
                   .max = q.limit});
  const WheelInput& force = vertical_force_input();
  all.push_back({.name = state_group(wheel) + std::string(force.name),
                 .description = std::string(force.description) + "; 0: the height counts, state.vertical",
                 .unit = std::string(force.unit),
                 .start = 80e3,
                 .min = 0,
                 .max = largest_vertical_force});
  for (std::size_t k = 0; k < wheel_results().size(); ++k)
    all.push_back(result(result_group(wheel), wheel_results()[k], k < outputs ? Causality::output : Causality::local));
  all.push_back({.name = is_vehicle ? result_group(wheel) + "status" : "status",
                 .description = status_codes,
                 .kind = Kind::integer,
                 .causality = Causality::output});
  for (std::size_t k = 0; k < patches_shown; ++k)
    for (const PatchQuantity& q : patch_results())
      all.push_back(result((is_vehicle ? result_group(wheel) : "") + numbered("patch", k), q));
  for (std::size_t k = first; k < all.size(); ++k) all[k].part = wheel;
}

} // namespace

ModelInfo model_info() {
  ModelInfo info{.name = is_vehicle ? "microslip wheels of a vehicle" : "microslip wheel on rail",
                 .identifier = is_vehicle ? "microslip_vehicle_wheels" : "microslip_wheel_rail",
                 .description =
                     std::string("Forces of a rail on a wheel by their profiles: in track axes, x forward, y to the "
                                 "left, z up, moments about the wheel's centre") +
                     (is_vehicle ? "; wheels 1, 3, 5 ... are left ones, 2, 4, 6 ... right ones" : ""),
                 .variables = {}};
  for (const NamedInput& named : parameters()) info.variables.push_back(parameter(named));
  for (std::size_t wheel = 0; wheel < wheels; ++wheel) add_wheel(wheel, info.variables);
  return info;
}

std::unique_ptr<Model> make_model(const std::filesystem::path& resources) {
  return std::make_unique<WheelRailModel>(resources);
}

} // namespace microslip::fmi
