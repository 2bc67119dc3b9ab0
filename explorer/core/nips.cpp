#include "explorer/core/nips.hpp"

#include "explorer/core/solution_fields.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/elasticity/shore_hardness.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/nip.hpp"

#include <string>
#include <utility>

namespace microslip::explorer {
namespace {

RollingProblem under_force(RollingProblem problem, double force) {
  problem.motion.force_x = force;
  return problem;
}

RollingProblem with_creepage(RollingProblem problem, double creepage) {
  problem.motion.force_x.reset();
  problem.motion.creepage.longitudinal = creepage;
  return problem;
}

/// Surface speed of the undeformed body 1 over that of body 2.
double speed_ratio(const ContactSolution& solution, const Motion& motion) {
  const double creepage = solution.creepage.longitudinal;
  return surface_speed(Roller::body1, motion, creepage) / surface_speed(Roller::body2, motion, creepage);
}

io::Json totals_of(const ContactSolution& solution, const Motion& motion, io::Json& units) {
  io::Json all = {{"speed_ratio", io::json_number(speed_ratio(solution, motion))},
                  {"status", to_string(solution.report.status)}};
  for (const Quantity& q : quantities()) {
    if (!q.applies(solution)) continue;
    all[std::string(q.name)] = io::json_number(q.value(solution));
    units[std::string(q.name)] = q.unit_of(solution);
  }
  if (!solution.report.reason.empty()) all["reason"] = solution.report.reason;
  return all;
}

/// How stiff a layer is at short times, by the keys of case files that may say so; its hardness as far as there is one.
io::Json stiffness_of(const Material& material) {
  const double young = young_modulus(material.shear_modulus, material.poisson_ratio);
  io::Json all = {{"shear_modulus", io::json_number(material.shear_modulus)},
                  {"young_modulus", io::json_number(young)}};
  if (young >= young_modulus_of_shore_a(softest_shore_a) && young <= young_modulus_of_shore_a(hardest_shore_a))
    all["hardness"] = io::json_number(shore_a_of_young_modulus(young));
  return all;
}

/// Fn mu [N].
double largest_force(const RollingProblem& problem) {
  return problem.friction.law.static_coefficient() * hertz_contact(problem).normal_force;
}

/// Throws Error for a case without layers, not of steady rolling, without friction, and for a force beyond friction.
void check(const io::RollingCase& input) {
  const RollingProblem& problem = input.problem;
  if (!problem.layered || problem.motion.kind != ContactMotion::steady)
    throw Error("nip: needs a case with layers and motion.kind = \"steady\"");
  require_positive("friction.coefficient", problem.friction.law.static_coefficient(), "-");
  const double largest = largest_force(problem);
  if (const auto force = problem.motion.force_x)
    require_between("motion.force_longitudinal", *force, "N", -largest, largest);
}

constexpr std::string_view fields[] = {"x", "y", "pressure", "bound", "px", "py"};

/// The creepage under a force. Throws Error where it is not found.
double creepage_under(double force, const RollingProblem& problem, Solver& solver) {
  const ContactSolution solution = solver.solve(under_force(problem, force));
  if (solution.report.status != Status::ok) throw Error("free rolling: " + solution.report.reason);
  return solution.creepage.longitudinal;
}

} // namespace

Solver& Nips::solver_for(const io::RollingCase& input) {
  check(input);
  if (input.method != solver_.method()) solver_ = Solver(input.method);
  return solver_;
}

io::Json Nips::solve(const io::RollingCase& input) {
  Solver& solver = solver_for(input);
  const ContactSolution given = solver.solve(input.problem);
  const ContactSolution free = solver.solve(under_force(input.problem, 0));
  io::Json units = {{"speed_ratio", "-"}}, found = io::Json::object();
  add_fields(given, fields, found, units);
  found["state"] = states_of(given);
  const Motion& motion = input.problem.motion;
  io::Json result = {{"given", totals_of(given, motion, units)}, {"free", totals_of(free, motion, units)}};
  result["fields"] = std::move(found);
  if (const auto& layers = input.body2.layers; !layers.empty())
    result["cover"] = stiffness_of(layers.front().material.instantaneous);
  result["units"] = std::move(units);
  return result;
}

io::Json Nips::curve(const io::RollingCase& input, int count) {
  Solver& solver = solver_for(input);
  const RollingProblem& problem = input.problem;
  const double middle = creepage_under(0, problem, solver),
               reach = 3 * (creepage_under(-0.5 * largest_force(problem), problem, solver) - middle);
  io::Json curve = {{"units", {{"value", "-"}, {"fx", "N"}}}};
  for (const char* member : {"value", "fx", "status"}) curve[member] = io::Json::array();
  for (int k = 0; k < count; ++k) {
    const double creepage = middle + reach * (2. * k / (count - 1) - 1);
    const ContactForces forces = solver.solve(with_creepage(problem, creepage)).forces();
    curve["value"].push_back(io::json_number(creepage));
    curve["fx"].push_back(io::json_number(forces.fx));
    curve["status"].push_back(to_string(forces.status));
  }
  return curve;
}

} // namespace microslip::explorer
