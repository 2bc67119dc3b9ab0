#pragma once

#include "cases/wheel_rail_result.hpp"

#include <deque>
#include <string>

namespace microslip::explorer {

/// Wheels on rails that have been solved, with their profiles read and their solvers made: where a case differs from
/// one of them by the state in its [wheel] alone, only that is read and solved.
class WheelModels {
public:
  struct Model {
    std::string setting;
    io::WheelRailCase input;
    WheelRail solver;
  };

  /// The model of a case with its states; `setting` tells it from others. Errors as of read_wheel_rail_case. The
  /// reference holds until the next call.
  Model& of(const io::TomlSection& root, std::string setting, const io::CreepTables& tables);
  /// Forgets them all, as when files have changed.
  void clear() { models_.clear(); }

private:
  std::deque<Model> models_; ///< the last one used first
};

} // namespace microslip::explorer
