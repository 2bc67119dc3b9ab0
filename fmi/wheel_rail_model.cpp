// A wheel on a rail as a unit. Parameters are the inputs of case files by their paths, inputs and results those of the
// tables of quantities.

#include "fmi/model.hpp"
#include "io/case_inputs.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

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
      path.starts_with("right_"))
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

std::string numbered(std::size_t patch) {
  return "patch[" + std::to_string(patch + 1) + "].";
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

class WheelRailModel final : public Model {
public:
  explicit WheelRailModel(const std::filesystem::path& resources) : folder_((resources / "parameters").string()) {}

  /// Reads the profiles, each of them once unless the parameters of its file change.
  std::vector<std::string> set_parameters(const Values& v) override {
    io::CaseInputs inputs(kind_of_case, folder_);
    for (std::size_t index = 0; index < parameters().size(); ++index) set(inputs, parameters()[index], v, index);
    inputs.set("wheel.forward_velocity", 0.0); // of some state
    inputs.set("wheel.vertical", 0.0);
    solver_.reset();
    const io::WheelRailCase input = io::read_wheel_rail_case(inputs.root(), tables_, &profiles_);
    solver_.emplace(io::solver_of(input, input.method));
    std::vector<std::string> warnings;
    for (const auto& [path, profile] : {std::pair("rail.profile: ", &input.rail), {"wheelset.profile: ", &input.wheel}})
      for (const std::string& warning : profile->report.warnings) warnings.push_back(path + warning);
    return warnings;
  }

  void evaluate(Values& v) override {
    solver_->reset(); // as a function of the inputs alone
    solver_->solve(state(v), vertical_force(v), found_);
    std::size_t index = first_input_ + state_numbers + 1;
    for (const WheelQuantity& q : wheel_results()) store(v, index++, q, q.value(found_));
    v.integer[index++] = static_cast<int>(found_.status);
    for (std::size_t k = 0; k < patches_shown; ++k)
      for (const PatchQuantity& q : patch_results())
        store(v, index++, q, k < found_.patches.size() ? q.value(found_.patches[k]) : 0);
  }

  std::span<const double> differentiate(const Values& v) override {
    solver_->reset();
    solver_->differentiate(state(v), vertical_force(v), found_, derivatives_);
    return derivatives_.values;
  }

private:
  WheelState<double> state(const Values& v) const {
    WheelState<double> state;
    for (std::size_t k = 0; k < state_numbers; ++k) {
      const StateQuantity& q = state_quantities()[k];
      const double value = v.real[first_input_ + k];
      if (!(std::abs(value) <= q.limit)) // makes the texts of errors only then
        require_between("state." + std::string(q.name), value, std::string(q.unit), -q.limit, q.limit);
      q.of(state) = value;
    }
    return state;
  }

  std::optional<double> vertical_force(const Values& v) const {
    const double force = v.real[first_input_ + state_numbers];
    if (force != 0 && !is_vertical_force(force))
      require_between("state.vertical_force", force, "N", least_vertical_force, largest_vertical_force);
    return force > 0 ? std::optional(force) : std::nullopt;
  }

  std::string folder_; ///< the file that the parameters would be in, beside the unit's ones
  io::CreepTables tables_;
  io::ProfileFiles profiles_;
  std::optional<WheelRail> solver_;
  std::size_t first_input_ = parameters().size();
  WheelRailSolution found_;
  WheelRailDerivatives derivatives_;
};

} // namespace

ModelInfo model_info() {
  ModelInfo info{.name = "microslip wheel on rail",
                 .identifier = "microslip_wheel_rail",
                 .description =
                     "Forces of a rail on a wheel by their profiles: in track axes, x forward, y to the left, z "
                     "up, moments about the wheel's centre",
                 .variables = {}};
  std::vector<Variable>& all = info.variables;
  for (const NamedInput& named : parameters()) all.push_back(parameter(named));
  for (const StateQuantity& q : state_quantities())
    all.push_back({.name = "state." + std::string(q.name),
                   .description = std::string(q.description),
                   .unit = std::string(q.unit),
                   .min = -q.limit,
                   .max = q.limit});
  const WheelInput& force = vertical_force_input();
  all.push_back({.name = "state." + std::string(force.name),
                 .description = std::string(force.description) + "; 0: state.vertical counts",
                 .unit = std::string(force.unit),
                 .start = 80e3,
                 .min = 0,
                 .max = largest_vertical_force});
  for (std::size_t k = 0; k < wheel_results().size(); ++k)
    all.push_back(result("wheel.", wheel_results()[k], k < outputs ? Causality::output : Causality::local));
  all.push_back({.name = "status", .description = status_codes, .kind = Kind::integer, .causality = Causality::output});
  for (std::size_t k = 0; k < patches_shown; ++k)
    for (const PatchQuantity& q : patch_results()) all.push_back(result(numbered(k), q));
  return info;
}

std::unique_ptr<Model> make_model(const std::filesystem::path& resources) {
  return std::make_unique<WheelRailModel>(resources);
}

} // namespace microslip::fmi
