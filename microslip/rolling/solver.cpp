#include "microslip/rolling/solver.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/rolling/ellipse_solver.hpp"
#include "microslip/rolling/layered_rolling.hpp"
#include "microslip/rolling/step_derivatives.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace microslip {
namespace {

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
  std::string shape = beyond("a/b", contact.a / contact.b, axes.least_ratio, axes.largest_ratio);
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

struct Solver::Kept {
  Method method;
  EllipseSolver exact;
  std::optional<AccurateContactSolver> accurate;
  int finest = 0; ///< elements across of what that found last
  std::optional<KeptPatch> patch;
  TransformPlans plans; ///< of patches
  ContactSequence sequence;
  LayeredRolling layered;

  explicit Kept(const Method& how) : method(how), exact(how), layered(how) {}

  ContactSolution solve(const RollingProblem& problem, const Progress& progress) {
    if (problem.layered) return solve_layered(problem, progress);
    return is_hertzian(problem) ? solve_ellipse(problem, progress) : solve_on_grid(problem, progress);
  }

  ContactSolution solve_layered(const RollingProblem& problem, const Progress& progress) {
    if (method.accuracy) return solve_accurately(problem, progress);
    try {
      return layered.solve(problem, progress);
    } catch (const Stopped& stopped) {
      return solution_without_result(Status::not_converged, stopped.what());
    }
  }

  ContactSolution solve_ellipse(const RollingProblem& problem, const Progress& progress) {
    if (method.theory == Theory::table) return look_up(*method.table, elliptic_contact(problem));
    if (method.theory != Theory::exact) return solve_simplified(elliptic_contact(problem), problem.motion.direction);
    return method.accuracy ? solve_accurately(problem, progress) : exact.solve(problem, progress);
  }

  ContactSolution solve_accurately(const RollingProblem& problem, const Progress& progress) {
    if (!accurate) accurate.emplace(method);
    AccurateContact found = accurate->solve(problem, progress);
    finest = found.elements;
    return with_limit(std::move(found));
  }

  ContactSolution solve_simplified(const EllipticContact& contact, RollingDirection direction) const {
    const SimplifiedOptions options = simplified_options(method, direction);
    return method.theory == Theory::fastrip ? Fastrip(options).fields(contact)
                                            : RowSolver(marching_scheme(method.theory), options).fields(contact);
  }

  ContactSolution solve_on_grid(const RollingProblem& p, const Progress& progress) {
    GapValues shape = gap_values(p, method);
    const bool fitted = discretisation_of(p, method) == Discretisation::second_order;
    return fitted ? solve_patch(p, std::move(shape), progress) : solve_classical(p, std::move(shape), progress);
  }

  PatchRolling& press_patch(const RollingProblem& p, GapValues shape, const Progress& progress) {
    if (!patch || !is_of(*patch, shape, p)) {
      PatchRolling rolling(p.bodies.material, shape.grid, shape.gap, p.load, p.motion.direction, progress, plans);
      patch.emplace(KeptPatch{std::move(shape), p.bodies.material, p.load, p.motion.direction, std::move(rolling)});
    }
    return patch->rolling;
  }

  PatchRollingMotion motion_of(const RollingProblem& p, Progress progress) const {
    return {.friction = p.friction.law.static_coefficient(),
            .creepage = p.motion.creepage,
            .force_x = p.motion.force_x,
            .force_y = p.motion.force_y,
            .rolling_speed = p.motion.rolling_speed,
            .tolerance = method.tolerance,
            .progress = std::move(progress)};
  }

  ContactSolution solve_patch(const RollingProblem& p, GapValues shape, const Progress& progress) {
    return press_patch(p, std::move(shape), part(progress, 0, 0.3)).solve(motion_of(p, part(progress, 0.3, 1)));
  }

  FrequencyResponse respond(const RollingProblem& p, std::span<const double> wavenumbers, ResponseTo causes,
                            const Progress& progress) {
    if (!is_hertzian(p))
      return press_patch(p, gap_values(p, method), part(progress, 0, 0.1))
          .respond(motion_of(p, part(progress, 0.1, 1)), wavenumbers, causes);
    if (causes == ResponseTo::motion_and_load) return exact.respond(p, wavenumbers, progress);
    FrequencyResponse out = exact.respond(p, wavenumbers, part(progress, 0, 0.4));
    if (out.solution.report.status == Status::ok) add_roughness(p, wavenumbers, part(progress, 0.4, 1), out);
    return out;
  }

  /// Adds what an ellipse, whose pressures do not stay Hertz's, has by elements that follow a pressure on a grid.
  void add_roughness(const RollingProblem& p, std::span<const double> wavenumbers, const Progress& progress,
                     FrequencyResponse& out) {
    constexpr int margin = 5; // elements around the ellipse
    const EllipticContact contact = elliptic_contact(p);
    const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
    const ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, method.mx, method.my, margin);
    const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, material, contact.normal_force);
    RollingProblem on_grid = p;
    on_grid.geometry = GapValues{grid, hertzian_gap(hertz.gap, grid)};
    on_grid.bodies.material = material;
    on_grid.load = {NormalLoad::Given::force, contact.normal_force};
    const FrequencyResponse rough = respond(on_grid, wavenumbers, ResponseTo::load_and_roughness, progress);
    if (rough.at.size() != out.at.size()) {
      out.solution.report = rough.solution.report;
      out.at.clear();
      return;
    }
    out.products += rough.products;
    for (std::size_t k = 0; k < out.at.size(); ++k) {
      ForceResponse &to = out.at[k], from = rough.at[k];
      std::copy_n(from.by_roughness, 3, to.by_roughness);
      to.load_by_roughness = from.load_by_roughness;
      to.work_by_load = from.work_by_load, to.work_by_roughness = from.work_by_roughness;
    }
  }

  /// Of layers and of gaps on a grid.
  ExactDerivatives differentiate(const RollingProblem& p, const Progress& progress) {
    check(p.motion);
    require_differentiable(p);
    try {
      if (p.layered) return layered.differentiate(p, progress);
      const ContactStep step = contact_step(p, method, gap_values(p, method), p.load);
      ContactSolution solution = solve_steps(sequence, step, 1, essential_part(progress, 0, 0.7));
      return with_derivatives(sequence, step, std::move(solution), part(progress, 0.7, 1));
    } catch (const Stopped& stopped) {
      return {.solution = solution_without_result(Status::not_converged, stopped.what())};
    }
  }

  ContactSolution solve_classical(const RollingProblem& p, GapValues shape, const Progress& progress) {
    check(p.motion);
    // A sequence takes forces over the normal force, which need not be known: the normal problem tells it.
    if ((p.motion.force_x || p.motion.force_y) && p.load.given == NormalLoad::Given::approach)
      throw Error("motion.force_longitudinal, motion.force_lateral: need load.normal_force on a gap's grid");
    try {
      return solve_steps(sequence, contact_step(p, method, std::move(shape), p.load), p.motion.steps, progress);
    } catch (const Stopped& stopped) {
      return solution_without_result(Status::not_converged, stopped.what());
    }
  }
};

Solver::Solver(const Method& method) : kept_(std::make_unique<Kept>(method)) {
  const int most = method.theory == Theory::exact ? most_elements : most_cells;
  require_count("mx", method.mx, 1, most);
  require_count("my", method.my, 1, most);
  require_between("tolerance", method.tolerance, "-", smallest_tolerance, largest_tolerance);
  if (method.accuracy) require_between("accuracy", *method.accuracy, "-", smallest_accuracy, largest_accuracy);
  if (method.theory != Theory::exact || method.accuracy) return;
  const bool classical = method.discretisation == Discretisation::classical;
  require_memory(classical ? ContactProblem::tangential : ContactProblem::second_order,
                 ElementGrid::across_ellipse(1, 1, method.mx, method.my, contact_margin));
}
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;
Solver::~Solver() = default;

const Method& Solver::method() const {
  return kept_->method;
}

ContactSolution Solver::solve(const RollingProblem& problem, const Progress& progress) {
  require_compatible(problem, kept_->method);
  ContactSolution out = kept_->solve(problem, progress);
  conclude(out, kept_->method.tolerance);
  return out;
}

ExactDerivatives Solver::differentiate(const RollingProblem& problem, const Progress& progress) {
  const Method& method = kept_->method;
  require_compatible(problem, method);
  if (method.accuracy) throw Error("solution.accuracy: there are no derivatives of extrapolated forces");
  if (method.theory != Theory::exact) throw Error("derivatives: by solution.theory = \"exact\" only");
  const bool on_grid = !is_hertzian(problem);
  if (on_grid && discretisation_of(problem, method) == Discretisation::second_order)
    throw Error("derivatives: of a gap on a grid by solution.discretisation = \"classical\" only");
  ExactDerivatives out = problem.layered || on_grid ? kept_->differentiate(problem, progress)
                                                    : kept_->exact.differentiate(problem, progress);
  conclude(out.solution, method.tolerance);
  return out;
}

FrequencyResponse Solver::respond(const RollingProblem& problem, std::span<const double> wavenumbers,
                                  const Progress& progress, ResponseTo causes) {
  const Method& method = kept_->method;
  require_compatible(problem, method);
  if (method.accuracy) throw Error("solution.accuracy: there are no responses of extrapolated forces");
  if (method.theory != Theory::exact) throw Error("responses: by solution.theory = \"exact\" only");
  if (problem.layered || discretisation_of(problem, method) != Discretisation::second_order ||
      problem.motion.kind != ContactMotion::steady)
    throw Error(
        "responses: of steady rolling of elastically similar bodies with Coulomb friction at second order only");
  require_wavenumbers(wavenumbers);
  FrequencyResponse out = kept_->respond(problem, wavenumbers, causes, progress);
  conclude(out.solution, method.tolerance);
  return out;
}

GapValues Solver::deformed_gap(const RollingProblem& problem, const Progress& progress) {
  require_compatible(problem, kept_->method);
  if (kept_->method.theory != Theory::exact) throw Error("deformed gap: needs the exact theory");
  const bool ellipse = is_hertzian(problem) && !problem.layered;
  if (ellipse && !kept_->method.accuracy) return kept_->exact.deformed_gap(problem, progress);
  if (ellipse) {
    if (kept_->finest == 0) throw Error("deformed gap: with an accuracy, of the problem last solved, and none was");
    Method on_finest = kept_->method;
    on_finest.accuracy.reset();
    on_finest.mx = on_finest.my = kept_->finest;
    return EllipseSolver(on_finest).deformed_gap(problem, progress);
  }
  ContactSolution solution = kept_->solve(problem, progress);
  return {solution.elements.grid, std::move(solution.fields.gap)};
}

} // namespace microslip
