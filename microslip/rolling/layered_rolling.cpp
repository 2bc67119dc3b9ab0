#include "microslip/rolling/layered_rolling.hpp"

#include "microslip/contact/loaded_part.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/step_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace microslip {
namespace {

/// The distance at which displacements of half-spaces in line contact are 0: the radius of both bodies, 1/(2 A).
std::optional<double> far_of(const GapCurvatures& curvatures) {
  return curvatures.is_line() ? std::optional(0.5 / curvatures.x) : std::nullopt;
}

/// mx by my elements across the contact's half-lengths and as many beside it as it may be longer: it was found on 16.
/// Strips of the length 1 m for b = 0.
ElementGrid elements_about(const FoundContact& contact, int mx, int my, ElementShape shape) {
  const auto with_margin = [](double length, int n, double& first, double& size, int& count) {
    const int margin = std::max(2, (n + 11) / 12);
    size = 2 * length / n;
    count = n + 2 * margin;
    first = -0.5 * (count - 1) * size;
  };
  ElementGrid grid;
  grid.shape = shape;
  with_margin(contact.a, mx, grid.x0, grid.dx, grid.mx);
  grid.x0 += contact.centre;
  if (contact.b == 0)
    grid.my = 1, grid.dy = 1, grid.line = true;
  else
    with_margin(contact.b, my, grid.y0, grid.dy, grid.my);
  return grid;
}

bool is_cut_off_across(const ElementGrid& grid, const LoadedPart& part) {
  return !grid.line && part.y.reaches_end_of(grid.my);
}

bool is_cut_off(const ElementGrid& grid, const LoadedPart& part) {
  return part.x.reaches_end_of(grid.mx) || is_cut_off_across(grid, part);
}

/// The same elements and an eighth more on each side.
ElementGrid wider(ElementGrid grid) {
  const int columns = (grid.mx + 7) / 8, rows = grid.line ? 0 : (grid.my + 7) / 8;
  grid.x0 -= columns * grid.dx, grid.mx += 2 * columns;
  grid.y0 -= rows * grid.dy, grid.my += 2 * rows;
  return grid;
}

constexpr const char* too_long = "layers: the contact of the rollers is longer than their radius 1/(2 A)";
constexpr const char* not_found = "layers: no contact area is found whose size is that of its elements";

/// Elements that a particle passes in a step; of steps that are not whole elements the next more.
int elements_of_step(const Motion& motion, const ElementGrid& grid) {
  const double elements = motion.step / grid.dx;
  if (!(elements < grid.mx)) throw Error("step", motion.step, "m", "shorter than the grid of bodies with layers");
  return std::max(1, static_cast<int>(std::ceil(elements)));
}

/// A step of the problem with the influence numbers of the layered bodies' elements; its half-spaces are the sizes of
/// displacements.
ContactStep step_with(std::shared_ptr<const InfluenceTable> table, const RollingProblem& problem, const Method& method,
                      GapValues gap) {
  ContactStep step = contact_step(problem, method, std::move(gap), problem.load);
  step.bodies = problem.layered->surfaces();
  step.response.table = std::move(table);
  return step;
}

/// Half-lengths of a contact [m]; b = 0: endless in y.
struct HalfLengths {
  double a, b;
};

/// Hertz's contact of the surfaces' half-spaces; of a line contact with an approach given, where the bodies overlap.
HalfLengths hertzian_lengths(const RollingProblem& problem, const GapCurvatures& curvatures) {
  const auto& [given, load] = problem.load;
  const CombinedMaterial surfaces = problem.layered->surfaces();
  const bool by_force = given == NormalLoad::Given::force;
  if (curvatures.is_line()) {
    require_positive("curvature", curvatures.x, "1/m");
    require_positive(by_force ? "normal_force" : "approach", load, by_force ? "N" : "m");
    return {by_force ? line_contact_from_load(curvatures.x, surfaces, load).half_width : std::sqrt(load / curvatures.x),
            0};
  }
  const HertzContact hertz =
      by_force ? hertz_from_load(curvatures, surfaces, load) : hertz_from_approach(curvatures, surfaces, load);
  return {hertz.a, hertz.b};
}

/// The contact of bodies with these curvatures. The search begins with Hertz's ellipse of the surfaces' half-spaces; a
/// contact that reaches the end of its elements gets twice as many lengths.
FoundContact find_contact(const RollingProblem& problem, const Method& method, const GapCurvatures& curvatures,
                          LayeredSurfaces& surfaces, const Progress& progress) {
  constexpr int coarse = 16, most_rounds = 40;
  constexpr double settled = 1.2; // change of the lengths
  const ElementShape shape = elements_of(problem, method);
  auto [a, b] = hertzian_lengths(problem, curvatures);
  double centre = 0;
  for (int round = 0; round < most_rounds; ++round) {
    if (curvatures.is_line() && a > *far_of(curvatures)) throw Error(too_long);
    const ElementGrid grid = elements_about({centre, a, b}, coarse, coarse, shape);
    ContactStep step = step_with(layered_table(surfaces, grid, far_of(curvatures), essential_part(progress, 0, 0)),
                                 problem, method, {grid, hertzian_gap(curvatures, grid)});
    step.frictionless = true;
    step.force_x = step.force_y = {}; // which nothing takes
    const ContactStepSolution s = ContactSequence().solve(step);
    const std::optional<LoadedPart> part = loaded_part(grid, s.fields.pressure);
    if (!part) break;
    const bool ends_in_x = part->x.reaches_end_of(grid.mx), ends_in_y = is_cut_off_across(grid, *part);
    const double next_a = ends_in_x ? 2 * a : 0.5 * part->x.count() * grid.dx,
                 next_b = grid.line   ? 0
                          : ends_in_y ? 2 * b
                                      : 0.5 * part->y.count() * grid.dy;
    if (!ends_in_x) centre = grid.x0 + part->x.middle() * grid.dx;
    const auto stays = [](double before, double after) {
      return after <= settled * before && before <= settled * after;
    };
    const bool found = stays(a, next_a) && stays(b, next_b);
    a = next_a, b = next_b;
    if (found) return {centre, a, b};
  }
  throw Error(not_found);
}

} // namespace

bool LayeredRolling::is_of_last(const RollingProblem& problem, const GapCurvatures& curvatures) const {
  return found_ && found_->bodies == *problem.layered && found_->curvatures.x == curvatures.x &&
         found_->curvatures.y == curvatures.y && found_->load.given == problem.load.given &&
         found_->load.value == problem.load.value;
}

const FoundContact& LayeredRolling::contact_of(const RollingProblem& problem, const GapCurvatures& curvatures,
                                               const Progress& progress) {
  if (!is_of_last(problem, curvatures))
    found_ = {*problem.layered, curvatures, problem.load,
              find_contact(problem, method_, curvatures, kept_.surfaces(*problem.layered), progress)};
  return found_->contact;
}

ContactStep LayeredRolling::step_on(const RollingProblem& problem, GapValues gap, std::optional<double> far,
                                    const Progress& progress) {
  auto table = kept_.table(*problem.layered, gap.grid, far, essential_part(progress, 0, 0),
                           elements_of_step(problem.motion, gap.grid));
  return step_with(std::move(table), problem, method_, std::move(gap));
}

ContactSolution LayeredRolling::solve_on(const RollingProblem& problem, GapValues gap, std::optional<double> far,
                                         const Progress& progress) {
  ContactStep step = step_on(problem, std::move(gap), far, progress);
  const Motion& motion = problem.motion;
  const bool is_force_known = problem.load.given == NormalLoad::Given::force || !(motion.force_x || motion.force_y);
  return is_force_known ? solve_steps(sequence_, step, motion.steps, progress)
                        : solve_at_approach(std::move(step), motion, progress);
}

/// Steps with forces that are given, not their ratios to a normal force, which tractions change: each is found again
/// with the last one until it stays. The first is that without tractions.
ContactSolution LayeredRolling::solve_at_approach(ContactStep step, const Motion& motion, const Progress& progress) {
  ContactStep alone = step;
  alone.frictionless = true;
  alone.force_x = alone.force_y = {};
  double normal = normal_force(step.grid, ContactSequence().solve(alone).fields.pressure);
  if (normal == 0) return solve_steps(sequence_, alone, motion.steps, progress);
  const double settled = 10 * method_.tolerance; // each solution has errors of the tolerance
  const auto settle = [&](const Progress& within) {
    constexpr int most_times = 30;
    for (int time = 0; time < most_times; ++time) {
      if (motion.force_x) step.force_x = *motion.force_x / normal;
      if (motion.force_y) step.force_y = *motion.force_y / normal;
      ContactSolution solution = solve_steps(sequence_, step, 1, within);
      const double before = std::exchange(normal, normal_force(step.grid, solution.fields.pressure));
      if (solution.report.status != Status::ok || std::abs(normal - before) <= settled * normal) return solution;
      if (motion.kind == ContactMotion::transient) step.start = StepStart::repeated;
    }
    return solution_without_result(Status::not_converged, "the normal force that tractions change does not settle");
  };
  if (motion.kind != ContactMotion::transient) return settle(progress);
  return roll(motion.steps, progress, [&](const Progress& within) {
    ContactSolution solution = settle(within);
    step.start = StepStart::previous;
    return solution;
  });
}

/// On these elements, or more of them where the contact reaches their end: friction and finer elements may make it
/// longer than it was found.
ContactSolution LayeredRolling::solve_about(const RollingProblem& problem, const GapCurvatures& curvatures,
                                            ElementGrid grid, const Progress& progress) {
  constexpr int most_times = 8;
  for (int time = 0; time < most_times; ++time) {
    ContactSolution solution = solve_on(problem, {grid, hertzian_gap(curvatures, grid)}, far_of(curvatures), progress);
    const std::optional<LoadedPart> part = loaded_part(grid, solution.fields.pressure);
    if (!part || !is_cut_off(grid, *part)) return solution;
    grid = wider(grid);
  }
  throw Error(not_found);
}

ContactSolution LayeredRolling::solve(const RollingProblem& problem, const Progress& progress) {
  check(problem.motion);
  const auto* curvatures = std::get_if<GapCurvatures>(&problem.geometry);
  if (curvatures == nullptr) return solve_on(problem, gap_values(problem, method_), {}, progress);
  return solve_about(
      problem, *curvatures,
      elements_about(contact_of(problem, *curvatures, progress), method_.mx, method_.my, elements_of(problem, method_)),
      progress);
}

ContactSolution LayeredRolling::solve(const RollingProblem& problem, int across, double moved,
                                      const Progress& progress) {
  check(problem.motion);
  const auto& curvatures = std::get<GapCurvatures>(problem.geometry);
  ElementGrid grid =
      elements_about(contact_of(problem, curvatures, progress), across, across, elements_of(problem, method_));
  grid.x0 += moved * grid.dx;
  return solve_about(problem, curvatures, grid, progress);
}

ExactDerivatives LayeredRolling::differentiate(const RollingProblem& problem, const Progress& progress) {
  ContactSolution solution = solve(problem, essential_part(progress, 0, 0.7));
  const auto* curvatures = std::get_if<GapCurvatures>(&problem.geometry);
  const ElementGrid& grid = solution.elements.grid;
  GapValues gap = curvatures ? GapValues{grid, hertzian_gap(*curvatures, grid)} : gap_values(problem, method_);
  ContactStep step = step_on(problem, std::move(gap), curvatures ? far_of(*curvatures) : std::nullopt, progress);
  return with_derivatives(sequence_, std::move(step), std::move(solution), part(progress, 0.7, 1));
}

} // namespace microslip
