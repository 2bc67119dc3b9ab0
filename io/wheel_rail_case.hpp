#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/railway/profile_preparation.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// A state of the wheel with its load.
struct LoadedWheelState {
  WheelState<double> state;             ///< its `vertical` counts without a force
  std::optional<double> vertical_force; ///< [N] on the wheel
};

/// What a case file says of a wheel on a rail, in SI units; examples/wheel_on_rail.toml shows every key.
struct WheelRailCase {
  std::string title;
  Track track;
  Wheelset wheelset;
  PreparedProfile rail, wheel;
  TrackSide side = TrackSide::left;
  Material material; ///< of both
  SurfaceStrength strength;
  std::vector<InclinedFriction> friction;
  WheelRailMethod method;
  InteriorGrid interior;                ///< points below each patch, in its frame; empty: none
  std::vector<std::string_view> varied; ///< names of what the sweep varies, in the order of the table of quantities
  std::vector<LoadedWheelState> states; ///< one without a sweep
};

/// Whether the text of a case file is about a wheel on a rail: it has one of the sections that only such files have.
/// Error as parse_wheel_rail_case for text that is not TOML.
bool is_wheel_rail_case(std::string_view text, const std::string& name);

/// Reads a case from TOML text, and the profiles it names; `name` is the file's name for messages and where the paths
/// of profiles start. Errors as of parse_case; those about a profile begin with the line that names it.
WheelRailCase parse_wheel_rail_case(std::string_view text, const std::string& name);

/// What the solver needs of it.
WheelRailBodies bodies_of(const WheelRailCase& input);

} // namespace microslip
