#include "c/names.hpp"
#include "c/problem.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

namespace microslip::c {
namespace {

template <class Input>
Input read(const io::CaseInputs& inputs, const io::CreepTables& tables, io::ProfileFiles& profiles) {
  if constexpr (std::is_same_v<Input, io::WheelRailCase>)
    return io::read_wheel_rail_case(inputs.root(), tables, &profiles);
  else
    return io::read_wheelset_case(inputs.root(), tables, &profiles);
}

void solve(WheelRail& solver, const io::LoadedWheelState& given, WheelRailSolution& solution,
           const Progress& progress) {
  solver.reset(); // a solution depends on the inputs alone
  solver.solve(given.state, given.vertical_force, solution, progress);
}
void solve(WheelsetOnTrack& solver, const io::LoadedWheelsetState& given, WheelsetSolution& solution,
           const Progress& progress) {
  solver.reset();
  solver.solve(given.state, given.load, solution, progress);
}

template <class Of> double value_in(std::span<const RailwayQuantity<Of>> table, std::string_view name, const Of& of) {
  return table[index_of(table, name)].value(of);
}

/// A wheel's name behind "left." or "right.", with that wheel; of other names none.
std::pair<const WheelRailSolution*, std::string_view> wheel_of(const WheelsetSolution& solution,
                                                               std::string_view name) {
  constexpr std::string_view left = "left.", right = "right.";
  if (name.starts_with(left)) return {&solution.left, name.substr(left.size())};
  if (name.starts_with(right)) return {&solution.right, name.substr(right.size())};
  return {nullptr, name};
}

double number_of(const WheelRailSolution& solution, std::string_view name) {
  return value_in(wheel_results(), name, solution);
}
double number_of(const WheelsetSolution& solution, std::string_view name) {
  const auto [wheel, rest] = wheel_of(solution, name);
  return wheel != nullptr ? number_of(*wheel, rest) : value_in(wheelset_quantities(), name, solution);
}

/// A number of each patch.
std::vector<double> field_of(const WheelRailSolution& solution, std::string_view name) {
  const auto& quantity = patch_results()[index_of(patch_results(), name)];
  std::vector<double> values;
  for (const WheelRailPatch& patch : solution.patches) values.push_back(quantity.value(patch));
  return values;
}
std::vector<double> field_of(const WheelsetSolution& solution, std::string_view name) {
  const auto [wheel, rest] = wheel_of(solution, name);
  if (wheel == nullptr) throw Error("name = " + io::printable(name) + ": begins with left. or right.");
  return field_of(*wheel, rest);
}

/// The solver is kept while nothing but the state changes, profiles and tables while their files are the same.
template <class Input, class WheelSolver, class Solution> class SolvedWheels final : public SolvedCase {
public:
  Ending solve(const io::CaseInputs& inputs, const Progress& progress) override {
    if (inputs.root().has("sweep")) throw Error("sweep: a problem is one state; microslip_solve_case solves all");
    io::CaseInputs setting = inputs.without_states();
    if (!made_ || !(made_->of == setting)) made_.emplace(make(inputs, std::move(setting)));
    const auto state = io::read_states(inputs.root(), made_->input).front();
    solution_.reset();
    Solution found;
    try {
      c::solve(made_->solver, state, found, progress);
    } catch (const Stopped& stopped) {
      return {Status::not_converged, stopped.what()};
    }
    solution_ = std::move(found);
    return {solution_->status, std::string(to_string(solution_->reason))};
  }

  double number(std::string_view name) const override { return number_of(solution(), name); }
  FieldSize field_size(std::string_view name) const override { return {field_of(solution(), name).size(), 1}; }
  void copy_field(std::string_view name, std::span<double> values) override {
    const std::vector<double> found = field_of(solution(), name);
    require_size("count", values.size(), found.size());
    std::ranges::copy(found, values.begin());
  }

private:
  struct Made {
    io::CaseInputs of; ///< without states
    Input input;
    WheelSolver solver;
  };

  Made make(const io::CaseInputs& inputs, io::CaseInputs setting) {
    Input input = read<Input>(inputs, tables_, profiles_);
    WheelSolver solver = io::solver_of(input, input.method);
    return {std::move(setting), std::move(input), std::move(solver)};
  }

  const Solution& solution() const {
    if (!solution_) throw Refusal(MICROSLIP_NO_RESULT, "microslip_solve was not called yet");
    return *solution_;
  }

  io::CreepTables tables_;
  io::ProfileFiles profiles_;
  std::optional<Made> made_;
  std::optional<Solution> solution_;
};

} // namespace

std::unique_ptr<SolvedCase> solved_wheel() {
  return std::make_unique<SolvedWheels<io::WheelRailCase, WheelRail, WheelRailSolution>>();
}

std::unique_ptr<SolvedCase> solved_wheelset() {
  return std::make_unique<SolvedWheels<io::WheelsetCase, WheelsetOnTrack, WheelsetSolution>>();
}

} // namespace microslip::c
