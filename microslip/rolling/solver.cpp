#include "microslip/rolling/solver.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace microslip {
namespace {

/// A gap as values at the centres of the elements that the method takes.
GapValues gap_values(const RollingProblem& problem, const Method& method) {
  GapValues out;
  if (const auto* values = std::get_if<GapValues>(&problem.geometry)) out = *values;
  const auto* formula = std::get_if<GapFormula>(&problem.geometry);
  if (formula != nullptr) out.grid = formula->grid;
  out.grid.shape = elements_of(problem, method);
  if (formula == nullptr) return out;
  const auto& [grid, gap] = *formula;
  check(grid);
  out.gap.resize(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) out.gap[static_cast<std::size_t>(j) * grid.mx + i] = gap(grid.x(i), grid.y(j));
  return out;
}

ExactMotion exact_motion(const Motion& motion) {
  return {.kind = motion.kind,
          .force_x = motion.force_x,
          .force_y = motion.force_y,
          .step = motion.step,
          .steps = motion.steps};
}

/// The finest solution with the limit's forces and creepages, and the limit's error.
ContactSolution with_limit(AccurateContact found) {
  ContactSolution out = std::move(found.finest);
  out.totals.fx = found.forces.fx;
  out.totals.fy = found.forces.fy;
  out.totals.mz = found.forces.mz;
  out.creepage = found.creepage;
  out.report.status = found.forces.status;
  out.report.products = found.products;
  out.report.estimated_error = found.error;
  out.report.reason.clear();
  return out;
}

/// Why a contact is out of a table's range; empty if it is within.
std::string out_of_range(const CreepTableAxes& axes, const EllipticContact& contact) {
  const auto beyond = [](const char* name, double value, double least, double largest) -> std::string {
    if (value >= least && value <= largest) return "";
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "%s = %.4g is beyond the creep-force table's range, %g to %g: the forces are those of limits", name,
                  value, least, largest);
    return text.data();
  };
  const std::string shape = beyond("a/b", contact.a / contact.b, axes.least_ratio, axes.largest_ratio);
  if (!shape.empty()) return shape;
  return beyond("Poisson's ratio", contact.poisson_ratio, axes.poisson_ratios.front(), axes.poisson_ratios.back());
}

/// Forces, areas and power.
ContactSolution look_up(const CreepForceTable& table, const EllipticContact& contact) {
  try {
    check_simplified(contact);
  } catch (const Error& error) {
    return solution_without_result(Status::invalid_input, error.what());
  }
  const ContactForces forces = table.solve(contact);
  ContactSolution out;
  out.creepage = contact.creepage;
  out.totals.fx = forces.fx;
  out.totals.fy = forces.fy;
  out.totals.mz = forces.mz;
  out.totals.adhesion_area = forces.adhesion_area;
  out.totals.slip_area = forces.slip_area;
  const auto& [xi, eta, phi] = contact.creepage;
  const double power = -contact.rolling_speed * (xi * forces.fx + eta * forces.fy + phi * forces.mz);
  out.totals.frictional_power = out.totals.power_by_creepage = power;
  out.report.status = forces.status;
  if (forces.status != Status::ok && forces.status != Status::invalid_input)
    out.report.reason = out_of_range(table.axes(), contact);
  return out;
}

/// A problem on a grid as a step of a sequence.
ContactStep contact_step(const RollingProblem& p, const Method& method, GapValues shape) {
  ContactStep step = contact_step(exact_options(p, method));
  step.grid = shape.grid;
  step.bodies = p.bodies;
  step.gap = std::move(shape.gap);
  step.load = p.load;
  step.friction = {p.friction.law};
  step.motion.motion = p.motion.kind;
  step.motion.creepage = p.motion.creepage;
  step.motion.step = p.motion.step;
  step.motion.rolling_speed = p.motion.rolling_speed;
  return step;
}

/// The patch whose normal problem and elements were found last.
struct KeptPatch {
  GapValues shape;
  CombinedMaterial material;
  NormalLoad load;
  RollingDirection direction;
  PatchRolling rolling;
};

/// A normal problem that was interrupted is solved anew.
bool is_of(const KeptPatch& kept, const GapValues& shape, const RollingProblem& p) {
  return kept.rolling.normal().status == Status::ok && kept.shape.grid == shape.grid && kept.shape.gap == shape.gap &&
         kept.material == p.bodies.material && kept.load.given == p.load.given && kept.load.value == p.load.value &&
         kept.direction == p.motion.direction;
}

} // namespace

EllipticContact elliptic_contact(const RollingProblem& problem, const HertzContact& hertz) {
  const CombinedMaterial& material = problem.bodies.material;
  return {.a = hertz.a,
          .b = hertz.b,
          .shear_modulus = material.shear_modulus,
          .poisson_ratio = material.poisson_ratio,
          .normal_force = hertz.normal_force,
          .friction = problem.friction.law,
          .creepage = problem.motion.creepage,
          .rolling_speed = problem.motion.rolling_speed,
          .dissimilarity = material.dissimilarity};
}

struct Solver::Kept {
  Method method;
  std::optional<EllipticContactSolver> exact;
  std::optional<ExactOptions> accurate_of;
  std::optional<AccurateContactSolver> accurate;
  int finest = 1; ///< elements across of what that found last
  std::optional<KeptPatch> patch;
  TransformPlans plans; ///< of patches
  ContactSequence sequence;

  ContactSolution solve_ellipse(const RollingProblem& problem, const Progress& progress) {
    const EllipticContact contact = elliptic_contact(problem, hertz_contact(problem));
    if (method.theory == Theory::table) return look_up(*method.table, contact);
    if (method.theory != Theory::exact) return solve_simplified(contact, problem.motion.direction);
    const ExactOptions options = exact_options(problem, method);
    if (method.accuracy) {
      if (!accurate || accurate_of != options) accurate.emplace(*method.accuracy, options);
      accurate_of = options;
      AccurateContact found = accurate->solve(contact, exact_motion(problem.motion), progress);
      finest = found.elements;
      return with_limit(std::move(found));
    }
    return with_options(options).solve(contact, exact_motion(problem.motion), progress);
  }

  EllipticContactSolver& with_options(const ExactOptions& options) {
    if (!exact || !(exact->options() == options)) exact.emplace(options);
    return *exact;
  }

  /// Refuses what only ellipses by the exact theory have.
  void require_exact_ellipse(const RollingProblem& problem, const char* what) const {
    require_compatible(problem, method);
    if (method.theory != Theory::exact || !is_hertzian(problem))
      throw Error(std::string(what) + ": of an ellipse by solution.theory = \"exact\" only");
  }

  ContactSolution solve_simplified(const EllipticContact& contact, RollingDirection direction) const {
    const SimplifiedOptions options = simplified_options(method, direction);
    ContactSolution out = method.theory == Theory::fastrip
                              ? Fastrip(options).fields(contact)
                              : RowSolver(marching_scheme(method.theory), options).fields(contact);
    return out;
  }

  ContactSolution solve_on_grid(const RollingProblem& p, const Progress& progress) {
    GapValues shape = gap_values(p, method);
    const bool fitted = discretisation_of(p, method) == Discretisation::second_order && p.motion.step == 0;
    return fitted ? solve_patch(p, std::move(shape), progress) : solve_classical(p, std::move(shape), progress);
  }

  ContactSolution solve_patch(const RollingProblem& p, GapValues shape, const Progress& progress) {
    if (!patch || !is_of(*patch, shape, p)) {
      PatchRolling rolling(p.bodies.material, shape.grid, shape.gap, p.load, p.motion.direction, part(progress, 0, 0.3),
                           plans);
      patch.emplace(KeptPatch{std::move(shape), p.bodies.material, p.load, p.motion.direction, std::move(rolling)});
    }
    return patch->rolling.solve({.friction = p.friction.law.static_coefficient(),
                                 .creepage = p.motion.creepage,
                                 .force_x = p.motion.force_x,
                                 .force_y = p.motion.force_y,
                                 .rolling_speed = p.motion.rolling_speed,
                                 .tolerance = method.tolerance,
                                 .progress = part(progress, 0.3, 1)});
  }

  ContactSolution solve_classical(const RollingProblem& p, GapValues shape, const Progress& progress) {
    require_count("motion.steps", p.motion.steps, 1, most_steps);
    ContactStep step = contact_step(p, method, std::move(shape));
    // A sequence takes forces over the normal force, which need not be known: the normal problem tells it.
    if ((p.motion.force_x || p.motion.force_y) && p.load.given == NormalLoad::Given::approach)
      throw Error("motion.force_longitudinal, motion.force_lateral: need load.normal_force on a gap's grid");
    if (p.motion.force_x) step.force_x = *p.motion.force_x / p.load.value;
    if (p.motion.force_y) step.force_y = *p.motion.force_y / p.load.value;
    ContactSolution out;
    try {
      out = solve_steps(sequence, std::move(step), p.motion.steps, progress);
    } catch (const Stopped& stopped) {
      out = solution_without_result(Status::not_converged, stopped.what());
    }
    return out;
  }
};

Solver::Solver(const Method& method) : kept_(std::make_unique<Kept>()) {
  require_count("solution.grid", method.mx, 1, most_elements);
  require_count("solution.grid", method.my, 1, most_elements);
  require_between("solution.tolerance", method.tolerance, "-", smallest_tolerance, largest_tolerance);
  if (method.accuracy) require_between("solution.accuracy", *method.accuracy, "-", smallest_accuracy, largest_accuracy);
  kept_->method = method;
}
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;
Solver::~Solver() = default;

const Method& Solver::method() const {
  return kept_->method;
}

ContactSolution Solver::solve(const RollingProblem& problem, const Progress& progress) {
  require_compatible(problem, kept_->method);
  ContactSolution out =
      is_hertzian(problem) ? kept_->solve_ellipse(problem, progress) : kept_->solve_on_grid(problem, progress);
  conclude(out, kept_->method.tolerance);
  return out;
}

ExactDerivatives Solver::differentiate(const RollingProblem& problem, const Progress& progress) {
  kept_->require_exact_ellipse(problem, "derivatives");
  if (kept_->method.accuracy) throw Error("solution.accuracy: there are no derivatives of extrapolated forces");
  const Motion& motion = problem.motion;
  if (motion.kind != ContactMotion::steady || motion.force_x || motion.force_y)
    throw Error("derivatives: of steady rolling with creepages given only");
  const EllipticContact contact = elliptic_contact(problem, hertz_contact(problem));
  return kept_->with_options(exact_options(problem, kept_->method)).differentiate(contact, progress);
}

DeformedGap Solver::deformed_gap(const RollingProblem& problem, const Progress& progress) {
  kept_->require_exact_ellipse(problem, "gap");
  ExactOptions options = exact_options(problem, kept_->method);
  if (kept_->method.accuracy) options.mx = options.my = kept_->finest;
  const EllipticContact contact = elliptic_contact(problem, hertz_contact(problem));
  return kept_->with_options(options).deformed_gap(contact, exact_motion(problem.motion), progress);
}

} // namespace microslip
