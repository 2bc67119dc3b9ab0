#include "explorer/core/wheel_models.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

constexpr std::size_t most_models = 4; ///< as of one pair of profiles at each level

} // namespace

WheelModels::Model& WheelModels::of(const TomlSection& root, std::string setting, const CreepTables& tables) {
  const auto known =
      std::find_if(models_.begin(), models_.end(), [&](const Model& model) { return model.setting == setting; });
  if (known != models_.end()) {
    known->input.states = read_states(root, known->input);
    std::rotate(models_.begin(), known, known + 1);
  } else {
    WheelRailCase input = read_wheel_rail_case(root, tables);
    WheelRail solver = solver_of(input, solving_method(input));
    models_.push_front({std::move(setting), std::move(input), std::move(solver)});
    if (models_.size() > most_models) models_.pop_back();
  }
  return models_.front();
}

} // namespace microslip
