#include "c/contact.hpp"
#include "c/exact_options.hpp"
#include "c/growing_struct.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/rolling/accurate_contact.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

using namespace microslip;
using namespace microslip::c;

struct microslip_exact {
  microslip_exact_options options;
  std::variant<Solver, AccurateContactSolver> solver;
  bool stopped = false; ///< by the caller's function
  // Last solved:
  RollingProblem problem = {};
  int finest = 0; ///< with an accuracy given: elements across
  std::optional<ContactSolution> solution = {};
  mutable InUse in_use = false;
};

namespace {

constexpr std::array motions = {ContactMotion::steady, ContactMotion::transient, ContactMotion::shift};

microslip_exact_motion default_motion() {
  microslip_exact_motion out{};
  out.struct_size = sizeof out;
  out.kind = MICROSLIP_STEADY;
  out.steps = 1;
  return out;
}

/// What an older header has of the options.
constexpr std::size_t oldest_options = offsetof(microslip_exact_options, elements);

Progress progress_of(microslip_exact& handle) {
  handle.stopped = false;
  if (!handle.options.progress) return {};
  return [&handle](double fraction) {
    handle.stopped = handle.options.progress(fraction, handle.options.progress_data) != 0;
    return !handle.stopped;
  };
}

std::variant<Solver, AccurateContactSolver> solver_for(const Method& method) {
  if (method.accuracy) return AccurateContactSolver(method);
  return Solver(method);
}

microslip_exact* make_solver(const microslip_exact_options& o) {
  check(o);
  return new microslip_exact{.options = o, .solver = solver_for(method_of(o))};
}

/// Makes the handle ready for a contact. Throws Error if options, contact and motion do not go together.
void prepare(microslip_exact& handle, const EllipticContact& contact, const Motion& motion) {
  RollingProblem problem = problem_of(handle.options, contact, motion);
  require_compatible(problem, method_of(handle.options));
  handle.solution.reset();
  handle.problem = std::move(problem);
}

Motion motion_of(const microslip_exact_motion& m) {
  require_between("step", m.step, "m", 0, std::numeric_limits<double>::max());
  require_count("steps", m.steps, 1, most_steps);
  Motion out{
      .kind = motions[static_cast<std::size_t>(require_count("kind", m.kind, 0, 2))], .step = m.step, .steps = m.steps};
  if (require_count("force_x_given", m.force_x_given, 0, 1)) out.force_x = require_finite("force_x", m.force_x, "N");
  if (require_count("force_y_given", m.force_y_given, 0, 1)) out.force_y = require_finite("force_y", m.force_y, "N");
  return out;
}

microslip_exact_result result_of(const ContactSolution& found) {
  microslip_exact_result out{};
  out.forces = forces_of(found.forces());
  out.creepage_longitudinal = found.creepage.longitudinal;
  out.creepage_lateral = found.creepage.lateral;
  out.spin = found.creepage.spin;
  out.approach = found.approach;
  out.peak_pressure = found.totals.peak_pressure;
  out.peak_traction = found.totals.peak_traction;
  out.frictional_power = found.totals.frictional_power;
  out.power_by_creepage = found.totals.power_by_creepage;
  out.elastic_energy = found.totals.elastic_energy;
  out.residual = found.report.residual;
  out.mx = found.elements.mx();
  out.my = found.elements.my();
  out.newton_steps = found.report.newton_steps;
  out.products = found.report.products;
  return out;
}

/// Solves, keeps the fields, and returns what there is to tell.
microslip_exact_result solve_with(Solver& solver, microslip_exact& handle) {
  handle.solution = solver.solve(handle.problem, progress_of(handle));
  return result_of(*handle.solution);
}

microslip_exact_result solve_with(AccurateContactSolver& solver, microslip_exact& handle) {
  AccurateContact found = solver.solve(handle.problem, progress_of(handle));
  microslip_exact_result out = result_of(found.finest);
  out.forces = forces_of(found.forces);
  out.creepage_longitudinal = found.creepage.longitudinal;
  out.creepage_lateral = found.creepage.lateral;
  out.error = found.error;
  out.products = found.products;
  handle.finest = found.elements;
  SolverReport& report = found.finest.report;
  report.status = found.forces.status;
  report.estimated_error = found.error;
  add_reason(report);
  handle.solution = std::move(found.finest);
  return out;
}

/// Why a contact is out of range, in the words of microslip_contact_check; empty if it is not.
std::string fault_of(const microslip_contact& contact) {
  try {
    check_contact(contact);
    return "";
  } catch (const Error& refusal) {
    return refusal.what();
  }
}

/// The library's form of a contact, with the dissimilarity of the options; none if it is out of range, which becomes
/// the handle's solution.
std::optional<EllipticContact> read_contact(microslip_exact& handle, const microslip_contact& contact) {
  std::string fault = fault_of(contact);
  handle.stopped = false;
  if (!fault.empty()) {
    handle.solution = solution_without_result(Status::invalid_input, std::move(fault));
    return {};
  }
  EllipticContact known = contact_of(contact);
  known.dissimilarity = handle.options.dissimilarity;
  return known;
}

microslip_code report_status(microslip_error* error, int status, const microslip_exact& handle) {
  const auto code = static_cast<microslip_code>(status);
  if (handle.stopped) return report(error, code, "ended by the caller's progress function");
  return report(error, code, code == MICROSLIP_OK ? "" : handle.solution->report.reason);
}

const ContactSolution& solution_of(const microslip_exact& solver) {
  return require_solution(solver.solution, "microslip_exact_solve");
}

/// Where the solution has no distance of the bodies, from the normal problem on its grid.
void find_gap(microslip_exact& handle) {
  if (!handle.solution || handle.solution->elements.size() == 0 || !handle.solution->fields.gap.empty()) return;
  std::vector<double>& gap = handle.solution->fields.gap;
  if (auto* const solver = std::get_if<Solver>(&handle.solver)) {
    gap = solver->deformed_gap(handle.problem).gap;
    return;
  }
  Method finest = method_of(handle.options);
  finest.accuracy.reset();
  finest.mx = finest.my = handle.finest;
  gap = Solver(finest).deformed_gap(handle.problem).gap;
}

} // namespace

microslip_code microslip_exact_options_init(microslip_exact_options* options, size_t size) {
  return guarded(nullptr, [&] { write_growing("options", default_exact_options(), options, size, oldest_options); });
}

microslip_code microslip_exact_motion_init(microslip_exact_motion* motion, size_t size) {
  return guarded(nullptr, [&] { write_growing("motion", default_motion(), motion, size); });
}

microslip_code microslip_exact_create(const microslip_exact_options* options, microslip_exact** solver,
                                      microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("solver", solver);
    *solver = make_solver(options ? read_growing("options", options, oldest_options) : default_exact_options());
  });
}

void microslip_exact_destroy(microslip_exact* solver) {
  delete solver;
}

microslip_code microslip_exact_solve(microslip_exact* solver, const microslip_contact* contact,
                                     const microslip_exact_motion* motion, microslip_exact_result* result,
                                     microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    require_pointer("contact", contact);
    const std::size_t size = require_pointer("result", result)->struct_size;
    require_struct_size("result", size, sizeof *result);
    const Motion move = motion_of(motion ? read_growing("motion", motion) : default_motion());
    const auto known = read_contact(*solver, *contact);
    if (known) prepare(*solver, *known, move);
    auto found = known ? std::visit([&](auto& theory) { return solve_with(theory, *solver); }, solver->solver)
                       : result_of(*solver->solution);
    if (solver->stopped) found.forces.status = MICROSLIP_NOT_CONVERGED; // fewer steps than wanted, each converged
    write_growing("result", found, result, size);
    return report_status(error, found.forces.status, *solver);
  });
}

microslip_code microslip_exact_differentiate(microslip_exact* solver, const microslip_contact* contact, size_t count,
                                             double* jacobian, microslip_exact_result* result, microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    require_pointer("contact", contact);
    require_pointer("jacobian", jacobian);
    require_size("count", count, 9);
    const std::size_t size = result ? result->struct_size : sizeof *result;
    require_struct_size("result", size, sizeof *result);
    if (!std::holds_alternative<Solver>(solver->solver))
      throw Refusal(MICROSLIP_INVALID_OPTION, "accuracy: there are no derivatives of extrapolated forces");
    ExactDerivatives found;
    if (const auto known = read_contact(*solver, *contact)) {
      prepare(*solver, *known, {});
      found = std::get<Solver>(solver->solver).differentiate(solver->problem, progress_of(*solver));
      solver->solution = std::move(found.solution);
    }
    const microslip_exact_result totals = result_of(*solver->solution);
    const bool has_result = std::isfinite(totals.forces.fx);
    for (std::size_t k = 0; k < 9; ++k)
      jacobian[k] = has_result ? found.jacobian[k / 3][k % 3] : std::numeric_limits<double>::quiet_NaN();
    if (result) write_growing("result", totals, result, size);
    return report_status(error, totals.forces.status, *solver);
  });
}

microslip_code microslip_exact_get(const microslip_exact* solver, int field, size_t count, double* values,
                                   microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    copy_field(solution_of(*solver), field_name(field), {require_pointer("values", values), count});
  });
}

microslip_code microslip_exact_quantity(const microslip_exact* solver, const char* name, double* value,
                                        microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    *require_pointer("value", value) = quantity_of(solution_of(*solver), require_pointer("name", name));
  });
}

microslip_code microslip_exact_field(microslip_exact* solver, const char* name, size_t count, double* values,
                                     microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    const std::string_view field = require_pointer("name", name);
    require_pointer("values", values);
    if (field == "gap") find_gap(*solver);
    copy_field(solution_of(*solver), field, {values, count});
  });
}
