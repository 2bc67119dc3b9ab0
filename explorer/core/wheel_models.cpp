#include "explorer/core/wheel_models.hpp"

#include <algorithm>
#include <utility>

namespace microslip::explorer {
namespace {

constexpr std::size_t most_models = 4; ///< as of one pair of profiles at each level

} // namespace

WheelModels::Model& WheelModels::of(const io::TomlSection& root, std::string setting, const io::CreepTables& tables) {
  const auto known =
      std::find_if(models_.begin(), models_.end(), [&](const Model& model) { return model.setting == setting; });
  if (known != models_.end()) {
    known->input.states = io::read_states(root, known->input);
    std::rotate(models_.begin(), known, known + 1);
  } else {
    io::WheelRailCase input = io::read_wheel_rail_case(root, tables);
    WheelRail solver = io::solver_of(input, cases::solving_method(input));
    models_.push_front({std::move(setting), std::move(input), std::move(solver)});
    if (models_.size() > most_models) models_.pop_back();
  }
  return models_.front();
}

} // namespace microslip::explorer
