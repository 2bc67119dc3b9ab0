#include "microslip/rolling/nip.hpp"

#include "microslip/contact/loaded_part.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/kept_layered_table.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace microslip {
namespace {

using Field = std::vector<double>;

double sign_of(const Motion& motion) {
  return motion.direction == RollingDirection::forward ? 1 : -1;
}

bool is_rigid(const LayeredBody& body) {
  return body.layers.empty() && body.substrate.is_rigid();
}

double cover_of(const LayeredBody& body) {
  constexpr double softer = 0.1;
  double thickness = 0;
  for (const BodyLayer& layer : body.layers)
    if (layer.material.instantaneous.shear_modulus < softer * body.substrate.instantaneous.shear_modulus)
      thickness += layer.thickness;
  return thickness;
}

void check(const RollingProblem& problem, const ContactSolution& solution, const RollerRadii& radii) {
  if (!problem.layered) throw Error("nip: needs a problem with layered bodies; half-spaces have no layers");
  if (problem.motion.kind != ContactMotion::steady) throw Error("nip: needs steady rolling");
  require_radius("radii.body1", radii.body1);
  require_radius("radii.body2", radii.body2);
  if (const auto* gap = std::get_if<GapCurvatures>(&problem.geometry);
      gap != nullptr && !(std::abs(radii.curvature() - 2 * gap->x) <= 2e-6 * gap->x))
    throw Error("radii: 1/body1 + 1/body2 = " + std::to_string(radii.curvature()) +
                " [1/m]: must be twice the gap's curvature, " + std::to_string(2 * gap->x) + " [1/m]");
  if (solution.fields.pressure.empty() || solution.totals.peak_pressure <= 0)
    throw Error("nip: the solution has no contact");
}

/// Integral over the contact of pressure times the slope along x of a field, by central differences.
double work_on_slope(const ElementGrid& grid, const Field& pressure, const Field& field) {
  double sum = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 1; i + 1 < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      sum += pressure[k] * (field[k + 1] - field[k - 1]);
    }
  return sum * grid.element_area() / (2 * grid.dx);
}

/// Displacement inwards of one body, the other one taken as rigid [m]; in line contact relative to the same distance as
/// the solution.
Field displacement_inwards(KeptLayeredTable& kept, const LayeredBodies& one, const RollingProblem& problem,
                           const ContactSolution& solution, const Progress& progress) {
  const ElementGrid& grid = solution.elements.grid;
  const auto* curvatures = std::get_if<GapCurvatures>(&problem.geometry);
  ElementResponse response;
  response.table =
      kept.table(one, grid, curvatures ? std::optional(0.5 / curvatures->x) : std::optional<double>(), progress);
  CoupledOperator map = CoupledOperator::displacement(Bodies(one.surfaces()), grid, {}, 1, {}, response);
  const SurfaceFields& f = solution.fields;
  VectorField along(grid.count());
  Field inwards(grid.count());
  map.apply({f.traction.x, f.traction.y, f.pressure},
            std::array{std::span(along.x), std::span(along.y), std::span(inwards)});
  return inwards;
}

/// Largest value where there is pressure.
double largest_in_contact(const Field& field, const Field& pressure) {
  double largest = 0;
  for (std::size_t k = 0; k < field.size(); ++k)
    if (pressure[k] > 0) largest = std::max(largest, field[k]);
  return largest;
}

/// State of a roller whose counterpart is taken as rigid in `one`, but for its drive.
RollerState state_of(KeptLayeredTable& kept, const LayeredBody& body, const LayeredBodies& one,
                     const RollingProblem& problem, const ContactSolution& solution, const Progress& progress) {
  RollerState state;
  if (is_rigid(body)) return state;
  const Field& pressure = solution.fields.pressure;
  const Field inwards = displacement_inwards(kept, one, problem, solution, progress);
  state.pressure_power = -rolling_velocity(problem.motion) * work_on_slope(solution.elements.grid, pressure, inwards);
  state.indentation = largest_in_contact(inwards, pressure);
  state.cover = cover_of(body);
  if (state.cover > 0) state.strain = state.indentation / state.cover;
  return state;
}

} // namespace

double surface_speed(Roller roller, const Motion& motion, double creepage) {
  const double half = 0.5 * sign_of(motion) * creepage;
  return motion.rolling_speed * (roller == Roller::body1 ? 1 - half : 1 + half);
}

/// Tables of each body on a rigid one.
struct NipAnalysis::Kept {
  KeptLayeredTable body1, body2;
};

NipAnalysis::NipAnalysis() : kept_(std::make_unique<Kept>()) {}
NipAnalysis::~NipAnalysis() = default;
NipAnalysis::NipAnalysis(NipAnalysis&&) noexcept = default;
NipAnalysis& NipAnalysis::operator=(NipAnalysis&&) noexcept = default;

Nip NipAnalysis::find(const RollingProblem& problem, const ContactSolution& solution, const RollerRadii& radii,
                      const Progress& progress) {
  check(problem, solution, radii);
  const Totals& totals = solution.totals;
  const double speed = problem.motion.rolling_speed, forward_force = sign_of(problem.motion) * totals.fx;
  const ElementGrid& grid = solution.elements.grid;
  const Field& pressure = solution.fields.pressure;
  Nip nip;
  nip.width = loaded_part(grid, pressure)->x.count() * grid.dx;
  nip.peak_pressure = totals.peak_pressure;
  nip.indentation = solution.approach;
  nip.traction = std::hypot(totals.fx, totals.fy);
  nip.traction_capacity = problem.friction.law.peak_coefficient() * normal_force(grid, pressure);
  if (nip.traction_capacity > 0) nip.utilisation = nip.traction / nip.traction_capacity;
  const auto& [body1, body2, velocity] = *problem.layered;
  const LayeredBody rigid = {{}, {{std::numeric_limits<double>::infinity(), 0}}};
  nip.body1 = state_of(kept_->body1, body1, {body1, rigid, velocity}, problem, solution, progress);
  nip.body2 = state_of(kept_->body2, body2, {rigid, body2, velocity}, problem, solution, progress);
  nip.slip_power = totals.frictional_power;
  nip.hysteresis_power =
      nip.body1.pressure_power + nip.body2.pressure_power + totals.power_by_creepage - totals.frictional_power;
  nip.rolling_resistance = nip.hysteresis_power / speed;
  const double xi = solution.creepage.longitudinal;
  nip.body1.drive = forward_force + nip.body1.pressure_power / surface_speed(Roller::body1, problem.motion, xi);
  nip.body2.drive = -forward_force + nip.body2.pressure_power / surface_speed(Roller::body2, problem.motion, xi);
  nip.warnings = roller_warnings({"roller of body 1", radii.body1, nip.body1.cover, nip.body1.strain},
                                 {"roller of body 2", radii.body2, nip.body2.cover, nip.body2.strain}, 0.5 * nip.width);
  return nip;
}

FreeRoller NipAnalysis::roll_without_torque(Solver& solver, const RollingProblem& problem, const RollerRadii& radii,
                                            Roller driven, const Progress& progress) {
  constexpr int most_solves = 10;
  constexpr double settled = 1e-6; // of the force, over mu Fn
  RollingProblem p = problem;
  p.motion.force_x = 0;
  FreeRoller out;
  bool is_settled = false;
  for (int solve = 0; solve < most_solves && !is_settled; ++solve) {
    out.solution = solver.solve(p, essential_part(progress, 0, 0));
    if (out.solution.report.status != Status::ok) break;
    const Nip nip = find(p, out.solution, radii, essential_part(progress, 0, 0));
    const double missing = driven == Roller::body1 ? -nip.body1.drive : nip.body2.drive;
    is_settled = std::abs(missing) <= settled * nip.traction_capacity;
    if (!is_settled) *p.motion.force_x += sign_of(p.motion) * missing;
  }
  SolverReport& report = out.solution.report;
  if (!is_settled && report.status == Status::ok) {
    report.status = Status::not_converged;
    add_reason(report);
  }
  out.creepage = out.solution.creepage.longitudinal;
  out.fx = out.solution.totals.fx;
  const Roller other = driven == Roller::body1 ? Roller::body2 : Roller::body1;
  out.speed_ratio = surface_speed(driven, p.motion, out.creepage) / surface_speed(other, p.motion, out.creepage);
  return out;
}

Nip nip_of(const RollingProblem& problem, const ContactSolution& solution, const RollerRadii& radii,
           const Progress& progress) {
  return NipAnalysis().find(problem, solution, radii, progress);
}

FreeRoller roll_without_torque(Solver& solver, const RollingProblem& problem, const RollerRadii& radii, Roller driven,
                               const Progress& progress) {
  return NipAnalysis().roll_without_torque(solver, problem, radii, driven, progress);
}

} // namespace microslip
