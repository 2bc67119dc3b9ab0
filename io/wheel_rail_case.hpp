#pragma once

#include "io/creep_tables.hpp"
#include "io/read_inputs.hpp"
#include "io/sliced_profile.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/railway/vehicle/wheelset_on_track.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

class TomlSection;

/// A state of the wheel with its load.
struct LoadedWheelState {
  WheelState<double> state;             ///< its `vertical` counts without a force
  std::optional<double> vertical_force; ///< [N] on the wheel
};

/// State of a wheelset with its load.
struct LoadedWheelsetState {
  WheelsetState state; ///< what the load leaves open
  WheelsetLoad load;
};

/// Elastic layers on a wheel and its rail, from the surface inwards.
struct WheelRailLayers {
  std::vector<BodyLayer> wheel = {}, rail = {};

  /// The bodies with `below` below their layers; none without layers.
  std::optional<LayeredBodies> on(const Material& below) const;
};

/// Contents of a case file of wheels, rails and track, in SI units; examples/wheel_on_rail.toml shows every key.
struct WheelRailSetting {
  std::string title;
  Track track;
  Wheelset wheelset;
  PlacedProfile rail, wheel;
  Material material;      ///< of both
  WheelRailLayers layers; ///< on it
  SurfaceStrength strength;
  std::vector<InclinedFriction> friction;
  WheelRailMethod method;
  ReadInputs inputs;                    ///< all of it, and of the states, by the keys of the file
  std::vector<std::string_view> varied; ///< names of what the sweep varies, in the order of the table of quantities
};

/// A wheel on a rail.
struct WheelRailCase : WheelRailSetting {
  TrackSide side = TrackSide::left;
  InteriorGrid interior;                ///< points below each patch, in its frame; empty: none
  std::vector<LoadedWheelState> states; ///< one without a sweep
};

/// Both wheels of a wheelset: `side = "both"`.
struct WheelsetCase : WheelRailSetting {
  std::optional<PlacedProfile> right_rail = {}, right_wheel = {}; ///< where they differ from the left ones
  WheelRailLayers right_layers = {};                              ///< of the right side
  std::vector<LoadedWheelsetState> states;                        ///< one without a sweep
};

/// Returns true if a case file's text is of a wheel on a rail: it has one of the sections that only such files have.
/// Error as parse_wheel_rail_case for text that is not TOML.
bool is_wheel_rail_case(std::string_view text, const std::string& name);
bool is_wheel_rail_case(const TomlSection& root);

/// Returns whether it is about both wheels of a wheelset.
bool is_wheelset_case(std::string_view text, const std::string& name);
bool is_wheelset_case(const TomlSection& root);

/// Sections whose `profile` names a file, a path that starts at the case file's folder.
inline constexpr std::string_view profile_sections[] = {"rail", "wheelset", "right_rail", "right_wheel"};

/// Reads a case from TOML text, and the profiles it names; `name` is the file's name for messages and where the paths
/// of profiles start. Errors as of parse_case; those about a profile begin with the line that names it.
WheelRailCase parse_wheel_rail_case(std::string_view text, const std::string& name);
WheelsetCase parse_wheelset_case(std::string_view text, const std::string& name);
/// Reads a file that is parsed as TOML already. Where many are read, `tables` and `profiles` are shared by all of
/// them; without the latter profiles are read each time.
WheelRailCase read_wheel_rail_case(const TomlSection& root, const CreepTables& tables = {},
                                   ProfileFiles* profiles = nullptr);
WheelsetCase read_wheelset_case(const TomlSection& root, const CreepTables& tables = {},
                                ProfileFiles* profiles = nullptr);
/// Its states alone, of the setting `of`.
std::vector<LoadedWheelState> read_states(const TomlSection& root, const WheelRailCase& of);
std::vector<LoadedWheelsetState> read_states(const TomlSection& root, const WheelsetCase& of);

/// Data of it for the solver.
WheelRailBodies bodies_of(const WheelRailCase& input);
/// Data of one side of a wheelset.
WheelRailBodies bodies_of(const WheelsetCase& input, TrackSide side);
/// Wheel or rail, the first and the second body, for the interior field.
InteriorBody interior_body(const WheelRailCase& input, Body body);
/// The solver itself.
WheelRail solver_of(const WheelRailCase& input, const WheelRailMethod& method);
WheelsetOnTrack solver_of(const WheelsetCase& input, const WheelRailMethod& method);

} // namespace microslip::io
