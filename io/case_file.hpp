#pragma once

#include "io/creep_tables.hpp"
#include "io/read_inputs.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/rolling/elliptic_contact.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/rolling/theory.hpp"
#include "microslip/simplified/row_solver.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace microslip::io {

class TomlSection;

/// One of the two bodies of a case file.
struct BodyInput {
  double rolling_radius = 0;    ///< [m], in the plane of rolling: positive convex, negative concave, infinite flat
  double transverse_radius = 0; ///< [m], in the lateral plane
  Material material = {};
  MaterialCreep creep = {}; ///< none: an elastic body
  std::optional<ThermalBody> thermal = {};
};

/// Contents of a case file, in SI units; the annotated example in examples/ shows every key.
struct RollingCase {
  std::string title = {};
  BodyInput body1 = {}; ///< the body that the forces act on, e.g. the wheel
  BodyInput body2 = {};
  InterfaceLayer layer = {};               ///< between them
  std::optional<double> normal_force = {}; ///< [N]; either this
  std::optional<double> approach = {};     ///< [m]; or this
  std::string friction_law = {};           ///< one of FrictionLaw::names, or polach
  FrictionLaw friction = {};
  FrictionMemory friction_memory = {};                      ///< of the exact theory
  std::optional<TemperatureEffect> temperature_effect = {}; ///< of the exact theory, with thermal data of both bodies
  Creepage creepage = {};                                   ///< for a shift the rigid shift [m] and rotation [rad]
  double rolling_speed = 0;                                 ///< [m/s]
  ExactMotion motion = {}; ///< what is not steady rolling with given creepages needs the exact theory
  Theory theory = Theory::fastsim2;
  SimplifiedOptions options = {.mx = 20, .my = 20}; ///< of the simplified theory; it shares the grid with the exact one
  Discretisation discretisation = Discretisation::second_order; ///< of the exact theory
  ElementShape elements = ElementShape::constant;               ///< of its classical discretisation
  double tolerance = 1e-6;                                      ///< of its residual
  Coupling coupling = Coupling::newton;                         ///< of its problems for dissimilar materials
  SlipStart slip_start = SlipStart::below;                      ///< of its friction that depends on the slip
  std::shared_ptr<const CreepForceTable> table = {};            ///< of the theory `table`
  InteriorGrid interior = {};          ///< points inside the bodies, with the exact theory; none: no interior field
  std::optional<double> accuracy = {}; ///< of its forces, in mu Fn, from grids that this chooses; none: on the grid
  ReadInputs inputs = {};              ///< the same by the keys of the file
};

/// Reads a case from TOML text; `name` is the file's name for messages. Unknown keys, missing keys, wrong types and
/// values out of range throw an Error with file, line, key, value and range: `w.toml:12: load.normal_forse: unknown
/// key; did you mean normal_force?`, `w.toml:7: friction.coefficient = -0.3 [-]: must be in [0, 10]`.
RollingCase parse_case(std::string_view text, const std::string& name);
/// The same of a file that is parsed as TOML already. Where many are read, `tables` are those of all of them.
RollingCase read_case(const TomlSection& root, const CreepTables& tables = {});

/// The bodies of a case: elastic, or viscoelastic in steady rolling.
Bodies bodies_of(const RollingCase& input);
/// One of them, for its interior field.
InteriorBody interior_body(const RollingCase& input, const BodyInput& body);

/// The case as a problem and as a method, for Solver.
RollingProblem rolling_problem(const RollingCase& input);
Method method_of(const RollingCase& input);
/// The method of a case that has been checked, without what the other theory has and without what is implied.
Method solver_method(const RollingCase& input);

/// The Hertzian contact of a case, the case for either theory, and the options of the exact one. They do not throw for
/// what parse_case gave.
HertzContact hertz_contact(const RollingCase& input);
PrincipalRadii principal_radii(const BodyInput& body1, const BodyInput& body2);
EllipticContact elliptic_contact(const RollingCase& input, const HertzContact& hertz);
ExactOptions exact_options(const RollingCase& input);
/// Returns whether the exact theory can solve the case with the classical discretisation only.
bool needs_classical(const RollingCase& input);

/// The text of a case file. Error if it cannot be read or is longer than 1 MiB.
std::string read_case_text(const std::filesystem::path& path);

} // namespace microslip::io
