#include "c/contact.hpp"
#include "c/growing_struct.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/rolling/accurate_contact.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

using namespace microslip;
using namespace microslip::c;

struct microslip_exact {
  std::variant<EllipticContactSolver, AccurateContactSolver> solver;
  int (*progress)(double, void*) = nullptr;
  void* progress_data = nullptr;
  bool stopped = false;                        ///< by the caller's function
  std::optional<ContactSolution> contact = {}; ///< last solved
};

namespace {

constexpr std::array motions = {ContactMotion::steady, ContactMotion::transient, ContactMotion::shift};

microslip_exact_options default_options() {
  const ExactOptions o;
  microslip_exact_options out{};
  out.struct_size = sizeof out;
  out.mx = o.mx;
  out.my = o.my;
  out.discretisation = static_cast<int>(o.discretisation);
  out.direction = static_cast<int>(o.direction);
  out.tolerance = o.tolerance;
  return out;
}

microslip_exact_motion default_motion() {
  microslip_exact_motion out{};
  out.struct_size = sizeof out;
  out.kind = MICROSLIP_STEADY;
  out.steps = 1;
  return out;
}

ExactOptions options_of(const microslip_exact_options& o) {
  return {.mx = o.mx,
          .my = o.my,
          .discretisation = choice<Discretisation>("discretisation", o.discretisation, 2),
          .direction = choice<RollingDirection>("direction", o.direction, 2),
          .tolerance = o.tolerance};
}
static_assert(static_cast<int>(Discretisation::classical) == MICROSLIP_CLASSICAL);

Progress progress_of(microslip_exact& handle) {
  handle.stopped = false;
  if (!handle.progress) return {};
  return [&handle](double fraction) {
    handle.stopped = handle.progress(fraction, handle.progress_data) != 0;
    return !handle.stopped;
  };
}

microslip_exact* make_solver(const microslip_exact_options& o) {
  const ExactOptions options = options_of(o);
  if (o.accuracy != 0)
    return new microslip_exact{AccurateContactSolver(o.accuracy, options), o.progress, o.progress_data};
  return new microslip_exact{EllipticContactSolver(options), o.progress, o.progress_data};
}

ExactMotion motion_of(const microslip_exact_motion& m) {
  require_between("step", m.step, "m", 0, std::numeric_limits<double>::max());
  require_count("steps", m.steps, 1, most_steps);
  ExactMotion out{
      .kind = motions[static_cast<std::size_t>(require_count("kind", m.kind, 0, 2))], .step = m.step, .steps = m.steps};
  if (require_count("force_x_given", m.force_x_given, 0, 1)) out.force_x = require_finite("force_x", m.force_x, "N");
  if (require_count("force_y_given", m.force_y_given, 0, 1)) out.force_y = require_finite("force_y", m.force_y, "N");
  return out;
}

microslip_exact_result result_of(const ContactSolution& found) {
  microslip_exact_result out{};
  out.forces = forces_of(found.forces());
  out.creep_longitudinal = found.creepage.longitudinal;
  out.creep_lateral = found.creepage.lateral;
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
microslip_exact_result solve_with(EllipticContactSolver& solver, microslip_exact& handle,
                                  const EllipticContact& contact, const ExactMotion& motion) {
  handle.contact = solver.solve(contact, motion, progress_of(handle));
  return result_of(*handle.contact);
}

microslip_exact_result solve_with(AccurateContactSolver& solver, microslip_exact& handle,
                                  const EllipticContact& contact, const ExactMotion& motion) {
  AccurateContact found = solver.solve(contact, motion, progress_of(handle));
  microslip_exact_result out = result_of(found.finest);
  out.forces = forces_of(found.forces);
  out.creep_longitudinal = found.creepage.longitudinal;
  out.creep_lateral = found.creepage.lateral;
  out.error = found.error;
  out.products = found.products;
  handle.contact = std::move(found.finest);
  return out;
}

/// Why a contact was taken for invalid.
std::string reason(const microslip_contact& contact) {
  try {
    check_contact(contact);
  } catch (const Error& refusal) {
    return refusal.what();
  }
  return contact.friction_law == MICROSLIP_COULOMB
             ? "numbers overflow on the way"
             : "friction_law: the exact theory has derivatives for Coulomb's only";
}

microslip_code report_status(microslip_error* error, int status, const microslip_contact& contact, bool stopped) {
  const auto code = static_cast<microslip_code>(status);
  if (stopped) return report(error, code, "ended by the caller's progress function");
  if (code == MICROSLIP_OK) return report(error, code, "");
  return report(error, code, code == MICROSLIP_INVALID_INPUT ? reason(contact) : microslip_code_text(code));
}

} // namespace

microslip_code microslip_exact_options_init(microslip_exact_options* options, size_t size) {
  return guarded(nullptr, [&] { write_growing("options", default_options(), options, size); });
}

microslip_code microslip_exact_motion_init(microslip_exact_motion* motion, size_t size) {
  return guarded(nullptr, [&] { write_growing("motion", default_motion(), motion, size); });
}

microslip_code microslip_exact_create(const microslip_exact_options* options, microslip_exact** solver,
                                      microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("solver", solver);
    *solver = make_solver(options ? read_growing("options", options) : default_options());
  });
}

void microslip_exact_destroy(microslip_exact* solver) {
  delete solver;
}

microslip_code microslip_exact_solve(microslip_exact* solver, const microslip_contact* contact,
                                     const microslip_exact_motion* motion, microslip_exact_result* result,
                                     microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("solver", solver);
    require_pointer("contact", contact);
    const std::size_t size = require_pointer("result", result)->struct_size;
    require_struct_size("result", size, sizeof *result);
    const ExactMotion move = motion_of(motion ? read_growing("motion", motion) : default_motion());
    auto found = std::visit([&](auto& theory) { return solve_with(theory, *solver, contact_of(*contact), move); },
                            solver->solver);
    if (solver->stopped) found.forces.status = MICROSLIP_NOT_CONVERGED; // fewer steps than wanted, each converged
    write_growing("result", found, result, size);
    return report_status(error, found.forces.status, *contact, solver->stopped);
  });
}

microslip_code microslip_exact_differentiate(microslip_exact* solver, const microslip_contact* contact, size_t count,
                                             double* jacobian, microslip_exact_result* result, microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("solver", solver);
    require_pointer("contact", contact);
    require_pointer("jacobian", jacobian);
    require_size("count", count, 9);
    const std::size_t size = result ? result->struct_size : sizeof *result;
    require_struct_size("result", size, sizeof *result);
    auto* const theory = std::get_if<EllipticContactSolver>(&solver->solver);
    if (!theory) throw Refusal(MICROSLIP_INVALID_OPTION, "accuracy: there are no derivatives of extrapolated forces");
    ExactDerivatives found = theory->differentiate(contact_of(*contact));
    const microslip_exact_result totals = result_of(found.solution);
    const bool valid = totals.forces.status != MICROSLIP_INVALID_INPUT;
    for (std::size_t k = 0; k < 9; ++k)
      jacobian[k] = valid ? found.jacobian[k / 3][k % 3] : std::numeric_limits<double>::quiet_NaN();
    if (result) write_growing("result", totals, result, size);
    solver->contact = std::move(found.solution);
    return report_status(error, totals.forces.status, *contact, false);
  });
}

microslip_code microslip_exact_get(const microslip_exact* solver, microslip_field field, size_t count, double* values,
                                   microslip_error* error) {
  return guarded(error, [&] {
    if (!require_pointer("solver", solver)->contact)
      throw Refusal(MICROSLIP_NO_RESULT, "microslip_exact_solve was not called yet");
    copy_field(*solver->contact, field, {require_pointer("values", values), count});
  });
}
