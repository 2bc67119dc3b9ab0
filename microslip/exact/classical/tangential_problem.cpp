#include "microslip/exact/classical/tangential_problem.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"
#include "microslip/exact/halfspace/displacement_operator.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/halfspace/rolling_difference.hpp"
#include "microslip/exact/halfspace/rolling_operator.hpp"
#include "microslip/exact/halfspace/traction_shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
  for (const VectorField* tractions : {input.previous, input.start})
    if (tractions && !tractions->x.empty() && (tractions->x.size() != count || tractions->y.size() != count))
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
  if (input.heading != 0 && (input.motion == ContactMotion::shift || input.leading_edge))
    throw Error("heading", input.heading, "rad", "0 except in rolling without the leading edge's correction");
  require_positive("rolling_speed", input.rolling_speed, "m/s");
  require_between("tolerance", input.tolerance, "-", smallest_tolerance, largest_tolerance);
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

/// A step in elements, rounded, from one on.
int nearest_columns(double step, const ElementGrid& grid) {
  return static_cast<int>(std::lround(std::clamp(std::abs(step) / grid.dx, 1.0, static_cast<double>(grid.mx))));
}

TractionsView view_of(const VectorField* tractions) {
  if (!tractions) return {};
  return {tractions->x, tractions->y};
}

std::unique_ptr<SlipOperator> displacement_operator(const Bodies& bodies, const ElementGrid& grid,
                                                    const Progress& progress) {
  if (bodies.are_elastic()) return std::make_unique<DisplacementOperator>(bodies, grid, progress);
  return std::make_unique<TangentialOperator>(TangentialOperator::displacement(bodies, grid, {}, 1, progress));
}

/// The slip D = A/length of a step with a displacement operator A, which it refers to.
class StepOperator : public SlipOperator {
public:
  StepOperator(SlipOperator& displacement, double length) : displacement_(displacement), length_(length) {}

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    displacement_.apply(px, py, sx, sy);
    for (const auto s : {sx, sy})
      for (double& value : s) value /= length_;
  }
  void apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                     std::span<double> sy) override {
    displacement_.apply_roughly(px, py, sx, sy);
    for (const auto s : {sx, sy})
      for (double& value : s) value /= length_;
  }
  bool has_rough_product() const override { return displacement_.has_rough_product(); }
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override {
    return displacement_.precondition(px, py, qx, qy);
  }
  double diagonal() const override { return displacement_.diagonal() / length_; }
  double scale() const override { return displacement_.scale() / length_; }
  long products() const override { return displacement_.products(); }

private:
  SlipOperator& displacement_;
  double length_;
};

/// A field of the grid moved by so many elements; none if something would leave the grid.
std::optional<Field> moved(const Field& field, const ElementGrid& grid, int columns, int rows) {
  Field result(field.size());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double value = field[static_cast<std::size_t>(j) * grid.mx + i];
      const int column = i + columns, row = j + rows;
      const bool inside = column >= 0 && column < grid.mx && row >= 0 && row < grid.my;
      if (!inside && value != 0) return {};
      if (inside) result[static_cast<std::size_t>(row) * grid.mx + column] = value;
    }
  return result;
}

/// Number of elements in a distance; none if that is not a whole number, or more than the grid has.
std::optional<int> whole_elements(double distance, double size, int most) {
  constexpr double rounding = 1e-12;
  const double elements = distance / size, nearest = std::round(elements);
  if (!(std::abs(elements - nearest) <= rounding * std::max(1.0, std::abs(nearest))) || std::abs(nearest) > most)
    return {};
  return static_cast<int>(nearest);
}

/// Solution of work that its progress function has ended before the first step.
ContactSolution nothing_found(const TangentialInput& input, ContactSolution out) {
  FrictionSolution s(out.elements.size());
  s.report.residual = 1;
  s.report.status = Status::not_converged;
  finish(input, std::move(s), out);
  return out;
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

void TangentialProblem::move_to(double x0, double y0) {
  grid_.x0 = x0, grid_.y0 = y0;
  if (!coarser_) return;
  const ElementGrid coarse = coarser_grid(grid_);
  coarser_->move_to(coarse.x0, coarse.y0);
}

SlipOperator& TangentialProblem::displacement(const Progress& progress) {
  if (!displacement_) displacement_ = displacement_operator(bodies_, grid_, progress);
  return *displacement_;
}

SlipOperator& TangentialProblem::difference(const TangentialInput& input, double step) {
  const Vec2 offset = way_of(input, step);
  if (step_.x != offset.x || step_.y != offset.y) {
    difference_.reset();
    rolling_.reset();
    step_ = offset;
  }
  const int columns = bodies_.are_elastic() && input.heading == 0 ? columns_of(step, grid_) : 0;
  if (columns != 0) return rolling_ ? *rolling_ : rolling_.emplace(bodies_, grid_, columns, input.progress);
  if (!difference_) difference_ = TangentialOperator::difference(bodies_, grid_, offset, input.progress);
  return *difference_;
}

/// Finds displacements at the points `offset` further. Where these are elements' centres, by tractions that far behind
/// at the elements.
void TangentialProblem::find_displacements(const VectorField& tractions, Vec2 offset, const Progress& progress,
                                           VectorField& u) {
  const auto columns = whole_elements(-offset.x, grid_.dx, grid_.mx),
             rows = whole_elements(-offset.y, grid_.dy, grid_.my);
  if (columns && rows) {
    const auto px = moved(tractions.x, grid_, *columns, *rows), py = moved(tractions.y, grid_, *columns, *rows);
    if (px && py) return displacement(progress).apply(*px, *py, u.x, u.y);
  }
  if (!ahead_ || offset_.x != offset.x || offset_.y != offset.y) {
    ahead_ = TangentialOperator::displacement(bodies_, grid_, offset, 1, progress);
    offset_ = offset;
  }
  ahead_->apply(tractions.x, tractions.y, u.x, u.y);
}

/// Steady rolling, or the first shift or step, on elements twice as long and wide, solved roughly, gives tractions and
/// constants to begin with. The step is as many of these elements, and the rigid slip is taken at the same distance.
TangentialProblem::CoarseStart TangentialProblem::start_from_coarser(std::span<const double> bound,
                                                                     const TangentialInput& input, double step) {
  const ElementGrid coarse = coarser_grid(grid_);
  const double ratio = coarse.dx / grid_.dx;
  std::unique_ptr<SlipDependentBound> slip_dependent;
  if (input.slip_dependent) {
    slip_dependent = input.slip_dependent->on_coarser(input.motion == ContactMotion::shift ? 1 : ratio);
    if (!slip_dependent) return {};
  }
  if (!coarser_) coarser_ = std::make_unique<TangentialProblem>(bodies_, coarse);
  const Field extra_x = mean_on_coarser(grid_, input.extra_x), extra_y = mean_on_coarser(grid_, input.extra_y),
              pressure = mean_on_coarser(grid_, input.pressure);
  TangentialInput on_coarse = input;
  on_coarse.previous = nullptr;
  on_coarse.step = ratio * std::abs(step);
  on_coarse.spin_offset = input.spin_offset / ratio;
  on_coarse.extra_x = extra_x, on_coarse.extra_y = extra_y;
  on_coarse.slip_dependent = slip_dependent.get(), on_coarse.pressure = pressure;
  if (input.leading_edge) on_coarse.leading_edge = LeadingEdge{.where_possible = true};
  on_coarse.tolerance = std::max(tolerance_of_coarser, input.tolerance);
  CoarseStart start;
  on_coarse.progress = [&](double done) {
    return !(start.stopped = input.progress && !input.progress(share_of_coarser * done));
  };
  const ContactSolution s = coarser_->solve(mean_on_coarser(grid_, bound), on_coarse);
  if (s.report.status != Status::ok) return start;
  const TractionShares shares(coarse, s.fields.bound, s.fields.traction.x, s.fields.traction.y);
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
  if (input.motion == ContactMotion::steady || !input.previous || input.previous->x.empty()) return;
  const VectorField& before = *input.previous;
  const double length = shift ? 1 : std::abs(step);
  VectorField u(cx.size());
  const Vec2 offset = way_of(input, shift ? 0 : step);
  find_displacements(before, offset, input.progress, u);
  if (!entering.empty()) {
    VectorField here(cx.size());
    displacement(input.progress).apply(before.x, before.y, here.x, here.y);
    for (const EnteringElement& e : entering) { // (R16)
      const auto at_edge = [&](const Field& field) {
        return field[e.ahead] + e.extrapolation * (field[e.ahead] - field[e.further_ahead]);
      };
      u.x[e.element] = at_edge(here.x);
      u.y[e.element] = at_edge(here.y);
    }
  }
  for (std::size_t k = 0; k < cx.size(); ++k) cx[k] -= u.x[k] / length, cy[k] -= u.y[k] / length;
}

ContactSolution TangentialProblem::solve(std::span<const double> bound, const TangentialInput& input) {
  check_input(input, bound, grid_.count());
  if (!bodies_.are_elastic() && input.motion != ContactMotion::steady)
    throw Error("motion: viscoelastic bodies need steady rolling");
  if (!bodies_.are_elastic() && input.heading != 0)
    throw Error("heading", input.heading, "rad", "0 with viscoelastic bodies");
  if (!bodies_.are_elastic() && input.leading_edge) throw Error("leading_edge: its correction is for elastic bodies");
  const double step = signed_step(input, grid_);
  const bool shift = input.motion == ContactMotion::shift;
  const std::size_t n = grid_.count();

  ContactSolution out;
  out.motion = input.motion;
  out.elements = Elements(grid_);
  out.fields.bound.assign(bound.begin(), bound.end());
  out.fields.displacement = VectorField(n);
  out.creepage = input.creepage;
  if (input.force_x) out.creepage.longitudinal = 0;
  if (input.force_y) out.creepage.lateral = 0;

  std::vector<EnteringElement> entering;
  if (!shift && input.leading_edge) entering = entering_elements(grid_, bound, step, *input.leading_edge);
  Field cx(n), cy(n), share;
  if (!entering.empty()) share.assign(n, 1);
  for (const EnteringElement& e : entering) share[e.element] = e.share;
  find_free_slip(input, out.creepage, step, entering, cx, cy);

  const bool steady = input.motion == ContactMotion::steady;
  FrictionNewton::Options options{.tolerance = input.tolerance,
                                  .most_steps = input.most_steps,
                                  .shortest_step = input.shortest_step,
                                  .budget = input.budget,
                                  .progress = input.progress};
  FrictionStart start;
  CoarseStart coarse;
  if (input.start) {
    start = {.px = input.start->x, .py = input.start->y};
  } else if (!steady && input.previous && !input.previous->x.empty()) {
    // A step changes what was there before, so that is where to begin.
    start = {.px = input.previous->x, .py = input.previous->y};
  } else if (std::max(grid_.mx, grid_.my) > largest_coarsest) {
    coarse = start_from_coarser(bound, input, step);
    start = {.px = coarse.tractions.x, .py = coarse.tractions.y, .constants = coarse.constants};
    options.progress = part(input.progress, share_of_coarser, 1);
    if (coarse.stopped) return nothing_found(input, std::move(out));
  }
  if (!steady) options.before = view_of(input.previous);
  SlipOperator* slip = steady ? &difference(input, step) : &displacement(input.progress);
  std::optional<StepOperator> of_step;
  if (input.motion == ContactMotion::transient) slip = &of_step.emplace(*slip, std::abs(step));
  std::optional<LeadingEdgeOperator> corrected;
  if (steady && input.leading_edge)
    slip = &corrected.emplace(*slip, displacement(input.progress), step, std::move(entering));
  std::optional<RollingOperator> preconditioned;
  if (steady && input.heading == 0)
    slip = &preconditioned.emplace(*slip, grid_, bound, input.direction, nearest_columns(step, grid_));
  FrictionSolution s = newton_.solve({*slip,
                                      bound,
                                      cx,
                                      cy,
                                      grid_.element_area(),
                                      input.force_x,
                                      input.force_y,
                                      share,
                                      {},
                                      input.slip_dependent,
                                      input.pressure},
                                     options, start);
  out.creepage.longitudinal += s.constants.x;
  out.creepage.lateral += s.constants.y;
  auto& [ux, uy] = out.fields.displacement;
  if (input.motion == ContactMotion::steady && rolling_)
    rolling_->displacement(s.traction.x, s.traction.y, ux, uy);
  else
    displacement(input.progress).apply(s.traction.x, s.traction.y, ux, uy);
  finish(input, std::move(s), out);
  return out;
}

} // namespace microslip
