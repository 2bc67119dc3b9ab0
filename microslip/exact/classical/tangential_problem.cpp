#include "microslip/exact/classical/tangential_problem.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/halfspace/rolling_difference.hpp"
#include "microslip/exact/halfspace/rolling_operator.hpp"
#include "microslip/exact/halfspace/traction_shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace microslip {
namespace {

using Field = std::vector<double>;

void check_input(const TangentialInput& input, std::span<const double> bound, std::size_t count) {
  const std::string wanted = std::to_string(count);
  if (bound.size() != count) throw Error("bound: must have mx times my = " + wanted + " values");
  for (std::size_t k = 0; k < count; ++k)
    if (!(bound[k] >= 0) || !std::isfinite(bound[k]))
      throw Error("bound[" + std::to_string(k) + "]", bound[k], "Pa", "finite and not negative");
  for (const TangentialState* state : {input.previous, input.start})
    if (state && !state->px.empty() && (state->px.size() != count || state->py.size() != count))
      throw Error("previous, start: must have tractions for all " + wanted + " elements");
  for (const auto extra : {input.extra_x, input.extra_y}) {
    if (!extra.empty() && extra.size() != count)
      throw Error("extra slip: must have mx times my = " + wanted + " values");
    if (!std::all_of(extra.begin(), extra.end(), [](double s) { return std::isfinite(s); }))
      throw Error("extra slip: must be finite");
  }
  require_finite("creepage.longitudinal", input.creepage.longitudinal, "-");
  require_finite("creepage.lateral", input.creepage.lateral, "-");
  require_finite("creepage.spin", input.creepage.spin, "1/m");
  if (input.force_x) require_finite("force_x", *input.force_x, "N");
  if (input.force_y) require_finite("force_y", *input.force_y, "N");
  require_between("step", input.step, "m", 0, std::numeric_limits<double>::max());
  require_between("spin_offset", input.spin_offset, "-", 0, 1);
  require_finite("heading", input.heading, "rad");
  if (input.heading != 0 && (input.motion != ContactMotion::transient || input.leading_edge))
    throw Error("heading", input.heading, "rad", "0 except in transient rolling without the leading edge's correction");
  require_positive("rolling_speed", input.rolling_speed, "m/s");
  require_between("tolerance", input.tolerance, "-", 1e-14, 1);
}

/// Elements along an axis that need no start from coarser ones.
constexpr int largest_coarsest = 16;
constexpr double tolerance_of_coarser = 1e-3; // of the order of the discretisation error between the grids
constexpr double share_of_coarser = 0.2;      // of the work

/// A step of whole elements, in elements; else 0.
int columns_of(double step, const ElementGrid& grid) {
  constexpr double rounding = 1e-9;
  const double columns = step / grid.dx, whole = std::round(columns);
  return std::abs(whole) < grid.mx && std::abs(columns - whole) < rounding ? static_cast<int>(whole) : 0;
}

TractionsView tractions_of(const TangentialState* state) {
  if (!state) return {};
  return {state->px, state->py};
}

} // namespace

bool has_one_solution(const ElementGrid& grid, const TangentialInput& input) {
  if (input.motion != ContactMotion::steady || grid.shape == ElementShape::bilinear) return true;
  constexpr double rounding = 1e-9;
  const double step = input.step > 0 ? input.step : grid.dx;
  return step >= 0.55 * grid.dx * (1 - rounding) || grid.dx <= grid.dy * (1 + rounding);
}

TangentialProblem::TangentialProblem(const Bodies& bodies, const ElementGrid& grid)
    : bodies_(bodies), grid_(require_memory(ContactProblem::tangential, grid)) {}

TangentialOperator& TangentialProblem::displacement(const Progress& progress) {
  if (!displacement_) displacement_ = TangentialOperator::displacement(bodies_, grid_, {}, 1, progress);
  return *displacement_;
}

SlipOperator& TangentialProblem::slip_operator(const TangentialInput& input, double step) {
  if (input.motion == ContactMotion::shift) return displacement(input.progress);
  if (motion_ != input.motion || step_ != step) {
    slip_operator_.reset();
    rolling_.reset();
    motion_ = input.motion;
    step_ = step;
  }
  const bool transient = input.motion == ContactMotion::transient;
  const int columns = bodies_.are_elastic() && !transient ? columns_of(step, grid_) : 0;
  if (columns != 0) return rolling_ ? *rolling_ : rolling_.emplace(bodies_, grid_, columns, input.progress);
  if (!slip_operator_)
    slip_operator_ = transient ? TangentialOperator::displacement(bodies_, grid_, {}, std::abs(step), input.progress)
                               : TangentialOperator::difference(bodies_, grid_, step, input.progress);
  return *slip_operator_;
}

/// Steady rolling on elements twice as long and wide, solved roughly, gives tractions and constants to begin with. The
/// step is as many of these elements, and the rigid slip is taken at the same distance.
TangentialProblem::CoarseStart TangentialProblem::start_from_coarser(std::span<const double> bound,
                                                                     const TangentialInput& input, double step) {
  const ElementGrid coarse = coarser_grid(grid_);
  if (!coarser_) coarser_ = std::make_unique<TangentialProblem>(bodies_, coarse);
  const double ratio = coarse.dx / grid_.dx;
  const Field extra_x = mean_on_coarser(grid_, input.extra_x), extra_y = mean_on_coarser(grid_, input.extra_y);
  TangentialInput on_coarse = input;
  on_coarse.step = ratio * std::abs(step);
  on_coarse.spin_offset = input.spin_offset / ratio;
  on_coarse.extra_x = extra_x, on_coarse.extra_y = extra_y;
  if (input.leading_edge) on_coarse.leading_edge = {.where_possible = true};
  on_coarse.tolerance = std::max(tolerance_of_coarser, input.tolerance);
  CoarseStart start;
  on_coarse.progress = [&](double done) {
    return !(start.stopped = input.progress && !input.progress(share_of_coarser * done));
  };
  const TangentialSolution s = coarser_->solve(mean_on_coarser(grid_, bound), on_coarse);
  if (s.forces.status != Status::ok) return start;
  const TractionShares shares(coarse, s.bound, s.tractions.px, s.tractions.py);
  start.tractions = VectorField(grid_.count());
  for (std::size_t k = 0; k < grid_.count(); ++k) {
    if (!(bound[k] > 0)) continue;
    const Vec2 share = shares.at(grid_.x(static_cast<int>(k % grid_.mx)), grid_.y(static_cast<int>(k / grid_.mx)));
    start.tractions.x[k] = bound[k] * share.x;
    start.tractions.y[k] = bound[k] * share.y;
  }
  start.constants = Vec2{s.creepage.longitudinal, s.creepage.lateral};
  return start;
}

/// Slip without tractions: rigid slip, and what a particle loses of its previous displacement.
void TangentialProblem::find_free_slip(const TangentialInput& input, const Creepage& creepage, double step,
                                       const std::vector<EnteringElement>& entering, Field& cx, Field& cy) {
  const bool shift = input.motion == ContactMotion::shift;
  find_rigid_slip(grid_, input, creepage, step, cx, cy);
  for (const EnteringElement& e : entering) cx[e.element] *= e.share, cy[e.element] *= e.share; // (R13)
  if (input.motion == ContactMotion::steady || !input.previous || input.previous->px.empty()) return;
  const TangentialState& before = *input.previous;
  const double length = shift ? 1 : std::abs(step);
  Field ux(cx.size()), uy(cx.size());
  const Vec2 way = way_of(input, shift ? 0 : step);
  TangentialOperator::displacement(bodies_, grid_, way, length, input.progress).apply(before.px, before.py, ux, uy);
  if (!entering.empty()) {
    Field here_x(cx.size()), here_y(cx.size());
    displacement(input.progress).apply(before.px, before.py, here_x, here_y);
    for (const EnteringElement& e : entering) { // (R16)
      const auto at_edge = [&](const Field& u) {
        return u[e.ahead] + e.extrapolation * (u[e.ahead] - u[e.further_ahead]);
      };
      ux[e.element] = at_edge(here_x) / length;
      uy[e.element] = at_edge(here_y) / length;
    }
  }
  for (std::size_t k = 0; k < cx.size(); ++k) cx[k] -= ux[k], cy[k] -= uy[k];
}

TangentialSolution TangentialProblem::solve(std::span<const double> bound, const TangentialInput& input) {
  check_input(input, bound, grid_.count());
  if (!bodies_.are_elastic() && input.motion != ContactMotion::steady)
    throw Error("motion: viscoelastic bodies need steady rolling");
  if (!bodies_.are_elastic() && input.leading_edge) throw Error("leading_edge: its correction is for elastic bodies");
  const double step = signed_step(input, grid_);
  const bool shift = input.motion == ContactMotion::shift;
  const std::size_t n = grid_.count();

  TangentialSolution out;
  out.bound.assign(bound.begin(), bound.end());
  out.creepage = input.creepage;
  if (input.force_x) out.creepage.longitudinal = 0;
  if (input.force_y) out.creepage.lateral = 0;

  std::vector<EnteringElement> entering;
  if (!shift && input.leading_edge) entering = entering_elements(grid_, bound, step, *input.leading_edge);
  Field cx(n), cy(n), share;
  if (!entering.empty()) share.assign(n, 1);
  for (const EnteringElement& e : entering) share[e.element] = e.share;
  find_free_slip(input, out.creepage, step, entering, cx, cy);

  const double area = grid_.element_area(), capacity = std::accumulate(bound.begin(), bound.end(), 0.0) * area;
  const double wanted = std::hypot(input.force_x.value_or(0), input.force_y.value_or(0));
  FrictionSolution s;
  if (wanted >= capacity && wanted > 0) {
    // No creepage gives this force: full sliding in its direction.
    s.status = Status::no_solution;
    s.residual = wanted / capacity - 1;
    for (auto* field : {&s.px, &s.py, &s.sx, &s.sy}) field->assign(n, 0.0);
    s.sliding.assign(n, 1);
    for (std::size_t k = 0; k < n; ++k) {
      s.px[k] = bound[k] * input.force_x.value_or(0) / wanted;
      s.py[k] = bound[k] * input.force_y.value_or(0) / wanted;
    }
  } else {
    const bool steady = input.motion == ContactMotion::steady;
    FrictionNewton::Options options{
        .tolerance = input.tolerance, .most_steps = input.most_steps, .progress = input.progress};
    FrictionStart start;
    CoarseStart coarse;
    if (input.start) {
      start = {.px = input.start->px, .py = input.start->py};
    } else if (!steady && input.previous) { // a step changes what was there before, so that is where to begin
      start = {.px = input.previous->px, .py = input.previous->py};
    } else if (steady && std::max(grid_.mx, grid_.my) > largest_coarsest) {
      coarse = start_from_coarser(bound, input, step);
      start = {.px = coarse.tractions.x, .py = coarse.tractions.y, .constants = coarse.constants};
      options.progress = part(input.progress, share_of_coarser, 1);
      if (coarse.stopped) options.progress = [](double) { return false; };
    }
    if (!steady) options.before = tractions_of(input.previous);
    SlipOperator* slip = &slip_operator(input, step);
    std::optional<LeadingEdgeOperator> corrected;
    if (steady && input.leading_edge)
      slip = &corrected.emplace(*slip, displacement(input.progress), step, std::move(entering));
    std::optional<RollingOperator> preconditioned;
    if (steady) slip = &preconditioned.emplace(*slip, grid_, bound, input.direction);
    s = newton_.solve(
        {*slip, bound, cx, cy, area, input.force_x, input.force_y, share, {}, input.slip_dependent, input.pressure},
        options, start);
  }
  out.creepage.longitudinal += s.constant_x;
  out.creepage.lateral += s.constant_y;
  out.ux.resize(n), out.uy.resize(n);
  if (rolling_)
    rolling_->displacement(s.px, s.py, out.ux, out.uy);
  else
    displacement(input.progress).apply(s.px, s.py, out.ux, out.uy);
  find_totals(grid_, input, std::move(s), out);
  return out;
}

} // namespace microslip
