#pragma once

#include "io/creep_tables.hpp"
#include "io/read_inputs.hpp"
#include "microslip/damage/surface_strength.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/rolling/method.hpp"
#include "microslip/rolling/rolling_problem.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace microslip::io {

class TomlSection;

/// Body of a case file, one of two.
struct BodyInput {
  /// [m], in the plane of rolling: positive convex, negative concave, infinite flat. Where the ellipse is given the
  /// second body counts as flat.
  double rolling_radius = 0;
  double transverse_radius = 0;       ///< [m], in the lateral plane
  Material material = {};             ///< below the layers, if there are any
  MaterialCreep creep = {};           ///< of it; none: an elastic body
  std::vector<BodyLayer> layers = {}; ///< from the surface inwards
  std::optional<ThermalBody> thermal = {};
};

/// Contents of a case file, in SI units: a problem, a method, and what to write. The annotated example in examples/
/// shows every key.
struct RollingCase {
  std::string title = {};
  BodyInput body1 = {}; ///< the body that the forces act on, e.g. the wheel
  BodyInput body2 = {};
  RollingProblem problem = {}; ///< of these bodies, by the curvatures of their gap or the ellipse
  Method method = {};          ///< with what the file gives, and the theory and grid
  /// Of the surface whose wear and fatigue are asked for, in steady rolling; none: of neither.
  std::optional<SurfaceStrength> strength = {};
  InteriorGrid interior = {}; ///< points inside the bodies, with the exact theory; none: no interior field
  ReadInputs inputs = {};     ///< the same by the keys of the file
};

/// Reads a case from TOML text; `name` is the file's name for messages. Unknown keys, missing keys, wrong types and
/// values out of range throw an Error with file, line, key, value and range: `w.toml:12: load.normal_forse: unknown
/// key; did you mean normal_force?`, `w.toml:7: friction.coefficient = -0.3 [-]: must be in [0, 10]`.
RollingCase parse_case(std::string_view text, const std::string& name);
/// Reads a file that is parsed as TOML already. Where many are read, `tables` are shared by all of them.
RollingCase read_case(const TomlSection& root, const CreepTables& tables = {});

/// Parts of a case from the sections that describe them: [ellipse], [material], of cases of wheels too, [load],
/// [motion] and, except for its creep-force table, [solution]. Throw Error as above.
Ellipse read_ellipse(const TomlSection& ellipse);
SurfaceStrength read_strength(const TomlSection& material);
NormalLoad read_load(const TomlSection& load);
Motion read_motion(const TomlSection& motion);
Method read_method(const TomlSection& solution);

/// Body of a case, for its interior field.
InteriorBody interior_body(const RollingCase& input, Body body);

PrincipalRadii principal_radii(const BodyInput& body1, const BodyInput& body2);

/// The text of a case file. Error if it cannot be read or is longer than 1 MiB.
std::string read_case_text(const std::filesystem::path& path);

} // namespace microslip::io
